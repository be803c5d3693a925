// Callbacks of a host, and its GL, run under the floating-point settings of the host, while claque's results are those
// of usual ones.
#include <memory>

#include "tests/api/floats_host.h"
#include "tests/api/test_world.h"

namespace
{

using floats_host::NotingHost;
using floats_host::Words;
using host_floats::Setting;

// A crowd of a host, which calls all of its callbacks. Everything that could compute runs under the host's settings.
class HostedCrowd
{
public:
    explicit HostedCrowd(const Words &floats) : host(floats)
    {
        const clq_context_def def = floats_host::context_of(host);
        world = std::make_unique<TestWorld>(&def);
        clq_crowd_def wanted = clq_crowd_def_init();
        wanted.clock = CLQ_CLOCK_LIVE, wanted.update_budget_ms = 1000, wanted.now_s = floats_host::now_s,
        wanted.now_user = &host;
        crowd = world->new_crowd(&wanted);
        world->set_up(crowd);
        const std::vector<clq_actor> actors = world->fill(crowd, 40, 5);
        clq_mechanism_def mechanism = world->mechanism(TestWorld::host);
        mechanism.host = {floats_host::move, &host, false};
        clq_mechanism_attachment attachment = clq_mechanism_attachment_init();
        host.call([&] { return clq_crowd_add_mechanism(crowd, &mechanism, &attachment.mechanism); });
        host.call([&] { return clq_crowd_set_ground(crowd, floats_host::height, &host); });
        const clq_actor_hooks hooks = floats_host::hooks_of(host);
        for (size_t i = 0; i < actors.size(); ++i) {
            if (i % 3 == 0) host.call([&] { return clq_actor_follow_ground(crowd, actors[i], 0.3f, 0.3f); });
            (void)clq_actor_attach_mechanism(crowd, actors[i], &attachment);  // not those of the other template
            if (i % 5 == 0) host.call([&] { return clq_actor_set_hooks(crowd, actors[i], &hooks); });
        }
        view = world->new_view(crowd, 0);
    }

    void draw()
    {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = floats_host::find, def.user = &host;
        clq_renderer *renderer = nullptr;
        host.call([&] { return clq_renderer_create(world->context, &def, &renderer); });
        for (clq_template *tmpl : world->templates) host.call([&] { return clq_renderer_prepare(renderer, tmpl); });
        host.call([&] { return clq_renderer_draw(renderer, view, nullptr); });
        clq_shadow_def shadow = clq_shadow_def_init();
        shadow.ground = CLQ_SHADOW_GROUND_HOST, shadow.user = &host, shadow.height = floats_host::height;
        host.call([&] { return clq_renderer_draw_shadows(renderer, view, &shadow, nullptr); });
        host.call([&] { return clq_renderer_destroy(renderer); });
    }

    // Hashes of everything that is computed, and of the crowd as saved.
    std::string results()
    {
        std::string all;
        for (int frame = 1; frame <= 6; ++frame) {
            const double time_s = 0.3 * frame;
            host.call([&] { return clq_crowd_update(crowd, time_s, &view, 1); });
            all += std::to_string(clq_view_get_hash(view)) + " " + std::to_string(clq_crowd_get_hash(crowd)) + " ";
            std::vector<float> vertices(3 * 64);
            for (uint32_t item = 0; item < 5; ++item) {
                host.call([&] { return clq_view_get_vertices(view, item, vertices.data(), nullptr, 64); });
                for (const float value : vertices) all += std::to_string(value) + " ";
            }
        }
        host.call([&] { return clq_crowd_save(crowd, floats_host::write, &host); });
        host.call([&] { return clq_context_log(world->context, CLQ_LOG_INFO, "a note"), CLQ_OK; });
        draw();
        return all;
    }

    NotingHost host;
    std::unique_ptr<TestWorld> world;
    clq_crowd *crowd = nullptr;
    clq_view *view = nullptr;
};

TEST(HostFloats, AreMetByEveryCallbackAndChangeNoResult)
{
    if (host_floats::settings().empty()) GTEST_SKIP() << "the settings of this processor are not known here";
    std::string usual;
    for (const Setting &setting : host_floats::settings()) {
        SCOPED_TRACE(setting.name);
        HostedCrowd scene(setting.words);
        const std::string results = scene.results();
        if (usual.empty()) usual = results;
        EXPECT_EQ(results, usual);
        EXPECT_EQ(scene.host.wrong(), (std::map<std::string, int>()));
        for (const char *name :
             {"allocate", "release", "log", "tasks", "height", "mechanism", "clock", "write", "before", "after",
              "get_proc_address", "glDrawElements", "glLoadMatrixf", "glGetString"})
            EXPECT_TRUE(scene.host.right().count(name)) << name << " was never called";
    }
}

// Rounding and flags that a callback changes are those of the host from then on.
TEST(HostFloats, ThatACallbackChangesStayChanged)
{
    if (host_floats::settings().empty()) GTEST_SKIP() << "the settings of this processor are not known here";
    static Words changed;
    changed = host_floats::settings()[1].words;
    clq_context_def def = clq_context_def_init();
    def.log.write = [](void *, clq_log_level, const char *) { host_floats::set(changed); };
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    const Words before = host_floats::now();
    host_floats::set(host_floats::settings()[2].words);
    const bool entered = clq_floats_enter();
    clq_context_log(context, CLQ_LOG_INFO, "one");
    const Words inside = host_floats::now();
    const bool left = clq_floats_leave();
    const Words after = host_floats::now();
    host_floats::set(before);
    EXPECT_TRUE(entered && left);
    EXPECT_EQ(inside.control, host_floats::settings()[0].words.control);
    EXPECT_TRUE(after == changed);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
}

TEST(HostFloats, AreEnteredAndLeftOnce)
{
    EXPECT_FALSE(clq_floats_leave());
    EXPECT_FALSE(clq_floats_differ());
    EXPECT_TRUE(clq_floats_enter());
    EXPECT_FALSE(clq_floats_enter());
    EXPECT_EQ(clq_context_destroy(nullptr), CLQ_OK);  // a call in between leaves them alone
    EXPECT_FALSE(clq_floats_enter());
    EXPECT_TRUE(clq_floats_leave());
    EXPECT_FALSE(clq_floats_leave());
}

TEST(HostFloats, HaveTheFlagsThatTheyHadAfterwards)
{
    if (host_floats::settings().empty()) GTEST_SKIP() << "the settings of this processor are not known here";
    const Words all_raised = {0, ~uint64_t(0)};
    for (const Setting &setting : host_floats::settings()) {
        const Words before = host_floats::now();
        host_floats::set(setting.words);
        const Words found = host_floats::now();
        clq_floats_enter();
        host_floats::set({host_floats::now().control, all_raised.raised});
        const Words inside = host_floats::now();
        clq_floats_leave();
        const Words left = host_floats::now();
        host_floats::set(before);
        EXPECT_NE(inside.raised, found.raised);
        EXPECT_TRUE(left == found) << setting.name << std::hex << " " << left.raised;
    }
}

// An exception of a callback is an error path: the host finds its settings on it too.
TEST(HostFloats, AreThereAgainAfterACallThatFails)
{
    if (host_floats::settings().empty()) GTEST_SKIP() << "the settings of this processor are not known here";
    for (const Setting &setting : host_floats::settings()) {
        const Words before = host_floats::now();
        host_floats::set(setting.words);
        const Words found = host_floats::now();
        const clq_status refused = clq_crowd_create(nullptr, nullptr, nullptr);
        const Words left = host_floats::now();
        const clq_status thrown = clq_context_run(
            nullptr, 3, [](void *, uint32_t index) { throw index; }, nullptr);
        const Words last = host_floats::now();
        host_floats::set(before);
        EXPECT_EQ(refused, CLQ_ARGUMENT);
        EXPECT_EQ(thrown, CLQ_CALLBACK);
        EXPECT_TRUE(left == found && last == found) << setting.name;
    }
}

}  // namespace

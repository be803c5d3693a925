// A host's callbacks round the drawing of one individual (S0 7.1): what they may do, and whom it reaches.
#include "passes/guard.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/mess.h"
#include "tests/gl/support/spy.h"
#include "tests/gl/support/state_dump.h"

#include <functional>

namespace gltest
{
namespace
{

using claque::draw::DrawList;
using passes::Guard;

struct Callbacks {
    std::function<int32_t()> before;
    std::function<void()> after;
    uint32_t index1 = 0, generation = 0;
    claque::draw::Hooks hooks;

    Callbacks(std::function<int32_t()> b, std::function<void()> a) : before(std::move(b)), after(std::move(a))
    {
        if (before) hooks.before = call_before;
        if (after) hooks.after = call_after;
        hooks.user = this;
    }
    Callbacks(const Callbacks &) = delete;

    static int32_t call_before(void *user, uint32_t index1, uint32_t generation)
    {
        Callbacks &self = *static_cast<Callbacks *>(user);
        self.index1 = index1, self.generation = generation;
        return self.before();
    }
    static void call_after(void *user, uint32_t index1, uint32_t generation)
    {
        Callbacks &self = *static_cast<Callbacks *>(user);
        self.index1 = index1, self.generation = generation;
        self.after();
    }
};

// Three individuals side by side.
class Hooks : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (figure_.tmpl) return;
        figure_ = small_figure();
        paint(*figure_.tmpl);
    }

    DrawList trio() const
    {
        DrawList list = list_of(figure_, camera_on(figure_, 5, -0.5f, 0.4f, 4.0f / 3.0f));
        for (uint32_t i = 0; i < 3; ++i) {
            claque::draw::Item item = list.items[0];
            item.actor_index = 10 + i;
            item.generation = 5;
            item.model_view[12] += 2.6f * (float(i) - 1);
            list.items.push_back(item);
        }
        list.items.erase(list.items.begin());
        return list;
    }
    DrawList trio(const Callbacks &of_the_middle) const
    {
        DrawList list = trio();
        list.items[1].hooks = &of_the_middle.hooks;
        return list;
    }
    // Its neighbours are wholly outside.
    static bool is_middle(size_t byte) { return std::abs(int(byte / 3 % width) - width / 2) < 58; }

    static void expect_same_neighbours(const Picture &a, const Picture &b)
    {
        uint32_t differ = 0;
        for (size_t i = 0; i < a.size(); ++i) differ += !is_middle(i) && a[i] != b[i];
        EXPECT_EQ(differ, 0u);
    }
    static bool same_middle(const Picture &a, const Picture &b)
    {
        for (size_t i = 0; i < a.size(); ++i)
            if (is_middle(i) && a[i] != b[i]) return false;
        return true;
    }
    Picture calm(const passes::RendererOptions &options = {})
    {
        return draw(*context_, *make_renderer_of(figure_, options), trio());
    }
    static std::set<gl::Enum> documented(Guard guard)
    {
        std::set<gl::Enum> names;
        for (const passes::Left &left : passes::left_by_minimal) names.insert(left.name);
        for (const passes::Left &left : passes::left_by_none)
            if (guard == Guard::none) names.insert(left.name);
        return names;
    }

    Figure figure_;
};

TEST_F(Hooks, AreCalledBeforeAndAfterTheDrawOfTheirIndividual)
{
    Spy spy(*context_);
    passes::Renderer renderer(std::pmr::get_default_resource(), options_of(passes::Strategy::per_zone));
    ASSERT_TRUE(renderer.open(Spy::get_proc_address, spy.user()).ok());
    ASSERT_TRUE(renderer.prepare(*figure_.tmpl).ok());
    passes::DrawStats alone;
    ASSERT_TRUE(renderer.draw(list_of(figure_, whole_view(figure_)), &alone).ok());
    std::vector<uint32_t> draws;
    const auto note = [&] { draws.push_back(spy.calls["glDrawElements"]); };
    const Callbacks both([&] { return note(), 0; }, note), first([&] { return note(), 0; }, nullptr),
        last(nullptr, note);
    DrawList list = trio(both);
    list.items[0].hooks = &first.hooks;
    list.items[2].hooks = &last.hooks;
    spy.reset();
    ASSERT_TRUE(renderer.draw(list, nullptr).ok());
    const uint32_t n = alone.draws;
    EXPECT_EQ(draws, (std::vector<uint32_t>{0, n, 2 * n, 3 * n}));
    EXPECT_EQ(both.index1, 12u);
    EXPECT_EQ(both.generation, 5u);
    EXPECT_EQ(first.index1, 11u);
    EXPECT_EQ(last.index1, 13u);
}

TEST_F(Hooks, AreNotCalledForWhoIsNotDrawn)
{
    uint32_t calls = 0;
    const Callbacks counting([&] { return ++calls, 0; }, [&] { ++calls; });
    const auto renderer = make_renderer_of(figure_);
    DrawList list = trio(counting);
    list.items[1].shadow_only = true;
    draw(*context_, *renderer, list);
    list.items[1].shadow_only = false;
    list.items[1].parts = 0;
    draw(*context_, *renderer, list);
    EXPECT_EQ(calls, 0u);
}

TEST_F(Hooks, FindTheirIndividualsPlaceNoArraysAndNoTexture)
{
    const auto look = [&] {
        EXPECT_EQ(host_->IsEnabled(gl::vertex_array) + host_->IsEnabled(gl::colour_array), 0);
        int32_t mode = 0, texture = -1;
        host_->GetIntegerv(gl::matrix_mode, &mode);
        host_->GetIntegerv(gl::texture_binding_2d, &texture);
        EXPECT_EQ(gl::Enum(mode), gl::modelview);
        EXPECT_EQ(texture, 0);
        double matrix[16];
        host_->GetDoublev(gl::modelview_matrix, matrix);
        const DrawList list = trio();
        EXPECT_TRUE(std::equal(matrix, matrix + 16, list.items[1].model_view));
        host_->GetDoublev(gl::projection_matrix, matrix);
        EXPECT_TRUE(std::equal(matrix, matrix + 16, list.projection));
        return 0;
    };
    const Callbacks looking(look, look);
    for (const passes::Strategy strategy : all_strategies)
        draw(*context_, *make_renderer_of(figure_, options_of(strategy)), trio(looking));
}

TEST_F(Hooks, ThatMessWithWhatClaqueSetsLeaveNoTraceInThePicture)
{
    for (const passes::Strategy strategy : all_strategies)
        for (const Guard guard : {Guard::full, Guard::minimal, Guard::none}) {
            const passes::RendererOptions options = options_of(strategy, guard);
            const Picture expected = calm(options);
            for (const auto &[first, last] : {std::pair(true, false), {false, true}, {true, true}})
                for (size_t place = 0; place < 3; ++place) {
                    SetUp();
                    Mess mess(*host_);
                    const auto make = [&] { return mess.with_what_claque_sets(), 0; };
                    const Callbacks hooks(first ? make : std::function<int32_t()>(),
                                          last ? make : std::function<void()>());
                    const auto renderer = make_renderer_of(figure_, options);
                    DrawList list = trio();
                    list.items[place].hooks = &hooks.hooks;
                    EXPECT_TRUE(draw(*context_, *renderer, list) == expected)
                        << int(strategy) << " " << int(guard) << " " << place;
                    EXPECT_TRUE(draw(*context_, *renderer, list) == expected) << "once more";
                    EXPECT_EQ(host_->GetError(), 0u);
                }
            SetUp();
        }
}

TEST_F(Hooks, ThatMessWithEverythingDoNotReachTheNeighbours)
{
    for (const passes::Strategy strategy : all_strategies) {
        const Picture expected = calm(options_of(strategy));
        for (const auto &[first, last] : {std::pair(true, false), {false, true}, {true, true}}) {
            SetUp();
            Mess mess(*host_);
            const auto make = [&] { return mess.with_everything(), 0; };
            const Callbacks hooks(first ? make : std::function<int32_t()>(), last ? make : std::function<void()>());
            const Picture messed = draw(*context_, *make_renderer_of(figure_, options_of(strategy)), trio(hooks));
            expect_same_neighbours(messed, expected);
            EXPECT_EQ(same_middle(messed, expected), !first) << "what claque inherits acts on it";
        }
        SetUp();
    }
}

TEST_F(Hooks, LeaveTheHostsStateAsItWasInGuardModeFull)
{
    for (const passes::Strategy strategy : all_strategies) {
        const auto renderer = make_renderer_of(figure_, options_of(strategy));
        const HostileHost hostile(*host_);
        Mess mess(*host_);
        const auto make = [&] { return mess.with_everything(), 0; };
        const Callbacks both(make, make);
        const State before = dump_state(*host_);
        const Status status = renderer->draw(trio(both), nullptr);
        EXPECT_TRUE(status.ok()) << status.text;
        const State after = dump_state(*host_);
        for (const std::string &name : differences(before, after))
            ADD_FAILURE() << name << " was " << text_of(before.at(name)) << ", is now " << text_of(after.at(name));
        SetUp();
    }
}

TEST_F(Hooks, LeaveNothingThatIsNotDocumentedInTheOtherGuardModes)
{
    for (const Guard guard : {Guard::minimal, Guard::none}) {
        const auto renderer = make_renderer_of(figure_, options_of(passes::Strategy::fused, guard));
        Mess mess(*host_);
        const auto make = [&] { return mess.with_everything(), 0; };
        const Callbacks both(make, make);
        DrawList list = trio(both);
        list.items[2].hooks = &both.hooks;
        const State before = dump_state(*host_);
        ASSERT_TRUE(renderer->draw(list, nullptr).ok());
        const State after = dump_state(*host_);
        const std::set<gl::Enum> left = documented(guard);
        for (const std::string &name : differences(before, after)) {
            if (name.rfind("GL_TEXTURE_2D GL_", 0) == 0) continue;  // of another texture
            EXPECT_TRUE(left.count(after.at(name).name)) << name << " is now " << text_of(after.at(name));
        }
        SetUp();
    }
}

// What one hook pushes the other may pop: lights of their own for one individual.
TEST_F(Hooks, MayLightTheirIndividual)
{
    constexpr gl::Enum lighting = 0x0B50;
    const float dim[4] = {0.4f, 0.4f, 0.4f, 1};
    const Callbacks dims(
        [&] {
            host_->PushAttrib(gl::all_attrib_bits);
            host_->LightModelfv(0x0B53, dim);
            host_->Enable(lighting);
            return 0;
        },
        [&] { host_->PopAttrib(); });
    const Picture expected = calm();
    const Picture dimmed = draw(*context_, *make_renderer_of(figure_), trio(dims));
    expect_same_neighbours(dimmed, expected);
    EXPECT_FALSE(same_middle(dimmed, expected));
    uint64_t sum = 0, expected_sum = 0;
    for (size_t i = 0; i < dimmed.size(); ++i)
        if (is_middle(i)) sum += dimmed[i], expected_sum += expected[i];
    EXPECT_LT(sum, expected_sum);
    EXPECT_EQ(host_->GetError(), 0u);
}

// The same template with another picture on it, and the zone keys that it needs.
TEST_F(Hooks, MayBindATextureOfTheirOwn)
{
    Figure other = small_figure();
    paint(*other.tmpl);
    model::Texture &texture = other.tmpl->textures[0];
    for (size_t i = 0; i < texture.rgba.size(); i += 4)
        std::swap(texture.rgba[i], texture.rgba[i + 1]), texture.rgba[i + 2] /= 2;
    uint32_t name = 0;
    host_->GenTextures(1, &name);
    host_->BindTexture(gl::texture_2d, name);
    host_->TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host_->TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host_->TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(texture.width), int32_t(texture.height), 0,
                      gl::rgba, gl::unsigned_byte, texture.rgba.data());
    host_->BindTexture(gl::texture_2d, 0);
    int32_t answer = 1;
    const Callbacks binds([&] { return host_->BindTexture(gl::texture_2d, name), answer; }, nullptr);
    for (const passes::Strategy strategy : all_strategies) {
        const Picture expected = calm(options_of(strategy));
        DrawList list = trio();
        for (claque::draw::Item &item : list.items) item.tmpl = other.tmpl.get();
        const Picture all_other = draw(*context_, *make_renderer_of(other, options_of(strategy)), list);
        EXPECT_FALSE(same_middle(all_other, expected));
        const auto renderer = make_renderer_of(figure_, options_of(strategy));
        answer = 1;
        const Picture swapped = draw(*context_, *renderer, trio(binds));
        expect_same_neighbours(swapped, expected);
        EXPECT_TRUE(same_middle(swapped, all_other)) << int(strategy);
        answer = 0;
        EXPECT_EQ(draw(*context_, *renderer, trio(binds)), expected) << "it has not asked for it to be used";
    }
}

// Modes that GL 1.1 alone can end are ended.
TEST_F(Hooks, ThatLeaveADisplayListOrSelectionOpenAreClosed)
{
    const Picture expected = calm();
    uint32_t names[8];
    const Callbacks lists([&] { return host_->NewList(7, 0x1300), 0; }, [&] { host_->NewList(8, 0x1300); });
    const Callbacks selects([&] { return host_->SelectBuffer(8, names), host_->RenderMode(0x1C02), 0; },
                            [&] { host_->RenderMode(0x1C02); });
    for (const Callbacks *hooks : {&lists, &selects}) {
        EXPECT_EQ(draw(*context_, *make_renderer_of(figure_), trio(*hooks)), expected);
        EXPECT_EQ(host_->GetError(), 0u);
    }
}

// A program in use is newer than what claque can undo.
TEST_F(Hooks, ThatLeaveWhatCannotBeUndoneAreNamed)
{
    using One = void (*)(uint32_t);
    const uint32_t shader = host_->ask<uint32_t (*)(gl::Enum)>("glCreateShader")(0x8B31);
    const uint32_t program = host_->ask<uint32_t (*)()>("glCreateProgram")();
    const char *source = "void main() { gl_Position = ftransform(); }";
    host_->ask<void (*)(uint32_t, int32_t, const char **, const int32_t *)>("glShaderSource")(shader, 1, &source,
                                                                                              nullptr);
    host_->ask<One>("glCompileShader")(shader);
    host_->ask<void (*)(uint32_t, uint32_t)>("glAttachShader")(program, shader);
    host_->ask<One>("glLinkProgram")(program);
    const auto use = host_->ask<One>("glUseProgram");
    const Picture expected = calm();
    const auto renderer = make_renderer_of(figure_);
    passes::DrawStats stats;

    const Callbacks between([&] { return use(program), 0; }, [&] { use(0); });
    host_->clear(0, 0, 0);
    Status status = renderer->draw(trio(between), &stats);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    for (const char *word : {"actor 11", "'before'", "program is in use"})
        EXPECT_NE(std::string(status.text).find(word), std::string::npos) << status.text;
    EXPECT_EQ(stats.individuals, 2u) << "its neighbours are drawn";

    const State before = dump_state(*host_);
    const Callbacks for_good(nullptr, [&] { use(program); });
    status = renderer->draw(trio(for_good), &stats);
    use(0);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    EXPECT_NE(std::string(status.text).find("'after'"), std::string::npos) << status.text;
    EXPECT_EQ(stats.individuals, 2u) << "nobody is drawn by somebody else's program";
    EXPECT_EQ(differences(before, dump_state(*host_)), std::vector<std::string>());
    EXPECT_EQ(draw(*context_, *renderer, trio()), expected);
}

TEST_F(Hooks, NeedAPlaceMoreOnTheAttributeStacks)
{
    const Callbacks none([] { return 0; }, nullptr);
    const auto renderer = make_renderer_of(figure_);
    int32_t most = 0;
    host_->GetIntegerv(gl::max_attrib_stack_depth, &most);
    for (int32_t i = 1; i < most; ++i) host_->PushAttrib(gl::current_bit);
    EXPECT_TRUE(renderer->draw(trio(), nullptr).ok());
    const Status status = renderer->draw(trio(none), nullptr);
    EXPECT_EQ(status.code, CLQ_GL_STATE);
    EXPECT_NE(std::string(status.text).find("glPushAttrib stack, claque needs 2"), std::string::npos) << status.text;
    host_->PopAttrib();
    EXPECT_TRUE(renderer->draw(trio(none), nullptr).ok());
    EXPECT_EQ(host_->GetError(), 0u);
}

// Nothing below what it has pushed is the host's to pop; who does it all the same loses its own alone.
TEST_F(Hooks, ThatPopTooMuchLeaveTheStacksBalanced)
{
    const Callbacks pops([&] { return host_->PopAttrib(), host_->PopAttrib(), 0; }, [&] { host_->PopClientAttrib(); });
    const auto renderer = make_renderer_of(figure_);
    host_->PushAttrib(gl::current_bit);
    host_->PushClientAttrib(gl::client_vertex_array_bit);
    EXPECT_EQ(draw(*context_, *renderer, trio(pops)), calm());
    int32_t depth = 0;
    host_->GetIntegerv(gl::attrib_stack_depth, &depth);
    EXPECT_EQ(depth, 1);
    host_->GetIntegerv(gl::client_attrib_stack_depth, &depth);
    EXPECT_EQ(depth, 1);
    EXPECT_EQ(host_->GetError(), 0u);
}

}  // namespace
}  // namespace gltest

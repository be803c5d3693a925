// Calls that meet another one for the same object get CLQ_BUSY and do nothing, wherever they come from: each callback,
// and another thread during an update.
#include <algorithm>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <thread>

#include "tests/api/busy_calls.h"
#include "tests/api/stub_gl.h"
#include "tests/support/patterns.h"

namespace
{

using busy::Call;
using busy::Use;

// Makes every call once, at its first chance, and notes what it got.
struct Meddler {
    const busy::Objects *objects = nullptr;
    std::vector<std::pair<const Call *, clq_status>> got;
    void meddle()
    {
        if (!got.empty()) return;
        for (const Call &call : busy::calls()) got.emplace_back(&call, call.run(*objects));
    }
};

Meddler &meddler_of(void *user) { return *static_cast<Meddler *>(user); }

double height(void *user, const double *)
{
    meddler_of(user).meddle();
    return 0;
}

using BusyCalls = busy::Busy;

TEST(BusyTable, HoldsEveryCallForACrowdAViewASceneOrARenderer)
{
    std::set<std::string> declared, listed;
    const std::string call = R"((clq_\w+)\((?:const )?(?:struct )?clq_(?:crowd|view|scene|renderer) \*)";
    for (const auto &header : std::filesystem::directory_iterator(CLAQUE_SOURCE_DIR "/include/claque")) {
        std::stringstream text;
        text << std::ifstream(header.path()).rdbuf();
        for (const patterns::Match &found : patterns::matches(call, text.str())) declared.insert(found[1]);
    }
    for (const Call &one : busy::calls()) listed.insert(one.name);
    EXPECT_EQ(declared, listed);
}

TEST_F(BusyCalls, SucceedOutsideCallbacks)
{
    for (const Call &call : busy::calls()) {
        if (call.name.find("destroy") != std::string::npos || call.name == "clq_renderer_abandon") continue;
        const clq_status status = call.run(objects_);
        EXPECT_NE(status, CLQ_BUSY) << call.name << ": " << clq_last_error();
        if (call.use != Use::changes_crowd) {
            EXPECT_EQ(status, CLQ_OK) << call.name << ": " << clq_last_error();
        }
        ASSERT_EQ(clq_crowd_update(objects_.crowd, 1, &objects_.view, 1), CLQ_OK);
    }
}

TEST_F(BusyCalls, AreRefusedInACallbackOfAnUpdate)
{
    Meddler by_ground{&objects_, {}}, by_mechanism{&objects_, {}};
    ASSERT_EQ(clq_crowd_set_ground(objects_.crowd, height, &by_ground), CLQ_OK);
    clq_mechanism_def def = world_.mechanism(TestWorld::host);
    def.host.user = &by_mechanism;
    def.host.run = [](void *user, const clq_behaviour_call *, clq_dof_writer *) { meddler_of(user).meddle(); };
    clq_mechanism made;
    ASSERT_EQ(clq_crowd_add_mechanism(objects_.crowd, &def, &made), CLQ_OK) << clq_last_error();
    const clq_mechanism_attachment attachment = {made, 0, 0, 0};
    ASSERT_EQ(clq_actor_attach_mechanism(objects_.crowd, objects_.actor, &attachment), CLQ_OK);
    const uint64_t before = clq_crowd_get_hash(objects_.crowd);
    busy::Objects without = objects_;
    without.renderer = nullptr;  // no update uses it
    for (Meddler *meddler : {&by_ground, &by_mechanism}) meddler->objects = &without;
    ASSERT_EQ(clq_crowd_update(objects_.crowd, 5, &objects_.view, 1), CLQ_OK) << clq_last_error();
    for (const Meddler *meddler : {&by_ground, &by_mechanism}) {
        EXPECT_EQ(meddler->got.size(), busy::calls().size());
        for (const auto &[call, status] : meddler->got)
            if (call->use != Use::renders) {
                EXPECT_EQ(status, CLQ_BUSY) << call->name;
            }
    }
    EXPECT_EQ(clq_crowd_get_hash(objects_.crowd), before);
    EXPECT_EQ(clq_renderer_draw(objects_.renderer, objects_.view, nullptr), CLQ_OK) << clq_last_error();
}

TEST_F(BusyCalls, AreRefusedInAWriter)
{
    static Meddler meddler;
    busy::Objects without = objects_;
    without.renderer = nullptr;
    meddler = {&without, {}};
    const auto write = [](void *user, const void *, size_t) {
        meddler_of(user).meddle();
        return 0;
    };
    ASSERT_EQ(clq_crowd_save(objects_.crowd, write, &meddler), CLQ_OK) << clq_last_error();
    EXPECT_FALSE(meddler.got.empty());
    for (const auto &[call, status] : meddler.got)
        if (call->use != Use::renders) {
            EXPECT_EQ(status, CLQ_BUSY) << call->name;
        }
}

// What does not change the crowd may be asked for while a view is drawn, except of that view.
TEST_F(BusyCalls, AreRefusedInAHookExceptThoseThatReadTheCrowd)
{
    Meddler by_hook{&objects_, {}};
    clq_actor_hooks hooks = {};
    hooks.user = &by_hook;
    hooks.before = [](void *user, clq_actor) {
        meddler_of(user).meddle();
        return false;
    };
    ASSERT_EQ(clq_actor_set_hooks(objects_.crowd, objects_.actor, &hooks), CLQ_OK);
    ASSERT_EQ(clq_crowd_update(objects_.crowd, 2, &objects_.view, 1), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_renderer_draw(objects_.renderer, objects_.view, nullptr), CLQ_OK) << clq_last_error();
    Meddler by_height{&objects_, {}};
    clq_shadow_def def = clq_shadow_def_init();
    def.ground = CLQ_SHADOW_GROUND_HOST, def.height = height, def.user = &by_height;
    ASSERT_EQ(clq_renderer_draw_shadows(objects_.renderer, objects_.view, &def, nullptr), CLQ_OK) << clq_last_error();
    for (const Meddler *meddler : {&by_hook, &by_height}) {
        EXPECT_EQ(meddler->got.size(), busy::calls().size()) << "the callback was not called";
        for (const auto &[call, status] : meddler->got)
            EXPECT_EQ(status, call->use == Use::reads_crowd ? CLQ_OK : CLQ_BUSY) << call->name;
    }
}

TEST_F(BusyCalls, AreRefusedOnAnotherThreadDuringAnUpdate)
{
    struct Meeting {
        std::mutex mutex;
        std::condition_variable changed;
        bool inside = false, done = false;
    } meeting;
    ASSERT_EQ(clq_crowd_set_ground(
                  objects_.crowd,
                  [](void *user, const double *) {
                      Meeting &m = *static_cast<Meeting *>(user);
                      std::unique_lock<std::mutex> lock(m.mutex);
                      m.inside = true;
                      m.changed.notify_all();
                      m.changed.wait(lock, [&] { return m.done; });
                      return 0.0;
                  },
                  &meeting),
              CLQ_OK);
    busy::Objects without = objects_;
    without.renderer = nullptr;
    Meddler meddler{&without, {}};
    std::thread other([&] {
        std::unique_lock<std::mutex> lock(meeting.mutex);
        meeting.changed.wait(lock, [&] { return meeting.inside; });
        meddler.meddle();
        meeting.done = true;
        meeting.changed.notify_all();
    });
    EXPECT_EQ(clq_crowd_update(objects_.crowd, 5, &objects_.view, 1), CLQ_OK) << clq_last_error();
    other.join();
    EXPECT_FALSE(meddler.got.empty());
    for (const auto &[call, status] : meddler.got)
        if (call->use != Use::renders) {
            EXPECT_EQ(status, CLQ_BUSY) << call->name;
        }
}

}  // namespace

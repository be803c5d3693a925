// An update tells which actors entered or left view, so that no host has to ask of all.
#include <claque/claque.h>

#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace
{

using Key = std::pair<uint32_t, uint32_t>;

Key key_of(const clq_actor &actor) { return {actor.index1, actor.generation}; }

class ViewChanges : public testing::Test
{
protected:
    ViewChanges() : crowd_(world_.new_crowd()) { world_.set_up(crowd_); }

    std::vector<clq_view_change> told() const
    {
        size_t count = 0, again = 0;
        EXPECT_EQ(clq_crowd_get_view_changes(crowd_, nullptr, 0, &count), CLQ_OK);
        std::vector<clq_view_change> out(count + 1);
        EXPECT_EQ(clq_crowd_get_view_changes(crowd_, out.data(), out.size(), &again), CLQ_OK);
        EXPECT_EQ(again, count);
        out.resize(count);
        return out;
    }
    // Of actors by id, as the actors themselves say it.
    std::map<Key, bool> seen(const std::vector<clq_actor> &actors) const
    {
        std::map<Key, bool> out;
        for (const clq_actor &actor : actors) {
            clq_actor_info info = clq_actor_info_init();
            EXPECT_EQ(clq_actor_get_info(crowd_, actor, &info), CLQ_OK);
            out[key_of(actor)] = info.visible;
        }
        return out;
    }
    static std::map<Key, bool> by_id(const std::vector<clq_view_change> &changes)
    {
        std::map<Key, bool> out;
        for (const clq_view_change &change : changes) out[key_of(change.actor)] = change.in_view;
        EXPECT_EQ(out.size(), changes.size()) << "each once";
        return out;
    }
    void turn(clq_view *view, double angle)
    {
        clq_camera camera;
        const double eye[3] = {0, 2, 0}, target[3] = {std::sin(angle), 1.8, -std::cos(angle)};
        const float up[3] = {0, 1, 0};
        EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 0.5f, 1, 0.1f, 100), CLQ_OK);
        EXPECT_EQ(clq_view_set_camera(view, &camera), CLQ_OK);
    }
    void update(double time_s, std::vector<clq_view *> views)
    {
        ASSERT_EQ(clq_crowd_update(crowd_, time_s, views.data(), static_cast<uint32_t>(views.size())), CLQ_OK)
            << clq_last_error();
    }

    TestWorld world_;
    clq_crowd *crowd_;
};

}  // namespace

// Actors come, go, are cloned, join groups that are hidden, walk and appear; views turn, are added and left out.
TEST_F(ViewChanges, AreTheDifferencesOfWhatActorsSay)
{
    std::vector<clq_actor> actors = world_.fill(crowd_, 90, 5);
    clq_view *views[2] = {world_.new_view(crowd_, 0), world_.new_view(crowd_, 3)};
    std::map<Key, bool> before;
    size_t entered = 0, left = 0;
    for (uint32_t step = 0; step < 120; ++step) {
        for (uint32_t k = 0; k < step % 4; ++k) world_.happen(crowd_, actors, 11, 1000 + 4 * step + k);
        turn(views[0], 0.9 * std::sin(0.2 * step)), turn(views[1], 0.7 * std::cos(0.31 * step));
        update(0.1 * step, {views, views + (step % 7 == 6 ? 0 : 1 + step % 2)});
        const std::map<Key, bool> now = seen(actors);
        std::map<Key, bool> wanted;
        for (const auto &[key, visible] : now) {
            const auto known = before.find(key);
            if (known == before.end() || known->second != visible) wanted[key] = visible;
        }
        const std::vector<clq_view_change> changes = told();
        std::map<Key, bool> found = by_id(changes);
        clq_actor first = {1, 1};  // that the world made, which is not in the list
        found.erase(key_of(first));
        EXPECT_EQ(found, wanted) << "step " << step;
        for (size_t i = 1; i < changes.size(); ++i)
            EXPECT_LT(changes[i - 1].actor.index1, changes[i].actor.index1) << "in the order of ids";
        for (const auto &change : wanted) change.second ? ++entered : ++left;
        before = now;
    }
    EXPECT_GT(entered, 100u);
    EXPECT_GT(left, 100u);
}

TEST_F(ViewChanges, AreEmptyWhereNothingChanges)
{
    world_.fill(crowd_, 40, 5);
    clq_view *view = world_.new_view(crowd_, 0);
    EXPECT_TRUE(told().empty()) << "before the first update";
    update(1, {view});
    EXPECT_GE(told().size(), 41u) << "the first update tells of all";
    update(1, {view});
    EXPECT_TRUE(told().empty());
    clq_crowd_update(crowd_, NAN, &view, 1);
    EXPECT_TRUE(told().empty()) << "an update that fails changes nothing";
}

TEST_F(ViewChanges, LeaveOutActorsThatAreGoneAndTellOfThoseThatCameInTheirRow)
{
    clq_view *view = world_.new_view(crowd_, 0);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = world_.templates[0], def.transform.position[2] = -8;
    clq_actor actor, next;
    ASSERT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_OK);
    turn(view, 0);
    update(1, {view});
    ASSERT_TRUE(by_id(told())[key_of(actor)]);
    ASSERT_EQ(clq_actor_destroy(crowd_, actor), CLQ_OK);
    EXPECT_EQ(by_id(told()).count(key_of(actor)), 0u);
    ASSERT_EQ(clq_actor_create(crowd_, &def, &next), CLQ_OK);
    ASSERT_EQ(next.index1, actor.index1);
    EXPECT_EQ(by_id(told()).count(key_of(next)), 0u) << "no update has known it";
    update(1, {view});
    const std::map<Key, bool> found = by_id(told());
    ASSERT_EQ(found.count(key_of(next)), 1u);
    EXPECT_TRUE(found.at(key_of(next)));
    EXPECT_EQ(found.count(key_of(actor)), 0u);
}

TEST_F(ViewChanges, TellOfAllAfterACrowdIsRestored)
{
    const std::vector<clq_actor> actors = world_.fill(crowd_, 30, 7);
    clq_view *view = world_.new_view(crowd_, 0);
    const saved::Bytes bytes = saved::save(crowd_);
    update(1, {view});
    ASSERT_EQ(clq_crowd_restore(crowd_, bytes.data(), bytes.size(), world_.templates, 2), CLQ_OK) << clq_last_error();
    EXPECT_TRUE(told().empty());
    update(1, {view});
    const std::map<Key, bool> found = by_id(told());
    for (const auto &[key, visible] : seen(actors)) {
        ASSERT_EQ(found.count(key), 1u);
        EXPECT_EQ(found.at(key), visible);
    }
}

TEST_F(ViewChanges, AreRefusedWithoutRoom)
{
    world_.fill(crowd_, 30, 7);
    clq_view *view = world_.new_view(crowd_, 0);
    update(1, {view});
    clq_view_change one = {{77, 77}, true};
    size_t count = 5;
    EXPECT_EQ(clq_crowd_get_view_changes(crowd_, &one, 1, &count), CLQ_LIMIT);
    EXPECT_NE(std::string(clq_last_error()).find("there is room for 1"), std::string::npos) << clq_last_error();
    EXPECT_EQ(count, 5u);
    EXPECT_EQ(one.actor.index1, 77u);
    EXPECT_EQ(clq_crowd_get_view_changes(crowd_, nullptr, 1, &count), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_view_changes(crowd_, nullptr, 0, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_view_changes(nullptr, nullptr, 0, &count), CLQ_ARGUMENT);
}

// Save and restore through the C API: a restored crowd shows, answers and continues as the saved one.
#include "tests/api/calls.h"
#include "tests/api/save_fixture.h"

namespace
{

using saved::Bytes;

class Save : public SaveFixture
{
};

double slope(void *, const double point[3]) { return 0.1 * point[0]; }

}  // namespace

TEST_F(Save, ARestoredFreshCrowdContinuesLikeTheSavedOne)
{
    const Bytes bytes = saved::save(crowd_);
    clq_crowd *fresh = test_world_.new_crowd();
    test_world_.set_up(fresh);
    ASSERT_EQ(restore(fresh, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_get_hash(fresh), clq_crowd_get_hash(crowd_));
    EXPECT_EQ(clq_crowd_get_actor_count(fresh), clq_crowd_get_actor_count(crowd_));
    EXPECT_EQ(saved::save(fresh), bytes);
    const std::vector<uint64_t> shown = story(crowd_, actors_, 7);
    EXPECT_EQ(story(fresh, actors_, 7), shown);
    EXPECT_NE(shown[0], shown[198]) << "without motion this test shows nothing";
    EXPECT_EQ(saved::save(fresh), saved::save(crowd_)) << "the same calls gave the same ids";
}

TEST_F(Save, ACrowdGoesBackInTimeAndShowsTheSameAgain)
{
    clq_view *view = test_world_.new_view(crowd_, 0);
    const Bytes bytes = saved::save(crowd_);
    const std::vector<uint64_t> first = story(crowd_, actors_, 7);
    for (int take = 0; take < 3; ++take) {
        // Other frames in between, so that caches and lists are full of them.
        EXPECT_EQ(clq_crowd_update(crowd_, 3.02 + take, &view, 1), CLQ_OK);
        const uint64_t list = clq_view_get_hash(view);
        ASSERT_EQ(restore(crowd_, bytes), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_view_get_hash(view), list) << "lists stay until the next update";
        EXPECT_EQ(saved::save(crowd_), bytes);
        EXPECT_EQ(story(crowd_, actors_, 7), first);
    }
}

TEST_F(Save, AnotherCrowdsStateReplacesEverythingThatWasThere)
{
    clq_crowd *full = other();
    const std::vector<uint64_t> shown = story(crowd_, actors_, 7);
    const Bytes bytes = saved::save(crowd_);
    story(full, test_world_.fill(full, 60, 3), 9);
    ASSERT_EQ(restore(full, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(saved::save(full), bytes);
    clq_view *views[2] = {test_world_.new_view(crowd_, 0), test_world_.new_view(full, 0)};
    for (int frame = 0; frame < 20; ++frame) {
        ASSERT_EQ(clq_crowd_update(crowd_, 9 + 0.1 * frame, &views[0], 1), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(full, 9 + 0.1 * frame, &views[1], 1), CLQ_OK);
        ASSERT_EQ(clq_view_get_hash(views[1]), clq_view_get_hash(views[0])) << frame;
    }
}

TEST_F(Save, IdsAreValidAgainAndStaleWhereTheyWereStale)
{
    const clq_actor gone = actors_[3];
    ASSERT_EQ(clq_actor_destroy(crowd_, gone), CLQ_OK);
    clq_attachment object, lost;
    const float centre[3] = {0, 0, 0};
    ASSERT_EQ(api_test::attach(crowd_, actors_[4], 0, centre, 1, &lost), CLQ_OK);
    ASSERT_EQ(clq_actor_detach(crowd_, lost), CLQ_OK);
    ASSERT_EQ(api_test::attach(crowd_, actors_[4], 0, centre, 9, &object), CLQ_OK);
    clq_actor_info before = clq_actor_info_init(), after = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd_, actors_[4], &before), CLQ_OK);
    const Bytes bytes = saved::save(crowd_);
    clq_crowd *crowd = other();
    clq_view *view = test_world_.new_view(crowd, 0);
    ASSERT_EQ(clq_crowd_update(crowd, 1, &view, 1), CLQ_OK);
    ASSERT_EQ(restore(crowd, bytes), CLQ_OK) << clq_last_error();
    for (const clq_actor actor : actors_)
        if (clq_actor_get_info(crowd, actor, &after) == CLQ_OK) {
            EXPECT_EQ(after.visible, 0) << "no actor has been visible since";
        }
    EXPECT_EQ(clq_actor_destroy(crowd, gone), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_detach(crowd, lost), CLQ_STALE_ID);
    ASSERT_EQ(clq_actor_get_info(crowd, actors_[4], &after), CLQ_OK);
    EXPECT_EQ(after.sklsroot_radius, before.sklsroot_radius);
    EXPECT_EQ(after.refpoint_radius, before.refpoint_radius);
    EXPECT_EQ(clq_actor_detach(crowd, object), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_actor_get_info(crowd, actors_[4], &after), CLQ_OK);
    EXPECT_LT(after.sklsroot_radius, before.sklsroot_radius) << "attached objects are held by their actors again";
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = test_world_.templates[1];
    clq_actor next, same;
    ASSERT_EQ(clq_actor_create(crowd_, &def, &next), CLQ_OK);
    ASSERT_EQ(clq_actor_create(crowd, &def, &same), CLQ_OK);
    EXPECT_EQ(same.index1, next.index1);
    EXPECT_EQ(same.generation, next.generation);
}

// Objects that were attached in another order than that of their slots are freed in the same order after a restore.
TEST_F(Save, LaterObjectsGetTheSameIdsInARestoredCrowd)
{
    const auto attach = [](clq_crowd *crowd, clq_actor to) {
        clq_attachment_def def = clq_attachment_def_init();
        def.radius = 0.1f;
        clq_attachment made = {};
        EXPECT_EQ(clq_actor_attach(crowd, to, &def, &made), CLQ_OK) << clq_last_error();
        return made;
    };
    const clq_attachment first = attach(crowd_, actors_[0]), second = attach(crowd_, actors_[1]);
    EXPECT_EQ(clq_actor_detach(crowd_, first), CLQ_OK);
    const clq_attachment third = attach(crowd_, actors_[1]);
    EXPECT_EQ(third.index1, first.index1) << "below the slot of the object that the actor had already";
    EXPECT_LT(third.index1, second.index1);
    const saved::Bytes bytes = saved::save(crowd_);
    clq_crowd *restored = other();
    ASSERT_EQ(restore(restored, bytes), CLQ_OK) << clq_last_error();
    for (clq_crowd *crowd : {crowd_, restored}) EXPECT_EQ(clq_actor_destroy(crowd, actors_[1]), CLQ_OK);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(attach(crowd_, actors_[2]).index1, attach(restored, actors_[2]).index1);
    EXPECT_EQ(clq_crowd_get_hash(crowd_), clq_crowd_get_hash(restored));
}

TEST_F(Save, TheGroundStaysWithTheCrowd)
{
    for (const clq_actor actor : actors_) ASSERT_EQ(clq_actor_follow_ground(crowd_, actor, 5, 5), CLQ_OK);
    const Bytes bytes = saved::save(crowd_);
    ASSERT_EQ(clq_crowd_set_ground(crowd_, slope, nullptr), CLQ_OK);
    EXPECT_EQ(saved::save(crowd_), bytes) << "callbacks are not part of the state";
    clq_crowd *fresh = test_world_.new_crowd();
    test_world_.set_up(fresh);
    ASSERT_EQ(clq_crowd_set_ground(fresh, slope, nullptr), CLQ_OK);
    ASSERT_EQ(restore(fresh, bytes), CLQ_OK) << clq_last_error();
    EXPECT_EQ(story(fresh, actors_, 3), story(crowd_, actors_, 3));
}

TEST_F(Save, HostMechanismsAreMatchedByNumberOrRefused)
{
    const Bytes bytes = saved::save(crowd_);
    clq_crowd *bare = test_world_.new_crowd();
    const uint64_t before = clq_crowd_get_hash(bare);
    EXPECT_EQ(restore(bare, bytes), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("mechanism 6 of the saved crowd is the host's own"), std::string::npos)
        << clq_last_error();
    EXPECT_EQ(clq_crowd_get_hash(bare), before);

    // A mechanism with memory where the saved one has none.
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = test_world_.templates[0];
    clq_actor actor;
    ASSERT_EQ(clq_actor_create(bare, &def, &actor), CLQ_OK);
    clq_mechanism_def wanted = test_world_.mechanism(TestWorld::host);
    wanted.host.has_memory = 1;
    clq_mechanism made;
    for (int i = 0; i < 6; ++i) ASSERT_EQ(clq_crowd_add_mechanism(bare, &wanted, &made), CLQ_OK);
    EXPECT_EQ(restore(bare, bytes), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("mechanism 6, the host's own, keeps a memory here"), std::string::npos)
        << clq_last_error();
}

TEST_F(Save, TemplatesAreFoundByNameAndStructure)
{
    const Bytes bytes = saved::save(crowd_);
    const auto with = [&](std::vector<clq_template *> templates) {
        return clq_crowd_restore(crowd_, bytes.data(), bytes.size(), templates.data(),
                                 static_cast<uint32_t>(templates.size()));
    };
    const auto says = [](const char *sentence) {
        return std::string(clq_last_error()).find(sentence) != std::string::npos ? "" : clq_last_error();
    };
    const uint64_t before = clq_crowd_get_hash(crowd_);
    EXPECT_EQ(with({test_world_.templates[1]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 'figure' of the saved crowd is not among those given"), "");
    EXPECT_EQ(with({test_world_.templates[0], test_world_.templates[0]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("templates 0 and 1 are the same"), "");
    EXPECT_EQ(with({test_world_.templates[0], nullptr}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 1 is NULL"), "");
    EXPECT_EQ(clq_crowd_restore(crowd_, bytes.data(), bytes.size(), nullptr, 2), CLQ_ARGUMENT);
    EXPECT_STREQ(says("templates is NULL with a count of 2"), "");
    test_world_.dofs[TestWorld::turn].max = 0.9f;
    clq_template *changed = nullptr, *foreign = nullptr, *same = nullptr;
    ASSERT_EQ(clq_template_build(test_world_.context, &test_world_.with_dofs.def, &changed), CLQ_OK);
    test_world_.dofs[TestWorld::turn].max = 1;
    EXPECT_EQ(with({changed, test_world_.templates[1]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 'figure' is not the one that the saved crowd used"), "");
    TestWorld abroad;
    EXPECT_EQ(with({test_world_.templates[0], abroad.templates[1]}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 1 was made from another context"), "");
    EXPECT_EQ(clq_crowd_get_hash(crowd_), before);
    // A template that was rebuilt is accepted in any order, and the crowd keeps it alive.
    ASSERT_EQ(clq_template_build(test_world_.context, &test_world_.with_dofs.def, &same), CLQ_OK);
    EXPECT_EQ(with({changed, test_world_.templates[1], same}), CLQ_ARGUMENT);
    EXPECT_STREQ(says("follows a track of hash"), "");
    test_world_.add_tracks_for(crowd_, same);
    EXPECT_EQ(with({changed, test_world_.templates[1], same}), CLQ_OK) << clq_last_error();
    for (clq_template *tmpl : {changed, foreign, same}) clq_template_destroy(tmpl);
    EXPECT_EQ(saved::save(crowd_), bytes);
    clq_actor_info info = clq_actor_info_init();
    ASSERT_EQ(clq_actor_get_info(crowd_, actors_[0], &info), CLQ_OK);
    EXPECT_EQ(info.tmpl, same);
    story(crowd_, actors_, 3);
}

TEST_F(Save, NoCacheConfusesPosesOfTwoStates)
{
    clq_crowd *fresh = test_world_.new_crowd();
    test_world_.set_up(crowd_ = test_world_.new_crowd());
    test_world_.set_up(fresh);
    const clq_transform in_front = {{0, 1, -8}, {0, 0, 0, 1}, 1};
    const clq_mechanism_attachment use = {{TestWorld::gaze + 1}, 1, 0, 0};
    const clq_actor actor = {1, 1};
    ASSERT_EQ(clq_crowd_set_transforms(crowd_, &actor, &in_front, 1), CLQ_OK);
    ASSERT_EQ(clq_actor_attach_mechanism(crowd_, actor, &use), CLQ_OK);
    // Two states that differ only in the gaze target of one actor.
    Bytes states[2];
    for (int i = 0; i < 2; ++i) {
        const double point[3] = {i ? 9.0 : -9.0, 1, 2};
        ASSERT_EQ(clq_actor_gaze(crowd_, actor, {TestWorld::gaze + 1}, point, 0), CLQ_OK);
        states[i] = saved::save(crowd_);
    }
    clq_view *view = test_world_.new_view(crowd_, 0), *fresh_view = test_world_.new_view(fresh, 0);
    uint64_t last = 0;
    for (int take = 0; take < 4; ++take) {
        ASSERT_EQ(restore(crowd_, states[take % 2]), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_update(crowd_, 5, &view, 1), CLQ_OK);
        if (take < 2) {
            ASSERT_EQ(restore(fresh, states[take]), CLQ_OK) << clq_last_error();
            ASSERT_EQ(clq_crowd_update(fresh, 5, &fresh_view, 1), CLQ_OK);
            EXPECT_EQ(clq_view_get_hash(view), clq_view_get_hash(fresh_view)) << take;
        }
        EXPECT_NE(clq_view_get_hash(view), last) << take;
        last = clq_view_get_hash(view);
    }
}

TEST_F(Save, AWriterThatRefusesStopsIt)
{
    const auto none = [](void *, const void *, size_t) { return 1; };
    EXPECT_EQ(clq_crowd_save(crowd_, none, nullptr), CLQ_IO);
    EXPECT_NE(std::string(clq_last_error()).find("the writer refused"), std::string::npos) << clq_last_error();
    int left = 2;
    const auto few = [](void *user, const void *, size_t) { return --*static_cast<int *>(user) < 0 ? 1 : 0; };
    EXPECT_EQ(clq_crowd_save(crowd_, few, &left), CLQ_IO);
    EXPECT_EQ(left, -1) << "it is not asked again";
    EXPECT_EQ(clq_crowd_save(nullptr, few, &left), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_save(crowd_, nullptr, nullptr), CLQ_ARGUMENT);
    const auto meddle = [](void *user, const void *, size_t) {
        return clq_group_create(static_cast<clq_crowd *>(user), nullptr, nullptr) == CLQ_BUSY ||
                       clq_crowd_update(static_cast<clq_crowd *>(user), 0, nullptr, 0) == CLQ_BUSY
                   ? 0
                   : 1;
    };
    EXPECT_EQ(clq_crowd_save(crowd_, meddle, crowd_), CLQ_OK) << clq_last_error();
}

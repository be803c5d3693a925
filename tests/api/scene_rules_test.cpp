// What a scene refuses, and the rules that do not need a crowd at random: stale ids, numbers out of range, several
// scenes, what is kept and what ends.
#include <cmath>

#include "tests/api/scene_people.h"

namespace
{

class SceneRules : public testing::Test
{
protected:
    SceneRules() : crowd_(3) { crowd_.fill(20); }

    clq_actor first() const { return crowd_.people[0].id; }
    clq_scene *scene() const { return crowd_.scene; }
    uint32_t count_of(uint64_t category, const clq_scene *scene) const
    {
        clq_scene_filter filter = clq_scene_filter_init();
        filter.all_of = category;
        uint32_t count = 99;
        EXPECT_EQ(clq_scene_find(scene, &filter, nullptr, 0, &count), CLQ_OK) << clq_last_error();
        return count;
    }

    scene_people::Crowd crowd_;
    uint32_t count_ = 99;
    clq_scene_hit hit_;
    clq_actor found_ = {9, 9};
    const double origin_[3] = {0, 0, 0}, nan_[3] = {0, NAN, 0};
};

TEST_F(SceneRules, StaleIdsAreRefusedAndChangeNothing)
{
    const clq_actor gone = first();
    ASSERT_EQ(clq_actor_destroy(crowd_.crowd, gone), CLQ_OK);
    const clq_actor both[2] = {crowd_.people[1].id, gone};
    const double keys[2] = {1, 2};
    EXPECT_EQ(clq_scene_set_categories(scene(), both, 2, 4), CLQ_STALE_ID);
    EXPECT_EQ(clq_scene_set_keys(scene(), both, keys, 2), CLQ_STALE_ID);
    EXPECT_EQ(count_of(4, scene()), 0u) << "all or none";
    EXPECT_EQ(clq_scene_find_keys(scene(), -9, 9, nullptr, nullptr, 0, &count_), CLQ_OK);
    EXPECT_EQ(count_, 0u);
    clq_scene_actor known = clq_scene_actor_init();
    EXPECT_EQ(clq_scene_get_actor(scene(), gone, 0, &known), CLQ_STALE_ID);
    EXPECT_EQ(clq_scene_find_next(scene(), gone, false, nullptr, &found_), CLQ_STALE_ID);
}

TEST_F(SceneRules, QuestionsThatMakeNoSenseAreRefusedAndWriteNothing)
{
    const double inf = HUGE_VAL;
    clq_scene *s = scene();
    EXPECT_EQ(clq_scene_find_within(s, NAN, origin_, 1, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_within(s, 0, nan_, 1, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_within(s, 0, origin_, -1, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_within(s, 0, nullptr, 1, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_within(s, 0, origin_, 1, nullptr, nullptr, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_nearest(s, 0, origin_, NAN, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_nearest(s, inf, origin_, 1, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_in_box(s, 0, origin_, nan_, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    const double below[3] = {0, -1, 0};
    EXPECT_EQ(clq_scene_find_in_box(s, 0, origin_, below, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    for (const clq_ray &ray : {clq_ray{{0, 0, 0}, {0, 0, 0}, 1}, clq_ray{{0, 0, 0}, {0, 0, 1}, -1},
                               clq_ray{{0, NAN, 0}, {0, 0, 1}, 1}, clq_ray{{0, 0, 0}, {0, inf, 1}, 1}})
        EXPECT_EQ(clq_scene_find_on_ray(s, 0, &ray, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT);
    clq_camera camera = {};
    EXPECT_EQ(clq_scene_find_in_frustum(s, 0, &camera, nullptr, &hit_, 1, &count_), CLQ_ARGUMENT) << "no rotation";
    EXPECT_EQ(clq_scene_find_keys(s, NAN, 1, nullptr, &found_, 1, &count_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_scene_find_next(s, first(), false, nullptr, &found_), CLQ_ARGUMENT) << "it has no key";
    EXPECT_NE(std::string(clq_last_error()).find("has no key"), std::string::npos);
    EXPECT_EQ(clq_scene_update(s, NAN), CLQ_ARGUMENT);
    clq_scene_filter filter = clq_scene_filter_init();
    filter.struct_bytes = 5;
    EXPECT_EQ(clq_scene_find(s, &filter, &found_, 1, &count_), CLQ_STRUCT_SIZE);
    EXPECT_EQ(count_, 99u);
    EXPECT_EQ(found_.index1, 9u);
}

TEST_F(SceneRules, RaysOfCamerasThatHaveNoneAreRefused)
{
    clq_ray ray;
    clq_camera camera;
    const clq_look_at_def def = clq_look_at_def_init();
    ASSERT_EQ(clq_camera_look_at(&def, &camera), CLQ_OK);
    EXPECT_EQ(clq_camera_get_ray(&camera, 0, 0, &ray), CLQ_OK);
    EXPECT_NEAR(ray.direction[2], -1, 1e-6);
    EXPECT_NEAR(ray.origin[2], -0.1, 1e-6) << "on the near plane";
    EXPECT_EQ(clq_camera_get_ray(&camera, 1.5f, 0, &ray), CLQ_ARGUMENT);
    EXPECT_EQ(clq_camera_get_ray(&camera, 0, NAN, &ray), CLQ_ARGUMENT);
    for (float &x : camera.projection) x = 0;
    EXPECT_EQ(clq_camera_get_ray(&camera, 0, 0, &ray), CLQ_ARGUMENT);
}

TEST_F(SceneRules, ScenesOfOneCrowdHaveCategoriesOfTheirOwn)
{
    clq_scene *other = nullptr;
    ASSERT_EQ(clq_scene_create(crowd_.crowd, &other), CLQ_OK);
    const clq_actor id = first();
    ASSERT_EQ(clq_scene_set_categories(other, &id, 1, 8), CLQ_OK);
    EXPECT_EQ(count_of(8, other), 1u);
    EXPECT_EQ(count_of(8, scene()), 0u);
    EXPECT_EQ(count_of(0, other), uint32_t(crowd_.people.size()));
    ASSERT_EQ(clq_scene_destroy(other), CLQ_OK);
    crowd_.fill(40);
    EXPECT_EQ(count_of(0, scene()), 40u);
    EXPECT_EQ(clq_scene_destroy(nullptr), CLQ_OK);
}

TEST_F(SceneRules, CategoriesAndKeysEndWithTheActorWhoseRowIsUsedAgain)
{
    const clq_actor id = first();
    const double key = 7;
    ASSERT_EQ(clq_scene_set_categories(scene(), &id, 1, 2), CLQ_OK);
    ASSERT_EQ(clq_scene_set_keys(scene(), &id, &key, 1), CLQ_OK);
    ASSERT_EQ(clq_actor_destroy(crowd_.crowd, id), CLQ_OK);
    crowd_.people.erase(crowd_.people.begin());
    crowd_.fill(20);
    ASSERT_EQ(crowd_.people.back().id.index1, id.index1) << "the row was used again";
    for (int updated = 0; updated < 2; ++updated) {
        EXPECT_EQ(count_of(2, scene()), 0u);
        EXPECT_EQ(clq_scene_find_keys(scene(), 0, 9, nullptr, nullptr, 0, &count_), CLQ_OK);
        EXPECT_EQ(count_, 0u);
        ASSERT_EQ(clq_scene_update(scene(), 0), CLQ_OK);
    }
}

TEST_F(SceneRules, StatisticsCountWhatIsTakenOverAndItsMemory)
{
    clq_scene_stats before = clq_scene_stats_init(), after = before;
    ASSERT_EQ(clq_scene_update(scene(), 0), CLQ_OK);
    ASSERT_EQ(clq_scene_get_stats(scene(), &before), CLQ_OK);
    EXPECT_EQ(before.actor_count, 20u);
    EXPECT_EQ(before.marked, 0u);
    crowd_.fill(2000);
    ASSERT_EQ(clq_scene_get_stats(scene(), &after), CLQ_OK);
    EXPECT_EQ(after.marked, 1980u);
    ASSERT_EQ(clq_scene_update(scene(), 0), CLQ_OK);
    ASSERT_EQ(clq_scene_get_stats(scene(), &after), CLQ_OK);
    EXPECT_EQ(after.actor_count, 2000u);
    EXPECT_EQ(after.placed - before.placed, 1980u) << "each once";
    EXPECT_GT(after.bytes, before.bytes + 1980 * 150);
    EXPECT_LT(after.bytes, before.bytes + 1980 * 600);
    EXPECT_LE(after.height, 15u) << "balanced: 1.44 times the logarithm";
}

TEST_F(SceneRules, AnActorNowhereIsFoundByIdAndStateOnly)
{
    clq_group group;
    clq_transform huge = clq_transform_init(), far = clq_transform_init();
    huge.scale = 1e6f, far.position[0] = 1.7e308;
    ASSERT_EQ(clq_group_create(crowd_.crowd, &huge, &group), CLQ_OK);
    ASSERT_EQ(clq_actor_join(crowd_.crowd, first(), group, &far), CLQ_OK);
    for (int updated = 0; updated < 2; ++updated) {
        clq_scene_actor known = clq_scene_actor_init();
        ASSERT_EQ(clq_scene_get_actor(scene(), first(), 0, &known), CLQ_OK);
        EXPECT_FALSE(known.present);
        EXPECT_EQ(clq_scene_find_within(scene(), 0, origin_, HUGE_VAL, nullptr, nullptr, 0, &count_), CLQ_OK);
        EXPECT_EQ(count_, 19u);
        EXPECT_EQ(count_of(0, scene()), 20u);
        ASSERT_EQ(clq_scene_update(scene(), 0), CLQ_OK);
    }
}

}  // namespace

// A view that a scene has seen is destroyed: the scene forgets it, and goes on with the others and with new ones, even
// where a new one lies at the same address.
#include <cmath>

#include "tests/api/scene_people.h"

namespace
{

class SceneOfViews : public testing::Test
{
protected:
    SceneOfViews() : crowd_(5) { crowd_.fill(200); }

    uint64_t bytes() const
    {
        clq_scene_stats stats = clq_scene_stats_init();
        EXPECT_EQ(clq_scene_get_stats(crowd_.scene, &stats), CLQ_OK) << clq_last_error();
        return stats.bytes;
    }

    // What rays through a grid of the picture meet in a view's draw list.
    std::vector<uint32_t> met_in(const clq_view *view, double eye_x) const
    {
        const double eye[3] = {eye_x, 2, 4}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        clq_camera camera;
        EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 0.9f, 1.3f, 0.1f, 200), CLQ_OK);
        std::vector<uint32_t> met;
        for (int y = -16; y <= 16; ++y)
            for (int x = -16; x <= 16; ++x) {
                clq_ray ray;
                clq_scene_pick found = clq_scene_pick_init();
                EXPECT_EQ(clq_camera_get_ray(&camera, float(x) / 16, float(y) / 16, &ray), CLQ_OK);
                EXPECT_EQ(clq_scene_pick_triangle(crowd_.scene, view, &ray, nullptr, &found), CLQ_OK);
                met.push_back(found.actor.index1);
            }
        return met;
    }

    std::vector<uint32_t> levels() const
    {
        std::vector<uint32_t> all;
        for (const scene_people::Person &person : crowd_.people) {
            clq_scene_actor known = clq_scene_actor_init();
            EXPECT_EQ(clq_scene_get_actor(crowd_.scene, person.id, 1, &known), CLQ_OK) << clq_last_error();
            all.push_back(known.level);
        }
        return all;
    }

    scene_people::Crowd crowd_;
};

TEST_F(SceneOfViews, ForgetsOneThatIsDestroyedAndGoesOnWithTheOthers)
{
    clq_view *seen[2] = {crowd_.views[0], crowd_.views[1]};
    ASSERT_EQ(clq_crowd_update(crowd_.crowd, 1, seen, 2), CLQ_OK) << clq_last_error();
    const std::vector<uint32_t> first = met_in(seen[0], 0), second = met_in(seen[1], 12), shown = levels();
    const std::vector<uint32_t> nothing(first.size(), 0);
    ASSERT_NE(first, nothing);
    ASSERT_NE(second, nothing);
    ASSERT_NE(first, second);
    ASSERT_EQ(clq_view_destroy(seen[0]), CLQ_OK) << clq_last_error();
    EXPECT_EQ(met_in(seen[1], 12), second);
    EXPECT_EQ(levels(), shown);
    clq_view *again = crowd_.world->new_view(crowd_.crowd, 0);
    EXPECT_EQ(met_in(again, 0), nothing) << "its list is empty until an update";
    seen[0] = again;
    ASSERT_EQ(clq_crowd_update(crowd_.crowd, 1, seen, 2), CLQ_OK) << clq_last_error();
    EXPECT_EQ(met_in(again, 0), first);
    EXPECT_EQ(met_in(seen[1], 12), second);
}

TEST_F(SceneOfViews, GivesBackTheMemoryOfThoseThatAreDestroyed)
{
    ASSERT_EQ(clq_crowd_update(crowd_.crowd, 1, nullptr, 0), CLQ_OK) << clq_last_error();
    const uint64_t before = bytes();
    std::vector<clq_view *> views;
    for (int k = 0; k < 16; ++k) views.push_back(crowd_.world->new_view(crowd_.crowd, k));
    ASSERT_EQ(clq_crowd_update(crowd_.crowd, 1, views.data(), 16), CLQ_OK) << clq_last_error();
    const uint64_t with = bytes();
    EXPECT_GT(with, before + 16 * crowd_.people.size() * 4) << "an item for each individual and view";
    for (clq_view *view : views) ASSERT_EQ(clq_view_destroy(view), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_crowd_update(crowd_.crowd, 1, nullptr, 0), CLQ_OK) << clq_last_error();
    EXPECT_LT(bytes() - before, (with - before) / 8);
}

}  // namespace

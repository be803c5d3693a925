// A depth camera by rays sees what a visibility picture shows; a lidar turns once and counts its rings.
#include <cmath>
#include <set>

#include "samples/hosts/range/sensor.h"
#include "tests/visibility/people.h"

namespace
{

using namespace visibility_test;

class RangeSensor : public People
{
};

TEST_F(RangeSensor, AsADepthCameraSeesTheVisibilityPicture)
{
    size_t shown = 0, different = 0;
    for (uint64_t seed = 400; seed < 420; ++seed) {
        place(seed, 4);
        update(static_cast<double>(seed));
        draw();
        const Channels found = channels();
        const range::RayScene scene({{view_, camera_}}, std::nan(""));
        const std::vector<range::Return> returns = scene.cast(range::rays_of(camera_, width, height, 100));
        for (size_t i = 0; i < returns.size(); ++i) {
            shown += found.actors[i] != 0;
            if (returns[i].actor != found.actors[i] || (returns[i].actor != 0 && returns[i].zone != found.zones[i])) {
                ++different;
                continue;
            }
            if (returns[i].actor == 0) continue;
            double square = 0;
            for (size_t k = 0; k < 3; ++k) {
                const double along = found.positions[3 * i + k] - camera_.eye[k];
                square += along * along;
            }
            // A silhouette's triangles are nearly edge on: a part of a pixel is much depth there.
            if (std::fabs(std::sqrt(square) - static_cast<double>(returns[i].distance)) > 0.02) ++different;
        }
    }
    EXPECT_GT(shown, 2000u);
    EXPECT_LT(different, shown / 50) << different << " of " << shown;
}

TEST(Lidar, TurnsOnceThroughAllOfItsRings)
{
    range::Lidar lidar;
    lidar.rings = 3, lidar.steps = 4, lidar.lowest_deg = -30, lidar.highest_deg = 30;
    const std::vector<range::Ray> rays = rays_of(lidar);
    ASSERT_EQ(rays.size(), 12u);
    EXPECT_NEAR(static_cast<double>(rays[0].direction[1]), -0.5, 1e-6);
    EXPECT_NEAR(static_cast<double>(rays[4].direction[0]), 1, 1e-6);
    EXPECT_NEAR(static_cast<double>(rays[5].direction[2]), -1, 1e-6);
    EXPECT_NEAR(static_cast<double>(rays[11].direction[1]), 0.5, 1e-6);
}

TEST_F(RangeSensor, SeesPeopleAllRoundItThroughItsFourViews)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.period_near_s = def.period_far_s = 0;
    clq_crowd *crowd = nullptr;
    scenes::check(clq_crowd_create(library_.context(), &def, &crowd));
    crowd_.reset(crowd);
    std::set<uint32_t> all, met;
    for (int i = 0; i < 24; ++i) {
        clq_actor_def actor_def = clq_actor_def_init();
        actor_def.tmpl = library_.builtin("citizen");
        actor_def.transform.position[0] = 6 * std::cos(0.2618 * i),
        actor_def.transform.position[2] = 6 * std::sin(0.2618 * i);
        clq_actor actor = {};
        scenes::check(clq_actor_create(crowd, &actor_def, &actor));
        all.insert(actor.index1);
    }
    const range::Lidar lidar;
    std::vector<range::Look> looks;
    std::vector<clq_view *> views;
    for (const clq_camera &camera : range::cameras_round({0, 1.5, 0}, lidar)) {
        clq_view *view = nullptr;
        scenes::check(clq_view_create(crowd, &view));
        scenes::check(clq_view_set_camera(view, &camera));
        views.push_back(view), looks.push_back({view, camera});
    }
    scenes::check(clq_crowd_update(crowd, 0, views.data(), 4));
    const range::RayScene scene(looks, 0);
    size_t ground = 0;
    for (const range::Return &one : scene.cast(rays_of(lidar))) {
        if (one.actor != 0) met.insert(one.actor);
        if (one.actor != 0 || one.distance < 0) continue;
        ++ground;
        EXPECT_GT(std::fabs(one.normal[1]), 0.99f);
    }
    EXPECT_EQ(met, all);
    EXPECT_GT(ground, 1000u);
    EXPECT_EQ(scene.triangle_count() % 24, 0u) << "each person once, although views overlap";
}

}  // namespace

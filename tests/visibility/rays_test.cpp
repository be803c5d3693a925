// Every channel against a ray a pixel: ids are equal but where GL may round, and what is computed from them is that of
// the point that the ray meets.
#include "tests/visibility/rays.h"

#include <claque/scene.h>

#include <cmath>

#include "tests/visibility/people.h"

namespace
{

using namespace visibility_test;

class Labels : public People
{
protected:
    struct Pixel {
        int x, y;
        size_t index;
    };
    // Those that show an individual.
    static std::vector<Pixel> shown_in(const Channels &found)
    {
        std::vector<Pixel> out;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const size_t i = static_cast<size_t>(y) * width + static_cast<size_t>(x);
                if (found.individuals[i] != CLQ_NONE) out.push_back({x, y, i});
            }
        return out;
    }
};

// Where GL may round: a centre within 1/128 pixel of an edge, or two depths within a step of the buffer of 24 bits.
bool may_round(const Hit &hit) { return hit.edge_px < 1.0 / 128 || hit.step < 2.0 / (1 << 24); }

TEST_F(Labels, AreThoseOfARayAPixelOnTwoHundredRandomPictures)
{
    size_t compared = 0, rounded = 0, shown = 0;
    for (uint64_t seed = 1; seed <= 200; ++seed) {
        place(seed, 2 + seed % 4);
        update(static_cast<double>(seed) * 0.37);
        draw();
        const Channels found = channels();
        const std::vector<Body> bodies = bodies_of(view_);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const size_t i = static_cast<size_t>(y) * width + static_cast<size_t>(x);
                const Hit hit = hit_at(bodies, camera_, width, height, x, y);
                ++compared;
                const bool same =
                    found.individuals[i] == hit.body && (hit.body == CLQ_NONE || found.triangles[i] == hit.triangle);
                if (!same && may_round(hit)) {
                    ++rounded;
                    continue;
                }
                ASSERT_EQ(found.individuals[i], hit.body) << "picture " << seed << ", pixel " << x << ", " << y;
                if (hit.body == CLQ_NONE) {
                    ASSERT_TRUE(std::isnan(found.depth_m[i]));
                    ASSERT_EQ(found.actors[i], 0u);
                    ASSERT_EQ(found.zones[i], CLQ_NONE);
                    continue;
                }
                ++shown;
                ASSERT_EQ(found.triangles[i], hit.triangle) << "picture " << seed << ", pixel " << x << ", " << y;
                const Body &body = bodies[hit.body];
                ASSERT_EQ(found.actors[i], body.drawn.actor.index1);
                ASSERT_NEAR(static_cast<double>(found.depth_m[i]) / -hit.eye[2], 1, 1e-5);
                for (size_t k = 0; k < 3; ++k)
                    ASSERT_NEAR(static_cast<double>(found.barycentric[3 * i + k]), hit.weights[k], 1e-4);
                const uint32_t zone = body.triangles[hit.triangle].zone;
                if (zone != CLQ_NONE) ASSERT_EQ(found.zones[i], zone);
                else ASSERT_NE(found.zones[i], CLQ_NONE);
            }
    }
    RecordProperty("pixels", static_cast<int>(compared));
    RecordProperty("rounded", static_cast<int>(rounded));
    EXPECT_GT(shown, compared / 50);
    EXPECT_LT(rounded, shown / 200) << rounded << " of " << shown << " pixels of people";
}

TEST_F(Labels, HavePointsInTheWorldWithNormalsTowardsTheEye)
{
    size_t towards = 0, shown = 0;
    for (uint64_t seed = 300; seed < 310; ++seed) {
        place(seed, 4);
        update(static_cast<double>(seed));
        draw();
        const Channels found = channels();
        const std::vector<Body> bodies = bodies_of(view_);
        for (const auto [x, y, i] : shown_in(found)) {
            // From the world to the eye by the camera's quaternion, written out.
            const double *p = &found.positions[3 * i];
            const double v[3] = {p[0] - camera_.eye[0], p[1] - camera_.eye[1], p[2] - camera_.eye[2]};
            const float *q = camera_.rotation_xyzw;
            const double a = static_cast<double>(q[0]), b = static_cast<double>(q[1]), c = static_cast<double>(q[2]),
                         w = static_cast<double>(q[3]);
            const double t[3] = {2 * (b * v[2] - c * v[1]), 2 * (c * v[0] - a * v[2]), 2 * (a * v[1] - b * v[0])};
            const Point eye = {v[0] + w * t[0] + b * t[2] - c * t[1], v[1] + w * t[1] + c * t[0] - a * t[2],
                               v[2] + w * t[2] + a * t[1] - b * t[0]};
            const auto at = pixel_of(camera_, width, height, eye);
            ASSERT_NEAR(at[0], x + 0.5, 0.02);
            ASSERT_NEAR(at[1], y + 0.5, 0.02);
            const float *n = &found.normals[3 * i];
            double length = 0, along = 0;
            for (size_t k = 0; k < 3; ++k) {
                length += static_cast<double>(n[k]) * static_cast<double>(n[k]);
                along += static_cast<double>(n[k]) * (camera_.eye[k] - p[k]);
            }
            ASSERT_NEAR(length, 1, 1e-5);
            ++shown;
            towards += along > 0;
        }
    }
    // Normals between corners may turn away at the very rim.
    EXPECT_GT(shown, 500u);
    EXPECT_GT(static_cast<double>(towards), 0.97 * static_cast<double>(shown));
}

// A pick searches the draw list's triangles by itself, and knows the part and the texel's zone of what it meets.
TEST_F(Labels, HaveThePartAndZoneThatAPickFinds)
{
    size_t compared = 0, other_parts = 0, several_zones = 0;
    for (uint64_t seed = 400; seed < 420; ++seed) {
        place(seed, 5);
        clq_scene *made = nullptr;
        scenes::check(clq_scene_create(crowd_.get(), &made));
        const std::unique_ptr<clq_scene, clq_status (*)(clq_scene *)> scene(made, clq_scene_destroy);
        update(static_cast<double>(seed));
        draw();
        const Channels found = channels();
        const std::vector<Body> bodies = bodies_of(view_);
        for (const auto [x, y, i] : shown_in(found)) {
            clq_ray ray = {};
            scenes::check(clq_camera_get_ray(&camera_, 2 * (static_cast<float>(x) + 0.5f) / width - 1,
                                             2 * (static_cast<float>(y) + 0.5f) / height - 1, &ray));
            clq_scene_pick pick = clq_scene_pick_init();
            scenes::check(clq_scene_pick_triangle(scene.get(), view_, &ray, nullptr, &pick));
            const Body::Triangle &triangle = bodies[found.individuals[i]].triangles[found.triangles[i]];
            if (pick.actor.index1 != found.actors[i] ||
                !std::equal(pick.vertices, pick.vertices + 3, triangle.corners.begin()))
                continue;  // rounded to a neighbour, see above
            ++compared;
            ASSERT_EQ(found.parts[i], pick.part) << "picture " << seed << ", pixel " << x << ", " << y;
            other_parts += pick.part != 0;
            if (triangle.zone != CLQ_NONE) continue;
            ++several_zones;
            ASSERT_EQ(found.zones[i], pick.zone) << "picture " << seed << ", pixel " << x << ", " << y;
        }
    }
    EXPECT_GT(compared, 1000u);
    EXPECT_GT(other_parts, 100u);
    EXPECT_GT(several_zones, 50u);
}

}  // namespace

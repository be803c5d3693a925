// Optical flow closes: a point that is moved by its flow lies where its triangle is at that time.
#include <cmath>

#include "tests/visibility/people.h"
#include "tests/visibility/rays.h"

namespace
{

using namespace visibility_test;
using scenes::check;

class Flow : public People
{
protected:
    std::vector<float> flow_to(double time_s, const clq_camera &camera)
    {
        clq_flow_def def = clq_flow_def_init();
        def.time_s = time_s, def.camera = camera;
        std::vector<float> out(2 * numbers_.size());
        const clq_pixels given = pixels();
        check(clq_view_get_flow(view_, &given, &def, out.data()));
        return out;
    }
    // The camera a step further, turned a little.
    clq_camera next_camera(double by) const
    {
        clq_camera out = camera_;
        out.eye[0] += 0.3 * by, out.eye[1] += 0.1 * by;
        return out;
    }
};

TEST_F(Flow, IsNothingAtTheSameTimeAndCamera)
{
    place(7, 4);
    update(2.5);
    draw();
    const std::vector<float> flow = flow_to(2.5, camera_);
    size_t shown = 0;
    for (size_t i = 0; i < numbers_.size(); ++i) {
        if (numbers_[i] == 0) {
            ASSERT_TRUE(std::isnan(flow[2 * i]));
            continue;
        }
        ++shown;
        ASSERT_NEAR(static_cast<double>(flow[2 * i]), 0, 0.02);
        ASSERT_NEAR(static_cast<double>(flow[2 * i + 1]), 0, 0.02);
    }
    EXPECT_GT(shown, 50u);
}

TEST_F(Flow, LeadsToWhereTheTriangleIsThenForwardsAndBackwards)
{
    double farthest = 0;
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        place(seed, 3);
        const double time_s = static_cast<double>(seed) * 0.61, then_s = time_s + (seed % 2 == 0 ? 0.1 : -0.1);
        update(time_s);
        draw();
        const Channels found = channels();
        const clq_camera then = next_camera(then_s - time_s);
        const std::vector<float> flow = flow_to(then_s, then);
        const std::vector<Body> before = bodies_of(view_);
        // The same crowd at the other time, seen by that camera. Its levels hardly change; where one does, it is left
        // out.
        check(clq_view_set_camera(view_, &then));
        check(clq_crowd_update(crowd_.get(), then_s, &view_, 1));
        const std::vector<Body> after = bodies_of(view_);
        for (size_t i = 0; i < numbers_.size(); ++i) {
            if (found.individuals[i] == CLQ_NONE) continue;
            const Body &from = before[found.individuals[i]];
            const Body *to = nullptr;
            for (const Body &one : after)
                if (one.drawn.actor.index1 == from.drawn.actor.index1 && one.drawn.level == from.drawn.level) to = &one;
            if (!to) continue;
            Point eye = {0, 0, 0};
            for (size_t k = 0; k < 3; ++k)
                for (size_t j = 0; j < 3; ++j)
                    eye[j] +=
                        static_cast<double>(found.barycentric[3 * i + k]) * to->triangles[found.triangles[i]].eye[k][j];
            const auto at = pixel_of(then, width, height, eye);
            const double x = static_cast<double>(i % width) + 0.5, y = static_cast<double>(i / width) + 0.5;
            ASSERT_NEAR(x + static_cast<double>(flow[2 * i]), at[0], 0.02) << "picture " << seed;
            ASSERT_NEAR(y + static_cast<double>(flow[2 * i + 1]), at[1], 0.02) << "picture " << seed;
            farthest = std::max(farthest, std::hypot(at[0] - x, at[1] - y));
        }
    }
    EXPECT_GT(farthest, 1);
}

TEST_F(Flow, OfAnActorThatIsGoneIsNotANumber)
{
    place(11, 2);
    update(1);
    draw();
    const Channels found = channels();
    check(clq_actor_destroy(crowd_.get(), actors_[0]));
    const std::vector<float> flow = flow_to(1.1, camera_);
    for (size_t i = 0; i < numbers_.size(); ++i)
        ASSERT_EQ(std::isnan(flow[2 * i]), found.actors[i] != actors_[1].index1);
}

}  // namespace

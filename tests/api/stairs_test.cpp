// Tracks on ground that the host knows: their steps stand on it, and need it no more once they are made.
#include <stdexcept>

#include "tests/api/walkers.h"

using walkers::Walkers;

namespace
{

double tread(double x) { return 0.2 * std::floor(x / 0.4); }

class OnStairs : public Walkers
{
protected:
    // Up along x, with the path as a ramp through the middles of treads.
    clq_track *climb(clq_height_function ground, clq_status expected = CLQ_OK)
    {
        std::vector<clq_track_point> points;
        for (int i = 0; i <= 80; ++i) points.push_back({0.1 * i, {0.07 * i - 3, 0.5 * (0.07 * i - 3) - 0.1, 0}, NAN});
        clq_track_def def = clq_track_def_init();
        def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
        def.ground = ground, def.ground_user = &asked_;
        clq_track *made = nullptr;
        EXPECT_EQ(clq_track_create(locomotion_, &def, &made), expected) << clq_last_error();
        if (made) tracks_.push_back(made);
        return made;
    }
    static double stairs(void *user, const double point[3])
    {
        ++*static_cast<int *>(user);
        return tread(point[0]);
    }
    std::vector<uint64_t> lists(clq_track *track)
    {
        clq_crowd *crowd = this->crowd();
        walker(crowd, track);
        clq_view *view = this->view(crowd, 6);
        std::vector<uint64_t> all;
        for (const double t : {5.0, 1.0, 1.1, 3.3, 7.9, 0.2}) {
            EXPECT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK) << clq_last_error();
            EXPECT_EQ(visible(view), 1u) << t;
            all.push_back(clq_view_get_hash(view));
        }
        return all;
    }
    int asked_ = 0;
};

}  // namespace

TEST_F(OnStairs, HaveStepsAtTheHeightsOfTheTreads)
{
    clq_track *track = climb(stairs);
    size_t steps = 0, off_the_ramp = 0;
    for (uint32_t foot = 0; foot < 2; ++foot) {
        clq_track_plant plants[64];
        size_t count = 0;
        ASSERT_EQ(clq_track_get_plants(track, foot, 0, 8, plants, 64, &count), CLQ_OK) << clq_last_error();
        for (size_t i = 0; i < count; ++i, ++steps) {
            const double *at = plants[i].position;
            EXPECT_NEAR(at[1], tread(at[0]), 1e-5);
            off_the_ramp += std::fabs(at[1] - (0.5 * at[0] - 0.1)) > 0.03;
        }
    }
    EXPECT_GT(steps, 12u);
    EXPECT_GT(off_the_ramp, 4u);
}

TEST_F(OnStairs, NeedTheGroundNoMoreOnceTheyAreMade)
{
    clq_track *made = climb(stairs);
    const int asked = asked_;
    EXPECT_GT(asked, 30);
    std::vector<uint8_t> bytes;
    const auto keep = [](void *user, const void *more, size_t size) {
        const auto *first = static_cast<const uint8_t *>(more);
        auto &out = *static_cast<std::vector<uint8_t> *>(user);
        out.insert(out.end(), first, first + size);
        return 0;
    };
    ASSERT_EQ(clq_track_save(made, keep, &bytes), CLQ_OK) << clq_last_error();
    clq_track *back = nullptr;
    ASSERT_EQ(clq_track_load(locomotion_, bytes.data(), bytes.size(), &back), CLQ_OK) << clq_last_error();
    tracks_.push_back(back);
    const std::vector<uint64_t> all = lists(made);
    EXPECT_TRUE(lists(back) == all);
    EXPECT_FALSE(lists(climb(nullptr)) == all);
    EXPECT_EQ(asked_, asked);
}

TEST_F(OnStairs, ThatThrowAreNotMade)
{
    climb([](void *, const double[3]) -> double { throw std::runtime_error("no stone"); }, CLQ_CALLBACK);
    EXPECT_NE(std::string(clq_last_error()).find("clq_track_def.ground threw an exception: no stone"),
              std::string::npos)
        << clq_last_error();
}

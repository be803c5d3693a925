// Ways lead round what is in the way, and not through closed doors.
#include "tests/unit/walk/floors.h"

using floors::Floor;

namespace
{

class Ways : public testing::Test
{
protected:
    ~Ways() override { clq_navigation_destroy(made_); }
    clq_way way(const double (&from)[3], const double (&to)[3])
    {
        clq_way out = clq_way_init();
        points_.assign(3 * 256, NAN);
        EXPECT_EQ(clq_navigation_find_way(made_, from, to, 256, points_.data(), &out), CLQ_OK) << clq_last_error();
        return out;
    }
    clq_navigation *made_ = nullptr;
    std::vector<double> points_;
};

}  // namespace

TEST_F(Ways, GoRoundHolesByTheirCorners)
{
    Floor floor;
    floor.add(0, 0, 10, 10), floor.wall(4, 0, 6, 8);
    made_ = floor.make().release();
    const clq_way found = way({1, 0, 1}, {9, 0, 1});
    EXPECT_TRUE(found.complete);
    ASSERT_GE(found.point_count, 4u);
    ASSERT_LE(found.point_count, 6u);  // corners are cells, and may be cut
    const size_t last = 3 * size_t(found.point_count) - 3;
    // From the start to (3.8, 8.2), (6.2, 8.2), to the goal, right to some cells.
    EXPECT_NEAR(found.length, 2 * std::hypot(2.8, 7.2) + 2.4, 0.4);
    EXPECT_NEAR(points_[3], 3.8, 0.25);
    EXPECT_NEAR(points_[5], 8.2, 0.25);
    EXPECT_NEAR(points_[last], 9, 1e-4);
    EXPECT_TRUE(std::isnan(points_[last + 3]));
}

TEST_F(Ways, EndBeforeAClosedDoorAndGoThroughAnOpenOne)
{
    made_ = floors::two_rooms(true).make().release();
    EXPECT_TRUE(way({1, 0, 3}, {15, 0, 3}).complete);
    ASSERT_EQ(clq_navigation_set_door(made_, 0, false), CLQ_OK);
    const clq_way closed = way({1, 0, 3}, {15, 0, 3});
    EXPECT_FALSE(closed.complete);
    EXPECT_LT(points_[3 * closed.point_count - 3], 8.1);
    EXPECT_GT(points_[3 * closed.point_count - 3], 7.0);
    bool open = true;
    ASSERT_EQ(clq_navigation_get_door(made_, 0, &open), CLQ_OK);
    EXPECT_FALSE(open);
    ASSERT_EQ(clq_navigation_set_door(made_, 0, true), CLQ_OK);
    EXPECT_TRUE(way({1, 0, 3}, {15, 0, 3}).complete);
    EXPECT_EQ(clq_navigation_set_door(made_, 1, true), CLQ_ARGUMENT);
    EXPECT_EQ(clq_navigation_get_door(made_, 9, &open), CLQ_ARGUMENT);
}

TEST_F(Ways, OfPointsNearNoGroundHaveNoPoints)
{
    made_ = floors::two_rooms(false).make().release();
    const clq_way found = way({1, 0, 3}, {100, 0, 3});
    EXPECT_EQ(found.point_count, 0u);
    EXPECT_FALSE(found.complete);
    double place[3] = {7, 7, 7};
    bool near = true;
    const double outside[3] = {-1, 0, 3}, far[3] = {-9, 0, 3};
    ASSERT_EQ(clq_navigation_find_nearest(made_, outside, 2, place, &near), CLQ_OK);
    EXPECT_TRUE(near);
    EXPECT_NEAR(place[0], 0.2, 0.11);
    ASSERT_EQ(clq_navigation_find_nearest(made_, far, 2, place, &near), CLQ_OK);
    EXPECT_FALSE(near);
    ASSERT_EQ(clq_navigation_find_nearest(made_, outside, 1.1, place, &near), CLQ_OK);  // 1.2 m away
    EXPECT_FALSE(near);
}

TEST_F(Ways, AreRefusedForNumbersThatMeanNothing)
{
    made_ = floors::two_rooms(false).make().release();
    const double good[3] = {1, 0, 1}, bad[3] = {1, NAN, 1}, huge[3] = {1e300, 0, 0};
    double out[3];
    bool found;
    clq_way way = clq_way_init();
    EXPECT_EQ(clq_navigation_find_way(made_, bad, good, 0, nullptr, &way), CLQ_ARGUMENT);
    EXPECT_EQ(clq_navigation_find_way(made_, good, huge, 0, nullptr, &way), CLQ_ARGUMENT);
    EXPECT_EQ(clq_navigation_find_way(made_, good, good, 257, out, &way), CLQ_ARGUMENT);
    EXPECT_EQ(clq_navigation_find_way(made_, good, good, 1, nullptr, &way), CLQ_ARGUMENT);
    EXPECT_EQ(clq_navigation_find_way(nullptr, good, good, 0, nullptr, &way), CLQ_ARGUMENT);
    way.struct_bytes = 1;
    EXPECT_EQ(clq_navigation_find_way(made_, good, good, 0, nullptr, &way), CLQ_STRUCT_SIZE);
    for (const double reach : {0.0, -1.0, double(NAN), 1e9})
        EXPECT_EQ(clq_navigation_find_nearest(made_, good, reach, out, &found), CLQ_ARGUMENT);
    EXPECT_EQ(clq_navigation_find_nearest(made_, nullptr, 1, out, &found), CLQ_ARGUMENT);
}

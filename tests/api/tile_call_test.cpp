// clq_view_set_tile refuses what is no part of a picture, and changes nothing then.
#include <claque/claque.h>

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "tests/api/test_world.h"

namespace
{

TEST(TileCall, RefusesWhatIsNoPartOfAPictureAndChangesNothing)
{
    TestWorld world;
    clq_crowd *crowd = world.new_crowd();
    world.set_up(crowd);
    world.fill(crowd, 60, 3);
    clq_view *view = world.new_view(crowd, 0);
    const auto listed = [&] {
        EXPECT_EQ(clq_crowd_update(crowd, 1, &view, 1), CLQ_OK) << clq_last_error();
        return clq_view_get_hash(view);
    };
    const uint64_t whole = listed();
    const float middle[4] = {0.4f, 0.4f, 0.6f, 0.6f};
    ASSERT_EQ(clq_view_set_tile(view, middle), CLQ_OK) << clq_last_error();
    const uint64_t part = listed();
    EXPECT_NE(part, whole);
    const float bad[][4] = {{0, 0, 0, 1},     {0.5f, 0, 0.4f, 1}, {0, 0.7f, 1, 0.7f},
                            {-0.1f, 0, 1, 1}, {0, 0, 1.1f, 1},    {0, 0, 1, INFINITY},
                            {NAN, 0, 1, 1},   {0, 0, NAN, 1},     {0, -INFINITY, 1, 0.5f}};
    for (const auto &tile : bad) {
        EXPECT_EQ(clq_view_set_tile(view, tile), CLQ_ARGUMENT) << tile[0] << " " << tile[1];
        EXPECT_NE(std::strstr(clq_last_error(), "shares of the picture"), nullptr) << clq_last_error();
    }
    EXPECT_EQ(clq_view_set_tile(nullptr, middle), CLQ_ARGUMENT);
    EXPECT_EQ(clq_view_set_tile(view, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(listed(), part);
    const float all[4] = {0, 0, 1, 1};
    ASSERT_EQ(clq_view_set_tile(view, all), CLQ_OK);
    EXPECT_EQ(listed(), whole);
}

}  // namespace

// Groups of silhouettes: each box is in one group, and no two of a group touch.
#include "samples/labels/silhouettes.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace
{

using labels::Box;

TEST(Groups, HoldEachBoxOnceAndNoTwoThatTouch)
{
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        std::vector<Box> boxes;
        for (int i = 0; i < 60; ++i) {
            const double x = random() % 600, y = random() % 400, w = random() % 80, h = random() % 120;
            boxes.push_back({x + 0.3, y + 0.6, x + w, y + h});
        }
        std::set<uint32_t> seen;
        for (const std::vector<uint32_t> &group : labels::groups_apart(boxes))
            for (const uint32_t one : group) {
                EXPECT_TRUE(seen.insert(one).second);
                for (const uint32_t other : group) {
                    if (one == other) continue;
                    const Box &a = boxes[one], &b = boxes[other];
                    EXPECT_TRUE(a.x1 + 1 <= b.x0 || b.x1 + 1 <= a.x0 || a.y1 + 1 <= b.y0 || b.y1 + 1 <= a.y0);
                }
            }
        for (uint32_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(seen.count(i), boxes[i].empty() ? 0u : 1u);
    }
}

TEST(Groups, OfBoxesApartIsOne)
{
    EXPECT_EQ(labels::groups_apart({{0, 0, 10, 10}, {20, 0, 30, 10}, {0, 20, 10, 30}}).size(), 1u);
    EXPECT_EQ(labels::groups_apart({{0, 0, 10, 10}, {5, 5, 30, 10}, {6, 6, 10, 30}}).size(), 3u);
    EXPECT_TRUE(labels::groups_apart({}).empty());
}

}  // namespace

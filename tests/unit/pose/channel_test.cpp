// Finding the keys of a channel at a time.
#include "lib/pose/channel.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace claque::pose
{

TEST(Keys, AreFoundAsByALinearSearchWhateverTheirSpacing)
{
    std::mt19937 random(5);
    for (int kind = 0; kind < 4; ++kind) {
        for (uint32_t count = 1; count < 60; ++count) {
            std::vector<float> times;
            float t = -2.5f;
            for (uint32_t i = 0; i < count; ++i) {
                times.push_back(t);
                t += kind == 0   ? 1.0f / 30
                     : kind == 1 ? 0.001f + float(random() % 1000)
                     : kind == 2 ? (i < 3 ? 50.0f : 0.01f)
                                 : 0.25f;
            }
            for (int i = 0; i < 200; ++i) {
                const double time = times[0] - 0.5 + (double(times.back()) - times[0] + 1) * i / 199;
                uint32_t expected = 0;
                while (expected + 1 < count && times[expected + 1] <= time) ++expected;
                const KeyInterval place = find_key(times.data(), count, time);
                ASSERT_EQ(place.key, expected) << kind << " " << count << " " << time;
                ASSERT_GE(place.f, 0);
                ASSERT_LT(place.f, 1);
            }
            for (uint32_t i = 0; i < count; ++i) {
                ASSERT_EQ(find_key(times.data(), count, times[i]).key, i);
                ASSERT_EQ(find_key(times.data(), count, times[i]).f, 0);
            }
        }
    }
}

TEST(Keys, OutsideTheirTimesTheEndsHold)
{
    const float times[3] = {1, 2, 4};
    EXPECT_EQ(find_key(times, 3, -1e300).key, 0u);
    EXPECT_EQ(find_key(times, 3, 1e300).key, 2u);
    EXPECT_EQ(find_key(times, 3, 1e300).f, 0);
    EXPECT_EQ(find_key(times, 3, 3).key, 1u);
    EXPECT_DOUBLE_EQ(find_key(times, 3, 3).f, 0.5);
}

}  // namespace claque::pose

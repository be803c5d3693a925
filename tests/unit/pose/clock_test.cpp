// The time within a clip at a time of the crowd.
#include "lib/pose/clock.h"

#include <cmath>

#include <gtest/gtest.h>

namespace claque::pose
{

namespace
{

model::Clip clip(float start_s, float duration_s)
{
    model::Clip out;
    out.start_s = start_s;
    out.duration_s = duration_s;
    return out;
}

}  // namespace

TEST(ClipClock, GoesRoundTheClip)
{
    const model::Clip walk = clip(0.5f, 2.0f);
    EXPECT_DOUBLE_EQ(clip_time({10, 1, 0}, walk, 10), 0.5);
    EXPECT_DOUBLE_EQ(clip_time({10, 1, 0.25f}, walk, 11), 1.75);
    EXPECT_DOUBLE_EQ(clip_time({10, 1, 0}, walk, 13), 1.5);
    EXPECT_DOUBLE_EQ(clip_time({10, 2, 0}, walk, 10.75), 2.0);
}

TEST(ClipClock, RunsBackwardsAndBeforeItsStart)
{
    const model::Clip walk = clip(0.0f, 2.0f);
    EXPECT_DOUBLE_EQ(clip_time({0, -1, 0}, walk, 0.5), 1.5);
    EXPECT_DOUBLE_EQ(clip_time({0, 1, 0}, walk, -0.5), 1.5);
    EXPECT_DOUBLE_EQ(clip_time({0, 1, 0}, walk, -2), 0);
    EXPECT_DOUBLE_EQ(clip_time({0, 0, 0.75f}, walk, 1e6), 0.75);
}

TEST(ClipClock, DoesNotDriftInTenMillionSeconds)
{
    const model::Clip walk = clip(0.0f, 1.25f);  // both exact in binary, so the answer is known
    for (int i = 0; i < 1000; ++i) {
        const double t = 1e7 + i / 64.0;
        EXPECT_NEAR(clip_time({0, 1, 0}, walk, t), std::fmod(i / 64.0, 1.25), 1e-8);  // 1e7 is 8e6 clips
    }
}

TEST(ClipClock, AClipOfNoLengthHasOnlyItsStart)
{
    EXPECT_EQ(clip_time({3, 1, 0.5f}, clip(2, 0), 77), 2);
    EXPECT_EQ(clip_time({0, 1e38f, 0}, clip(2, 1), 1e300), 2);  // beyond all floats: still a time of the clip
}

TEST(ClipClock, StaysInsideTheClip)
{
    const model::Clip odd = clip(0.1f, 0.7f);
    for (int i = -100000; i < 100000; ++i) {
        const double t = clip_time({0.3, 1.7f, 0.2f}, odd, i * 0.0137);
        ASSERT_GE(t, double(odd.start_s));
        ASSERT_LT(t, double(odd.start_s) + odd.duration_s);
    }
}

}  // namespace claque::pose

#include "animcache/period.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"

namespace claque::animcache
{

TEST(Period, IsLinearInTheSquaredDistance)
{
    const PeriodLaw law;
    EXPECT_NEAR(period_s(law, 0), 0.02, 1e-8);
    EXPECT_NEAR(period_s(law, 5), 0.02, 1e-8);
    EXPECT_NEAR(period_s(law, 50), 0.25, 1e-8);
    EXPECT_NEAR(period_s(law, 1e9), 0.25, 1e-8);
    EXPECT_NEAR(period_s(law, std::sqrt((25 + 2500) / 2.0)), 0.135, 1e-7);
}

TEST(Period, RoundsDownToARateStepSoThatNoActorIsSlowerThanTheLaw)
{
    const PeriodLaw law;
    EXPECT_EQ(rate_hz(rate_step_of(law, 0)), 50);  // 0.02f is a little less than 1/50 and must not mean every frame
    EXPECT_EQ(rate_hz(rate_step_of(law, 50)), 4);
    for (double d = 0; d < 80; d += 0.01) {
        const uint32_t rate_step = rate_step_of(law, d);
        EXPECT_LE(period_s(rate_step), period_s(law, d) * (1 + 2e-6));
        EXPECT_TRUE(rate_step + 1 == rate_step_count || period_s(rate_step + 1) > period_s(law, d));
    }
}

TEST(Period, NothingMeansEveryFrameAndVeryLongMeansFourHertz)
{
    EXPECT_EQ(rate_step_of({0, 0, 5, 50}, 100), 0u);
    EXPECT_EQ(rate_step_of({0, 0.25f, 5, 50}, 5), 0u);
    EXPECT_EQ(rate_step_of({0.01f, 0.25f, 5, 50}, 0), 0u);  // faster than the first rate step
    EXPECT_EQ(rate_hz(rate_step_of({0.5f, 1, 5, 50}, 0)), 4);
    EXPECT_EQ(tick_s(0, 1.234, 99), 1.234);
}

TEST(Tick, IsTheLastOneAndStaysUntilTheNext)
{
    for (uint32_t rate_step = 1; rate_step < rate_step_count; ++rate_step) {
        for (uint64_t id = 0; id < 40; ++id) {
            const uint64_t h = base::hash(1, id, base::Purpose::cache_phase);
            for (const double t : {-3.217, 0.0, 0.013, 17.29, 1e7 + 0.37}) {
                const double tick = tick_s(rate_step, t, h);
                EXPECT_LE(tick, t + 1e-8);
                EXPECT_GT(tick, t - period_s(rate_step) - 1e-8);
                EXPECT_EQ(tick_s(rate_step, tick + 0.5 * period_s(rate_step), h), tick) << rate_step << " " << t;
            }
        }
    }
}

TEST(Tick, EveryRateStepTicksAtItsRateInALongRun)
{
    for (uint32_t rate_step = 1; rate_step < rate_step_count; ++rate_step)
        for (const double start : {0.0, 1e7}) {
            const uint64_t h = base::hash(5, rate_step, base::Purpose::cache_phase);
            const double frame_s = 1 / 211.0;  // in no simple ratio to any rate
            uint32_t ticks = 0;
            double last = tick_s(rate_step, start, h);
            for (int f = 1; f <= 211 * 400; ++f) {
                const double tick = tick_s(rate_step, start + f * frame_s, h);
                ticks += tick != last;
                last = tick;
            }
            EXPECT_NEAR(ticks, 400 * rate_hz(rate_step), 1) << rate_step << " from " << start;
        }
}

TEST(Tick, HasNotDriftedAfterTenMillionSeconds)
{
    // The ticks are at the same multiples as at the start, within the resolution of a double of that size: 2^-29 s.
    for (uint32_t rate_step = 1; rate_step < rate_step_count; ++rate_step)
        for (uint64_t id = 0; id < 50; ++id) {
            const uint64_t h = base::hash(9, id, base::Purpose::cache_phase);
            const double early = tick_s(rate_step, 0.5, h);
            for (const double later : {1e5, 1e6, 1e7}) {  // multiples of every period
                EXPECT_NEAR(tick_s(rate_step, later + early + 0.5 * period_s(rate_step), h), later + early, 4e-9);
                EXPECT_NEAR(tick_s(rate_step, -later + early + 0.5 * period_s(rate_step), h), -later + early, 4e-9);
            }
        }
}

TEST(Tick, PhasesAreSpreadEvenly)
{
    uint32_t in_quarter[4] = {};
    for (uint64_t id = 0; id < 4000; ++id) {
        const double tick = tick_s(12, 10, base::hash(3, id, base::Purpose::cache_phase));
        ++in_quarter[std::min(3, int((10 - tick) / 0.0625))];
    }
    for (const uint32_t count : in_quarter) EXPECT_NEAR(count, 1000, 120);
}

}  // namespace claque::animcache

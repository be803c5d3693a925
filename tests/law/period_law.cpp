// Tests T(d^2) = clamp(T_near + (T_far - T_near)(d^2 - d_near^2) / (d_far^2 - d_near^2)), rounded to rate steps; the
// rates that are reached, and how evenly updates are spread over frames (S1 4).
#include <cmath>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "support/scene.h"

namespace claque
{

using namespace testing_support;

namespace
{

// One clip of one template, played by actors in a row at given distances.
void line_up(Scene &scene, double first, double last)
{
    crowd::Play play;
    play.clip = clip_walk;
    for (size_t i = 0; i < scene.ids.size(); ++i) {
        crowd::Transform place;
        place.position = glm::dvec3(0, 1.7, -(first + (last - first) * double(i) / double(scene.ids.size())));
        crowd::set_transforms(scene.crowd, &scene.ids[i], &place, 1);
        crowd::play(scene.crowd, scene.ids[i], play);
    }
}

double lawful_rate(double d)
{
    // Follows the sentence in the documentation, not the code.
    double period = 0.02 + (0.25 - 0.02) * (d * d - 25) / (2500 - 25);
    period = std::min(0.25, std::max(0.02, period));
    double rate = 50;
    for (const double rate_step : {50.0, 40.0, 32.0, 25.0, 20.0, 16.0, 12.5, 10.0, 8.0, 6.25, 5.0, 4.0})
        if (rate_step >= 1 / period * (1 - 1e-6)) rate = rate_step;
    return rate;
}

}  // namespace

TEST(PeriodLaw, RatesReachedFollowTheSquaredDistanceInEveryBand)
{
    SceneDef def;
    def.actors = 120;
    Scene scene(def);
    line_up(scene, 1, 70);
    double expected[frame::band_count] = {}, seconds[frame::band_count] = {};
    const double step = 1.0 / 200, length = 10;
    for (int i = 0; i <= int(length / step); ++i) scene.update(100 + i * step);
    for (uint32_t row = 0; row < scene.crowd.row_count(); ++row) {
        const double d = -scene.crowd.transform_of(row).position.z;
        for (uint32_t b = 0; b < frame::band_count; ++b) {
            const frame::Band &band = scene.frame.stats().bands[b];
            if (d < band.distance_min || (b + 1 < frame::band_count && d >= band.distance_max)) continue;
            expected[b] += lawful_rate(d) * length;
            seconds[b] += length;
        }
    }
    for (uint32_t b = 0; b < frame::band_count; ++b) {
        const frame::Band &band = scene.frame.stats().bands[b];
        EXPECT_NEAR(band.seconds, seconds[b], 1e-6) << b;
        EXPECT_NEAR(double(band.animated) / band.seconds, expected[b] / seconds[b], 0.15) << b;
    }
    EXPECT_NEAR(double(scene.frame.stats().bands[0].animated) / scene.frame.stats().bands[0].seconds, 50, 0.15);
    EXPECT_NEAR(double(scene.frame.stats().bands[7].animated) / scene.frame.stats().bands[7].seconds, 4, 0.15);
}

TEST(PeriodLaw, ComingIntoViewAndJumpsOfTimeAreNoRates)
{
    Scene scene;
    const glm::dvec3 eye(0, 1.7, 60), ahead(0, 1, 0), behind(0, 1, 90);
    const auto measured = [&] {
        double seconds = 0;
        uint64_t animated = 0;
        for (const frame::Band &band : scene.frame.stats().bands) seconds += band.seconds, animated += band.animated;
        return seconds > 0 || animated > 0;
    };
    for (int i = 0; i < 6; ++i) scene.look(0, eye, i % 2 ? behind : ahead), scene.update(i * 0.1);
    scene.look(0, eye, ahead);
    for (const double time_s : {5.0, 10.0, 3.0}) scene.update(time_s);
    EXPECT_FALSE(measured());
    EXPECT_GT(scene.frame.stats().bands[7].actor_frames, 0u);
    scene.update(3.1);
    EXPECT_TRUE(measured());
    scene.frame.reset_bands();
    EXPECT_FALSE(measured());
}

TEST(PeriodLaw, NoFrameCarriesABurst)
{
    SceneDef def;
    def.actors = 2000;
    Scene scene(def);
    line_up(scene, 60, 90);  // all at 4 Hz
    scene.update(0);
    const uint32_t visible = scene.frame.stats().visible;
    ASSERT_EQ(visible, 2000u);
    for (int i = 1; i < 120; ++i) {
        scene.update(i / 60.0);
        const double share = visible * 4 / 60.0;  // 133: a binomial of deviation 11
        EXPECT_NEAR(scene.frame.stats().animated, share, 60) << i;
    }
}

TEST(PeriodLaw, APeriodOfNothingMeansEveryFrame)
{
    SceneDef def;
    def.settings.caches.period = {0, 0, 5, 50};
    Scene scene(def);
    line_up(scene, 1, 70);
    for (int i = 0; i < 20; ++i) {
        scene.update(3 + i * 0.0007);
        EXPECT_EQ(scene.frame.stats().animated, scene.frame.stats().visible);
        EXPECT_EQ(scene.frame.stats().visible, 80u);
        EXPECT_EQ(scene.frame.visibility(scene.crowd, 5).shown_s, 3 + i * 0.0007);
        EXPECT_EQ(scene.frame.visibility(scene.crowd, 5).period_s, 0);
    }
}

TEST(PeriodLaw, TheNearestOfSeveralEyesDecides)
{
    SceneDef def;
    def.actors = 1;
    Scene scene(def);
    line_up(scene, 40, 41);
    scene.update(1);
    EXPECT_FLOAT_EQ(scene.frame.visibility(scene.crowd, 0).period_s, 0.16f);  // T(1600) = 0.166
    scene.add_view(glm::dvec3(0, 1.7, -42), glm::dvec3(0, 1.7, 0));
    scene.update(1);
    EXPECT_FLOAT_EQ(scene.frame.visibility(scene.crowd, 0).period_s, 0.02f);
    EXPECT_FLOAT_EQ(scene.views[0]->list.items[0].eye_distance_m, 40);
    EXPECT_FLOAT_EQ(scene.views[1]->list.items[0].eye_distance_m, 2);
}

}  // namespace claque

// The law of feet at every moment: a foot on the ground does not slip, a foot that goes to another place rises, and no
// foot goes through the floor. The built-in people on written ways.
#include "tests/unit/track/contact_law.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "meshsplit/build.h"
#include "tests/unit/track/made_tracks.h"
#include "tests/unit/track/sole_meter.h"

using namespace claque;

namespace
{

constexpr double speeds[] = {0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 1.3, 1.6, 2.0, 2.6, 3.2, 4.0};

test::Contacts walk(const char *person, const std::vector<track::Point> &points)
{
    const test::SoleMeter meter(test::locomotion_of(person));
    return meter.watch(*test::track_of(points, person));
}

// A citizen, but for its clips.
struct Other {
    explicit Other(bool dips) : tmpl(std::pmr::get_default_resource()), walks(std::pmr::get_default_resource())
    {
        model::Model model = figures::citizen();
        model::Rig &rig = model.rig;
        for (const char *name : {"walk", "walk_slow"}) {
            const model::Clip &clip = rig.clips[rig.find_clip(name)];
            for (uint32_t c = clip.first_channel; dips && c < clip.first_channel + clip.channel_count; ++c) {
                const model::Channel &channel = rig.channels[c];
                if (channel.target != model::ChannelTarget::translation) continue;
                for (uint32_t k = 0; k < channel.key_count; ++k) {
                    const double part =
                        double(rig.times[channel.first_time + k] - clip.start_s) / double(clip.duration_s);
                    rig.values[channel.first_value + 3 * k + 1] -= 0.019f * float(1 - std::cos(2 * M_PI * part));
                }
            }
        }
        meshsplit::build(model, {}, tmpl);
        track::LocomotionClips clips = test::locomotion_of("citizen").clips;
        if (!dips) clips.slow = clips.turn = model::none;
        track::measure(tmpl, clips, walks);
    }
    test::Contacts walk(const std::vector<track::Point> &points) const
    {
        track::Track track(std::pmr::get_default_resource());
        track::build(walks, {points.data(), static_cast<uint32_t>(points.size())}, {}, track);
        return test::SoleMeter(walks).watch(track);
    }
    model::Template tmpl;
    track::Locomotion walks;
};

class ContactLaw : public testing::TestWithParam<const char *>
{
};

INSTANTIATE_TEST_SUITE_P(People, ContactLaw, testing::Values("citizen", "patrician"),
                         [](const auto &info) { return std::string(info.param); });

}  // namespace

TEST_P(ContactLaw, HoldsAtEverySpeed)
{
    for (const double speed : speeds)
        test::expect_law(test::numbered("ahead at %g m/s", speed),
                         walk(GetParam(), test::points_of(10, 12, test::ahead(speed))));
}

// Their bodies differ less from the citizen's.
TEST(ContactLawOfOthers, HoldsAtSomeSpeedsAndInTurns)
{
    for (const char *person : {"plebeian", "decurion"}) {
        for (const double speed : {0.2, 0.5, 1.1, 2.6})
            test::expect_law(std::string(person) + test::numbered(", %g m/s", speed),
                             walk(person, test::points_of(10, 12, test::ahead(speed))));
        test::expect_law(std::string(person) + ", stop and go",
                         walk(person, test::points_of(25, 24, test::stop_and_go(1, 3, 4))));
        test::expect_law(std::string(person) + ", a turn", walk(person, test::points_of(25, 8, test::corner(1, 150))));
    }
}

// Once a cycle the whole body goes 38 mm down, and with it the feet.
TEST(ContactLawOfClips, HoldsWhereTheyDipIntoTheFloor)
{
    const Other dipping(true);
    for (const double speed : speeds)
        if (speed < 1.8)
            test::expect_law(test::numbered("dips, %g m/s", speed),
                             dipping.walk(test::points_of(10, 12, test::ahead(speed))));
    test::expect_law("dips, stop and go", dipping.walk(test::points_of(25, 24, test::stop_and_go(1, 3, 4))));
    test::expect_law("dips, a turn", dipping.walk(test::points_of(25, 8, test::corner(1, 150))));
}

TEST(ContactLawOfClips, HoldsWithoutASlowWalkAndATurn)
{
    const Other other(false);
    for (const double speed : speeds)
        test::expect_law(test::numbered("no slow walk, %g m/s", speed),
                         other.walk(test::points_of(10, 12, test::ahead(speed))));
    for (const double degrees : {90.0, 180.0})
        test::expect_law(test::numbered("no slow walk, %g degrees", degrees),
                         other.walk(test::points_of(25, 8, test::corner(1, degrees))));
    test::expect_law("no slow walk, stop and go", other.walk(test::points_of(25, 24, test::stop_and_go(1, 3, 4))));
    test::expect_law("no slow walk, shuffles", other.walk(test::points_of(25, 24, test::shuffle(0.2, 3))));
}

TEST_P(ContactLaw, HoldsWhileTheSpeedChanges)
{
    for (const double rate : {0.2, 0.5, 1.0}) {
        const auto sway = [=](double t) { return glm::dvec2(0, 0.8 * t + 0.6 / rate * std::sin(rate * t)); };
        test::expect_law(test::numbered("0.2 to 1.4 m/s, %g a second", rate),
                         walk(GetParam(), test::points_of(10, 25, sway)));
    }
}

TEST_P(ContactLaw, HoldsInStartsAndStops)
{
    for (const double speed : {0.3, 0.6, 1.0, 1.4, 1.8})
        for (const double stands_s : {1.5, 4.0})
            test::expect_law(test::numbered("stop and go, %g m/s, %g s", speed, stands_s),
                             walk(GetParam(), test::points_of(25, 24, test::stop_and_go(speed, 3, stands_s))));
    for (const double step_m : {0.15, 0.3, 0.5})
        for (const double every_s : {2.0, 4.0})
            test::expect_law(test::numbered("shuffles by %g m in %g s", step_m, every_s),
                             walk(GetParam(), test::points_of(25, 24, test::shuffle(step_m, every_s))));
}

TEST_P(ContactLaw, HoldsInTurns)
{
    for (const double speed : {0.3, 0.7, 1.1, 1.5, 2.0})
        for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0, 180.0})
            test::expect_law(test::numbered("%g degrees at %g m/s", degrees, speed),
                             walk(GetParam(), test::points_of(25, 8, test::corner(speed, degrees))));
}

TEST_P(ContactLaw, HoldsInCurves)
{
    for (const double speed : {0.4, 0.8, 1.2, 1.6})
        for (const double radius : {0.5, 1.0, 2.0, 10.0})
            test::expect_law(test::numbered("a circle of %g m, %g m/s", radius, speed),
                             walk(GetParam(), test::points_of(25, 12, test::circle(speed, radius))));
}

// Up and down; the ground is known from the path, or from the host.
TEST_P(ContactLaw, HoldsOnSlopes)
{
    const test::SoleMeter meter(test::locomotion_of(GetParam()));
    static double slope = 0;
    track::BuildSettings told;
    told.ground = [](void *, const double point[3]) { return slope * point[2]; };
    for (const double one : {-0.08, -0.04, 0.04, 0.08}) {
        slope = one;
        const auto ground = [](double, double z) { return slope * z; };
        const auto watch = [&](const char *form, double number, const test::WayFunction &way) {
            std::vector<track::Point> points = test::points_of(25, 16, way);
            for (track::Point &point : points) point.position.y = ground(0, point.position.z);
            for (const track::BuildSettings &settings : {track::BuildSettings(), told})
                test::expect_law(test::numbered(form, number, 100 * slope),
                                 meter.watch(*test::track_of(points, GetParam(), settings), ground));
        };
        for (const double speed : {0.3, 0.7, 1.2, 2.0}) watch("%g m/s, a slope of %g %%", speed, test::ahead(speed));
        watch("stop and go, %g s, a slope of %g %%", 3, test::stop_and_go(1, 3, 3));
    }
}

// People that stand, and the file says that they turn.
TEST_P(ContactLaw, HoldsInTurnsOnTheSpot)
{
    for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0, 180.0})
        for (const double rate : {0.5, 1.7}) {
            std::vector<track::Point> points = test::points_of(25, 24, [](double) { return glm::dvec2(0, 0); });
            const double turn = degrees * M_PI / 180, turn_s = turn / rate;
            for (track::Point &point : points) {
                const double round = std::floor(point.time_s / 6), part = (point.time_s - 6 * round - 2) / turn_s;
                point.heading_rad = turn * (round + std::min(1.0, std::max(0.0, part)));
            }
            test::expect_law(test::numbered("%g degrees on the spot, %g rad/s", degrees, rate),
                             walk(GetParam(), points));
            // They have turned before the next turn begins, if the file has.
            if (turn_s > 3.5) continue;
            const auto track = test::track_of(points, GetParam());
            for (int round = 1; round <= 3; ++round) {
                const double shown = track::state_at(*track, 6.0 * round + 1).heading_rad;
                EXPECT_NEAR(std::remainder(shown - turn * round, 2 * M_PI), 0, 0.01) << degrees << ", " << rate;
            }
        }
}

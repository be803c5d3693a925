// The meter of feet on the ground, on soles that are known.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/track/made_tracks.h"
#include "tests/unit/track/sole_meter.h"

using namespace claque;

namespace
{

// A sole of four points, flat on the ground.
test::Soleprint sole_at(double time_s, double z, double y)
{
    test::Soleprint out;
    out.time_s = time_s;
    for (const glm::dvec2 &p : {glm::dvec2(0, 0), glm::dvec2(0.08, 0), glm::dvec2(0, 0.18), glm::dvec2(0.08, 0.18)})
        out.points.emplace_back(p.x, y, z + p.y);
    return out;
}
const std::vector<test::Part> four = {test::Part::heel, test::Part::heel, test::Part::ball, test::Part::ball};

}  // namespace

TEST(ContactMeter, SeesAFlatFootThatSkidsBy30Mm)
{
    for (const double skid : {0.0, 0.03}) {
        std::vector<test::Soleprint> prints;
        for (int i = 0; i < 100; ++i)
            prints.push_back(sole_at(0.01 * i, skid * std::min(1.0, 0.01 * i), i < 90 ? 0.001 : 0.02));
        const test::Contacts contacts = test::contacts_of(prints, four);
        ASSERT_EQ(contacts.slips.each.size(), 1u);
        EXPECT_NEAR(contacts.slips.max(), 0.89 * skid, 1e-9);
        EXPECT_NEAR(contacts.holds.max(), 0.89 * skid, 1e-9);
        EXPECT_NEAR(contacts.flats.max(), 0.89 * skid, 1e-9);
    }
}

TEST(ContactMeter, SeesHowAFootTurnsRisesAndSinks)
{
    std::vector<test::Soleprint> prints;
    for (int i = 0; i < 300; ++i) {
        const bool swings = i >= 100 && i < 150;
        test::Soleprint print = sole_at(0.01 * i, i < 125 ? 0 : 0.3, swings ? 0.007 : i == 200 ? -0.004 : 0);
        const double turn = 0.003 * std::min(i, 100);
        for (glm::dvec3 &p : print.points)
            p = glm::dvec3(p.x * std::cos(turn) + p.z * std::sin(turn), p.y,
                           -p.x * std::sin(turn) + p.z * std::cos(turn));
        prints.push_back(print);
    }
    const test::Contacts contacts = test::contacts_of(prints, four);
    ASSERT_EQ(contacts.lifts.each.size(), 1u);
    EXPECT_NEAR(contacts.lifts.min(), 0.007, 1e-9);
    EXPECT_NEAR(contacts.depths.max(), 0.004, 1e-9);
    EXPECT_NEAR(contacts.turns.max(), 0.297 * 180 / M_PI, 1e-6);
    EXPECT_EQ(contacts.dragged, 0);
}

TEST(ContactMeter, SeesFeetThatDragAlongOrNeverComeDown)
{
    std::vector<test::Soleprint> prints;
    for (int i = 0; i < 400; ++i) {
        prints.push_back(sole_at(0.01 * i, 0, 0));
        prints.back().body.y = 0.001 * i;
    }
    EXPECT_EQ(test::contacts_of(prints, four).dragged, 1);
    for (test::Soleprint &print : prints)
        for (glm::dvec3 &p : print.points) p.y = 0.01;
    EXPECT_EQ(test::contacts_of(prints, four).dragged, 1);
}

// The clips by themselves, a walk blended with a stand.
TEST(ContactMeter, SeesTheFeetOfASlowWalkDragWhereTheLegsAreNotHeld)
{
    const test::SoleMeter meter(test::locomotion_of("citizen"));
    const auto track = test::track_of(test::points_of(10, 12, [](double t) { return glm::dvec2(0, 0.3 * t); }));
    const test::Contacts contacts = meter.watch(*track, {}, false);
    EXPECT_GT(contacts.slips.mean(), 0.1);
    EXPECT_LT(contacts.lifts.min(), 0.010);
}

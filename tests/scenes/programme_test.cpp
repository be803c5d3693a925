// Programmes depend on seed, individual and time; they are whole clips in sequence, most of them quiet.
#include "samples/scenes/odeon/programme.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace
{

using namespace scenes;

Member member(uint64_t person, Temperament temperament = Temperament::hearty)
{
    Member m;
    m.seed = 7;
    m.person = person;
    m.x = 0.65 * static_cast<double>(person % 40);
    m.z = -8 - 0.78 * static_cast<double>(person / 40);
    m.aside_m = person % 7 == 0 ? 9 : 0.1 * static_cast<double>(person % 3);
    m.temperament = temperament;
    m.duration_s = {4.0, 5.2, 6.1, 5.0, 3.1, 2.9, 3.3, 2.6, 1.7, 4.4, 2.4, 2.2, 2.8, 3.0, 1.8};
    return m;
}

bool up(Act act) { return act >= Act::stand && act <= Act::stand_laugh; }

void expect_same(const Playing &a, const Playing &b)
{
    EXPECT_EQ(a.act, b.act);
    EXPECT_EQ(a.begin_s, b.begin_s);
    EXPECT_EQ(a.end_s, b.end_s);
    EXPECT_EQ(a.speed, b.speed);
}

TEST(Programme, IsMadeOfWholeClipsOneAfterTheOther)
{
    for (uint64_t person = 0; person < 50; ++person) {
        const Member m = member(person);
        Playing now = playing_at(m, -100);
        EXPECT_TRUE(now.begin_s <= -100 && -100 < now.end_s);
        while (now.end_s < 200) {
            EXPECT_NEAR((now.end_s - now.begin_s) * now.speed, m.duration_s[static_cast<size_t>(now.act)], 1e-9);
            const Playing next = playing_at(m, now.end_s + 1e-6);
            EXPECT_NEAR(next.begin_s, now.end_s, 1e-9);
            expect_same(playing_at(m, (now.begin_s + now.end_s) / 2), now);
            now = next;
        }
    }
}

TEST(Programme, RisesBeforeItStandsAndSitsDownAfter)
{
    uint32_t risen = 0;
    for (uint64_t person = 0; person < 400; ++person) {
        const Member m = member(person);
        Act before = playing_at(m, 0).act;
        for (double t = playing_at(m, 0).end_s + 1e-6; t < 300; t = playing_at(m, t).end_s + 1e-6) {
            const Act act = playing_at(m, t).act;
            EXPECT_EQ(up(act) || act == Act::sit_down, up(before) || before == Act::rise);
            risen += act == Act::rise;
            before = act;
        }
    }
    EXPECT_GT(risen, 100u);
}

TEST(Programme, ASitterRightBehindAnotherNeitherRisesNorLeansForward)
{
    for (uint64_t person = 0; person < 400; ++person)
        for (double t = 0; t < 300; t += 5) {
            const Act act = playing_at(member(person), t).act;
            EXPECT_FALSE(act >= Act::rise && member(person).aside_m < aside_to_rise_m);
            EXPECT_FALSE(act == Act::lean && member(person).aside_m < aside_to_lean_m);
        }
}

TEST(Programme, SpeedsStayNearOne)
{
    for (uint64_t person = 0; person < 300; ++person)
        for (double t = 0; t < 400; t += 31) {
            const double speed = playing_at(member(person), t).speed;
            EXPECT_GT(speed, 0.84);
            EXPECT_LT(speed, 1.16);
        }
}

TEST(Programme, IsKnownAtAnyTime)
{
    for (const double t : {-1e7, -0.001, 0.0, 1e7, 3e9}) {
        const Playing now = playing_at(member(3), t);
        EXPECT_TRUE(now.begin_s <= t && t < now.end_s) << t;
    }
}

TEST(Programme, MostSitQuietlyAndAFewStand)
{
    std::map<Act, uint32_t> seen;
    uint32_t all = 0, quiet = 0, standing = 0;
    const Temperament temperaments[] = {Temperament::grave, Temperament::gracious, Temperament::hearty};
    for (uint64_t person = 0; person < 1000; ++person)
        for (double t = 0; t < 300; t += 7.3) {
            const Act act = playing_at(member(person, temperaments[person % 3]), t).act;
            ++seen[act];
            ++all;
            quiet += act <= Act::talk;
            standing += act >= Act::rise;
        }
    EXPECT_EQ(seen.size(), act_count) << "every clip is played";
    EXPECT_GT(quiet, all * 55 / 100);
    EXPECT_LT(quiet, all * 85 / 100);
    EXPECT_GT(standing, all * 1 / 100);
    EXPECT_LT(standing, all * 7 / 100);
}

TEST(Programme, NeighboursApplaudTogetherMoreThanStrangers)
{
    double together = 0, strangers = 0, applauding = 0, samples = 0;
    for (double t = 0; t < 400; t += 5)
        for (uint64_t person = 0; person + 1 < 400; ++person) {
            if (person % 40 == 39) continue;
            const bool here = playing_at(member(person), t).act == Act::applaud;
            const bool beside = playing_at(member(person + 1), t).act == Act::applaud;
            const bool later = playing_at(member(person + 1), t + 1000).act == Act::applaud;
            together += here && beside;
            strangers += here && later;
            applauding += here;
            ++samples;
        }
    EXPECT_GT(applauding / samples, 0.05);
    EXPECT_GT(together, 1.5 * strangers);
}

}  // namespace

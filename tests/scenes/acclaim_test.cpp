// Acclamations are functions of time and place: they run outwards from where they start, and every spectator's clips
// follow each other without a gap, from one seated pose to the next.
#include "samples/scenes/amphitheatre/acclaim.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace scenes;
using namespace scenes::amphitheatre;

Spectator spectator(uint64_t person, double x = 40, double z = -30)
{
    Spectator made;
    made.seed = 1, made.person = person, made.x = x, made.z = z;
    made.temperament = Temperament::hearty;
    made.duration_s = {7, 9, 8, 8.5, 5.5, 4.5, 5, 4, 2, 6, 5, 4, 4, 5, 2.1};
    return made;
}

bool is_seated(Act act) { return static_cast<size_t>(act) < seated_count; }
bool is_excited(Act act) { return act == Act::applaud || act == Act::cheer || act == Act::wave || !is_seated(act); }

TEST(Acclaim, ClipsFollowEachOtherWithoutAGap)
{
    for (uint64_t person = 0; person < 40; ++person) {
        const Spectator s = spectator(person, -60 + 3.0 * static_cast<double>(person));
        Playing before = playing_at(s, -100);
        for (double time = before.end_s; time < 200;) {
            const Playing now = playing_at(s, time + 1e-9);
            ASSERT_NEAR(now.begin_s, before.end_s, 1e-6);
            ASSERT_GT(now.end_s, now.begin_s);
            ASSERT_GT(now.speed, 0.55);
            ASSERT_LT(now.speed, 1.8);
            const double loops = now.speed * (now.end_s - now.begin_s) / s.duration_s[static_cast<size_t>(now.act)];
            ASSERT_NEAR(loops, std::floor(loops + 0.5), 1e-6) << "a clip that does not end in its last pose";
            // People are seated before they rise and after they sit down, and stand only in between.
            ASSERT_EQ(now.act == Act::rise || is_seated(now.act), is_seated(before.act) || before.act == Act::sit_down);
            time = now.end_s, before = now;
        }
    }
}

TEST(Acclaim, AnyTimeIsFoundByItself)
{
    const Spectator s = spectator(7);
    for (double time = -50; time < 150; time += 0.37) {
        const Playing now = playing_at(s, time), same = playing_at(s, (now.begin_s + now.end_s) / 2);
        ASSERT_LE(now.begin_s, time);
        ASSERT_LT(time, now.end_s);
        ASSERT_EQ(same.act, now.act);
        ASSERT_EQ(same.begin_s, now.begin_s);
        ASSERT_EQ(same.end_s, now.end_s);
    }
}

TEST(Acclaim, WavesComeLaterToPeopleFartherAway)
{
    for (int64_t number = -3; number < 20; ++number) {
        const Wave w = wave(1, number);
        const double near = arrival_s(spectator(1, w.x, w.z), number),
                     far = arrival_s(spectator(1, w.x + 90, w.z), number);
        EXPECT_NEAR(far - near, 90 / wave_m_per_s, 1e-9);
        EXPECT_NEAR(w.start_s, static_cast<double>(number) * wave_every_s, 4);
        EXPECT_GE(near, w.start_s);
        EXPECT_LT(near, w.start_s + 1);
    }
}

TEST(Acclaim, ManyJoinAWaveAndFewActBeforeIt)
{
    const Wave w = wave(1, 2);
    size_t joined = 0, before = 0;
    for (uint64_t person = 0; person < 1000; ++person) {
        const Spectator s = spectator(person, w.x, w.z);
        joined += is_excited(playing_at(s, w.start_s + 3).act) ? 1 : 0;
        before += is_excited(playing_at(s, w.start_s - 1).act) ? 1 : 0;
    }
    EXPECT_GT(joined, 500u);
    EXPECT_LT(before, 120u);
}

}  // namespace

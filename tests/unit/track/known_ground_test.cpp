// The ground that a host gives: what level or unreachable ground changes, what is saved of it, and what is refused.
#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/follows.h"
#include "lib/track/track_file.h"
#include "tests/unit/track/feet.h"
#include "tests/unit/track/stairs.h"

using namespace claque;
using test::climb;
using test::settings_for;
using test::Stairs;

TEST(KnownGround, ThatIsLevelChangesNoPose)
{
    const auto level = [](void *, const double[3]) { return 0.0; };
    const auto none = [](void *, const double[3]) { return std::nan(""); };
    for (const test::Way &way : test::ways()) {
        track::BuildSettings settings;
        const auto plain = test::track_of(way.points);
        settings.ground = none;
        EXPECT_EQ(test::track_of(way.points, "citizen", settings)->hash, plain->hash) << way.name;
        settings.ground = level;
        const auto known = test::track_of(way.points, "citizen", settings);
        EXPECT_TRUE(known->climbs);
        EXPECT_NE(known->hash, plain->hash);
        test::Soles soles(*plain->locomotion);
        for (double t = 0; t < plain->length_s; t += 0.1)
            for (int f = 0; f < 2; ++f) {
                const std::vector<glm::dvec3> a = test::soles_at(soles, *plain, f, t, true).points;
                ASSERT_TRUE(a == test::soles_at(soles, *known, f, t, true).points) << way.name << " at " << t;
            }
    }
}

TEST(KnownGround, ThatNoLegReachesIsNone)
{
    const auto plain = test::track_of(test::ways()[2].points);
    for (double far : {-30.0, 1.0, 1e300, double(INFINITY)}) {
        track::BuildSettings settings;
        settings.ground = [](void *user, const double[3]) { return *static_cast<double *>(user); };
        settings.ground_user = &far;
        EXPECT_EQ(test::track_of(test::ways()[2].points, "citizen", settings)->hash, plain->hash) << far;
    }
}

TEST(KnownGround, IsSavedWithTheTrackInAVersionOfItsOwn)
{
    Stairs stairs;
    const auto made = test::track_of(climb(stairs, 0.8, false), "citizen", settings_for(stairs));
    const auto level = test::track_of(test::ways()[2].points);
    track::Array<uint8_t> bytes, level_bytes, again;
    track::save(*made, bytes), track::save(*level, level_bytes);
    EXPECT_EQ(bytes[8], track::climbing_file_version);
    EXPECT_EQ(level_bytes[8], track::track_file_version);
    track::Track back(std::pmr::get_default_resource());
    track::load(bytes.data(), bytes.size(), *made->locomotion, back);
    EXPECT_EQ(back.hash, made->hash);
    EXPECT_TRUE(back.climbs);
    for (double t = 0; t < made->length_s; t += 0.07)
        for (int f = 0; f < 2; ++f)
            ASSERT_EQ(track::foot_at(back, track::state_at(back, t), f, t).y,
                      track::foot_at(*made, track::state_at(*made, t), f, t).y);
    EXPECT_EQ(back.plants[0][3].slope, made->plants[0][3].slope);
    track::save(back, again);
    EXPECT_TRUE(again == bytes);
}

TEST(KnownGround, AtAnImpossibleHeightIsRefused)
{
    Stairs stairs;
    const auto refused = [&](const std::function<void(track::Track &)> &spoil, const char *why) {
        const auto made = test::track_of(climb(stairs, 0.8, false), "citizen", settings_for(stairs));
        spoil(*made);
        track::Array<uint8_t> bytes;
        track::save(*made, bytes);
        track::Track back(std::pmr::get_default_resource());
        try {
            track::load(bytes.data(), bytes.size(), *made->locomotion, back);
            ADD_FAILURE() << why;
        } catch (const base::Error &error) {
            EXPECT_EQ(error.status(), CLQ_FORMAT);
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
        }
    };
    refused([](track::Track &made) { made.plants[1][3].y = INFINITY; }, "a step of a saved track is at an impossible");
    refused([](track::Track &made) { made.plants[0][2].y = 1e8f; }, "a step of a saved track is at an impossible");
    refused([](track::Track &made) { made.plants[0][2].slope = 0.31f; }, "a step of a saved track is at an impossible");
    refused([](track::Track &made) { made.swings[0].y = NAN; }, "a step of a saved track is at an impossible");
    refused([](track::Track &made) { made.sinks[4] = 65535; }, "the hips of a saved track sink by 0.99");
    refused([](track::Track &made) { made.sinks.pop_back(); }, "samples, but");
}

// Room for what the track may move, while any of the pieces that an actor shows climbs.
TEST(KnownGround, GivesActorsRoomForSunkHips)
{
    Stairs stairs;
    const auto climbing = test::track_of(climb(stairs, 0.8, false), "citizen", settings_for(stairs));
    const auto level = test::track_of(test::ways()[2].points);
    crowd::Follow follow;
    follow.track = level.get();
    const float room = crowd::room_of(follow);
    EXPECT_EQ(room, level->locomotion->legs[0].max_shift);
    follow.earlier[1] = climbing.get(), follow.earlier[0] = level.get();
    EXPECT_EQ(crowd::room_of(follow), 2 * room);
    follow.track = climbing.get(), follow.earlier[1] = nullptr;
    EXPECT_EQ(crowd::room_of(follow), 2 * room);
}

TEST(KnownGround, WhoseCallbackThrowsMakesNoTrack)
{
    track::BuildSettings settings;
    settings.ground = [](void *, const double[3]) -> double { throw std::runtime_error("no stone"); };
    try {
        test::track_of(test::ways()[2].points, "citizen", settings);
        ADD_FAILURE();
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_CALLBACK);
        EXPECT_STREQ(error.what(), "clq_track_def.ground threw an exception: no stone");
    }
}

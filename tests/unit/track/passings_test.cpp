// Passings: where people come close to each other as they pass.
#include "lib/track/passings.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

TEST(Passings, AreNotOfPeopleWhoWalkTogether)
{
    const auto a = test::points_of(5, 10, [](double t) { return glm::dvec2(0, 1.2 * t); });
    const auto b = test::points_of(5, 10, [](double t) { return glm::dvec2(0.5 + 0.1 * std::sin(t), 1.2 * t); });
    const base::Span<const track::Point> people[] = {{a.data(), 51}, {b.data(), 51}};
    track::Array<track::FoundPassing> found;
    track::find_passings({people, 2}, 1, found);
    EXPECT_TRUE(found.empty());
}

TEST(Passings, OfACrowdAreThoseThatEachPairHas)
{
    std::vector<std::vector<track::Point>> points;
    for (int i = 0; i < 60; ++i) {
        const double x = 0.31 * (i * 37 % 60), z = 0.23 * (i * 17 % 60), way = i % 2 ? 1 : -1;
        points.push_back(test::points_of(3 + i % 5, 8, [=](double t) {
            return glm::dvec2(x + 0.3 * std::sin(t + i), z + way * (0.8 + 0.01 * i) * (t - 4));
        }));
    }
    std::vector<base::Span<const track::Point>> people;
    for (const auto &own : points) people.emplace_back(own.data(), static_cast<uint32_t>(own.size()));
    track::Array<track::FoundPassing> found;
    track::find_passings({people.data(), 60}, 1, found);
    size_t by_pairs = 0;
    for (size_t i = 0; i < people.size(); ++i)
        for (size_t k = i + 1; k < people.size(); ++k) {
            const base::Span<const track::Point> two[] = {people[i], people[k]};
            track::Array<track::FoundPassing> own;
            track::find_passings({two, 2}, 1, own);
            by_pairs += own.size();
        }
    EXPECT_EQ(found.size(), by_pairs);
    EXPECT_GT(found.size(), 100u);
    for (size_t i = 1; i < found.size(); ++i) {
        ASSERT_LE(found[i - 1].person, found[i].person);
        const bool same = found[i - 1].person == found[i].person;
        ASSERT_TRUE(!same || found[i - 1].passing.time_s <= found[i].passing.time_s);
    }
}

TEST(Shoulders, OfPeopleWhoPassInShortSequenceTurnWithoutAJump)
{
    const auto points = test::points_of(5, 12, [](double t) { return glm::dvec2(0, 1.2 * t); });
    for (double gap_s = 0.2; gap_s < 1.6; gap_s += 0.1) {
        std::vector<track::Passing> passings;
        for (int i = 0; i < 5; ++i) {
            const double time_s = 3 + gap_s * i;
            passings.push_back({time_s, glm::dvec3(i % 2 ? 0.55 : -0.55, 0, 1.2 * time_s)});
        }
        track::BuildSettings settings;
        settings.passings = base::Span<const track::Passing>(passings);
        const auto track = test::track_of(points, "citizen", settings);
        const auto turned = [&](double t) {
            return double(track::upper_at(*track, track::state_at(*track, t), t).torso_rad);
        };
        double most = 0, before = turned(1);
        for (double t = 1; t < 11; t += 0.005) {
            const double now = turned(t);
            // Half a radian there and back in 0.7 s.
            ASSERT_LT(std::fabs(now - before), 0.03) << t << ", every " << gap_s << " s";
            most = std::max(most, std::fabs(now)), before = now;
        }
        EXPECT_GT(most, 0.3) << gap_s;
    }
}

TEST(Passings, OfPointsThatMeanNothingAreRefused)
{
    std::vector<track::Point> bad = test::points_of(5, 1, [](double t) { return glm::dvec2(0, t); });
    bad[3].time_s = bad[2].time_s;
    const base::Span<const track::Point> people[] = {{bad.data(), 6}};
    track::Array<track::FoundPassing> found;
    EXPECT_THROW(track::find_passings({people, 1}, 1, found), base::Error);
    EXPECT_THROW(track::find_passings({people, 0}, 0, found), base::Error);
}

// A track made in pieces is the track that was made at once, nearly; and nothing jumps where one piece ends.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "lib/track/track_file.h"
#include "tests/unit/track/contact_law.h"
#include "tests/unit/track/pieces.h"
#include "tests/unit/track/sole_meter.h"

using namespace claque;

namespace
{

double turn_between(double a, double b)
{
    const double turn = 2 * math::pi, d = b - a;
    return std::fabs(d - turn * std::floor(d / turn + 0.5));
}

double gap(const track::Track &a, const track::Track &b, double time_s)
{
    const glm::dvec3 d = track::position_at(a, time_s) - track::position_at(b, time_s);
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

// A person that turns away from where it went, each second: the points behind the end of a piece are then wrong.
void change_of_mind(std::vector<track::Point> &seen, double end_s)
{
    const int second = static_cast<int>(end_s);
    for (track::Point &point : seen)
        if (point.time_s > end_s) point.position.x += (second % 2 ? 1.5 : -1.5) * (point.time_s - end_s);
}

// What follows the end of a piece is a guess: straight on, as fast as before.
void go_straight_on(std::vector<track::Point> &seen, double end_s)
{
    size_t last = 0;
    while (last + 1 < seen.size() && seen[last + 1].time_s <= end_s + 1e-9) ++last;
    if (last == 0) return;
    const track::Point &b = seen[last], &a = seen[last > 2 ? last - 2 : 0];
    const glm::dvec3 velocity = (b.position - a.position) / (b.time_s - a.time_s);
    for (size_t i = last + 1; i < seen.size(); ++i)
        seen[i].position = b.position + velocity * (seen[i].time_s - b.time_s);
}

void expect_no_piece(const std::vector<track::Point> &points, clq_status status, const char *words,
                     const track::BuildSettings &settings)
{
    try {
        test::track_of(points, "citizen", settings);
        ADD_FAILURE() << "accepted, not refused with '" << words << "'";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), status);
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

void expect_no_jump(const test::Pieces &pieces, const std::string &name)
{
    for (size_t k = 1; k < pieces.all.size(); ++k) {
        const track::Track &before = *pieces.all[k - 1], &after = *pieces.all[k];
        const double time_s = after.start_s;
        ASSERT_EQ(time_s, track::end_of(before)) << name;
        const track::State a = track::state_at(before, time_s), b = track::state_at(after, time_s);
        ASSERT_LT(gap(before, after, time_s), 0.0002) << name << " at " << time_s;
        ASSERT_LT(turn_between(a.heading_rad, b.heading_rad), 1e-4) << name << " at " << time_s;
        ASSERT_LT(turn_between(2 * math::pi * a.phase, 2 * math::pi * b.phase), 1e-4) << name << " at " << time_s;
        ASSERT_EQ(a.gait, b.gait) << name << " at " << time_s;
        for (int f = 0; f < 2; ++f) {
            const pose::FootTarget x = track::foot_at(before, a, f, time_s), y = track::foot_at(after, b, f, time_s);
            ASSERT_EQ(x.planted, y.planted) << name << " foot " << f << " at " << time_s;
            ASSERT_NEAR(x.x, y.x, 0.0005) << name << " foot " << f << " at " << time_s;
            ASSERT_NEAR(x.z, y.z, 0.0005) << name << " foot " << f << " at " << time_s;
            ASSERT_NEAR(x.turn_rad, y.turn_rad, 0.001) << name << " foot " << f << " at " << time_s;
            ASSERT_NEAR(x.ground, y.ground, 0.001) << name << " foot " << f << " at " << time_s;
        }
    }
}

}  // namespace

TEST(Pieces, AreWhereTheWholeTrackIs)
{
    for (const test::Way &way : test::ways()) {
        const auto whole = test::track_of(way.points);
        const test::Pieces pieces(way.points), guessed(way.points, "citizen", {}, go_straight_on);
        const bool stands = whole->standing_s > 0;
        double worst = 0, worst_guessed = 0;
        for (double t = pieces.start_s(); t <= pieces.end_s(); t += 0.02) {
            worst = std::max(worst, gap(pieces.at(t), *whole, t));
            worst_guessed = std::max(worst_guessed, gap(guessed.at(t), *whole, t));
        }
        std::printf("pieces: %s | %.1f mm | %.1f mm where the next second was a guess\n", way.name, 1e3 * worst,
                    1e3 * worst_guessed);
        // The place of a stand is chosen when it begins, not from all of it.
        EXPECT_LT(worst, stands ? 0.06 : 0.005) << way.name;
        EXPECT_LT(worst_guessed, 0.40) << way.name;
    }
}

TEST(Pieces, HaveNoJumpAtTheirBorders)
{
    for (const test::Way &way : test::ways())
        for (const double length : {0.25, 0.5, 1.3})
            expect_no_jump(test::Pieces(way.points, "citizen", {length}), way.name);
}

TEST(Pieces, HaveNoJumpWhereAPersonChangesItsMind)
{
    for (const test::Way &way : test::ways()) {
        const test::Pieces fickle(way.points, "citizen", {}, change_of_mind);
        expect_no_jump(fickle, way.name);
        for (double t = 0.02; t < fickle.end_s(); t += 0.02) {
            const glm::dvec3 d =
                track::position_at(fickle.at(t), t) - track::position_at(fickle.at(t - 0.02), t - 0.02);
            ASSERT_LT(std::sqrt(d.x * d.x + d.z * d.z), 0.02 * 5) << way.name << " at " << t;  // metres
        }
        expect_no_jump(test::Pieces(way.points, "citizen", {0.5, 0, 0}), way.name);
    }
}

TEST(Pieces, KeepFeetThatCarryWeightWhereTheyStand)
{
    const test::Pieces::See guesses[] = {nullptr, go_straight_on, change_of_mind};
    for (const char *figure : {"citizen", "patrician"}) {
        test::Soles soles(test::locomotion_of(figure));
        for (const test::Way &way : test::ways())
            for (int guess = 0; guess < 3; ++guess) {
                const test::Pieces pieces(way.points, figure, {}, guesses[guess]);
                const test::FootDrift drift = test::drift_of_pieces(soles, pieces, 0.02);
                EXPECT_LT(drift.max(), 0.020) << way.name << ", guess " << guess;
                EXPECT_GT(drift.each.size(), 10u) << way.name;
            }
    }
}

// The law of contact_law_test.cpp, but for the heights of steps that were planned for another way.
TEST(Pieces, LetNoFootSlipOrDragAlong)
{
    const test::Pieces::See guesses[] = {nullptr, go_straight_on, change_of_mind};
    const test::SoleMeter meter(test::locomotion_of("citizen"));
    for (const test::Way &way : test::ways())
        for (int guess = 0; guess < 3; ++guess) {
            const test::Pieces pieces(way.points, "citizen", {}, guesses[guess]);
            const auto shown = [&](double t) -> const track::Track & { return pieces.at(t); };
            test::expect_law(std::string(way.name) + test::numbered(", guess %g", guess),
                             meter.watch(shown, pieces.start_s(), pieces.end_s()));
        }
}

TEST(Pieces, KeepEachFootThatIsDownInItsPlace)
{
    for (const test::Way &way : test::ways()) {
        const test::Pieces pieces(way.points);
        int over = 0;
        for (size_t k = 1; k < pieces.all.size(); ++k)
            for (int f = 0; f < 2; ++f)
                for (const track::Plant &plant : pieces.all[k - 1]->plants[f]) {
                    const double end = pieces.all[k - 1]->length_s;
                    if (double(plant.begin_s) > end || double(plant.end_s) < end) continue;
                    int same = 0;
                    for (const track::Plant &now : pieces.all[k]->plants[f])
                        same += now.begin_s <= 0 && now.end_s >= 0 && now.x == plant.x && now.z == plant.z &&
                                now.heading_rad == plant.heading_rad;
                    ASSERT_EQ(same, 1) << way.name << " at " << pieces.all[k]->start_s;
                    ++over;
                }
        EXPECT_GT(over, 10) << way.name;
    }
}

TEST(Pieces, TurnByAtMostHalfATurnASecond)
{
    for (const test::Way &way : test::ways()) {
        const test::Pieces pieces(way.points, "citizen", {}, change_of_mind);
        for (double t = 0.01; t < pieces.end_s(); t += 0.01)
            ASSERT_LE(turn_between(track::state_at(pieces.at(t - 0.01), t - 0.01).heading_rad,
                                   track::state_at(pieces.at(t), t).heading_rad),
                      math::pi * 0.01 * 1.0001)
                << way.name << " at " << t;
    }
}

TEST(Pieces, DependOnThePieceBeforeAndThePointsNearbyAlone)
{
    const std::vector<track::Point> points = test::ways()[7].points;
    const test::Pieces a(points), b(points);
    for (size_t k = 0; k < a.all.size(); ++k) ASSERT_EQ(a.all[k]->hash, b.all[k]->hash) << k;
    // Farther than two seconds away nothing counts.
    track::BuildSettings settings;
    settings.previous = a.all[19].get(), settings.end_s = 10.5;
    std::vector<track::Point> moved = points;
    for (track::Point &point : moved)
        if (point.time_s < 7.4 || point.time_s > 13.1) point.position.x += 7;
    EXPECT_EQ(test::track_of(points, "citizen", settings)->hash, test::track_of(moved, "citizen", settings)->hash);
    for (track::Point &point : moved) point.position.x += 0.5;
    EXPECT_NE(test::track_of(points, "citizen", settings)->hash, test::track_of(moved, "citizen", settings)->hash);
}

TEST(Pieces, StandStillAcrossManyBorders)
{
    const auto way = [](double t) { return t < 4 ? glm::dvec2(0, 1.2 * t) : glm::dvec2(0.01 * std::sin(t), 4.8); };
    const test::Pieces pieces(test::points_of(10, 20, way));
    const glm::dvec3 at = track::position_at(pieces.at(6), 6);
    for (double t = 6; t < 18; t += 0.05) {
        ASSERT_TRUE(track::state_at(pieces.at(t), t).stands) << t;
        const glm::dvec3 d = track::position_at(pieces.at(t), t) - at;
        ASSERT_LT(std::sqrt(d.x * d.x + d.z * d.z), 1e-9) << t;
    }
    EXPECT_EQ(pieces.all.back()->stand_count, 1u);
}

TEST(Pieces, TakeAnyPointsWithoutHarm)
{
    for (uint64_t seed = 1; seed < 20; ++seed) {
        uint64_t bits = seed;
        const auto number = [&bits] {
            return double((bits = bits * 6364136223846793005u + 1442695040888963407u) >> 33) / (1u << 30);
        };
        std::vector<track::Point> points;
        double t = 0;
        for (int i = 0; i < 40; ++i) {
            points.push_back(
                {t, glm::dvec3(30 * number(), number(), 30 * number()), i % 3 ? std::nan("") : 9 * number()});
            t += 1e-6 + number() * number();
        }
        const test::Pieces pieces(points, "citizen", {0.1 + 0.5 * number(), number(), 30});
        expect_no_jump(pieces, "any points");
        for (double at = -1; at < t + 1; at += 0.07) {
            const track::State state = track::state_at(pieces.at(at), at);
            ASSERT_TRUE(std::isfinite(state.position.x) && std::isfinite(state.heading_rad) &&
                        std::isfinite(state.phase));
            ASSERT_TRUE(state.gait >= 0 && state.gait <= 2);
        }
    }
}

TEST(Pieces, AreSavedAndLoaded)
{
    const test::Pieces pieces(test::ways()[8].points);
    for (const auto &piece : pieces.all) {
        track::Array<uint8_t> bytes;
        track::save(*piece, bytes);
        track::Track back(std::pmr::get_default_resource());
        track::load(bytes.data(), bytes.size(), test::locomotion_of("citizen"), back);
        ASSERT_EQ(back.hash, piece->hash);
        ASSERT_EQ(back.previous_hash, piece->previous_hash);
        for (double t = piece->start_s; t < track::end_of(*piece); t += 0.03)
            for (int f = 0; f < 2; ++f) {
                const track::State state = track::state_at(back, t);
                ASSERT_EQ(track::foot_at(back, state, f, t).x, track::foot_at(*piece, state, f, t).x);
            }
    }
}

TEST(Pieces, ThatFitNowhereAreRefused)
{
    const std::vector<track::Point> points = test::ways()[2].points;
    const test::Pieces pieces(points);
    track::BuildSettings settings;
    settings.end_s = 0.05;
    expect_no_piece(points, CLQ_ARGUMENT, "from 0 s to 0.05 s: it must be 0.1 s long at least", settings);
    settings.end_s = std::nan("");
    expect_no_piece(points, CLQ_ARGUMENT, "end_s of a track is not a number", settings);
    settings.end_s = 3, settings.previous = pieces.all[1].get();
    expect_no_piece({points.begin() + 11, points.end()}, CLQ_ARGUMENT,
                    "the first point of a piece is at 1.1 s, but the piece before ends at 1 s", settings);
    settings.end_s = 0.5;
    expect_no_piece(points, CLQ_ARGUMENT, "from 1 s to 0.5 s", settings);
    settings.end_s = 3, settings.scale = 2;
    expect_no_piece(points, CLQ_ARGUMENT, "a scale of 2 m, the piece before one of 1 m", settings);
    settings.scale = 1;
    try {
        test::track_of(points, "patrician", settings);
        ADD_FAILURE();
    } catch (const base::Error &error) {
        EXPECT_NE(std::string(error.what()).find("another locomotion"), std::string::npos) << error.what();
    }
}

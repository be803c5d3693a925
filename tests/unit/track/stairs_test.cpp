// People on stairs that their path has as a ramp: feet stand on treads, legs reach them, and swings clear the edges.
#include "tests/unit/track/stairs.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/track/feet.h"
#include "tests/unit/track/pieces.h"

using namespace claque;

namespace
{

using test::climb;
using test::settings_for;
using test::Stairs;

// Of the lowest point of a sole over the stone below it, while the foot stands with its whole weight.
struct Gaps {
    double most_above = 0, most_below = 0, sum = 0;
    int count = 0;

    void add(double gap)
    {
        most_above = std::max(most_above, gap), most_below = std::max(most_below, -gap);
        sum += std::fabs(gap), ++count;
    }
    double mean() const { return sum / count; }
};

// The highest stone below the part of a sole that touches it.
double gap_of(const test::SolesInWorld &sole, const Stairs &stairs)
{
    double gap = 1e9;
    for (const glm::dvec3 &p : sole.points) gap = std::min(gap, p.y - stairs.tread(p.z));
    return gap;
}

Gaps gaps_of(const track::Track &track, const Stairs &stairs)
{
    test::Soles soles(*track.locomotion);
    Gaps gaps;
    for (int f = 0; f < 2; ++f)
        for (const track::Plant &plant : track.plants[f])
            for (double t = double(plant.begin_s) + track::landing_s; t <= double(plant.end_s) - track::landing_s;
                 t += 0.02)
                gaps.add(gap_of(test::soles_at(soles, track, f, track.start_s + t, true), stairs));
    return gaps;
}

// How far the sole that touches the stone moves over it while a foot stands.
double drift_of(const track::Track &track)
{
    test::Soles soles(*track.locomotion);
    double most = 0;
    for (int f = 0; f < 2; ++f)
        for (const track::Plant &plant : track.plants[f]) {
            glm::dvec3 sum(0);
            test::SolesInWorld before;
            for (double t = double(plant.begin_s); t <= double(plant.end_s); t += 0.02) {
                test::SolesInWorld now = test::soles_at(soles, track, f, track.start_s + t, true);
                glm::dvec3 moved(0);
                int touching = 0;
                const double stone = double(plant.y) + track.origin_m.y + 0.012;
                for (size_t i = 0; i < before.points.size(); ++i)
                    if (before.points[i].y < stone && now.points[i].y < stone)
                        moved += now.points[i] - before.points[i], ++touching;
                if (touching > 0) sum += moved / double(touching);
                most = std::max(most, std::sqrt(sum.x * sum.x + sum.z * sum.z));
                before = std::move(now);
            }
        }
    return most;
}

// The share of the time in which one of the feet is more than 3 cm in the stone.
double share_in_stone(const track::Track &track, const Stairs &stairs)
{
    test::Soles soles(*track.locomotion);
    double inside = 0, all = 0;
    for (double t = 0; t < track.length_s; t += 0.02)
        for (int f = 0; f < 2; ++f, ++all) inside += gap_of(test::soles_at(soles, track, f, t, true), stairs) < -0.03;
    return inside / all;
}

struct Way {
    const char *figure;
    double run_m, rise_m, speed;
    bool down;
};

std::vector<Way> ways()
{
    std::vector<Way> all;
    for (const char *figure : {"citizen", "decurion"})
        for (const double speed : {0.5, 0.8, 1.3})
            for (const bool down : {false, true}) all.push_back({figure, 0.39, 0.215, speed, down});
    for (const bool down : {false, true}) all.push_back({"patrician", 0.34, 0.17, 0.6, down});
    return all;
}

std::string name_of(const Way &way)
{
    char text[80];
    std::snprintf(text, sizeof text, "%s %s at %g m/s", way.figure, way.down ? "down" : "up", way.speed);
    return text;
}

}  // namespace

TEST(PeopleOnStairs, StandOnTheTreads)
{
    struct {
        double mean = 0, above = 0, below = 0;
    } all;
    for (const Way &way : ways()) {
        Stairs stairs{way.run_m, way.rise_m};
        const auto track = test::track_of(test::climb(stairs, way.speed, way.down), way.figure, settings_for(stairs));
        const Gaps gaps = gaps_of(*track, stairs);
        EXPECT_GT(gaps.count, 200) << name_of(way);
        EXPECT_LT(gaps.mean(), 0.003) << name_of(way);
        EXPECT_LT(gaps.most_above, 0.020) << name_of(way);
        EXPECT_LT(gaps.most_below, 0.010) << name_of(way);
        EXPECT_LT(drift_of(*track), 0.020) << name_of(way);
        EXPECT_LT(share_in_stone(*track, stairs), 0.03) << name_of(way);
        all.mean = std::max(all.mean, gaps.mean()), all.above = std::max(all.above, gaps.most_above);
        all.below = std::max(all.below, gaps.most_below);
    }
    std::printf("stairs: soles are %.4f m beside their tread in the mean, at most %.3f above and %.3f below\n",
                all.mean, all.above, all.below);
}

TEST(PeopleOnStairs, FloatAndSinkWhereTheGroundIsNotKnown)
{
    Stairs stairs;
    for (const bool down : {false, true}) {
        const auto track = test::track_of(climb(stairs, 0.8, down), "citizen", {});
        const Gaps gaps = gaps_of(*track, stairs);
        std::printf("a ramp: soles are %.3f m beside their tread in the mean, at most %.3f above and %.3f below\n",
                    gaps.mean(), gaps.most_above, gaps.most_below);
        EXPECT_GT(gaps.mean(), 0.03);
        EXPECT_GT(gaps.most_above, 0.08);
        EXPECT_GT(gaps.most_below, 0.08);
        EXPECT_GT(share_in_stone(*track, stairs), 0.05);
    }
}

TEST(PeopleOnStairs, KeepTheirStepsAcrossThePiecesOfATrack)
{
    Stairs stairs;
    for (const bool down : {false, true}) {
        const test::Pieces pieces(climb(stairs, 0.8, down), "citizen", {}, nullptr, settings_for(stairs));
        test::Soles soles(*pieces.all[0]->locomotion);
        Gaps gaps;
        for (const auto &piece : pieces.all)
            for (int f = 0; f < 2; ++f)
                for (const track::Plant &plant : piece->plants[f])
                    for (double t = std::max(0.0, double(plant.begin_s) + track::landing_s);
                         t <= std::min(piece->length_s, double(plant.end_s) - track::landing_s); t += 0.02)
                        gaps.add(gap_of(test::soles_at(soles, *piece, f, piece->start_s + t, true), stairs));
        EXPECT_GT(gaps.count, 200);
        EXPECT_LT(gaps.mean(), 0.003);
        EXPECT_LT(gaps.most_below, 0.010);
        int climbing = 0;
        for (size_t k = 1; k < pieces.all.size(); ++k) {
            const track::Track &before = *pieces.all[k - 1], &after = *pieces.all[k];
            climbing += after.climbs;
            const double t = after.start_s;
            for (int f = 0; f < 2; ++f) {
                const float was = track::foot_at(before, track::state_at(before, t), f, t).y;
                EXPECT_NEAR(was, track::foot_at(after, track::state_at(after, t), f, t).y, 0.002) << t;
            }
        }
        EXPECT_GT(climbing, 10);
    }
}

TEST(PeopleOnStairs, MoveTheirHipsSmoothly)
{
    for (const Way &way : ways()) {
        Stairs stairs{way.run_m, way.rise_m};
        const auto track = test::track_of(test::climb(stairs, way.speed, way.down), way.figure, settings_for(stairs));
        const track::Locomotion &locomotion = *track->locomotion;
        pose::Workspace work(locomotion.tmpl->rig, &locomotion.tmpl->motion);
        double before = NAN, fastest = 0, lowest = 0, level = 0;
        for (double t = 0; t < track->length_s; t += 0.02) {
            const track::State state = track::state_at(*track, t);
            pose::Layer layers[3];
            pose::PoseJob job = work.job();
            job.layers = {layers,
                          track::layers_of(locomotion, state.gait, state.turn, state.phase, state.idle, t, layers)};
            const pose::FootTarget feet[] = {track::foot_at(*track, state, 0, t), track::foot_at(*track, state, 1, t)};
            job.feet = {feet, 2};
            job.run();
            const double hip = work.global(locomotion.legs[0].thigh).column(3).y * track->scale;
            if (t == 0) level = hip;
            if (t > 0) fastest = std::max(fastest, std::fabs(hip - before) / 0.02);
            lowest = std::max(lowest, level - hip);
            before = hip;
        }
        EXPECT_LT(fastest, 1.5) << name_of(way);
        EXPECT_LT(lowest, 0.20) << name_of(way);
        EXPECT_GT(lowest, 0.03) << name_of(way);
    }
}

TEST(PeopleOnStairs, StayWithinTheRoomThatTheCrowdGivesThem)
{
    for (const Way &way : ways()) {
        Stairs stairs{way.run_m, way.rise_m};
        const auto track = test::track_of(test::climb(stairs, way.speed, way.down), way.figure, settings_for(stairs));
        test::Soles soles(*track->locomotion);
        const model::Template &tmpl = soles.tmpl();
        const double allowed = double(tmpl.blend_radius.at(0)) + 2 * double(track->locomotion->legs[0].max_shift);
        for (double t = 0; t < track->length_s; t += 0.05)
            for (const std::vector<glm::dvec3> &foot : soles.at(*track, t).points)
                for (const glm::dvec3 &p : foot) {
                    const glm::dvec3 d = p - glm::dvec3(tmpl.sklsroot.centre);
                    ASSERT_LT(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), allowed) << name_of(way);
                }
    }
}

// People on tracks look where they will go before they turn, and pull the shoulder back that is next to a person whom
// they pass.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/math/trig.h"
#include "lib/pose/pose.h"
#include "lib/track/passings.h"
#include "tests/unit/track/pieces.h"

using namespace claque;

namespace
{

double wrapped(double a) { return a - 2 * math::pi * std::floor(a / (2 * math::pi) + 0.5); }

// A person on a track, posed as the crowd poses it.
class Posed
{
public:
    explicit Posed(const track::Track &track)
        : track_(&track), work_(track.locomotion->tmpl->rig, &track.locomotion->tmpl->motion)
    {
    }
    void at(double time_s, bool turned = true)
    {
        state_ = track::state_at(*track_, time_s);
        pose::Layer layers[3];
        pose::PoseJob job = work_.job();
        job.layers = {layers, track::layers_of(*track_->locomotion, state_.gait, state_.turn, state_.phase, state_.idle,
                                               time_s, layers)};
        const pose::FootTarget feet[] = {track::foot_at(*track_, state_, 0, time_s),
                                         track::foot_at(*track_, state_, 1, time_s)};
        job.feet = {feet, 2};
        if (turned) job.upper = track::upper_at(*track_, state_, time_s);
        job.run();
    }
    const track::State &state() const { return state_; }
    uint32_t node(const char *name) const { return track_->locomotion->tmpl->rig.find_node(name); }
    uint32_t node_count() const { return track_->locomotion->tmpl->rig.node_count(); }
    glm::dvec3 place(uint32_t node) const { return in_world(work_.global(node).column(3)) + state_.position; }
    // The heading of a node's own z.
    double heading(uint32_t node) const
    {
        const glm::dvec3 ahead = in_world(work_.global(node).column(2));
        return std::atan2(ahead.x, ahead.z);
    }

private:
    glm::dvec3 in_world(const glm::vec3 &v) const
    {
        const double c = std::cos(state_.heading_rad), s = std::sin(state_.heading_rad);
        return glm::dvec3(double(v.x) * c + double(v.z) * s, double(v.y), -double(v.x) * s + double(v.z) * c);
    }
    const track::Track *track_;
    track::State state_;
    pose::Workspace work_;
};

const test::Way &way(const char *name)
{
    static const std::vector<test::Way> all = test::ways();
    return *std::find_if(all.begin(), all.end(), [&](const test::Way &w) { return std::string(w.name) == name; });
}

// The first time at which an angle is past `half`.
template <class Angle>
double when_past(const track::Track &track, double half, const Angle &angle)
{
    for (double t = 0; t < track.length_s; t += 0.01)
        if (angle(t) > half) return t;
    return 1e9;
}

// Two people who pass each other on parallel ways, the second one to the left of the first.
struct Pair {
    std::vector<track::Point> points[2];
    std::vector<track::FoundPassing> found;
    std::unique_ptr<track::Track> tracks[2];

    explicit Pair(double apart_m, bool turns = true, uint64_t seed = 0)
    {
        points[0] = test::points_of(5, 10, [](double t) { return glm::dvec2(0, 1.2 * (t - 5)); });
        points[1] = test::points_of(5, 10, [=](double t) { return glm::dvec2(apart_m, -1.2 * (t - 5)); });
        const base::Span<const track::Point> people[] = {{points[0].data(), 51}, {points[1].data(), 51}};
        track::Array<track::FoundPassing> all;
        track::find_passings({people, 2}, 1, all);
        found.assign(all.begin(), all.end());
        for (uint32_t i = 0; i < 2; ++i) {
            std::vector<track::Passing> own;
            for (const track::FoundPassing &one : found)
                if (one.person == i && turns) own.push_back(one.passing);
            track::BuildSettings settings;
            settings.passings = base::Span<const track::Passing>(own), settings.seed = seed;
            tracks[i] = test::track_of(points[i], "citizen", settings);
        }
    }
};

double flat_distance(const glm::dvec3 &a, const glm::dvec3 &b) { return std::hypot(a.x - b.x, a.z - b.z); }

}  // namespace

TEST(Gaze, IsAheadOfTheHeadingRoundACorner)
{
    const auto track = test::track_of(way("a corner").points);
    Posed person(*track);
    const uint32_t head = person.node("head");
    const double body =
        when_past(*track, math::pi / 4, [&](double t) { return track::state_at(*track, t).heading_rad; });
    const double gaze = when_past(*track, math::pi / 4, [&](double t) {
        person.at(t);
        return wrapped(person.heading(head));
    });
    EXPECT_GT(body - gaze, 0.3);
    EXPECT_LT(body - gaze, 0.8);
}

TEST(Gaze, IsAheadOfATurnOnTheSpot)
{
    // Stands for four seconds, then leaves to the left.
    const auto track = test::track_of(test::points_of(
        10, 14, [](double t) { return t < 4 ? glm::dvec2(0, 1.2 * t) : glm::dvec2(std::max(0.0, t - 8.0), 4.8); }));
    Posed person(*track);
    const uint32_t head = person.node("head");
    bool looked = false;
    for (double t = 5; t < 10; t += 0.02) {
        person.at(t);
        const track::State now = person.state();
        if (now.stands && wrapped(person.heading(head) - now.heading_rad) > 0.25) looked = true;
    }
    EXPECT_TRUE(looked) << "the head turns while the body still stands";
}

TEST(Gaze, OfPiecesIsThatOfTheWholeTrackAndDoesNotJump)
{
    for (const char *name : {"a corner", "to and fro", "stop and go"}) {
        const auto whole = test::track_of(way(name).points);
        const test::Pieces pieces(way(name).points);
        double before = 0, away = 0, most = 0;
        int count = 0;
        for (double t = pieces.start_s(); t < pieces.end_s(); t += 0.02, ++count) {
            const track::Track &piece = pieces.at(t);
            const double gaze = double(track::upper_at(piece, track::state_at(piece, t), t).gaze_rad);
            const double step = count > 0 ? std::fabs(gaze - before) : 0;
            ASSERT_LT(step, 0.15) << name << " at " << t;
            away += std::fabs(gaze - double(track::upper_at(*whole, track::state_at(*whole, t), t).gaze_rad));
            before = gaze, most = std::max(most, std::fabs(gaze));
        }
        EXPECT_LT(away / count, 0.1) << name;
        EXPECT_GE(most, std::string(name) == "stop and go" ? 0 : 0.4) << name;
    }
}

TEST(Gaze, IsStraightAheadOnAStraightWay)
{
    for (const char *name : {"ahead at 0.6 m/s", "ahead at 1.1 m/s", "ahead at 2.6 m/s"}) {
        const auto track = test::track_of(way(name).points);
        for (double t = 1; t < track->length_s; t += 0.1)
            ASSERT_LT(std::fabs(track::upper_at(*track, track::state_at(*track, t), t).gaze_rad), 0.02f) << name;
    }
}

TEST(Gaze, StaysWithinWhatANeckTurns)
{
    for (const test::Way &one : test::ways()) {
        const auto track = test::track_of(one.points);
        for (double t = 0; t < track->length_s; t += 0.02)
            ASSERT_LE(std::fabs(track::upper_at(*track, track::state_at(*track, t), t).gaze_rad), 1.1f) << one.name;
    }
}

TEST(Gaze, OfATemplateWithoutAHeadTurnsNothing)
{
    pose::Upper upper;
    math::Columns nodes[2] = {};
    nodes[0].c[0] = math::F4{1, 2, 3, 0};
    pose::UpperTarget target{&upper, 0.5f, 0.5f};
    pose::turn_upper(target, nullptr, nodes);
    EXPECT_EQ(nodes[0].c[0][0], 1);
    EXPECT_EQ(nodes[0].c[0][2], 3);
}

TEST(Joints, MoveNoFasterThanPeopleCan)
{
    for (const test::Way &one : test::ways()) {
        const auto track = test::track_of(one.points);
        Posed person(*track);
        std::vector<glm::dvec3> before;
        double head_before = 0;
        for (double t = 0; t < track->length_s; t += 0.01) {
            person.at(t);
            std::vector<glm::dvec3> now;
            for (uint32_t n = 0; n < person.node_count(); ++n) now.push_back(person.place(n));
            const double head = person.heading(person.node("head"));
            for (size_t n = 0; n < before.size(); ++n) {
                const glm::dvec3 d = now[n] - before[n];
                ASSERT_LT(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), 0.075)
                    << one.name << " node " << n << " at " << t;
            }
            // A glance takes a head to 400 degrees a second.
            const double turned = before.empty() ? 0 : std::fabs(wrapped(head - head_before));
            ASSERT_LT(turned, 0.07) << one.name << " at " << t;
            before = std::move(now), head_before = head;
        }
    }
}

TEST(Passings, OfTwoPeopleAreFoundForBoth)
{
    const Pair pair(0.6);
    ASSERT_EQ(pair.found.size(), 2u);
    for (uint32_t i = 0; i < 2; ++i) {
        EXPECT_EQ(pair.found[i].person, i);
        EXPECT_NEAR(pair.found[i].passing.time_s, 5, 0.02);
        EXPECT_NEAR(pair.found[i].passing.position.x, i == 0 ? 0.6 : 0, 1e-6);
        EXPECT_NEAR(pair.found[i].passing.position.z, 0, 0.02);
    }
    EXPECT_TRUE(Pair(1.1).found.empty()) << "farther than a metre";
}

TEST(Shoulders, TurnAwayFromThePersonThatPasses)
{
    // The mean of several pairs: a walk turns the shoulders too, to and fro.
    constexpr uint64_t seeds = 12;
    double farther = 0;
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        const Pair with(0.55, true, seed), without(0.55, false, seed);
        Posed a(*with.tracks[0]), b(*with.tracks[1]), c(*without.tracks[0]), d(*without.tracks[1]);
        const uint32_t left = a.node("upper_arm_l");
        double nearest = 1e9, nearest_unturned = 1e9;
        for (double t = 4; t < 6; t += 0.02) {
            a.at(t), b.at(t), c.at(t), d.at(t);
            nearest = std::min(nearest, flat_distance(a.place(left), b.place(left)));
            nearest_unturned = std::min(nearest_unturned, flat_distance(c.place(left), d.place(left)));
        }
        farther += (nearest - nearest_unturned) / seeds;
    }
    EXPECT_GT(farther, 0.02);
    const Pair with(0.55), without(0.55, false);
    Posed a(*with.tracks[0]), c(*without.tracks[0]);
    a.at(5);
    EXPECT_GT(track::upper_at(*with.tracks[0], a.state(), 5).torso_rad, 0.3f) << "to the left";
    EXPECT_NEAR(track::upper_at(*with.tracks[0], a.state(), 3.9).torso_rad, 0, 1e-6);
    EXPECT_NEAR(track::upper_at(*with.tracks[0], a.state(), 6.1).torso_rad, 0, 1e-6);
    for (const double at : {-1.7e308, 1.7e308}) EXPECT_EQ(track::upper_at(*with.tracks[0], a.state(), at).torso_rad, 0);
    // The head keeps its direction.
    c.at(5);
    EXPECT_NEAR(wrapped(a.heading(a.node("head")) - c.heading(c.node("head"))), 0, 0.03);
    EXPECT_GT(wrapped(a.heading(a.node("chest")) - c.heading(c.node("chest"))), 0.3);
}

TEST(Shoulders, TurnTheLessTheFartherTheOtherIs)
{
    const auto turn_at = [](double apart) {
        const Pair pair(apart);
        return double(track::upper_at(*pair.tracks[0], track::state_at(*pair.tracks[0], 5), 5).torso_rad);
    };
    EXPECT_GT(turn_at(0.55), turn_at(0.75) + 0.1);
    EXPECT_LT(turn_at(0.97), 0.05);
    EXPECT_LT(turn_at(-0.6), -0.3) << "on the right";
}

TEST(Shoulders, KeepWithinTheSphereThatTheCrowdGivesThem)
{
    const Pair pair(0.5);
    const model::Template &tmpl = *pair.tracks[0]->locomotion->tmpl;
    const glm::dvec3 centre(tmpl.sklsroot.centre);
    const double allowed = double(pair.tracks[0]->locomotion->legs[0].max_shift);
    pose::Workspace work(tmpl.rig, &tmpl.motion);
    double most = 0;
    for (uint32_t clip = 0; clip < tmpl.rig.clips.size(); ++clip)
        for (const float way : {-1.0f, 1.0f})
            for (int k = 0; k < 8; ++k) {
                pose::PoseJob job = work.job();
                job.clip = clip, job.time_s = 0.125 * k * double(tmpl.rig.clips[clip].duration_s);
                job.run();
                std::vector<double> before;
                const auto reach = [&](uint32_t node) {
                    const glm::dvec3 d = glm::dvec3(work.global(node).column(3)) - centre;
                    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
                };
                for (uint32_t n = 0; n < tmpl.rig.node_count(); ++n) before.push_back(reach(n));
                job.upper = {&pair.tracks[0]->locomotion->upper, way * -1.1f, way * 0.6f};
                job.run();
                for (uint32_t n = 0; n < tmpl.rig.node_count(); ++n) most = std::max(most, reach(n) - before[n]);
            }
    EXPECT_LE(most, allowed * 1.0001);
    EXPECT_GT(most, 0);
}

// The clips and cells of a gait against what they are said to be: shares that are linear in the gait, cells between
// those measured, and measures that the posed skeleton itself has.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "lib/pose/pose.h"
#include "meshsplit/build.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

// By which share each clip is seen: the layers cover each other in their order.
double share_of(const pose::Layer *layers, uint32_t count, uint32_t clip)
{
    double share = 0;
    for (uint32_t k = 0; k < count; ++k)
        share = share * (1 - double(layers[k].weight)) + (layers[k].clip == clip ? double(layers[k].weight) : 0);
    return share;
}

// 1 at `top`, 0 at the steps of the axis beside it.
double tent(double gait, double below, double top, double above)
{
    if (gait <= top) return below < top ? std::fmax(0, (gait - below) / (top - below)) : 1;
    return above > top ? std::fmax(0, (above - gait) / (above - top)) : 1;
}

track::Locomotion measured(const track::LocomotionClips &clips)
{
    track::Locomotion out(std::pmr::get_default_resource());
    track::measure(*test::locomotion_of("citizen").tmpl, clips, out);
    return out;
}

double fraction(double x) { return x - std::floor(x); }

}  // namespace

TEST(GaitAxis, SharesItsClipsLinearlyAndAtTheirPhase)
{
    const track::LocomotionClips all = test::locomotion_of("citizen").clips;
    for (const bool slows : {true, false})
        for (const bool runs : {true, false}) {
            track::LocomotionClips clips = all;
            if (!slows) clips.slow = model::none;
            if (!runs) clips.run = model::none;
            const track::Locomotion people = measured(clips);
            const model::Rig &rig = people.tmpl->rig;
            for (double gait = 0; gait <= (runs ? 2.0 : 1.0); gait += 0.0625)
                for (const float turn : {0.0f, 0.25f, 1.0f}) {
                    pose::Layer layers[3];
                    const double phase = 7.3 + gait, idle_s = 21.7;
                    const uint32_t count = track::layers_of(people, float(gait), turn, phase, 1, idle_s, layers);
                    ASSERT_LE(count, 3u);
                    const double walks = 1 - double(turn), slow = slows ? 0.5 : 0;
                    const auto seen = [&](uint32_t clip) { return share_of(layers, count, clip); };
                    EXPECT_NEAR(seen(clips.idles[1]), walks * tent(gait, 0, 0, slows ? slow : 1), 1e-6) << gait;
                    if (slows) EXPECT_NEAR(seen(clips.slow), walks * tent(gait, 0, 0.5, 1), 1e-6) << gait;
                    EXPECT_NEAR(seen(clips.walk), walks * tent(gait, slow, 1, runs ? 2 : 1), 1e-6) << gait;
                    if (runs) EXPECT_NEAR(seen(clips.run), walks * tent(gait, 1, 2, 2), 1e-6) << gait;
                    EXPECT_NEAR(seen(clips.turn), turn, 1e-6);
                    for (uint32_t k = 0; k < count; ++k) {
                        const pose::Layer &layer = layers[k];
                        const model::Clip &clip = rig.clips[layer.clip];
                        const float ahead = layer.clip == clips.run    ? people.run_phase
                                            : layer.clip == clips.slow ? people.slow_phase
                                            : layer.clip == clips.turn ? people.turn_phase
                                                                       : 0.0f;
                        const double length = double(clip.duration_s);
                        const double cycles = layer.clip == clips.idles[1] ? idle_s / length : phase + double(ahead);
                        EXPECT_NEAR(layer.time_s, double(clip.start_s) + fraction(cycles) * length, 1e-6);
                    }
                }
        }
}

TEST(GaitAxis, StandsWithItsFirstClipWhereItHasNoOtherAndWithNoneAtRest)
{
    track::LocomotionClips clips = test::locomotion_of("citizen").clips;
    for (const uint32_t count : {0u, 1u, 3u}) {
        clips.idle_count = count;
        const track::Locomotion people = measured(clips);
        for (uint32_t idle = 0; idle < 4; ++idle) {
            pose::Layer layers[3];
            ASSERT_EQ(track::layers_of(people, 0, 0, 0.3, idle, 0.1, layers), 1u);
            EXPECT_EQ(layers[0].clip, count == 0 ? model::none : clips.idles[idle < count ? idle : 0]);
            EXPECT_EQ(layers[0].weight, 1);
        }
    }
}

TEST(GaitAxis, HasTheCellsThatWereMeasuredAndTheirMeansBetweenThem)
{
    const track::Locomotion &people = test::locomotion_of("citizen");
    constexpr uint32_t phases = track::phase_count;
    const auto of = [](const track::GaitCell &cell) {
        std::vector<double> out = {double(cell.advance)};
        for (int f = 0; f < 2; ++f)
            for (const float x : {cell.x[f], cell.z[f], cell.supports[f], cell.reach[f], cell.hip_x[f], cell.hip_z[f],
                                  cell.node_x[f], cell.node_z[f], cell.yaw[f]})
                out.push_back(double(x));
        return out;
    };
    const auto expect_mean = [&](const track::GaitCell &found, std::initializer_list<track::GaitCell> cells, int line) {
        const std::vector<double> own = of(found);
        for (size_t k = 0; k < own.size(); ++k) {
            double sum = 0;
            for (const track::GaitCell &cell : cells) sum += of(cell)[k];
            ASSERT_NEAR(own[k], sum / double(cells.size()), 1e-5) << "line " << line << ", number " << k;
        }
    };
    for (uint32_t step = 0; step < track::gait_step_count; ++step)
        for (uint32_t p = 0; p < phases; ++p) {
            const double gait = double(track::gait_steps[step]), phase = (p + 1e-9) / double(phases) - 3;
            const track::GaitCell &cell = people.cell(step, p), &next = people.cell(step, (p + 1) % phases);
            expect_mean(track::cell_at(people, gait, 0, phase), {cell}, __LINE__);
            expect_mean(track::cell_at(people, gait, 0, phase + 0.5 / phases), {cell, next}, __LINE__);
            expect_mean(track::cell_at(people, gait, 1, phase), {people.turn_cells[p]}, __LINE__);
            expect_mean(track::cell_at(people, gait, 0.5, phase), {cell, people.turn_cells[p]}, __LINE__);
            if (step + 1 == track::gait_step_count) continue;
            const double between = (gait + double(track::gait_steps[step + 1])) / 2;
            expect_mean(track::cell_at(people, between, 0, phase), {cell, people.cell(step + 1, p)}, __LINE__);
            const double mean_s = (double(people.cycle_s[step]) + double(people.cycle_s[step + 1])) / 2;
            ASSERT_NEAR(track::cycle_s_at(people, between), mean_s, 1e-6);
        }
    for (const double beyond : {-1.0, 3.0}) {
        const uint32_t step = beyond < 0 ? 0 : track::gait_step_count - 1;
        expect_mean(track::cell_at(people, beyond, 0, 0), {people.cell(step, 0)}, __LINE__);
        EXPECT_NEAR(track::cycle_s_at(people, beyond), double(people.cycle_s[step]), 1e-6);
    }
}

// Every cell against the skeleton in that pose: hips, feet, and how far a straight leg reaches when the foot is let
// down to the ground.
TEST(GaitAxis, HasTheFeetHipsAndLegsThatThePoseHas)
{
    const track::Locomotion &people = test::locomotion_of("decurion");
    pose::Workspace work(people.tmpl->rig, &people.tmpl->motion);
    const auto place = [&](uint32_t node) { return glm::dvec3(work.global(node).column(3)); };
    for (uint32_t step = 0; step <= track::gait_step_count; ++step)
        for (uint32_t p = 0; p < track::phase_count; p += 5) {
            const bool turns = step == track::gait_step_count;
            pose::Layer layers[3];
            pose::PoseJob job = work.job();
            job.layers = {layers, track::layers_of(people, turns ? 0 : track::gait_steps[step], turns ? 1.0f : 0.0f,
                                                   double(p) / track::phase_count, 0, 0, layers)};
            job.run();
            const track::GaitCell &cell = turns ? people.turn_cells[p] : people.cell(step, p);
            for (int f = 0; f < 2; ++f) {
                const pose::Leg &leg = people.legs[f];
                const pose::Print print = pose::print_of(leg, job.globals.data);
                const glm::vec3 ball = math::transform_point(work.global(leg.foot), leg.ball),
                                heel = math::transform_point(work.global(leg.foot), leg.heel);
                const glm::dvec3 sole(print.x, 0, print.z), ahead(ball - heel);
                const glm::dvec3 hip = place(leg.thigh), knee = place(leg.shin), foot = place(leg.foot);
                EXPECT_NEAR(double(cell.x[f]), sole.x, 1e-5);
                EXPECT_NEAR(double(cell.z[f]), sole.z, 1e-5);
                EXPECT_NEAR(double(cell.hip_x[f]), hip.x, 1e-5);
                EXPECT_NEAR(double(cell.hip_z[f]), hip.z, 1e-5);
                EXPECT_NEAR(double(cell.node_x[f]), foot.x - sole.x, 1e-5);
                EXPECT_NEAR(double(cell.node_z[f]), foot.z - sole.z, 1e-5);
                const auto length = [](const glm::dvec3 &d) { return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z); };
                const double straight = length(hip - knee) + length(knee - foot);
                EXPECT_NEAR(double(cell.yaw[f]), std::atan2(ahead.x, ahead.z), 1e-5);
                const double high = hip.y - (foot.y - double(print.low));
                EXPECT_NEAR(std::hypot(double(cell.reach[f]), high), straight, 2e-4) << step << ", " << p;
            }
        }
}

namespace
{

// A citizen whose jog leaps: its hips go up and down by 20 cm twice a cycle.
struct Leaper {
    Leaper() : tmpl(std::pmr::get_default_resource()), walks(std::pmr::get_default_resource())
    {
        model::Model model = figures::citizen();
        model::Rig &rig = model.rig;
        const model::Clip &jog = rig.clips[rig.find_clip("jog")];
        for (uint32_t c = jog.first_channel; c < jog.first_channel + jog.channel_count; ++c) {
            const model::Channel &channel = rig.channels[c];
            if (channel.target != model::ChannelTarget::translation) continue;
            for (uint32_t k = 0; k < channel.key_count; ++k) {
                const double part = double(rig.times[channel.first_time + k] - jog.start_s) / double(jog.duration_s);
                rig.values[channel.first_value + 3 * k + 1] += 0.1f * float(1 - std::cos(4 * 3.14159265 * part));
            }
        }
        meshsplit::build(model, {}, tmpl);
        track::measure(tmpl, test::locomotion_of("citizen").clips, walks);
    }
    model::Template tmpl;
    track::Locomotion walks;
};

// Returns the phases of flight, in which no foot carries weight.
int expect_advance(const track::Locomotion &people)
{
    constexpr uint32_t phases = track::phase_count;
    int flights = 0;
    for (uint32_t step = 1; step < track::gait_step_count; ++step) {
        const auto cell = [&](uint32_t p) -> const track::GaitCell & { return people.cell(step, p % phases); };
        const auto pace = [&](uint32_t p) {
            double most = -1;
            for (int f = 0; f < 2; ++f)
                if (cell(p).supports[f] > 0)
                    most = std::fmax(std::fmax(most, 0),
                                     double(cell(p + phases - 1).z[f] - cell(p + 1).z[f]) * phases / 2);
            return most;
        };
        double mean = 0;
        for (uint32_t p = 0; p < phases; ++p) {
            double own = pace(p);
            if (own < 0) {
                EXPECT_GT(track::gait_steps[step], 1) << "who walks has a foot on the ground";
                ++flights;
                uint32_t before = p + phases, after = p;
                while (pace(before) < 0) --before;
                while (pace(after) < 0) ++after;
                const double gone = double(p + phases - before) / double(after + phases - before);
                own = pace(before) + (pace(after) - pace(before)) * gone;
            }
            mean += own / phases;
            // What a foot that pauses would stop goes on at a third of the stride, nearly.
            EXPECT_NEAR(double(cell(p).advance), std::fmax(own, 0.35 * double(people.stride[step])), 1e-4)
                << step << ", " << p;
        }
        EXPECT_NEAR(double(people.stride[step]), mean, 1e-4) << track::gait_steps[step];
    }
    return flights;
}

}  // namespace

// The body goes ahead as fast as the foot that carries it moves back; as the faster of two; in flight between the pace
// before it and the pace behind.
TEST(GaitAxis, AdvancesAsTheFeetThatCarryItMoveBack)
{
    for (const char *figure : {"citizen", "plebeian"}) {
        const track::Locomotion &people = test::locomotion_of(figure);
        expect_advance(people);
        for (const float supports : {people.cell(0, 3).supports[0], people.cell(0, 9).supports[1]})
            EXPECT_EQ(supports, 1);
    }
    EXPECT_GT(expect_advance(Leaper().walks), 10);
}

TEST(GaitAxis, LastsAsLongAsItsClips)
{
    const track::Locomotion &people = test::locomotion_of("citizen");
    const model::Rig &rig = people.tmpl->rig;
    const auto length = [&](uint32_t clip) { return double(rig.clips[clip].duration_s); };
    const double walk = length(people.clips.walk), run = length(people.clips.run), slow = length(people.clips.slow);
    for (uint32_t step = 0; step < track::gait_step_count; ++step) {
        const double gait = double(track::gait_steps[step]);
        const double wanted = gait <= 0.5 ? slow
                              : gait <= 1 ? slow + (walk - slow) * (gait - 0.5) * 2
                                          : walk + (run - walk) * (gait - 1);
        EXPECT_NEAR(double(people.cycle_s[step]), wanted, 1e-6) << gait;
    }
    EXPECT_FLOAT_EQ(people.turn_cycle_s, rig.clips[people.clips.turn].duration_s);
    EXPECT_FLOAT_EQ(people.max_gait(), 2);
    track::LocomotionClips clips = people.clips;
    clips.run = model::none;
    EXPECT_FLOAT_EQ(measured(clips).max_gait(), 1);
}

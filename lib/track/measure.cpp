// Measures the gaits of a template: poses it at every step of the gait axis and phase, and watches its feet.
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "lib/pose/pose.h"
#include "lib/track/clip_checks.h"
#include "lib/track/sole.h"
#include "lib/track/track_file.h"

namespace claque::track
{

namespace
{

using base::fail;
using model::none;

glm::vec3 place_of(const pose::Workspace &work, uint32_t node) { return work.global(node).column(3); }

double distance(const glm::vec3 &a, const glm::vec3 &b)
{
    const glm::dvec3 d = glm::dvec3(a) - glm::dvec3(b);
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

void set_legs(const model::Template &tmpl, Locomotion &out)
{
    std::pmr::memory_resource *memory = out.cells.get_allocator().resource();
    pose::Workspace work(tmpl.rig, &tmpl.motion);
    const uint32_t idle = out.clips.idle_count > 0 ? out.clips.idles[0] : none;
    work.pose(idle, idle == none ? 0 : double(tmpl.rig.clips[idle].start_s));
    double length = 0;
    for (int f = 0; f < 2; ++f) {
        const uint32_t *nodes = out.clips.legs[f];
        const glm::vec3 hip = place_of(work, nodes[0]), knee = place_of(work, nodes[1]),
                        ankle = place_of(work, nodes[2]);
        length += 0.5 * (distance(hip, knee) + distance(knee, ankle));
    }
    out.leg_length = static_cast<float>(length);
    if (!(out.leg_length > 0))
        fail(CLQ_ARGUMENT, "the legs of template '%s' have no length: thigh, shin and foot are in one place",
             tmpl.name.c_str());
    for (int f = 0; f < 2; ++f) {
        const uint32_t *nodes = out.clips.legs[f];
        pose::Leg &leg = out.legs[f];
        leg.thigh = nodes[0], leg.shin = nodes[1], leg.foot = nodes[2];
        leg.thigh_nodes = pose::nodes_below(tmpl.rig, nodes[0], nodes[1], memory);
        leg.shin_nodes = pose::nodes_below(tmpl.rig, nodes[1], nodes[2], memory);
        leg.foot_nodes = pose::nodes_below(tmpl.rig, nodes[2], none, memory);
        leg.max_shift = 0.3f * out.leg_length;
        leg.ankle = math::transform_point(math::inverse(work.global(nodes[1])), place_of(work, nodes[2]));
        set_sole(tmpl, work, nodes[3], leg);
    }
}

void set_upper(const model::Template &tmpl, Locomotion &out)
{
    std::pmr::memory_resource *memory = out.cells.get_allocator().resource();
    const auto below = [&](uint32_t node) {
        return node == none ? Array<uint32_t>(memory) : pose::nodes_below(tmpl.rig, node, none, memory);
    };
    pose::Upper &upper = out.upper;
    upper.torso = out.clips.torso, upper.neck = out.clips.neck, upper.head = out.clips.head;
    upper.torso_nodes = below(upper.torso), upper.neck_nodes = below(upper.neck), upper.head_nodes = below(upper.head);
    upper.centre_x = tmpl.sklsroot.centre.x, upper.centre_z = tmpl.sklsroot.centre.z;
    upper.room = out.legs[0].max_shift;
}

// The feet over one cycle of one gait.
struct FootPath {
    double low[2][phase_count];                            // height of the lower of ball and heel
    double x[2][phase_count], z[2][phase_count];           // of the sole
    double yaw[2][phase_count];                            // to which the foot points
    glm::dvec3 hip[2][phase_count], node[2][phase_count];  // the foot's node as seen from the sole
    double length[2][phase_count];                         // of the leg
};

FootPath watch(const Locomotion &locomotion, float gait, float turn, pose::Workspace &work)
{
    FootPath path{};
    pose::PoseJob job = work.job();
    for (uint32_t p = 0; p < phase_count; ++p) {
        pose::Layer layers[3];
        const uint32_t count = layers_of(locomotion, gait, turn, double(p) / phase_count, 0, 0, layers);
        job.layers = {layers, count};
        job.run();
        for (int f = 0; f < 2; ++f) {
            const pose::Leg &leg = locomotion.legs[f];
            const pose::Print print = pose::print_of(leg, job.globals.data);
            const glm::vec3 hip = place_of(work, leg.thigh), knee = place_of(work, leg.shin);
            const glm::vec3 sole(print.x, print.low, print.z);
            path.hip[f][p] = glm::dvec3(hip);
            path.node[f][p] = glm::dvec3(place_of(work, leg.foot)) - glm::dvec3(sole);
            path.length[f][p] = distance(hip, knee) + distance(knee, pose::point_of(job.globals[leg.shin], leg.ankle));
            const auto height = [&](const glm::vec3 &p) { return pose::point_of(job.globals[leg.foot], p).y; };
            path.low[f][p] = double(std::min(height(leg.ball), height(leg.heel)));
            path.x[f][p] = double(print.x), path.z[f][p] = double(print.z);
            path.yaw[f][p] = math::atan2(double(print.ahead_x), double(print.ahead_z));
        }
    }
    return path;
}

// How fast a foot moves back, per cycle.
double backwards(const FootPath &path, int f, uint32_t p)
{
    const uint32_t next = (p + 1) % phase_count, before = (p + phase_count - 1) % phase_count;
    return (path.z[f][before] - path.z[f][next]) * phase_count / 2;
}

// The height below which a foot may carry weight.
double low_of(const FootPath &path, int f, float leg_length)
{
    return *std::min_element(path.low[f], path.low[f] + phase_count) + 0.035 * double(leg_length);
}

// How feet move the ground in a cycle, by what they do while they are low. Lifting one settles it for most steps: feet
// that stay low go to and fro by as much.
glm::dvec2 moved_ground(const FootPath &path, float leg_length)
{
    glm::dvec2 ground(0);
    for (int f = 0; f < 2; ++f) {
        const double low = low_of(path, f, leg_length);
        for (uint32_t p = 0; p < phase_count; ++p) {
            const uint32_t next = (p + 1) % phase_count, before = (p + phase_count - 1) % phase_count;
            if (path.low[f][p] > low) continue;
            ground.x += (path.x[f][next] - path.x[f][before]) / 2;
            ground.y += (path.z[f][next] - path.z[f][before]) / 2;
        }
    }
    return ground;
}

// A foot carries weight in the longest run of phases in which it is low and moves back.
void find_support(const FootPath &path, int f, float leg_length, bool out[phase_count])
{
    const double low = low_of(path, f, leg_length);
    uint32_t best = 0, best_length = 0, run = 0;
    for (uint32_t i = 0; i < 2 * phase_count; ++i) {
        const uint32_t p = i % phase_count;
        run = path.low[f][p] <= low && backwards(path, f, p) > 0 ? std::min(run + 1, phase_count) : 0;
        if (run > best_length) best_length = run, best = i + 1 - run;
    }
    std::fill(out, out + phase_count, false);
    for (uint32_t i = 0; i < best_length; ++i) out[(best + i) % phase_count] = true;
}

// Where neither foot carries weight the body keeps the pace that it had on both sides.
void fill_flight(double advance[phase_count], const bool known[phase_count])
{
    for (uint32_t p = 0; p < phase_count; ++p) {
        if (known[p]) continue;
        uint32_t before = 1, after = 1;
        while (before < phase_count && !known[(p + phase_count - before) % phase_count]) ++before;
        while (after < phase_count && !known[(p + after) % phase_count]) ++after;
        const double a = advance[(p + phase_count - before) % phase_count], b = advance[(p + after) % phase_count];
        advance[p] = (a * after + b * before) / (before + after);
    }
}

// Where the feet are at a phase, whether they carry weight, and how far their legs reach.
void set_feet(const FootPath &path, const bool supports[2][phase_count], uint32_t p, GaitCell &cell)
{
    for (int f = 0; f < 2; ++f) {
        cell.x[f] = static_cast<float>(path.x[f][p]), cell.z[f] = static_cast<float>(path.z[f][p]);
        cell.yaw[f] = static_cast<float>(path.yaw[f][p]);
        cell.supports[f] = supports[f][p];
        // The foot comes down to the ground, and with it the ankle; the hip stays.
        const glm::dvec3 &hip = path.hip[f][p], &node = path.node[f][p];
        const double height = hip.y - node.y;
        const double square = path.length[f][p] * path.length[f][p] - height * height;
        cell.reach[f] = static_cast<float>(square > 0 ? std::sqrt(square) : 0);
        cell.hip_x[f] = static_cast<float>(hip.x), cell.hip_z[f] = static_cast<float>(hip.z);
        cell.node_x[f] = static_cast<float>(node.x), cell.node_z[f] = static_cast<float>(node.z);
    }
}

// Steps on the spot: a foot carries weight while it is low.
void measure_turn(Locomotion &out, pose::Workspace &work)
{
    const FootPath path = watch(out, 0, 1, work);
    bool supports[2][phase_count];
    for (int f = 0; f < 2; ++f) {
        const double ground = *std::min_element(path.low[f], path.low[f] + phase_count);
        for (uint32_t p = 0; p < phase_count; ++p)
            supports[f][p] = path.low[f][p] <= ground + 0.012 * double(out.leg_length);
    }
    out.turn_cells.resize(phase_count);
    for (uint32_t p = 0; p < phase_count; ++p) {
        if (!supports[0][p] && !supports[1][p]) supports[path.low[0][p] <= path.low[1][p] ? 0 : 1][p] = true;
        set_feet(path, supports, p, out.turn_cells[p]);
    }
}

void measure_step(Locomotion &out, uint32_t step, pose::Workspace &work)
{
    const FootPath path = watch(out, gait_steps[step], 0, work);
    if (is_of_one_clip(out.clips, step)) {
        const glm::dvec2 ground = moved_ground(path, out.leg_length);
        check_direction(*out.tmpl, clip_of_step(out.clips, step), ground.x / double(out.leg_length),
                        ground.y / double(out.leg_length));
    }
    bool supports[2][phase_count], known[phase_count] = {};
    for (int f = 0; f < 2; ++f) {
        if (step == 0) std::fill(supports[f], supports[f] + phase_count, true);
        else find_support(path, f, out.leg_length, supports[f]);
    }
    // Walking people have a foot on the ground at any time: the lower one, where neither was found.
    if (step <= walk_step)
        for (uint32_t p = 0; p < phase_count; ++p)
            if (!supports[0][p] && !supports[1][p]) supports[path.low[0][p] <= path.low[1][p] ? 0 : 1][p] = true;
    double advance[phase_count] = {}, sum = 0;
    for (uint32_t p = 0; p < phase_count; ++p) {
        known[p] = supports[0][p] || supports[1][p];
        // The faster foot: the other one is landing or leaving.
        for (int f = 0; f < 2; ++f)
            if (supports[f][p]) advance[p] = std::max(advance[p], backwards(path, f, p));
    }
    if (step > 0 && !(*std::max_element(advance, advance + phase_count) > 0)) fail_to_walk(*out.tmpl, out.clips, step);
    if (step > 0) fill_flight(advance, known);
    for (const double a : advance) sum += a / phase_count;
    out.stride[step] = static_cast<float>(sum);
    for (uint32_t p = 0; p < phase_count; ++p) {
        GaitCell &cell = out.cells[step * phase_count + p];
        // A foot that pauses must not stop the body: the phase would never get on.
        cell.advance = static_cast<float>(std::max(advance[p], 0.35 * sum));
        set_feet(path, supports, p, cell);
    }
}

// The phase at which the left foot begins to carry weight. `cells`: [phase_count]
double strike_of(const GaitCell *cells)
{
    for (uint32_t p = 0; p < phase_count; ++p)
        if (cells[p].supports[0] > 0 && !(cells[(p + phase_count - 1) % phase_count].supports[0] > 0))
            return double(p) / phase_count;
    return 0;
}

void set_cycles(const model::Rig &rig, Locomotion &out)
{
    const auto length = [&](uint32_t clip) { return double(rig.clips[clip].duration_s); };
    const LocomotionClips &clips = out.clips;
    const double walk_s = length(clips.walk), run_s = clips.run == none ? walk_s : length(clips.run);
    const double slow_s = clips.slow == none ? walk_s : length(clips.slow);
    for (uint32_t step = 0; step < gait_step_count; ++step) {
        const double gait = double(gait_steps[step]), slow = double(slow_gait);
        const double slowly = std::min(1.0, std::max(0.0, (1 - gait) / (1 - slow)));
        out.cycle_s[step] =
            static_cast<float>(walk_s + (slow_s - walk_s) * slowly + (run_s - walk_s) * std::max(0.0, gait - 1));
    }
    if (clips.turn != none) out.turn_cycle_s = rig.clips[clips.turn].duration_s;
}

// The clips by themselves, so that their left feet strike together.
void set_phases(Locomotion &out, pose::Workspace &work)
{
    const auto strike = [&](uint32_t step) {
        measure_step(out, step, work);
        return strike_of(&out.cell(step, 0));
    };
    const double walk = strike(walk_step);
    if (out.clips.run != none) out.run_phase = static_cast<float>(strike(gait_step_count - 1) - walk);
    if (out.clips.slow != none) out.slow_phase = static_cast<float>(strike(slow_step) - walk);
    if (out.clips.turn == none) return;
    measure_turn(out, work);
    out.turn_phase = static_cast<float>(strike_of(out.turn_cells.data()) - walk);
    measure_turn(out, work);
}

}  // namespace

void measure(const model::Template &tmpl, const LocomotionClips &clips, Locomotion &out)
{
    out.tmpl = &tmpl;
    out.clips = clips;
    check_clips(tmpl, clips);
    find_legs(tmpl.rig, out.clips);
    check_legs(tmpl, out.clips);
    set_legs(tmpl, out);
    find_upper(tmpl.rig, out.clips);
    check_upper(tmpl, out.clips);
    set_upper(tmpl, out);
    out.cells.resize(size_t(gait_step_count) * phase_count);

    set_cycles(tmpl.rig, out);
    pose::Workspace work(tmpl.rig, &tmpl.motion);
    set_phases(out, work);
    for (uint32_t step = 0; step < gait_step_count; ++step) measure_step(out, step, work);
    check_speeds(tmpl, out);
    out.hash = hash_of(out);
}

}  // namespace claque::track

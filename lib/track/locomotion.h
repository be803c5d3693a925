// What a template stands, walks and runs with, measured: how far each clip carries the body at each phase, when each
// foot carries weight and where it then is. Clips play in place, so a foot that carries weight moves back as fast as
// the body goes forward.
#pragma once

#include "lib/base/span.h"
#include "lib/pose/layer.h"
#include "lib/pose/leg.h"
#include "lib/pose/upper.h"

namespace claque::track
{

using model::Array;

constexpr uint32_t max_idles = 4;

// The clips and nodes, as a host names them.
struct LocomotionClips {
    uint32_t walk = model::none;
    uint32_t run = model::none;   // none: fast people walk fast
    uint32_t slow = model::none;  // a walk with short steps; none: the walk is blended with standing
    uint32_t turn = model::none;  // steps on the spot; none: people that turn on the spot take steps of the walk
    uint32_t idles[max_idles] = {model::none, model::none, model::none, model::none};
    uint32_t idle_count = 0;
    // Thigh, shin, foot and toes of the left and the right leg. All none: found by their names. Toes may be none.
    uint32_t legs[2][4] = {{model::none, model::none, model::none, model::none},
                           {model::none, model::none, model::none, model::none}};
    // What turns with shoulders and gaze. All none: found by their names; each may be missing.
    uint32_t torso = model::none, neck = model::none, head = model::none;
};

// The gait axis: 0 stands, 0.5 walks slowly where there is such a clip, 1 walks, 2 runs; between them both clips are
// blended. Beside it: the share of the clip that turns on the spot.
constexpr float gait_steps[] = {0, 0.1f, 0.25f, 0.5f, 0.75f, 1, 1.25f, 1.5f, 1.75f, 2};
constexpr uint32_t gait_step_count = sizeof gait_steps / sizeof gait_steps[0];
constexpr uint32_t walk_step = 5;  // gait_steps[walk_step] == 1
constexpr uint32_t slow_step = 3;
constexpr float slow_gait = gait_steps[slow_step];
constexpr uint32_t phase_count = 48;

// The body at one phase of one gait, in model units.
struct GaitCell {
    float advance = 0;    // of the body, per cycle of the phase
    float x[2] = {0, 0};  // the sole of each foot (pose::print_of)
    float z[2] = {0, 0};
    float yaw[2] = {0, 0};       // to which each foot points, radians about y
    float supports[2] = {0, 0};  // 1: this foot carries weight
    // For each leg: how far its straight length reaches over the ground, where its hip is, and how far the foot's node
    // is behind the sole.
    float reach[2] = {0, 0}, hip_x[2] = {0, 0}, hip_z[2] = {0, 0}, node_x[2] = {0, 0}, node_z[2] = {0, 0};
};

struct Locomotion {
    explicit Locomotion(std::pmr::memory_resource *memory)
        : cells(memory), turn_cells(memory), legs{pose::Leg(memory), pose::Leg(memory)}, upper(memory)
    {
    }

    const model::Template *tmpl = nullptr;
    LocomotionClips clips;
    Array<GaitCell> cells;               // [gait_step_count][phase_count]
    Array<GaitCell> turn_cells;          // [phase_count], or empty without such a clip; they do not advance
    float stride[gait_step_count] = {};  // of a whole cycle, model units
    float cycle_s[gait_step_count] = {};
    float turn_cycle_s = 1;
    // Of these clips when the walk clip's phase is 0: their left feet strike together.
    float run_phase = 0, slow_phase = 0, turn_phase = 0;
    pose::Leg legs[2];  // left, right
    pose::Upper upper;
    float leg_length = 0;
    uint64_t hash = 0;  // of what measure() found (track_file.h): a track loads by it, and there may be many tracks

    float max_gait() const { return clips.run == model::none ? 1.0f : 2.0f; }
    // Model units a second, at the clips' own pace.
    double walking_speed() const { return double(stride[walk_step]) / double(cycle_s[walk_step]); }
    double slow_speed() const { return double(stride[slow_step]) / double(cycle_s[slow_step]); }
    double running_speed() const { return double(stride[gait_step_count - 1]) / double(cycle_s[gait_step_count - 1]); }
    const GaitCell &cell(uint32_t step, uint32_t phase) const { return cells[step * phase_count + phase]; }
};

// The clips of a gait and phase (in cycles) at a time of the idle clip; returns how many layers there are.
//   turn   [0, 1] share of the clip that turns on the spot
uint32_t layers_of(const Locomotion &locomotion, float gait, float turn, double phase, uint32_t idle, double idle_s,
                   pose::Layer out[3]) noexcept;

// A cell between those measured.
GaitCell cell_at(const Locomotion &locomotion, double gait, double turn, double phase) noexcept;
double cycle_s_at(const Locomotion &locomotion, double gait) noexcept;

// Checks clips and nodes, finds the legs and measures. `out` has the template's memory. Throws base::Error (ARGUMENT)
// with the names of what is missing, or std::bad_alloc.
void measure(const model::Template &tmpl, const LocomotionClips &clips, Locomotion &out);

// Fills clips.torso, neck and head by the names of the template's nodes where all are none. The torso is the lowest
// part of the spine that carries the head and no leg.
void find_upper(const model::Rig &rig, LocomotionClips &clips);

// Fills clips.legs by the names of the template's nodes where all are none. Throws base::Error (ARGUMENT).
void find_legs(const model::Rig &rig, LocomotionClips &clips);

}  // namespace claque::track

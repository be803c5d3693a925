// What a template stands, walks and runs with, measured: how far each clip carries the body at each phase, when each
// foot carries weight and where it then is. Clips play in place, so a foot that carries weight moves back as fast as
// the body goes forward.
#pragma once

#include "lib/base/span.h"
#include "lib/pose/layer.h"
#include "lib/pose/leg.h"

namespace claque::track
{

using model::Array;

constexpr uint32_t max_idles = 4;

// The clips and nodes, as a host names them.
struct LocomotionClips {
    uint32_t walk = model::none;
    uint32_t run = model::none;  // none: fast people walk fast
    uint32_t idles[max_idles] = {model::none, model::none, model::none, model::none};
    uint32_t idle_count = 0;
    // Thigh, shin, foot and toes of the left and the right leg. All none: found by their names. Toes may be none.
    uint32_t legs[2][4] = {{model::none, model::none, model::none, model::none},
                           {model::none, model::none, model::none, model::none}};
};

// The gait axis: 0 stands, 1 walks, 2 runs; between them both clips are blended.
constexpr float gait_steps[] = {0, 0.1f, 0.25f, 0.5f, 0.75f, 1, 1.25f, 1.5f, 1.75f, 2};
constexpr uint32_t gait_step_count = sizeof gait_steps / sizeof gait_steps[0];
constexpr uint32_t walk_step = 5;  // gait_steps[walk_step] == 1
constexpr uint32_t phase_count = 48;

// The body at one phase of one gait, in model units.
struct GaitCell {
    float advance = 0;    // of the body, per cycle of the phase
    float x[2] = {0, 0};  // the ball of each foot
    float z[2] = {0, 0};
    float supports[2] = {0, 0};  // 1: this foot carries weight
    // For each leg: how far its straight length reaches over the ground, from a point which, moved with the ball of the
    // foot, is below the hip.
    float reach[2] = {0, 0}, reach_x[2] = {0, 0}, reach_z[2] = {0, 0};
};

struct Locomotion {
    explicit Locomotion(std::pmr::memory_resource *memory) : cells(memory), legs{pose::Leg(memory), pose::Leg(memory)}
    {
    }

    const model::Template *tmpl = nullptr;
    LocomotionClips clips;
    Array<GaitCell> cells;               // [gait_step_count][phase_count]
    float stride[gait_step_count] = {};  // of a whole cycle, model units
    float cycle_s[gait_step_count] = {};
    float run_phase = 0;  // of the run clip when the walk clip's is 0: their left feet strike together
    pose::Leg legs[2];    // left, right
    float leg_length = 0;

    float max_gait() const { return clips.run == model::none ? 1.0f : 2.0f; }
    // Model units a second, at the clips' own pace.
    double walking_speed() const { return double(stride[walk_step]) / double(cycle_s[walk_step]); }
    double running_speed() const { return double(stride[gait_step_count - 1]) / double(cycle_s[gait_step_count - 1]); }
    const GaitCell &cell(uint32_t step, uint32_t phase) const { return cells[step * phase_count + phase]; }
};

// The clips of a gait and phase (in cycles) at a time of the idle clip; returns how many layers there are.
uint32_t layers_of(const Locomotion &locomotion, float gait, double phase, uint32_t idle, double idle_s,
                   pose::Layer out[3]) noexcept;

// A cell between those measured.
GaitCell cell_at(const Locomotion &locomotion, double gait, double phase) noexcept;
double cycle_s_at(const Locomotion &locomotion, double gait) noexcept;

// Checks clips and nodes, finds the legs and measures. `out` has the template's memory. Throws base::Error (ARGUMENT)
// with the names of what is missing, or std::bad_alloc.
void measure(const model::Template &tmpl, const LocomotionClips &clips, Locomotion &out);

// Fills clips.legs by the names of the template's nodes where all are none. Throws base::Error (ARGUMENT).
void find_legs(const model::Rig &rig, LocomotionClips &clips);

}  // namespace claque::track

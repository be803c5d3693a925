// Clips as they are sampled at run time: every clip at a uniform rate of its own, so that any moment is two neighbouring
// rows whatever was asked before, and in columns of eight joints, so that a row is posed eight joints at a time. Made by
// meshsplit from the channels of a Rig within a stated error; the channels stay the reference.
#pragma once

#include "lib/model/rig.h"

namespace claque::model
{

constexpr uint32_t motion_lanes = 8;                               // joints in a block
constexpr uint32_t block_numbers = 4 * motion_lanes;               // x of eight joints, then y, z and w
constexpr float rotation_unit = 32767;                             // what 1 is stored as
constexpr uint32_t max_motion_intervals = 0x7fffffffu / 32 / 256;  // rows of a clip, so that places fit 32 bits

// Where a clip has the rotations of one block of joints, in Motion::rotations.
struct MotionBlock {
    uint32_t first = none;  // of row 0; none: all eight rest
    uint32_t stride = 0;    // from row to row; 0: they stand still
    uint32_t moved = 0;     // bit i: joint i is not always at rest
};

// Where a clip has one group of numbers, in Motion::numbers: least + step * number, four a row.
struct MotionCurve {
    uint32_t first = 0;
    uint32_t stride = 0;  // 0: they stand still
    float min[4] = {0, 0, 0, 0};
    float step[4] = {0, 0, 0, 0};
};

// Four numbers at most that some clip or degree of freedom moves, other than rotations.
struct MotionGroup {
    ChannelTarget target = ChannelTarget::translation;
    uint32_t index = 0;  // the joint, an index of Motion::nodes; for morph_weights the first weight
    uint32_t count = 3;
};

// What stays with its channel, because no rate follows it within the error: STEP keys, cuts.
struct MotionExactChannel {
    uint32_t channel = 0;
    uint32_t index = 0;  // the joint, or the first of its groups
};

struct MotionClip {
    uint32_t intervals = 0;  // rows less one
    float rate_hz = 0;       // intervals a second; 0 where nothing moves
    uint32_t first_exact = 0, exact_count = 0;
    // Most that any vertex or node is away from where the channels have it, and most that any node is turned, measured
    // at all key times, between them and between rows.
    float error_m = 0, error_rad = 0;
};

struct Motion {
    explicit Motion(std::pmr::memory_resource *memory = std::pmr::get_default_resource())
        : nodes(memory),
          groups(memory),
          clips(memory),
          blocks(memory),
          curves(memory),
          exact(memory),
          rotations(memory),
          numbers(memory),
          joint_of(memory),
          group_of(memory),
          group_nodes(memory),
          rest_rotations(memory),
          rest_scales(memory),
          rest_offsets(memory),
          rest_groups(memory),
          still_nodes(memory),
          still_columns(memory)
    {
    }

    // Joints: nodes that any clip or degree of freedom moves. Eight a block, `none` behind the last.
    Array<uint32_t> nodes;
    Array<MotionGroup> groups;
    Array<MotionClip> clips;    // one each of the rig's; empty: clips are sampled from their channels
    Array<MotionBlock> blocks;  // [clips * block_count()]
    Array<MotionCurve> curves;  // [clips * groups.size()]
    Array<MotionExactChannel> exact;
    Array<int16_t> rotations;
    Array<uint16_t> numbers;

    // Found from the above and the rig by derive().
    Array<uint32_t> joint_of;     // per node: its joint, or none
    Array<uint32_t> group_of;     // per joint: of its translation and of its scale, or none
    Array<uint32_t> group_nodes;  // per group: the node that its numbers belong to
    Array<float> rest_rotations;  // [block_numbers * block_count()]
    Array<float> rest_scales;     // [3 * motion_lanes * block_count()]: x of eight joints, then y, then z
    Array<float> rest_offsets;    // [4 * nodes.size()]: translations
    Array<float> rest_groups;     // [4 * groups.size()]
    Array<uint32_t> still_nodes;  // that are no joints
    Array<float> still_columns;   // [16 * still_nodes.size()]: their local matrices
    bool scales_move = false;

    bool empty() const { return clips.empty(); }
    uint32_t block_count() const { return static_cast<uint32_t>(nodes.size() / motion_lanes); }
    uint32_t group_count() const { return static_cast<uint32_t>(groups.size()); }
};

// Throws base::Error (ARGUMENT) unless every index and length above holds, so that what passes is safe to sample.
void check(const Motion &motion, const Rig &rig);

// Fills what is found from the rest; requires check().
void derive(const Rig &rig, Motion &motion);

// What one clip takes: its rows, their places, and channels that it keeps.
uint64_t motion_bytes(const Motion &motion, const Rig &rig, uint32_t clip);
// All of it, but for channels.
uint64_t motion_bytes(const Motion &motion);

}  // namespace claque::model

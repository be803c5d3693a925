// Clips as they are sampled at run time. Every clip has a uniform rate of its own, so that any time is a blend of two
// neighbouring rows. Rows are columns of eight joints, so that eight joints are posed at a time. meshsplit makes them
// from the channels of a Rig within a stated error; the channels stay the reference.
#pragma once

#include "lib/model/rig.h"

namespace claque::model
{

constexpr uint32_t motion_lanes = 8;                               // joints per block
constexpr uint32_t block_numbers = 4 * motion_lanes;               // x of eight joints, then y, z and w
constexpr float rotation_unit = 32767;                             // the stored value of 1
constexpr uint32_t max_motion_intervals = 0x7fffffffu / 32 / 256;  // rows of a clip, so that offsets fit 32 bits

// The rotations of one block of joints in one clip, in Motion::rotations.
struct MotionBlock {
    uint32_t first = none;  // of row 0; none: all eight are at rest
    uint32_t stride = 0;    // between rows; 0: constant
    uint32_t moved = 0;     // bit i: joint i is not always at rest
};

// One group of numbers in one clip, in Motion::numbers: min + step * number, four per row.
struct MotionCurve {
    uint32_t first = 0;
    uint32_t stride = 0;  // 0: constant
    float min[4] = {0, 0, 0, 0};
    float step[4] = {0, 0, 0, 0};
};

// Up to four numbers, other than rotations, that a clip or a degree of freedom changes.
struct MotionGroup {
    ChannelTarget target = ChannelTarget::translation;
    uint32_t index = 0;  // the joint, an index of Motion::nodes; for morph_weights the first weight
    uint32_t count = 3;
};

// A channel that is sampled itself because no rate follows it within the error: STEP keys and cuts.
struct MotionExactChannel {
    uint32_t channel = 0;
    uint32_t index = 0;  // the joint, or the first of its groups
};

struct MotionClip {
    uint32_t intervals = 0;  // rows minus one
    float rate_hz = 0;       // intervals per second; 0 if the clip is constant
    uint32_t first_exact = 0, exact_count = 0;
    // The largest distance of any vertex or node from where the channels put it, and the largest rotation of any node,
    // measured at all key times, between them and between rows.
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

    // Joints: the nodes that a clip or degree of freedom moves, in blocks of eight; `none` fills the last block.
    Array<uint32_t> nodes;
    Array<MotionGroup> groups;
    Array<MotionClip> clips;    // one per clip of the rig; empty: clips are sampled from their channels
    Array<MotionBlock> blocks;  // [clips * block_count()]
    Array<MotionCurve> curves;  // [clips * groups.size()]
    Array<MotionExactChannel> exact;
    Array<int16_t> rotations;
    Array<uint16_t> numbers;

    // Computed from the above and the rig by derive().
    Array<uint32_t> joint_of;     // per node: its joint, or none
    Array<uint32_t> group_of;     // per joint: the groups of its translation and of its scale, or none
    Array<uint32_t> group_nodes;  // per group: the node of its numbers
    Array<float> rest_rotations;  // [block_numbers * block_count()]
    Array<float> rest_scales;     // [3 * motion_lanes * block_count()]: x of eight joints, then y, then z
    Array<float> rest_offsets;    // [4 * nodes.size()]: translations
    Array<float> rest_groups;     // [4 * groups.size()]
    Array<uint32_t> still_nodes;  // the nodes that are not joints
    Array<float> still_columns;   // [16 * still_nodes.size()]: their local matrices
    bool scales_move = false;

    bool empty() const { return clips.empty(); }
    uint32_t block_count() const { return static_cast<uint32_t>(nodes.size() / motion_lanes); }
    uint32_t group_count() const { return static_cast<uint32_t>(groups.size()); }
};

// Throws base::Error (ARGUMENT) unless every index and length above is valid; a motion that passes is safe to sample.
void check(const Motion &motion, const Rig &rig);

// Computes the derived members; requires check().
void derive(const Rig &rig, Motion &motion);

// The memory of one clip: its rows, their offsets, and the channels that it keeps.
uint64_t motion_bytes(const Motion &motion, const Rig &rig, uint32_t clip);
// The memory of all clips without channels.
uint64_t motion_bytes(const Motion &motion);

}  // namespace claque::model

// The fastest way to skin the vertices of a level, computed from its runs when a template is made or loaded and never
// stored. Each vertex goes through the same steps whatever the plan, so the plan changes no bit of the result.
#pragma once

#include "lib/model/rig.h"

namespace claque::model
{

struct Level;

constexpr uint32_t lane_count = 8;
constexpr uint32_t max_block_influences = 4;
constexpr uint32_t max_chunk_sets = 64;  // so that their matrices stay in the L1 cache

struct alignas(16) Lanes {  // read as four floats at once
    float v[lane_count] = {0, 0, 0, 0, 0, 0, 0, 0};
};

// Up to eight neighbouring vertices with the same palette entries, each in a lane of its own. Its Lanes: x, y, z,
// normal x, y, z, and for each influence the weight (none for a single influence). Lanes from `count` on are 0.
struct LaneBlock {
    uint32_t first = 0;        // vertex
    uint32_t first_lanes = 0;  // index of SkinPlan::lanes
    uint32_t count = 0;
    uint16_t joints[max_block_influences] = {0, 0, 0, 0};
};

enum class SkinMethod : uint8_t {
    vertex = 0,  // matrices are blended for each vertex
    block = 1,   // for eight vertices at once
    set = 2      // once for each set of (joints, weights), shared by many vertices
};

// Neighbouring vertices of one run.
struct SkinSegment {
    SkinMethod method = SkinMethod::vertex;
    uint32_t influences = 1;
    uint32_t first = 0, count = 0;  // vertices
    uint32_t first_influence = 0;   // index of Level::joints and weights
    uint32_t first_item = 0;        // block: of blocks; set: of set_joints and set_weights
    uint32_t item_count = 0;        // block: blocks; set: sets, at most max_chunk_sets
    // Set: index of set_of, which holds the set of each vertex, counted within the segment.
    uint32_t first_set_of = 0;
};

struct SkinPlan {
    explicit SkinPlan(std::pmr::memory_resource *memory)
        : segments(memory), blocks(memory), lanes(memory), set_joints(memory), set_weights(memory), set_of(memory)
    {
    }
    Array<SkinSegment> segments;  // cover the source vertices in order
    Array<LaneBlock> blocks;
    Array<Lanes> lanes;
    Array<uint16_t> set_joints;
    Array<float> set_weights;
    Array<uint16_t> set_of;
};

// Blocks fill when vertices with the same entries are neighbours; meshsplit sorts them so. Requires runs, joints and
// weights of valid lengths; throws std::bad_alloc.
void plan_skinning(Level &level);

// True if the entry lists `a` and `b` may be in one block. The first two entries may be swapped: a sum of two products
// is the same to the bit.
bool same_entries(const uint16_t *a, const uint16_t *b, uint32_t influences);

// How many of `count` vertices with the same entries are worth blocks; the rest is faster one by one.
uint32_t worth_blocks(uint32_t count);

}  // namespace claque::model

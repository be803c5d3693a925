// Reads the first half of a BVH file: joints, their offsets and their channels.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lib/asset/budget.h"
#include "lib/asset/bvh_text.h"

namespace claque::asset
{

enum class BvhChannel : uint8_t { x_position, y_position, z_position, x_rotation, y_rotation, z_rotation };

struct BvhJoint {
    std::string name;
    uint32_t parent = 0xffffffffu;             // index of an earlier joint; none for roots
    std::array<double, 3> offset = {0, 0, 0};  // from the parent, in the file's unit
    std::vector<BvhChannel> channels;          // in file order, each once; none for end sites
    bool has_position() const;
    bool has_rotation() const;
};

constexpr uint32_t max_bvh_joints = 10000;

// Reads from the word HIERARCHY up to and including MOTION. Parents come before their children.
std::vector<BvhJoint> read_hierarchy(BvhText &text, Budget &budget);

}  // namespace claque::asset

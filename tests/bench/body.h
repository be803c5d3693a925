// The body that skinning and whole updates are measured with: 650 vertices on 33 bones.
#pragma once

#include <random>

#include "lib/model/template.h"

namespace claque::bench
{

constexpr uint32_t vertex_count = 650, joint_count = 33;

// A body whose vertices follow neighbours among 33 bones with weights of their own, in the order in which meshsplit
// leaves them: about 33 groups of 20 on the same bones, so that blocks of eight lanes are filled to four fifths.
inline model::Level make_level(uint32_t influences)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> real(-1, 1), positive(0.1f, 1);
    std::vector<uint32_t> counts(joint_count), filled, loose;
    for (uint32_t v = 0; v < vertex_count; ++v) ++counts[random() % joint_count];
    for (uint32_t bone = 0; bone < joint_count; ++bone)
        for (uint32_t i = 0; i < counts[bone]; ++i)
            (i < model::worth_blocks(counts[bone]) ? filled : loose).push_back(bone);
    filled.insert(filled.end(), loose.begin(), loose.end());
    model::Level level(std::pmr::get_default_resource());
    level.source_count = level.vertex_count = vertex_count;
    level.runs.push_back({0, vertex_count, influences, 0});
    for (const uint32_t bone : filled) {
        for (int k = 0; k < 3; ++k) level.positions.push_back(real(random)), level.normals.push_back(real(random));
        for (uint32_t i = 0; i < influences; ++i) {
            level.joints.push_back(uint16_t((bone + i) % joint_count));
            level.weights.push_back(positive(random));
        }
    }
    model::plan_skinning(level);
    return level;
}

}  // namespace claque::bench

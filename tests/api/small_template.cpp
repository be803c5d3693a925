#include "tests/api/small_template.h"

#include <cstring>

SmallTemplate::SmallTemplate()
{
    std::memset(nodes, 0, sizeof nodes);
    nodes[0].name = "root", nodes[0].parent = CLQ_NONE;
    nodes[1].name = "tip", nodes[1].parent = 0, nodes[1].translation[1] = 1;
    for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 16; ++k) inverse_binds_[j][k] = k % 5 == 0 ? 1.0f : 0.0f;
        inverse_binds_[j][13] = j == 1 ? -1.0f : 0.0f;
        joints[j] = {static_cast<uint32_t>(j), inverse_binds_[j]};
    }
    // Left half of the texture is cloth (key 100), right half is skin (key 200).
    for (int t = 0; t < 64; ++t) {
        for (int k = 0; k < 3; ++k) rgba_[4 * t + k] = 255;
        rgba_[4 * t + 3] = t % 8 < 4 ? 100 : 200;
    }
    images[0] = {"strip", 8, 8, rgba_, CLQ_ALPHA_ZONE_KEYS};
    zones[0] = {"cloth", 100, {0.8f, 0.2f, 0.1f}, {0, 360, 0.5f, 1, 0.5f, 1}};
    zones[1] = {"skin", 200, {0.9f, 0.7f, 0.6f}, {15, 30, 0.2f, 0.4f, 0.6f, 1}};
    std::memset(materials, 0, sizeof materials);
    materials[0].name = "strip", materials[0].zone = CLQ_NONE;
    for (int row = 0; row < 5; ++row)
        for (int side = 0; side < 2; ++side) {
            const int v = 2 * row + side;
            positions_[3 * v] = side ? 0.3f : -0.3f, positions_[3 * v + 1] = 0.5f * static_cast<float>(row),
                           positions_[3 * v + 2] = 0;
            normals_[3 * v] = normals_[3 * v + 1] = 0, normals_[3 * v + 2] = 1;
            uvs_[2 * v] = side ? 0.95f : 0.05f, uvs_[2 * v + 1] = 0.05f + 0.2f * static_cast<float>(row);
            influence_joints_[2 * v] = 0, influence_joints_[2 * v + 1] = 1;
            weights_[2 * v + 1] = 0.25f * static_cast<float>(row), weights_[2 * v] = 1 - weights_[2 * v + 1];
        }
    for (uint32_t row = 0; row < 4; ++row) {
        const uint32_t corners[6] = {2 * row, 2 * row + 1, 2 * row + 3, 2 * row, 2 * row + 3, 2 * row + 2};
        std::memcpy(indices_ + 6 * row, corners, sizeof corners);
    }
    std::memset(parts, 0, sizeof parts);
    parts[0].name = "strip", parts[0].vertex_count = 10, parts[0].positions = positions_, parts[0].normals = normals_;
    parts[0].uvs = uvs_, parts[0].influence_count = 2, parts[0].joints = influence_joints_, parts[0].weights = weights_;
    parts[0].index_count = 24, parts[0].indices = indices_;
    const float times[3] = {0, 0.5f, 1}, values[12] = {0, 0, 0, 1, 0, 0, 0.5f, 0.8660254f, 0, 0, 0, 1};
    std::memcpy(times_, times, sizeof times);
    std::memcpy(values_, values, sizeof values);
    channels[0] = {1, CLQ_CHANNEL_ROTATION, CLQ_INTERPOLATION_LINEAR, 3, times_, values_};
    clips[0] = {"bend", 1, channels};

    def = clq_template_def_init();
    def.name = "strip";
    def.node_count = 2, def.nodes = nodes;
    def.joint_count = 2, def.joints = joints;
    def.image_count = 1, def.images = images;
    def.zone_count = 2, def.zones = zones;
    def.material_count = 1, def.materials = materials;
    def.part_count = 1, def.parts = parts;
    def.clip_count = 1, def.clips = clips;
}

// A character small enough to read: two joints, a bending strip of eight triangles, two zones, one clip of one second.
#pragma once

#include <claque/claque.h>

struct SmallTemplate {
    SmallTemplate();
    SmallTemplate(const SmallTemplate &) = delete;
    SmallTemplate &operator=(const SmallTemplate &) = delete;

    clq_template_def def;
    clq_node_def nodes[2];
    clq_joint_def joints[2];
    clq_image_def images[1];
    clq_zone_def zones[2];
    clq_material_def materials[1];
    clq_part_def parts[1];
    clq_clip_def clips[1];
    clq_channel_def channels[1];

private:
    float inverse_binds_[2][16];
    uint8_t rgba_[8 * 8 * 4];
    float positions_[10 * 3], normals_[10 * 3], uvs_[10 * 2], weights_[10 * 2];
    uint32_t influence_joints_[10 * 2], indices_[8 * 3];
    float times_[3], values_[3 * 4];
};

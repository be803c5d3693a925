#include "samples/scenes/hundred/dragon_plan.h"

#include <vector>

namespace scenes::hundred
{

const Skeleton &skeleton()
{
    static const Skeleton bones = {{
        {"heart", -1, 0, 0, 2.6, 0},
        {"chest", heart, 0, 0.06, 3.3, 0},
        {"shoulder", chest, 0, 0.20, 4.0, 0},
        {"neck1", shoulder, 0, 0.50, 4.6, 0},
        {"neck2", neck1, 0, 0.95, 5.02, far_m},
        {"neck3", neck2, 0, 1.50, 5.30, far_m},
        {"head", neck3, 0, 2.02, 5.58, far_m},
        {"jaw", head, 0, 1.86, 5.74, mid_m},
        {"eye_l", head, 0.27, 2.20, 6.02, mid_m},
        {"eye_r", head, -0.27, 2.20, 6.02, mid_m},
        {"whisker_l", head, 0.20, 1.98, 6.70, mid_m},
        {"whisker_r", head, -0.20, 1.98, 6.70, mid_m},
        {"crest", head, 0, 2.10, 5.50, mid_m},
        {"ear_l", head, 0.34, 2.20, 5.62, mid_m},
        {"ear_r", head, -0.34, 2.20, 5.62, mid_m},
        {"loin", heart, 0, 0.00, 1.85, 0},
        {"hip", loin, 0, 0.02, 1.10, 0},
        {"tail1", hip, 0, 0.00, 0.40, 0},
        {"tail2", tail1, 0, -0.04, -0.25, 0},
        {"tail3", tail1 + 1, 0, -0.08, -0.88, 0},
        {"tail4", tail1 + 2, 0, -0.10, -1.49, 0},
        {"tail5", tail1 + 3, 0, -0.09, -2.08, far_m},
        {"tail6", tail1 + 4, 0, -0.05, -2.65, far_m},
        {"tail7", tail1 + 5, 0, 0.02, -3.20, far_m},
        {"tail8", tail1 + 6, 0, 0.12, -3.72, mid_m},
        {"tail9", tail1 + 7, 0, 0.25, -4.21, mid_m},
        {"tail10", tail1 + 8, 0, 0.40, -4.66, mid_m},
        {"fin", tail10, 0, 0.56, -5.06, mid_m},
        {"fore_thigh_l", shoulder, 0.42, 0.00, 3.85, far_m},
        {"fore_shank_l", legs, 0.82, -0.52, 3.52, mid_m},
        {"fore_foot_l", legs + 1, 0.86, -1.12, 3.86, mid_m},
        {"fore_thigh_r", shoulder, -0.42, 0.00, 3.85, far_m},
        {"fore_shank_r", legs + 3, -0.82, -0.52, 3.52, mid_m},
        {"fore_foot_r", legs + 4, -0.86, -1.12, 3.86, mid_m},
        {"hind_thigh_l", hip, 0.36, -0.10, 1.05, far_m},
        {"hind_shank_l", legs + 6, 0.74, -0.62, 1.34, mid_m},
        {"hind_foot_l", legs + 7, 0.80, -1.20, 0.92, mid_m},
        {"hind_thigh_r", hip, -0.36, -0.10, 1.05, far_m},
        {"hind_shank_r", legs + 9, -0.74, -0.62, 1.34, mid_m},
        {"hind_foot_r", legs + 10, -0.80, -1.20, 0.92, mid_m},
    }};
    return bones;
}

namespace
{

struct Named {
    uint32_t node;
    const char *name;
    char what;  // y yaw, p pitch, r roll, t thrust
    float first, last;
};

// Names must outlive the call that makes a template.
constexpr Named named[dof_count] = {
    {heart, "heart.thrust", 't', -0.8f, 0.8f},
    {chest, "chest.yaw", 'y', -0.06f, 0.06f},
    {chest, "chest.pitch", 'p', -0.06f, 0.06f},
    {shoulder, "shoulder.yaw", 'y', -0.10f, 0.10f},
    {shoulder, "shoulder.pitch", 'p', -0.08f, 0.08f},
    {neck1, "neck1.yaw", 'y', -0.08f, 0.08f},
    {neck1, "neck1.pitch", 'p', -0.08f, 0.08f},
    {neck2, "neck2.yaw", 'y', -0.08f, 0.08f},
    {neck2, "neck2.pitch", 'p', -0.08f, 0.08f},
    {neck3, "neck3.yaw", 'y', -0.12f, 0.12f},
    {neck3, "neck3.pitch", 'p', -0.12f, 0.12f},
    {head, "head.yaw", 'y', -0.55f, 0.55f},
    {head, "head.pitch", 'p', -0.35f, 0.35f},
    {head, "head.roll", 'r', -0.25f, 0.25f},
    {jaw, "jaw.pitch", 'p', -0.55f, 0.0f},
    {jaw, "jaw.thrust", 't', 0.0f, 0.08f},
    {eye_l, "eye_l.yaw", 'y', -0.4f, 0.4f},
    {eye_l, "eye_l.pitch", 'p', -0.3f, 0.3f},
    {eye_r, "eye_r.yaw", 'y', -0.4f, 0.4f},
    {eye_r, "eye_r.pitch", 'p', -0.3f, 0.3f},
    {whisker_l, "whisker_l.yaw", 'y', -0.3f, 0.3f},
    {whisker_l, "whisker_l.pitch", 'p', -0.3f, 0.3f},
    {whisker_r, "whisker_r.yaw", 'y', -0.3f, 0.3f},
    {whisker_r, "whisker_r.pitch", 'p', -0.3f, 0.3f},
    {crest, "crest.pitch", 'p', -0.25f, 0.25f},
    {crest, "crest.yaw", 'y', -0.1f, 0.1f},
    {ear_l, "ear_l.yaw", 'y', -0.4f, 0.4f},
    {ear_l, "ear_l.pitch", 'p', -0.4f, 0.4f},
    {ear_r, "ear_r.yaw", 'y', -0.4f, 0.4f},
    {ear_r, "ear_r.pitch", 'p', -0.4f, 0.4f},
    {loin, "loin.yaw", 'y', -0.06f, 0.06f},
    {loin, "loin.pitch", 'p', -0.06f, 0.06f},
    {hip, "hip.yaw", 'y', -0.06f, 0.06f},
    {hip, "hip.pitch", 'p', -0.06f, 0.06f},
    {tail1, "tail1.yaw", 'y', -0.06f, 0.06f},
    {tail1, "tail1.pitch", 'p', -0.06f, 0.06f},
    {tail1 + 1, "tail2.yaw", 'y', -0.06f, 0.06f},
    {tail1 + 1, "tail2.pitch", 'p', -0.06f, 0.06f},
    {tail1 + 2, "tail3.yaw", 'y', -0.06f, 0.06f},
    {tail1 + 2, "tail3.pitch", 'p', -0.06f, 0.06f},
    {tail1 + 3, "tail4.yaw", 'y', -0.06f, 0.06f},
    {tail1 + 3, "tail4.pitch", 'p', -0.06f, 0.06f},
    {tail1 + 4, "tail5.yaw", 'y', -0.08f, 0.08f},
    {tail1 + 4, "tail5.pitch", 'p', -0.08f, 0.08f},
    {tail1 + 5, "tail6.yaw", 'y', -0.08f, 0.08f},
    {tail1 + 5, "tail6.pitch", 'p', -0.08f, 0.08f},
    {tail1 + 6, "tail7.yaw", 'y', -0.10f, 0.10f},
    {tail1 + 6, "tail7.pitch", 'p', -0.10f, 0.10f},
    {tail1 + 7, "tail8.yaw", 'y', -0.10f, 0.10f},
    {tail1 + 7, "tail8.pitch", 'p', -0.10f, 0.10f},
    {tail1 + 8, "tail9.yaw", 'y', -0.12f, 0.12f},
    {tail1 + 8, "tail9.pitch", 'p', -0.12f, 0.12f},
    {tail10, "tail10.yaw", 'y', -0.12f, 0.12f},
    {tail10, "tail10.pitch", 'p', -0.12f, 0.12f},
    {fin, "fin.yaw", 'y', -0.3f, 0.3f},
    {fin, "fin.pitch", 'p', -0.3f, 0.3f},
    {legs, "fore_thigh_l.yaw", 'y', -0.3f, 0.3f},
    {legs, "fore_thigh_l.pitch", 'p', -0.4f, 0.4f},
    {legs, "fore_thigh_l.roll", 'r', -0.3f, 0.3f},
    {legs + 1, "fore_shank_l.pitch", 'p', -0.5f, 0.5f},
    {legs + 2, "fore_foot_l.pitch", 'p', -0.4f, 0.4f},
    {legs + 2, "fore_foot_l.yaw", 'y', -0.3f, 0.3f},
    {legs + 3, "fore_thigh_r.yaw", 'y', -0.3f, 0.3f},
    {legs + 3, "fore_thigh_r.pitch", 'p', -0.4f, 0.4f},
    {legs + 3, "fore_thigh_r.roll", 'r', -0.3f, 0.3f},
    {legs + 4, "fore_shank_r.pitch", 'p', -0.5f, 0.5f},
    {legs + 5, "fore_foot_r.pitch", 'p', -0.4f, 0.4f},
    {legs + 5, "fore_foot_r.yaw", 'y', -0.3f, 0.3f},
    {legs + 6, "hind_thigh_l.yaw", 'y', -0.3f, 0.3f},
    {legs + 6, "hind_thigh_l.pitch", 'p', -0.4f, 0.4f},
    {legs + 6, "hind_thigh_l.roll", 'r', -0.3f, 0.3f},
    {legs + 7, "hind_shank_l.pitch", 'p', -0.5f, 0.5f},
    {legs + 8, "hind_foot_l.pitch", 'p', -0.4f, 0.4f},
    {legs + 8, "hind_foot_l.yaw", 'y', -0.3f, 0.3f},
    {legs + 9, "hind_thigh_r.yaw", 'y', -0.3f, 0.3f},
    {legs + 9, "hind_thigh_r.pitch", 'p', -0.4f, 0.4f},
    {legs + 9, "hind_thigh_r.roll", 'r', -0.3f, 0.3f},
    {legs + 10, "hind_shank_r.pitch", 'p', -0.5f, 0.5f},
    {legs + 11, "hind_foot_r.pitch", 'p', -0.4f, 0.4f},
    {legs + 11, "hind_foot_r.yaw", 'y', -0.3f, 0.3f},
};

}  // namespace

std::array<clq_dof_def, dof_count> dofs()
{
    std::array<clq_dof_def, dof_count> out = {};
    for (size_t i = 0; i < dof_count; ++i) {
        const Named &from = named[i];
        clq_dof_def &dof = out[i];
        dof.name = from.name;
        dof.node = from.node;
        dof.kind = from.what == 't' ? CLQ_DOF_TRANSLATION : CLQ_DOF_ROTATION;
        dof.axis[0] = from.what == 'p' ? -1.0f : 0.0f;
        dof.axis[1] = from.what == 'y' ? 1.0f : 0.0f;
        dof.axis[2] = from.what == 'r' || from.what == 't' ? 1.0f : 0.0f;
        dof.min = from.first;
        dof.max = from.last;
    }
    return out;
}

}  // namespace scenes::hundred

#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

constexpr float diagonal = 0.70710678f;
const glm::vec3 shoulder(0.172f, 1.425f, -0.012f);
constexpr float upper_arm_length = 0.295f, forearm_length = 0.250f;

glm::vec3 along_arm(float metres) { return shoulder + arm_direction() * metres; }

Skeleton make()
{
    Skeleton s{};
    const auto set = [&s](Bone bone, Bone parent, const char *name, glm::vec3 joint) {
        const size_t i = static_cast<size_t>(bone);
        s.parents[i] = bone == Bone::root ? -1 : index_of(parent);
        s.joints[i] = joint;
        s.names[i] = name;
    };
    const auto pair = [&](Bone bone, Bone parent, bool parent_twice, const char *left, const char *right,
                          glm::vec3 joint) {
        set(bone, parent, left, joint);
        set(on(Side::right, bone), parent_twice ? on(Side::right, parent) : parent, right,
            glm::vec3(-joint.x, joint.y, joint.z));
    };
    set(Bone::root, Bone::root, "root", {0, 0, 0});
    set(Bone::pelvis, Bone::root, "pelvis", {0, 0.95f, 0});
    set(Bone::spine, Bone::pelvis, "spine", {0, 1.04f, -0.005f});
    set(Bone::spine_upper, Bone::spine, "spine_upper", {0, 1.14f, -0.012f});
    set(Bone::chest, Bone::spine_upper, "chest", {0, 1.26f, -0.018f});
    set(Bone::neck, Bone::chest, "neck", {0, 1.450f, -0.030f});
    set(Bone::head, Bone::neck, "head", {0, 1.545f, -0.010f});
    pair(Bone::clavicle, Bone::chest, false, "clavicle_l", "clavicle_r", {0.025f, 1.430f, 0.005f});
    pair(Bone::upper_arm, Bone::clavicle, true, "upper_arm_l", "upper_arm_r", shoulder);
    pair(Bone::forearm, Bone::upper_arm, true, "forearm_l", "forearm_r", along_arm(upper_arm_length));
    pair(Bone::hand, Bone::forearm, true, "hand_l", "hand_r", along_arm(upper_arm_length + forearm_length));
    const glm::vec3 wrist = along_arm(upper_arm_length + forearm_length);
    const glm::vec3 a = arm_direction(), h = arm_dorsal(), c = arm_thumbward();
    pair(Bone::thumb, Bone::hand, true, "thumb_l", "thumb_r", wrist + a * 0.028f + c * 0.028f - h * 0.006f);
    pair(Bone::fingers, Bone::hand, true, "fingers_l", "fingers_r", wrist + a * 0.092f);
    pair(Bone::fingertips, Bone::fingers, true, "fingertips_l", "fingertips_r", wrist + a * 0.135f - h * 0.004f);
    pair(Bone::thigh, Bone::pelvis, false, "thigh_l", "thigh_r", {0.090f, 0.925f, 0});
    pair(Bone::shin, Bone::thigh, true, "shin_l", "shin_r", {0.090f, 0.490f, 0.004f});
    pair(Bone::foot, Bone::shin, true, "foot_l", "foot_r", {0.092f, 0.085f, -0.020f});
    pair(Bone::toes, Bone::foot, true, "toes_l", "toes_r", {0.098f, 0.020f, 0.110f});
    pair(Bone::skirt_front, Bone::pelvis, false, "skirt_front_l", "skirt_front_r", {0.085f, 0.965f, 0.060f});
    pair(Bone::skirt_back, Bone::pelvis, false, "skirt_back_l", "skirt_back_r", {0.085f, 0.965f, -0.070f});
    return s;
}

}  // namespace

glm::vec3 arm_direction() { return glm::vec3(diagonal, -diagonal, 0); }
glm::vec3 arm_dorsal() { return glm::vec3(diagonal, diagonal, 0); }

glm::vec3 Skeleton::offset(Bone bone) const
{
    const int parent = parents[static_cast<size_t>(bone)];
    return parent < 0 ? joint(bone) : joint(bone) - joints[static_cast<size_t>(parent)];
}

const Skeleton &skeleton()
{
    static const Skeleton made = make();
    return made;
}

void add_skeleton(model::Rig &rig)
{
    const Skeleton &s = skeleton();
    for (int i = 0; i < bone_count; ++i) {
        const size_t at = static_cast<size_t>(i);
        rig.parents.push_back(s.parents[at] < 0 ? model::none : static_cast<uint32_t>(s.parents[at]));
        math::Trs rest;
        rest.translation = s.offset(static_cast<Bone>(i));
        rig.rest.push_back(rest);
        rig.node_names.emplace_back(s.names[at]);
        model::PaletteEntry entry;
        entry.node = static_cast<uint32_t>(i);
        entry.inverse_bind.set_column(3, -s.joints[at]);
        rig.palette.push_back(entry);
    }
}

}  // namespace claque::figures

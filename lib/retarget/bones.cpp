#include "lib/retarget/bones.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/math/trig.h"

namespace claque::retarget
{

using model::none;

namespace
{

glm::dvec3 between(const GlobalPose &pose, uint32_t upper, uint32_t lower)
{
    return pose.positions[lower] - pose.positions[upper];
}

glm::dvec3 offset(const GlobalPose &pose, uint32_t upper, uint32_t lower)
{
    return glm::conjugate(pose.rotations[upper]) * between(pose, upper, lower);
}

// The length of the limb that each match belongs to.
std::vector<double> limb_lengths(const std::vector<JointMatch> &matches, const GlobalPose &target)
{
    std::vector<double> out(matches.size(), 0);
    std::vector<uint32_t> below_count(matches.size(), 0), below(matches.size(), none);
    for (uint32_t i = 0; i < matches.size(); ++i)
        if (matches[i].above != none) ++below_count[matches[i].above], below[matches[i].above] = i;
    for (uint32_t i = 0; i < matches.size(); ++i) {
        const uint32_t above = matches[i].above;
        if (above == none) continue;
        out[i] = glm::length(between(target, matches[above].target, matches[i].target));
        if (below_count[above] == 1) out[i] += out[above];
    }
    for (size_t i = matches.size(); i-- > 0;)
        if (below_count[i] == 1) out[i] = out[below[i]];
    return out;
}

}  // namespace

std::vector<Bone> bones_of(const std::vector<JointMatch> &matches, const GlobalPose &target)
{
    std::vector<Bone> out;
    for (uint32_t i = 0; i < matches.size(); ++i) {
        if (matches[i].above == none) continue;
        const double length = glm::length(between(target, matches[matches[i].above].target, matches[i].target));
        if (length > 0) out.push_back({matches[i].above, i, length});
    }
    return out;
}

bool offsets_agree(const std::vector<JointMatch> &matches, const GlobalPose &target, const GlobalPose &source,
                   double &scale)
{
    std::vector<glm::dvec3> own, other;
    double own_length = 0, other_length = 0;
    for (const JointMatch &m : matches) {
        const bool top = m.above == none;
        own.push_back(top ? glm::dvec3(0) : offset(target, matches[m.above].target, m.target));
        other.push_back(top ? glm::dvec3(0) : offset(source, matches[m.above].source, m.source));
        own_length += glm::length(own.back()), other_length += glm::length(other.back());
    }
    if (!(own_length > 0 && other_length > 0)) return false;
    scale = own_length / other_length;
    const std::vector<double> limbs = limb_lengths(matches, target);
    glm::dvec3 first(0);
    bool parallel = true;
    for (size_t i = 0; i < matches.size(); ++i) {
        if (glm::length(own[i] - scale * other[i]) > 0.01 * limbs[i] + 1e-5 * own_length) return false;
        const double length = glm::length(own[i]);
        if (!(length > 1e-3 * own_length)) continue;
        if (first == glm::dvec3(0)) first = own[i] / length;
        if (glm::length(glm::cross(first, own[i])) > 0.2 * length) parallel = false;
    }
    return !parallel;
}

AxisShare along_one_axis(const std::vector<Bone> &bones, const std::vector<JointMatch> &matches,
                         const GlobalPose &source)
{
    double all = 0, along[3] = {0, 0, 0};
    for (const Bone &bone : bones) {
        const glm::dvec3 way = between(source, matches[bone.upper].source, matches[bone.lower].source);
        all += glm::length(way);
        for (int axis = 0; axis < 3; ++axis) along[axis] += std::fabs(way[axis]);
    }
    AxisShare out;
    if (!(all > 0)) return out;
    out.axis = static_cast<int>(std::max_element(along, along + 3) - along);
    out.share = along[out.axis] / all;
    return out;
}

double likeness(const std::vector<Bone> &bones, const std::vector<JointMatch> &matches, const GlobalPose &target,
                const GlobalPose &source, const glm::dquat &axes)
{
    double sum = 0, all = 0;
    for (const Bone &bone : bones) {
        const glm::dvec3 own = between(target, matches[bone.upper].target, matches[bone.lower].target);
        const glm::dvec3 other = axes * between(source, matches[bone.upper].source, matches[bone.lower].source);
        const double length = glm::length(other);
        all += bone.length;
        if (length > 0) sum += glm::dot(own, other) / length;
    }
    return all > 0 ? sum / all : 1;
}

glm::dquat facing_rotation(const std::vector<Bone> &bones, const std::vector<JointMatch> &matches,
                           const GlobalPose &target, const GlobalPose &source, const glm::dquat &axes)
{
    std::vector<size_t> carried(matches.size(), 1);
    for (size_t i = matches.size(); i-- > 0;)
        if (matches[i].above != none) carried[matches[i].above] += carried[i];
    double along = 0, across = 0;
    for (const Bone &bone : bones) {
        if (3 * carried[bone.upper] < matches.size()) continue;
        const glm::dvec3 own = between(target, matches[bone.upper].target, matches[bone.lower].target);
        const glm::dvec3 other = axes * between(source, matches[bone.upper].source, matches[bone.lower].source);
        along += own.x * other.x + own.z * other.z;
        across += other.z * own.x - other.x * own.z;
    }
    const double half = math::atan2(across, along) / 2;
    return glm::dquat(math::cos(half), 0, math::sin(half), 0);
}

}  // namespace claque::retarget

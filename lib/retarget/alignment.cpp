#include "lib/retarget/alignment.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::retarget
{

using model::none;

namespace
{

// The 24 rotations that map axes to axes, the identity first.
std::array<glm::dquat, 24> axis_rotations()
{
    constexpr double h = 0.70710678118654752440;
    std::array<glm::dquat, 24> out;
    const std::array<glm::dquat, 6> up = {glm::dquat(1, 0, 0, 0), glm::dquat(h, h, 0, 0), glm::dquat(h, -h, 0, 0),
                                          glm::dquat(0, 1, 0, 0), glm::dquat(h, 0, 0, h), glm::dquat(h, 0, 0, -h)};
    const std::array<glm::dquat, 4> about = {glm::dquat(1, 0, 0, 0), glm::dquat(h, 0, h, 0), glm::dquat(0, 0, 1, 0),
                                             glm::dquat(h, 0, -h, 0)};
    for (size_t i = 0; i < 24; ++i) out[i] = up[i / 4] * about[i % 4];
    return out;
}

// Returns the ratio of leg lengths: the bone lengths down to the lowest joint, without the first bone, which differs
// most between skeletons.
double leg_ratio(const std::vector<JointMatch> &matches, const GlobalPose &target, const GlobalPose &source)
{
    uint32_t lowest = 0;
    for (uint32_t i = 1; i < matches.size(); ++i)
        if (target.positions[matches[i].target].y < target.positions[matches[lowest].target].y - 1e-6) lowest = i;
    double t = 0, s = 0;
    for (uint32_t i = lowest; matches[i].above != none; i = matches[i].above) {
        const JointMatch &lower = matches[i], &upper = matches[lower.above];
        if (upper.above == none && t > 0 && s > 0) break;
        t += glm::length(target.positions[lower.target] - target.positions[upper.target]);
        s += glm::length(source.positions[lower.source] - source.positions[upper.source]);
    }
    return t > 0 && s > 0 ? t / s : 1;
}

}  // namespace

glm::dquat common_axes(const std::vector<JointMatch> &matches, const GlobalPose &target, const GlobalPose &source)
{
    glm::dvec3 middle_t(0), middle_s(0);
    for (const JointMatch &m : matches) middle_t += target.positions[m.target], middle_s += source.positions[m.source];
    middle_t /= static_cast<double>(matches.size());
    middle_s /= static_cast<double>(matches.size());
    double maximum = 0;
    glm::dquat best(1, 0, 0, 0);
    for (const glm::dquat &rotation : axis_rotations()) {
        double alike = 0;
        for (const JointMatch &m : matches)
            alike +=
                glm::dot(rotation * (source.positions[m.source] - middle_s), target.positions[m.target] - middle_t);
        if (alike <= maximum * (1 + 1e-6)) continue;
        maximum = alike;
        best = rotation;
    }
    return best;
}

glm::dquat rotation_between(glm::dvec3 from, glm::dvec3 to)
{
    const double lengths = std::sqrt(glm::dot(from, from) * glm::dot(to, to));
    if (!(lengths > 0)) return glm::dquat(1, 0, 0, 0);
    const double w = lengths + glm::dot(from, to);
    if (w > 1e-9 * lengths) return glm::normalize(glm::dquat(w, glm::cross(from, to)));
    const glm::dvec3 aside = std::fabs(from.x) < std::fabs(from.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::dquat(0, glm::cross(from, aside)));
}

SkeletonAlignment align_skeletons(const std::vector<JointMatch> &matches, const GlobalPose &target,
                                  const GlobalPose &source, const glm::dquat &axes)
{
    SkeletonAlignment alignment;
    alignment.axes = axes;
    alignment.scale = leg_ratio(matches, target, source);
    std::vector<uint32_t> below(matches.size(), none), below_count(matches.size(), 0);
    for (uint32_t i = 0; i < matches.size(); ++i)
        if (matches[i].above != none) below[matches[i].above] = i, ++below_count[matches[i].above];
    for (uint32_t i = 0; i < matches.size(); ++i) {
        const JointMatch &match = matches[i];
        glm::dquat rotation(1, 0, 0, 0);
        if (match.rest == RestAlignment::align) {
            // A joint with no child bone, or several, takes its parent's rotation: a hand follows the forearm.
            if (match.above != none) rotation = alignment.aligned[match.above];
            if (below_count[i] == 1) {
                const JointMatch &next = matches[below[i]];
                const glm::dvec3 own = target.positions[next.target] - target.positions[match.target];
                const glm::dvec3 other =
                    alignment.axes * (source.positions[next.source] - source.positions[match.source]);
                if (glm::length(own) > 0 && glm::length(other) > 0) rotation = rotation_between(own, other);
            }
        }
        alignment.aligned.push_back(rotation);
    }
    return alignment;
}

}  // namespace claque::retarget

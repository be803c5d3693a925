#include "lib/retarget/followers.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "lib/base/error.h"
#include "lib/base/near_names.h"
#include "lib/math/slerp.h"

namespace claque::retarget
{

using base::fail;
using model::none;

namespace
{

// The minimum fraction of a leader's share, where one of several leaders moves away from the follower: cloth then hangs
// and is only pulled a little.
constexpr double min_pull = 0.3;

LeaderBinding leader_binding(const model::Rig &target, const std::vector<JointMatch> &matches, uint32_t joint,
                             uint32_t match, double share)
{
    LeaderBinding out;
    out.match = match, out.share = share;
    const GlobalPose rest = rest_pose(target);
    const glm::dvec3 leader = rest.positions[matches[match].target];
    for (const JointMatch &below : matches) {
        if (below.above != match) continue;
        const glm::dvec3 bone = rest.positions[below.target] - leader;
        if (!(glm::length(bone) > 0)) continue;
        out.along = glm::normalize(bone);
        const glm::dvec3 off = rest.positions[joint] - leader, side = off - out.along * glm::dot(off, out.along);
        if (glm::length(side) > 1e-3 * glm::length(bone)) out.side = glm::normalize(side);
        break;
    }
    return out;
}

// Returns the fraction of its share that a leader has with this rotation, in the space of the follower's parent.
double push_of(const LeaderBinding &leader, const glm::dquat &rotation)
{
    const double towards = glm::dot(rotation * leader.along - leader.along, leader.side);
    if (leader.side == glm::dvec3(0)) return 1;
    const double t = std::clamp(0.5 + 5 * towards, 0.0, 1.0);
    return min_pull + (1 - min_pull) * t * t * (3 - 2 * t);
}

}  // namespace

std::vector<FollowerBinding> match_followers(const model::Rig &target, const std::vector<JointMatch> &matches,
                                             const Options &options)
{
    std::vector<uint32_t> match_of(target.node_count(), none);
    for (uint32_t i = 0; i < matches.size(); ++i) match_of[matches[i].target] = i;
    std::vector<FollowerBinding> out;
    for (const Follower &follower : options.followers) {
        const uint32_t joint = target.find_node(follower.joint), leader = target.find_node(follower.leader);
        if (joint == none || match_of[joint] != none)
            fail(CLQ_ARGUMENT, "'%s' cannot follow '%s': it is %s%s", follower.joint.c_str(), follower.leader.c_str(),
                 joint == none ? "not a joint of the character" : "bound itself",
                 joint == none ? base::names_near(follower.joint, target.node_names).c_str() : "");
        if (leader == none || match_of[leader] == none)
            fail(CLQ_ARGUMENT, "'%s' cannot follow '%s', which is not bound%s", follower.joint.c_str(),
                 follower.leader.c_str(),
                 leader == none ? base::names_near(follower.leader, target.node_names).c_str() : "");
        if (!(follower.share >= 0 && follower.share <= 1))
            fail(CLQ_ARGUMENT, "'%s' follows with a share of %g: it must be from 0 to 1", follower.joint.c_str(),
                 follower.share);
        auto made = std::find_if(out.begin(), out.end(), [&](const FollowerBinding &f) { return f.joint == joint; });
        if (made == out.end()) {
            FollowerBinding fresh;
            fresh.joint = joint;
            for (uint32_t up = target.parents[joint]; up != none && fresh.above == none; up = target.parents[up])
                fresh.above = match_of[up];
            made = out.insert(out.end(), fresh);
        }
        made->leaders.push_back(leader_binding(target, matches, joint, match_of[leader], follower.share));
    }
    return out;
}

glm::dquat local_rotation(const FollowerBinding &f, const model::Rig &target, const GlobalPose &rest,
                          const std::vector<JointMatch> &matches, const std::vector<glm::dquat> &rotations)
{
    const uint32_t parent = target.parents[f.joint];
    const glm::dquat parent_rest = parent == none ? glm::dquat(1, 0, 0, 0) : rest.rotations[parent];
    glm::dquat moved(1, 0, 0, 0);  // rotation of the ancestor joints since rest
    if (f.above != none) moved = rotations[f.above] * glm::conjugate(rest.rotations[matches[f.above].target]);
    const glm::dquat above = moved * parent_rest;
    const glm::dquat at_rest = glm::conjugate(parent_rest) * rest.rotations[f.joint];
    // Leaders are weighted smoothly by the cube of their rotation, so the largest dominates.
    glm::dquat sum(0, 0, 0, 0);
    for (const LeaderBinding &leader : f.leaders) {
        const glm::dquat led = rotations[leader.match] * glm::conjugate(rest.rotations[matches[leader.match].target]);
        const glm::dquat whole = glm::conjugate(above) * led * rest.rotations[f.joint];
        const double push = f.leaders.size() > 1 ? push_of(leader, glm::conjugate(moved) * led) : 1;
        glm::dquat own = partial_rotation(glm::conjugate(at_rest) * whole, leader.share * push);
        if (own.w < 0) own = -own;
        const double sine = glm::length(glm::dvec3(own.x, own.y, own.z)) + 1e-6;
        const double weight = f.leaders.size() > 1 ? sine * sine * sine : 1;
        sum = sum + own * weight;
    }
    return glm::normalize(at_rest * glm::normalize(sum));
}

glm::dquat partial_rotation(const glm::dquat &rotation, double share)
{
    const float nothing[4] = {0, 0, 0, 1};
    const float whole[4] = {static_cast<float>(rotation.x), static_cast<float>(rotation.y),
                            static_cast<float>(rotation.z), static_cast<float>(rotation.w)};
    return dquat_of(math::slerp(nothing, whole, share));
}

}  // namespace claque::retarget

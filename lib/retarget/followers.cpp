#include "lib/retarget/followers.h"

#include "lib/base/error.h"
#include "lib/math/slerp.h"

namespace claque::retarget
{

using base::fail;
using model::none;

std::vector<Following> match_followers(const model::Rig &target, const std::vector<Match> &matches,
                                       const Options &options)
{
    std::vector<uint32_t> match_of(target.node_count(), none);
    for (uint32_t i = 0; i < matches.size(); ++i) match_of[matches[i].target] = i;
    std::vector<Following> out;
    for (const Follower &follower : options.followers) {
        const uint32_t joint = target.find_node(follower.joint), leader = target.find_node(follower.leader);
        if (joint == none || match_of[joint] != none)
            fail(CLQ_ARGUMENT, "'%s', which is to follow '%s', is %s", follower.joint.c_str(), follower.leader.c_str(),
                 joint == none ? "no joint of the character" : "bound itself");
        if (leader == none || match_of[leader] == none)
            fail(CLQ_ARGUMENT, "'%s' is to follow '%s', which is not bound", follower.joint.c_str(),
                 follower.leader.c_str());
        if (!(follower.share >= 0 && follower.share <= 1))
            fail(CLQ_ARGUMENT, "'%s' follows by a share of %g: 0 to 1 are wanted", follower.joint.c_str(),
                 follower.share);
        Following made = {joint, match_of[leader], none, follower.share};
        for (uint32_t up = target.parents[joint]; up != none && made.above == none; up = target.parents[up])
            made.above = match_of[up];
        out.push_back(made);
    }
    return out;
}

glm::dquat local_of(const Following &f, const model::Rig &target, const Stance &rest, const std::vector<Match> &matches,
                    const std::vector<glm::dquat> &turns)
{
    const uint32_t parent = target.parents[f.joint];
    const glm::dquat parent_rest = parent == none ? glm::dquat(1, 0, 0, 0) : rest.turns[parent];
    glm::dquat above = parent_rest;
    if (f.above != none) above = turns[f.above] * glm::conjugate(rest.turns[matches[f.above].target]) * above;
    const glm::dquat led = turns[f.leader] * glm::conjugate(rest.turns[matches[f.leader].target]);
    const glm::dquat at_rest = glm::conjugate(parent_rest) * rest.turns[f.joint];
    const glm::dquat whole = glm::conjugate(above) * led * rest.turns[f.joint];
    return glm::normalize(at_rest * share_of(glm::conjugate(at_rest) * whole, f.share));
}

glm::dquat share_of(const glm::dquat &turn, double share)
{
    const float nothing[4] = {0, 0, 0, 1};
    const float whole[4] = {static_cast<float>(turn.x), static_cast<float>(turn.y), static_cast<float>(turn.z),
                            static_cast<float>(turn.w)};
    return dquat_of(math::slerp(nothing, whole, share));
}

}  // namespace claque::retarget

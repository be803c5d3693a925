// Between two sampled poses, whatever moves with a node deviates from a straight line and moves by no more than the
// stated bounds.
#include "meshsplit/reach_poses.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "reach_rigs.h"

namespace claque::test
{

namespace
{

using meshsplit::Locals;
using meshsplit::MotionBound;
using meshsplit::PoseAt;
using meshsplit::PoseSegment;

// A point of a node's frame in model space, degrees of freedom at zero.
glm::dvec3 placed(const model::Rig &rig, const Locals &locals, uint32_t node, glm::dvec3 p)
{
    for (uint32_t n = node; n != model::none; n = rig.parents[n]) {
        const math::Trs &trs = locals.nodes[n];
        p = glm::dvec3(trs.translation) + glm::dquat(trs.rotation) * (glm::dvec3(trs.scale) * p);
    }
    return p;
}

void expect_between(const model::Rig &rig, const PoseAt &from, const PoseAt &to, const PoseSegment &segment)
{
    meshsplit::LocalPoser poser(rig);
    Locals first, last, between;
    poser.pose(from, first), poser.pose(to, last);
    for (uint32_t node = 0; node < rig.node_count(); ++node) {
        const glm::dvec3 p(0.3, 0.4, -0.2);
        MotionBound motion_bound;
        motion_bound.reach = glm::length(p);
        for (uint32_t n = node; n != model::none; n = rig.parents[n])
            motion_bound = segment.nodes[n].of(motion_bound, 0);
        const glm::dvec3 a = placed(rig, first, node, p), b = placed(rig, last, node, p);
        const double noise = 2e-6 * (1 + motion_bound.reach);
        EXPECT_LE(glm::distance(a, b), motion_bound.speed + noise);
        for (int k = 1; k < 16; ++k) {
            poser.pose({to.clip, from.time_s + (to.time_s - from.time_s) * k / 16}, between);
            const glm::dvec3 at = placed(rig, between, node, p);
            EXPECT_LE(glm::length(at), motion_bound.reach + noise);
            EXPECT_LE(glm::distance(at, glm::mix(a, b, k / 16.0)), motion_bound.chord_deviation() + noise);
        }
    }
}

// Nodes below one another, whose motions have all that a motion can have.
std::vector<meshsplit::NodeMotionBound> chain(uint32_t seed)
{
    std::vector<meshsplit::NodeMotionBound> out(8);
    const auto next = [&] { return seed = seed * 1664525u + 1013904223u, double(seed >> 8) / (1 << 24); };
    for (meshsplit::NodeMotionBound &node : out) {
        node.scale = 0.5 + next(), node.growth = next(), node.scale_acceleration = next();
        node.turn = next(), node.turn_acceleration = next();
        node.offset = next(), node.travel = next(), node.travel_acceleration = next();
    }
    return out;
}

}  // namespace

TEST(ReachPoses, HaveTheSameBoundInOneStepAsNodeByNode)
{
    const double shift = 0.1;
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        const std::vector<meshsplit::NodeMotionBound> nodes = chain(seed);
        MotionBound there = {0.5, 0.3, 0.2}, origin;
        meshsplit::MotionMap map;
        for (const meshsplit::NodeMotionBound &node : nodes) map = meshsplit::MotionMap(map, node, shift);
        const MotionBound of = map.of(there), origin_of = map.origin();
        for (size_t n = nodes.size(); n-- > 0;) {
            there = nodes[n].of(there, shift);
            origin = nodes[n].of(origin, shift);
        }
        EXPECT_NEAR(of.reach, there.reach, 1e-12 * there.reach);
        EXPECT_NEAR(of.speed, there.speed, 1e-12 * there.speed);
        EXPECT_NEAR(of.acceleration, there.acceleration, 1e-12 * there.acceleration);
        EXPECT_NEAR(origin_of.reach, origin.reach, 1e-12 * origin.reach);
        EXPECT_NEAR(origin_of.speed, origin.speed, 1e-12 * origin.speed);
        EXPECT_NEAR(origin_of.acceleration, origin.acceleration, 1e-12 * origin.acceleration);
    }
}

TEST(ReachPoses, DeviateFromStraightLinesByAtMostTheirBound)
{
    for (const FreeModel &free : moving_models()) {
        SCOPED_TRACE(free.name);
        PoseAt before;
        uint32_t ways = 0;
        meshsplit::walk_poses(free.model.rig, [&](const PoseAt &at, const Locals &, const PoseSegment *since) {
            if (since) ++ways, expect_between(free.model.rig, before, at, *since);
            before = at;
        });
        EXPECT_GT(ways, 0u);
    }
}

}  // namespace claque::test

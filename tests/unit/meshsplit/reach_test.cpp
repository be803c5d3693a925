// Degrees of freedom and clips together never move a vertex out of the Sklsroot Bsphere (S0 4.1), nor a node farther
// than its template states.
#include "meshsplit/reach.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "reach_rigs.h"
#include "reach_sampling.h"

namespace claque::test
{

using model::DofKind;

namespace
{

double random_unit(uint64_t i) { return double(base::unit(base::hash(5, i, base::Purpose::pick))); }

glm::dvec3 any_vector(uint64_t i)
{
    return glm::dvec3(random_unit(3 * i), random_unit(3 * i + 1), random_unit(3 * i + 2)) - 0.5;
}

}  // namespace

TEST(Reach, NoVertexOfAHundredThousandPosesIsOutside)
{
    for (const FreeModel &free : free_models()) {
        SCOPED_TRACE(free.name);
        const auto tmpl = built(free.model);
        const Sampled sampled = sample_reach(*tmpl, glm::dvec3(tmpl->sklsroot.centre), 100000);
        EXPECT_LE(sampled.vertex, double(tmpl->sklsroot.radius));
        ASSERT_EQ(tmpl->node_reach.size(), sampled.node.size());
        for (size_t n = 0; n < sampled.node.size(); ++n) {
            EXPECT_LE(sampled.node[n], double(tmpl->node_reach[n].distance)) << n;
            EXPECT_LE(sampled.stretch[n], double(tmpl->node_reach[n].scale)) << n;
        }
    }
}

TEST(Reach, NodeReachBoundsAreTight)
{
    const auto tmpl = built(articulated_actor().model);
    const Sampled sampled = sample_reach(*tmpl, glm::dvec3(tmpl->sklsroot.centre), 100000);
    for (size_t n = 0; n < sampled.node.size(); ++n) {
        EXPECT_LE(double(tmpl->node_reach[n].distance), 1.15 * sampled.node[n] + 0.01) << n;
        EXPECT_LE(double(tmpl->node_reach[n].scale), 1.0001) << n;
    }
}

TEST(Reach, StretchBoundsAreTight)
{
    for (const FreeModel &free : free_models()) {
        SCOPED_TRACE(free.name);
        const auto tmpl = built(free.model);
        const Sampled sampled = sample_reach(*tmpl, glm::dvec3(0), 10);
        for (size_t n = 0; n < sampled.node.size(); ++n)
            EXPECT_LE(double(tmpl->node_reach[n].scale), 2 * sampled.stretch[n]) << n;
    }
}

TEST(Reach, ASkeletonRootThatCannotMoveKeepsNearlyTheSphereOfItsClips)
{
    for (FreeModel &free : free_models()) {
        SCOPED_TRACE(free.name);
        for (model::Dof &dof : free.model.rig.dofs) dof.min = dof.max = dof.rest = 0;
        const auto held = built(free.model);
        free.model.rig.dofs.clear();
        free.model.rig.dof_names.clear();
        const auto bare = built(free.model);
        // Without degrees of freedom, times within one frame are hardly examined.
        if (free.name != "whirl" && free.name != "overshoot") {
            EXPECT_NEAR(held->sklsroot.radius, bare->sklsroot.radius, 0.05f * bare->sklsroot.radius);
        }
        ASSERT_EQ(bare->node_reach.size(), held->node_reach.size());
        for (size_t n = 0; n < bare->node_reach.size(); ++n)
            EXPECT_FLOAT_EQ(bare->node_reach[n].scale, held->node_reach[n].scale);
    }
}

TEST(Reach, TheFartherLevelCountsToo)
{
    for (FreeModel &free : free_models()) {
        if (free.name != "levels") continue;
        const auto both = built(free.model);
        ASSERT_EQ(both->levels.size(), 2u);
        free.model.parts.pop_back();
        EXPECT_LT(built(free.model)->sklsroot.radius, 0.97f * both->sklsroot.radius);
    }
}

TEST(ReachDirections, AnyVectorIsMadeOfThreeNeighboursWithoutNegativeWeights)
{
    for (const int splits : {0, 2, 3}) {
        const meshsplit::Directions directions(splits);
        EXPECT_EQ(directions.count(), size_t(10 * (1 << (2 * splits)) + 2));
        for (uint64_t i = 0; i < 20000; ++i) {
            const glm::dvec3 v = i < directions.count() ? directions[i] : glm::normalize(any_vector(i));
            const meshsplit::DirectionBlend blend = directions.find(v);
            glm::dvec3 sum(0);
            double weights = 0;
            for (size_t k = 0; k < 3; ++k) {
                ASSERT_GE(blend.weight[k], 0);
                sum += double(blend.weight[k]) * directions[blend.at[k]];
                weights += double(blend.weight[k]);
            }
            ASSERT_LT(glm::distance(sum, v), 1e-6);
            ASSERT_LE(weights, directions.max_weight() + 1e-6);
        }
    }
}

TEST(ReachSupport, ADegreeOfFreedomSweepsPointsAsFarAsTheyGoAndHardlyFarther)
{
    const meshsplit::Directions directions(3);
    const glm::vec3 axis = glm::normalize(glm::vec3(1, 2, -0.5f));
    for (const DofKind kind : {DofKind::rotation, DofKind::translation}) {
        model::Dof dof;
        dof.kind = kind, dof.axis = axis, dof.min = -0.7f, dof.max = 1.9f;
        const glm::dvec3 p(0.3, 0.8, -0.6);
        meshsplit::Support set, scratch;
        for (size_t i = 0; i < directions.count(); ++i) set.push_back(glm::dot(directions[i], p));
        meshsplit::DofSweep(directions, dof).sweep(glm::length(p), set, scratch);
        std::vector<glm::dvec3> swept;
        for (int k = 0; k <= 2000; ++k) {
            const double x = -0.7 + 2.6 * k / 2000, c = std::cos(x), s = std::sin(x);
            const glm::dvec3 a(axis), turned = p * c + glm::cross(a, p) * s + a * (glm::dot(a, p) * (1 - c));
            swept.push_back(kind == DofKind::rotation ? turned : p + a * x);
        }
        for (size_t i = 0; i < directions.count(); ++i) {
            double most = -1e9;
            for (const glm::dvec3 &at : swept) most = std::max(most, glm::dot(directions[i], at));
            ASSERT_GE(set[i], most - 1e-6);
            ASSERT_LE(set[i], most + 0.004);
        }
    }
}

}  // namespace claque::test

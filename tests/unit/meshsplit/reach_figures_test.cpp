// The built-in characters with their own degrees of freedom, or some in neck, head and spine, over all their clips (S0
// 4.1).
#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "reach_ascent.h"
#include "reach_rigs.h"
#include "reach_sampling.h"

namespace claque::test
{

namespace
{

enum class Moves { head, trunk };

model::Model figure_with(const figures::Builtin &builtin, Moves moves)
{
    model::Model m = builtin.make();
    if (!m.rig.dofs.empty()) return m;
    const auto dof = [&](const char *node, glm::vec3 axis, float first, float last) {
        add_dof(m, m.rig.find_node(node), model::DofKind::rotation, axis, first, last);
    };
    dof("neck", {0, 1, 0}, -0.6f, 0.6f), dof("neck", {1, 0, 0}, -0.3f, 0.4f);
    dof("head", {0, 1, 0}, -0.8f, 0.8f), dof("head", {1, 0, 0}, -0.5f, 0.4f), dof("head", {0, 0, 1}, -0.3f, 0.3f);
    add_dof(m, m.rig.find_node("head"), model::DofKind::translation, {0, 1, 0}, 0, 0.02f);
    if (moves == Moves::head) return m;
    dof("spine", {0, 1, 0}, -0.5f, 0.5f), dof("spine", {1, 0, 0}, -0.3f, 0.6f), dof("chest", {0, 0, 1}, -0.2f, 0.2f);
    return m;
}

void expect_held_and_snug(const figures::Builtin &builtin, Moves moves)
{
    SCOPED_TRACE(builtin.name);
    const auto tmpl = built(figure_with(builtin, moves), 64);
    const glm::dvec3 centre(tmpl->sklsroot.centre);
    const double radius = double(tmpl->sklsroot.radius), found = found_reach(*tmpl, centre);
    ::testing::Test::RecordProperty(builtin.name, std::to_string(radius / found));
    EXPECT_GE(radius, found);
    EXPECT_LE(radius, 1.04 * found);
    EXPECT_LT(0.96 * radius, found) << "the test would not notice too small a sphere";
    const Sampled sampled = sample_reach(*tmpl, centre, 30000);
    EXPECT_LE(sampled.vertex, radius);
    for (size_t n = 0; n < sampled.node.size(); ++n)
        EXPECT_LE(sampled.node[n], double(tmpl->node_reach[n].distance)) << n;
}

}  // namespace

TEST(ReachFigures, ThatMoveTheirHeadsStayInTheirSpheres)
{
    for (const figures::Builtin &builtin : figures::builtins()) expect_held_and_snug(builtin, Moves::head);
}

TEST(ReachFigures, ThatMoveTheirTrunksStayInTheirSpheres)
{
    for (const figures::Builtin &builtin : figures::builtins()) expect_held_and_snug(builtin, Moves::trunk);
}

}  // namespace claque::test

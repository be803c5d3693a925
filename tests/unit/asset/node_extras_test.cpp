// Degrees of freedom and distances that come with a file's nodes.
#include <cmath>

#include <gtest/gtest.h>

#include "maker.h"

namespace claque::testing
{
namespace
{

// A head with two eyelids' morph targets below a neck, and a hat beside it.
Maker puppet()
{
    Maker maker;
    maker.triangle();
    const int deltas = maker.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    maker.primitive()["targets"] = Json::array({{{"POSITION", deltas}}, {{"POSITION", deltas}}});
    maker.json["nodes"] = Json::array(
        {{{"name", "head"}, {"mesh", 0}}, {{"name", "neck"}, {"children", {0, 2}}}, {{"name", "hat"}, {"mesh", 0}}});
    maker.json["scenes"] = Json::array({{{"nodes", {1}}}});
    return maker;
}

Json &node_extras(Maker &maker, int node) { return maker.json["nodes"][node]["extras"]["claque"]; }

Json turn(const char *name)
{
    return {{"name", name}, {"kind", "rotation"}, {"axis", {0, 2, 0}}, {"min", -0.5}, {"max", 0.7}, {"rest", 0.1}};
}

TEST(NodeExtras, GiveDegreesOfFreedomInTheOrderOfTheRig)
{
    Maker maker = puppet();
    node_extras(maker, 0)["dofs"] =
        Json::array({{{"name", "blink"},
                      {"kind", "morph"},
                      {"morph_target", 1},
                      {"min", 0.25},
                      {"max", 1},
                      {"a hint for others", true}},
                     {{"kind", "translation"}, {"axis", {0, 0, -1}}, {"min", -2}, {"max", -1}}});
    node_extras(maker, 1)["dofs"] = Json::array({turn("yaw")});
    const model::Rig rig = load(maker.glb()).rig;
    ASSERT_EQ(rig.dofs.size(), 3u);
    EXPECT_EQ(rig.dof_names[0], "yaw");
    EXPECT_EQ(rig.dofs[0].node, rig.find_node("neck"));
    EXPECT_EQ(rig.dofs[0].kind, model::DofKind::rotation);
    EXPECT_EQ(rig.dofs[0].axis, glm::vec3(0, 1, 0)) << "made a unit one";
    EXPECT_EQ(rig.dofs[0].min, -0.5f);
    EXPECT_EQ(rig.dofs[0].max, 0.7f);
    EXPECT_EQ(rig.dofs[0].rest, 0.1f);
    EXPECT_EQ(rig.dofs[1].kind, model::DofKind::morph);
    EXPECT_EQ(rig.morph_sets[rig.dofs[1].node].node, rig.find_node("head"));
    EXPECT_EQ(rig.dofs[1].morph_target, 1u);
    EXPECT_EQ(rig.dofs[1].rest, 0.25f) << "as near to 0 as the range allows";
    EXPECT_EQ(rig.dofs[2].rest, -1);
    EXPECT_EQ(rig.dof_names[2], "");
    EXPECT_TRUE(rig.deactivation_m.empty());
}

TEST(NodeExtras, SayHowFarNodesAndMeshesGoOn)
{
    Maker maker = puppet();
    node_extras(maker, 1)["deactivation_m"] = 40;
    node_extras(maker, 0)["lod_m"] = {0, 12.5};
    node_extras(maker, 2)["lod_m"] = {12.5};
    const model::Model m = load(maker.glb());
    ASSERT_EQ(m.rig.deactivation_m.size(), 3u);
    EXPECT_EQ(m.rig.deactivation_of(m.rig.find_node("neck")), 40);
    EXPECT_TRUE(std::isinf(m.rig.deactivation_of(m.rig.find_node("hat"))));
    ASSERT_EQ(m.parts.size(), 2u);
    EXPECT_EQ(m.parts[0].lod_min_m, 0);
    EXPECT_EQ(m.parts[0].lod_max_m, 12.5f);
    EXPECT_EQ(m.parts[1].lod_min_m, 12.5f);
    EXPECT_TRUE(std::isinf(m.parts[1].lod_max_m));
}

TEST(NodeExtras, OfOthersAreNotJudged)
{
    Maker maker = puppet();
    for (const Json &theirs : {Json(7), Json("text"), Json({{"dofs", 3}}), Json({{"claque", {{"colour", "red"}}}})}) {
        maker.json["nodes"][0]["extras"] = theirs;
        EXPECT_EQ(outcome_of(maker.glb()).text, "");
    }
}

struct Bad {
    int node;
    Json extras;
    const char *says;
};

TEST(NodeExtras, ThatBreakARuleAreRefusedByName)
{
    const auto dof = [](const char *member, Json value) {
        Json out = turn("yaw");
        if (value.is_null()) out.erase(member);
        else out[member] = std::move(value);
        return Json({{"dofs", Json::array({out})}});
    };
    const Json twins = {{"dofs", Json::array({turn("yaw"), turn("yaw")})}};
    const Json blink = {{"kind", "morph"}, {"min", 0}, {"max", 1}, {"morph_target", 2}};
    const std::vector<Bad> all = {
        {0, {{"deactivation_m", 0}}, "deactivation_m is 0 m"},
        {0, {{"deactivation_m", -3}}, "deactivation_m is -3 m"},
        {0, {{"deactivation_m", "far"}}, "nodes[0].extras.claque.deactivation_m"},
        {0, {{"lod_m", {5, 5}}}, "lod_m is from 5 m to 5 m"},
        {0, {{"lod_m", {-1, 5}}}, "lod_m is from -1 m"},
        {0, {{"lod_m", {1, 2, 3}}}, "lod_m has 3 numbers"},
        {0, {{"lod_m", Json::array()}}, "lod_m has 0 numbers"},
        {0, {{"lod_m", 5}}, "lod_m is number instead of an array"},
        {1, {{"lod_m", {0, 5}}}, "nodes[1].extras.claque.lod_m says when a mesh is drawn"},
        {0, {{"dofs", 1}}, "dofs is number instead of an array"},
        {0, {{"dofs", Json::array({3})}}, "dofs[0]"},
        {0, dof("kind", "hinge"), "dofs[0].kind is 'hinge'"},
        {0, dof("kind", nullptr), "dofs[0].kind is missing"},
        {0, dof("axis", nullptr), "dofs[0].axis is missing"},
        {0, dof("axis", {0, 0, 0}), "dofs[0].axis has length 0"},
        {0, dof("axis", {0, 1}), "dofs[0].axis has 2 numbers"},
        {0, dof("min", nullptr), "dofs[0].min is missing"},
        {0, dof("max", nullptr), "dofs[0].max is missing"},
        {0, dof("max", -1), "range from -0.5 to -1"},
        {0, dof("max", 1e300), "dofs[0].max"},
        {0, dof("rest", 0.8), "dofs[0].rest is 0.8, outside"},
        {0, dof("name", 5), "dofs[0].name"},
        {0, twins, "dofs[1] is named 'yaw' like another"},
        {0, {{"dofs", Json::array({blink})}}, "moves morph target 2: the mesh that nodes[0] shows has 2"},
        {1, {{"dofs", Json::array({blink})}}, "the mesh that nodes[1] shows has 0"},
    };
    for (const Bad &bad : all) {
        Maker maker = puppet();
        node_extras(maker, bad.node) = bad.extras;
        const Outcome outcome = outcome_of(maker.glb());
        EXPECT_EQ(outcome.status, CLQ_FORMAT) << bad.says;
        EXPECT_NE(outcome.text.find(bad.says), std::string::npos) << outcome.text << "\nshould say: " << bad.says;
    }
}

TEST(NodeExtras, OfNodesThatAreNotShownAreCheckedAndLeftOut)
{
    Maker maker = puppet();
    maker.json["scenes"] = Json::array({{{"nodes", {3}}}});
    maker.json["nodes"].push_back({{"name", "other"}, {"mesh", 0}});
    node_extras(maker, 1)["dofs"] = Json::array({turn("yaw")});
    node_extras(maker, 1)["deactivation_m"] = 40;
    const model::Rig rig = load(maker.glb()).rig;
    EXPECT_TRUE(rig.dofs.empty() && rig.deactivation_m.empty());
    node_extras(maker, 1)["deactivation_m"] = -40;
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT);
}

}  // namespace
}  // namespace claque::testing

// Nodes: matrices taken apart, scenes chosen, order kept.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/asset/node_matrix.h"
#include "maker.h"

namespace claque::testing
{
namespace
{

std::vector<float> matrix_of(const math::Trs &trs)
{
    const math::Affine a = math::affine_of(trs);
    std::vector<float> m(16, 0);
    for (size_t c = 0; c < 4; ++c)
        for (size_t r = 0; r < 3; ++r) m[4 * c + r] = a.c[3 * c + r];
    m[15] = 1;
    return m;
}

void expect_same(const math::Trs &trs, const char *what)
{
    const std::vector<float> m = matrix_of(trs);
    const asset::DecomposedMatrix parts = asset::decompose(m.data());
    EXPECT_LT(parts.error, 1e-5) << what;
    const float longest = std::max({std::fabs(trs.scale.x), std::fabs(trs.scale.y), std::fabs(trs.scale.z)});
    const std::vector<float> again = matrix_of(parts.trs);
    for (size_t i = 0; i < 16; ++i) EXPECT_NEAR(again[i], m[i], 1e-6f * (1 + longest)) << what << " " << i;
}

TEST(NodeMatrix, IsTakenApartAndPutTogetherAgain)
{
    const glm::quat turns[] = {glm::quat(1, 0, 0, 0),
                               glm::quat(0, 1, 0, 0),
                               glm::quat(0, 0, 1, 0),
                               glm::quat(0, 0, 0, 1),
                               glm::normalize(glm::quat(0.3f, -0.5f, 0.7f, 0.2f)),
                               glm::normalize(glm::quat(-0.01f, 0.5f, 0.5f, -0.7f))};
    for (const glm::quat &turn : turns) {
        expect_same({glm::vec3(1, 2, 3), turn, glm::vec3(1)}, "a rotation");
        expect_same({glm::vec3(-1, 0, 3), turn, glm::vec3(100)}, "a factor");
        expect_same({glm::vec3(0), turn, glm::vec3(0.01f, 2, 5)}, "uneven scale");
        expect_same({glm::vec3(0), turn, glm::vec3(-1, 2, 3)}, "a mirror");
        expect_same({glm::vec3(0), turn, glm::vec3(-1, -2, -3)}, "three mirrors");
        expect_same({glm::vec3(0), turn, glm::vec3(2, 0, 3)}, "a flat one");
        expect_same({glm::vec3(0), turn, glm::vec3(0, 0, 3)}, "a line");
        expect_same({glm::vec3(0), turn, glm::vec3(0)}, "a point");
    }
}

TEST(NodeMatrix, ThatShearsIsRefused)
{
    Maker maker;
    maker.triangle();
    maker.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0.1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT);
    maker.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0.0000001, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    EXPECT_EQ(load(maker.glb()).rig.rest.at(0).translation, glm::vec3(5, 6, 7));
    maker.json["nodes"][0]["matrix"][3] = 1;
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << "a perspective";
}

TEST(Nodes, ComeDepthFirstWithChildrenAsListed)
{
    Maker maker;
    maker.triangle();
    maker.json["nodes"] = Json::array({{{"name", "c"}, {"mesh", 0}},
                                       {{"name", "a"}, {"children", {3, 0}}, {"mesh", 0}},
                                       {{"name", "d"}, {"mesh", 0}},
                                       {{"name", "b"}, {"mesh", 0}}});
    maker.json["scenes"] = Json::array({{{"nodes", {2}}}, {{"nodes", {1, 2}}}});
    maker.json["scene"] = 1;
    const model::Model model = load(maker.glb());
    std::string order;
    for (const model::Part &part : model.parts) order += model.rig.node_names[part.node].c_str();
    EXPECT_EQ(order, "abcd");
    EXPECT_EQ(model.rig.parents[1], 0u);
    EXPECT_EQ(model.rig.parents[3], model::none);
    asset::LoadOptions options;
    options.scene = 0;
    EXPECT_EQ(load(maker.glb(), options).parts.size(), 1u);
    options.scene = 2;
    EXPECT_EQ(outcome_of(maker.glb(), options).status, CLQ_ARGUMENT);
}

TEST(Nodes, WithoutAnySceneAreAllShown)
{
    Maker maker;
    maker.triangle();
    maker.json.erase("scenes");
    maker.add("nodes", {{"mesh", 0}});
    EXPECT_EQ(load(maker.glb()).parts.size(), 2u);
}

TEST(Nodes, AChainOfAHundredThousandIsFollowed)
{
    Maker maker;
    maker.triangle();
    const int length = 100000;
    for (int i = 1; i < length; ++i) maker.add("nodes", Json::object());
    for (int i = 0; i + 1 < length; ++i) maker.json["nodes"][i]["children"] = {i + 1};
    EXPECT_EQ(load(maker.glb()).rig.node_count(), 100000u);
    maker.json["nodes"][length - 1]["children"] = {1};
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT);
}

}  // namespace
}  // namespace claque::testing

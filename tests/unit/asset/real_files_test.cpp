// Files as people have them, which the format does not allow: read as far as they make sense, with a warning.
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets.h"
#include "lib/asset/nearest_vertex.h"

namespace claque::testing
{
namespace
{

// A skin of two joints on nodes 1 and 2, and the triangle on it.
Maker weighted(const std::vector<uint8_t> &joints, const std::vector<float> &weights)
{
    Maker maker;
    maker.triangle();
    maker.add("nodes", {{"name", "root"}, {"children", {2}}, {"scale", {100, 100, 100}}});
    maker.add("nodes", {{"name", "tip"}, {"translation", {0, 1, 0}}});
    maker.json["scenes"][0]["nodes"] = {0, 1};
    maker.add("skins", {{"joints", {1, 2}}});
    maker.json["nodes"][0]["skin"] = 0;
    maker.primitive()["attributes"]["JOINTS_0"] = maker.accessor(u8, "VEC4", 3, joints);
    maker.primitive()["attributes"]["WEIGHTS_0"] = maker.floats("VEC4", 3, weights);
    return maker;
}

// FBX2glTF 0.9.7 writes such weights for vertices without any.
TEST(RealFiles, WeightsThatAreNoNumbersCountAsNoneWithAWarning)
{
    const float nan = std::nanf(""), big = std::numeric_limits<float>::infinity();
    const model::Model model =
        load(weighted({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, {nan, nan, nan, nan, 2, big, 0, 0, 0, nan, 0, 0}).glb());
    const model::Part &part = model.parts.at(0);
    ASSERT_EQ(part.influence_count, 1u);
    EXPECT_EQ(part.joints, (std::vector<uint32_t>{0, 0, 0})) << "as the second, whatever joints they list";
    EXPECT_EQ(part.weights, (std::vector<float>{1, 1, 1}));
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("2 of 3 vertices have no weights above 0"), std::string::npos)
        << model.warnings[0];
}

TEST(RealFiles, OfTheCaseWithNanWeightsLoads)
{
    const std::string path = assets_folder() + "/../cases/characters/nan_weights.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const model::Model model = load(asset::read_file(path, 1u << 30));
    EXPECT_EQ(model.parts.at(0).positions.size(), 5u);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("1 of 5 vertices"), std::string::npos) << model.warnings[0];
}

TEST(RealFiles, WithoutAnyWeightsMovesWithTheJointAboveIt)
{
    for (const bool below : {false, true}) {
        Maker maker = weighted({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, std::vector<float>(12, 0));
        if (below) {  // "tip", the second of the skin's joints
            maker.json["nodes"][2]["children"] = {0};
            maker.json["scenes"][0]["nodes"] = {1};
        }
        const model::Model model = load(maker.glb());
        const uint32_t node = model.rig.palette.at(model.parts.at(0).joints.at(0)).node;
        EXPECT_EQ(model.rig.node_names[node], below ? "tip" : "root") << "or else with the skin's first";
        EXPECT_EQ(model.parts[0].weights, (std::vector<float>{1, 1, 1}));
        ASSERT_EQ(model.warnings.size(), 1u);
        EXPECT_NE(model.warnings[0].find("no vertex has weights"), std::string::npos) << model.warnings[0];
    }
}

TEST(RealFiles, NearestVerticesAreThoseOfASearchThroughAll)
{
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> among;
    uint32_t random = 1;
    for (uint32_t i = 0; i < 500; ++i) {
        const auto coordinate = [&] { return float((random = random * 1664525 + 1013904223) >> 12); };
        const float x = coordinate(), y = coordinate();
        positions.emplace_back(x, y, coordinate());
        if (i % 3) among.push_back(i);
    }
    const asset::NearestVertex nearest(positions, among);
    for (const glm::vec3 &place : positions) {
        const auto far = [&](uint32_t i) { return glm::dot(positions[i] - place, positions[i] - place); };
        float least = far(among[0]);
        for (const uint32_t i : among) least = std::min(least, far(i));
        EXPECT_EQ(far(nearest.to(place)), least);
    }
}

TEST(RealFiles, BytesBehindAGlbAreLeftOutWithAWarning)
{
    Maker maker;
    maker.triangle();
    Bytes bytes = maker.glb();
    bytes.insert(bytes.end(), 7, uint8_t('x'));
    const model::Model model = load(bytes);
    EXPECT_EQ(model.parts.size(), 1u);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("7 bytes follow the end"), std::string::npos) << model.warnings[0];
    bytes.resize(bytes.size() - 8);
    EXPECT_NE(outcome_of(bytes).text.find("the GLB header says"), std::string::npos);
}

TEST(RealFiles, OfAnotherFormatIsRefusedWithTheCommandThatReadsIt)
{
    for (const std::string text :
         {"INTERQUAKEMODEL", "Kaydara FBX Binary", "# a comment\nv 0 0 0\n", "<COLLADA/>", " "}) {
        const Outcome outcome = outcome_of(Bytes(text.begin(), text.end()));
        EXPECT_EQ(outcome.status, CLQ_FORMAT);
        EXPECT_NE(outcome.text.find("claque convert"), std::string::npos) << outcome.text;
    }
    const std::string broken = "\xef\xbb\xbf\n {]";
    EXPECT_NE(outcome_of(Bytes(broken.begin(), broken.end())).text.find("the JSON is broken"), std::string::npos);
}

}  // namespace
}  // namespace claque::testing

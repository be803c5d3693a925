// What a primitive may bring, in files of one triangle: each value is known beforehand.
#include <cmath>

#include <gtest/gtest.h>

#include "maker.h"

namespace claque::testing
{
namespace
{

TEST(Mesh, PositionsOfEveryComponentTypeComeOutAsTheFormatSays)
{
    struct Case {
        int component;
        bool normalized;
        Bytes bytes;  // of (low, high, 0) padded to 4 components, three times
        glm::vec3 expected;
    };
    const std::vector<Case> cases = {{i8, false, {0x80, 0x7f, 0, 0}, {-128, 127, 0}},
                                     {i8, true, {0x80, 0x7f, 0, 0}, {-1, 1, 0}},
                                     {u8, false, {0, 255, 0, 0}, {0, 255, 0}},
                                     {u8, true, {51, 255, 0, 0}, {0.2f, 1, 0}},
                                     {i16, false, {0, 0x80, 0xff, 0x7f, 0, 0, 0, 0}, {-32768, 32767, 0}},
                                     {i16, true, {0, 0x80, 0xff, 0x7f, 0, 0, 0, 0}, {-1, 1, 0}},
                                     {u16, false, {1, 0, 0xff, 0xff, 0, 0, 0, 0}, {1, 65535, 0}},
                                     {u16, true, {0, 0, 0xff, 0xff, 0, 0, 0, 0}, {0, 1, 0}}};
    for (const Case &c : cases) {
        Maker maker;
        maker.triangle();
        Bytes three;
        for (int k = 0; k < 3; ++k) three.insert(three.end(), c.bytes.begin(), c.bytes.end());
        const int accessor = maker.accessor(c.component, "VEC3", 3, three);
        maker.json["accessors"][accessor]["normalized"] = c.normalized;
        maker.json["bufferViews"].back()["byteStride"] = c.bytes.size();
        maker.primitive()["attributes"]["POSITION"] = accessor;
        const model::Model model = load(maker.glb());
        EXPECT_EQ(model.parts.at(0).positions.at(2), c.expected) << c.component << c.normalized;
    }
}

TEST(Mesh, SparseValuesStandOverWhatTheyChangeAndOverZeros)
{
    for (const bool has_base : {true, false}) {
        Maker maker;
        maker.triangle();
        Json &accessor = maker.json["accessors"][0];
        if (!has_base) accessor.erase("bufferView");
        const int indices = maker.view(std::vector<uint16_t>{1}), values = maker.view(std::vector<float>{7, 8, 9});
        accessor["sparse"] = {{"count", 1},
                              {"indices", {{"bufferView", indices}, {"componentType", u16}}},
                              {"values", {{"bufferView", values}}}};
        const model::Part part = load(maker.glb()).parts.at(0);
        EXPECT_EQ(part.positions[1], glm::vec3(7, 8, 9));
        EXPECT_EQ(part.positions[2], has_base ? glm::vec3(0, 1, 0) : glm::vec3(0));
        accessor["sparse"]["indices"]["bufferView"] = maker.view(std::vector<uint16_t>{3});
        EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT) << "a sparse index beyond the accessor";
    }
}

TEST(Mesh, IndicesOfEveryTypeAreReadAndTheirRangeChecked)
{
    const auto part_with = [](int component, const auto &values) {
        Maker maker;
        maker.triangle();
        maker.primitive()["indices"] = maker.accessor(component, "SCALAR", 3, values);
        return maker.glb();
    };
    const std::vector<uint32_t> expected = {2, 0, 1};
    EXPECT_EQ(load(part_with(u8, std::vector<uint8_t>{2, 0, 1})).parts[0].indices, expected);
    EXPECT_EQ(load(part_with(u16, std::vector<uint16_t>{2, 0, 1})).parts[0].indices, expected);
    EXPECT_EQ(load(part_with(u32, std::vector<uint32_t>{2, 0, 1})).parts[0].indices, expected);
    EXPECT_EQ(outcome_of(part_with(u16, std::vector<uint16_t>{2, 0, 3})).status, CLQ_FORMAT);
    EXPECT_EQ(outcome_of(part_with(f32, std::vector<float>{2, 0, 1})).status, CLQ_FORMAT);
}

TEST(Mesh, NumbersThatAreNotFiniteAreRefused)
{
    Maker maker;
    maker.triangle();
    maker.primitive()["attributes"]["NORMAL"] = maker.floats("VEC3", 3, {0, 0, 1, 0, std::nanf(""), 1, 0, 0, 1});
    const Outcome outcome = outcome_of(maker.glb());
    EXPECT_EQ(outcome.status, CLQ_FORMAT);
    EXPECT_NE(outcome.text.find("meshes[0].primitives[0].attributes.NORMAL"), std::string::npos) << outcome.text;
    EXPECT_NE(outcome.text.find("element 1"), std::string::npos) << outcome.text;
}

// A skin of two joints on nodes 1 and 2, and the triangle on it.
Maker skinned(const std::vector<uint8_t> &joints, const std::vector<float> &weights)
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

TEST(Mesh, WeightsAreMadeToSumToOneAndPackedInOrder)
{
    const Maker maker = skinned({0, 1, 9, 9, 1, 0, 1, 9, 1, 0, 0, 0}, {1, 3, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0});
    const model::Model model = load(maker.glb());
    const model::Part &part = model.parts.at(0);
    EXPECT_TRUE(part.skinned);
    ASSERT_EQ(part.influence_count, 2u);
    EXPECT_EQ(part.joints, (std::vector<uint32_t>{0, 1, 1, 1, 0, 1}));
    EXPECT_EQ(part.weights, (std::vector<float>{0.25f, 0.75f, 1, 0, 0.25f, 0.75f}));
    ASSERT_EQ(model.warnings.size(), 1u) << "the last vertex weighs nothing and moves as the first, the nearest to it";
    EXPECT_EQ(model.rig.palette[1].node, model.rig.find_node("tip"));
}

// Inverse binds of two joints, so many floats apart.
model::Model with_inverse_binds(size_t floats_apart)
{
    Maker maker = skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0});
    std::vector<float> numbers(floats_apart + 16, 77);
    for (size_t joint = 0; joint < 2; ++joint)
        for (size_t k = 0; k < 16; ++k)
            numbers[joint * floats_apart + k] = k % 5 == 0 ? 1 : k >= 12 ? 0.25f * static_cast<float>(joint + k) : 0;
    const int matrices = maker.floats("MAT4", 2, numbers);
    if (floats_apart != 16) maker.json["bufferViews"].back()["byteStride"] = 4 * floats_apart;
    maker.json["skins"][0]["inverseBindMatrices"] = matrices;
    return load(maker.glb());
}

TEST(Mesh, InverseBindMatricesMayLieApartWithAWarning)
{
    const model::Model together = with_inverse_binds(16), apart = with_inverse_binds(20);
    EXPECT_TRUE(together.warnings.empty());
    ASSERT_EQ(apart.warnings.size(), 1u);
    for (const char *word : {"skins[0].inverseBindMatrices", "byteStride", "80 bytes apart"})
        EXPECT_NE(apart.warnings[0].find(word), std::string::npos) << apart.warnings[0];
    ASSERT_EQ(together.rig.palette.size(), 2u);
    ASSERT_EQ(apart.rig.palette.size(), 2u);
    for (size_t joint = 0; joint < 2; ++joint)
        for (size_t k = 0; k < 12; ++k)
            EXPECT_EQ(apart.rig.palette[joint].inverse_bind.c[k], together.rig.palette[joint].inverse_bind.c[k]);
    EXPECT_EQ(apart.rig.palette[1].inverse_bind.c[9], 0.25f * 13) << "the second matrix, and nothing between the two";
}

TEST(Mesh, FurtherSetsOfJointsAddInfluences)
{
    Maker maker = skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0});
    maker.primitive()["attributes"]["JOINTS_1"] =
        maker.accessor(u16, "VEC4", 3, std::vector<uint16_t>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const int weights = maker.accessor(u8, "VEC4", 3, Bytes{255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0});
    maker.json["accessors"][weights]["normalized"] = true;
    maker.primitive()["attributes"]["WEIGHTS_1"] = weights;
    const model::Part part = load(maker.glb()).parts.at(0);
    ASSERT_EQ(part.influence_count, 3u);
    for (const float w : part.weights) EXPECT_FLOAT_EQ(w, 1.0f / 3);
}

TEST(Mesh, AJointThatTheSkinLacksIsRefusedOnlyIfItWeighs)
{
    EXPECT_EQ(
        outcome_of(skinned({0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}).glb()).status,
        0);
    EXPECT_EQ(
        outcome_of(skinned({0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}).glb()).status,
        CLQ_FORMAT);
    EXPECT_EQ(
        outcome_of(skinned({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {2, -1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}).glb()).status,
        CLQ_FORMAT);
}

TEST(Mesh, JointsOutsideTheSceneBecomePartOfTheRig)
{
    Maker maker = skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0});
    maker.json["scenes"][0]["nodes"] = {0};
    const model::Model model = load(maker.glb());
    EXPECT_EQ(model.rig.node_count(), 3u);
    EXPECT_EQ(model.rig.parents[model.rig.find_node("tip")], model.rig.find_node("root"));
    EXPECT_EQ(model.parts.size(), 1u);
}

TEST(Mesh, TwoSkinsOverOneSkeletonShareTheirMatrices)
{
    Maker maker = skinned({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, {1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0});
    maker.add("skins", {{"joints", {2, 1}}});
    maker.add("nodes", {{"mesh", 0}, {"skin", 1}});
    maker.json["scenes"][0]["nodes"] = {0, 1, 3};
    const model::Model model = load(maker.glb());
    EXPECT_EQ(model.rig.palette.size(), 2u);
    EXPECT_EQ(model.parts[0].joints[0], model.parts[1].joints[1]);
    EXPECT_EQ(model.parts[0].joints[1], model.parts[1].joints[0]);
}

TEST(Mesh, MorphTargetsAndTheirWeightsAreKeptForEachNode)
{
    Maker maker;
    maker.triangle();
    const int up = maker.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 2});
    maker.primitive()["targets"] = Json::array({{{"POSITION", up}}, Json::object()});
    maker.json["meshes"][0]["weights"] = {0.5, 0.25};
    maker.add("nodes", {{"mesh", 0}, {"weights", {1, 0}}});
    maker.json["scenes"][0]["nodes"] = {0, 1};
    const model::Model model = load(maker.glb());
    ASSERT_EQ(model.rig.morph_sets.size(), 2u);
    EXPECT_EQ(model.parts[1].morph_set, 1u);
    EXPECT_EQ(model.parts[1].morphs.at(0).positions.at(2), glm::vec3(0, 0, 2));
    EXPECT_TRUE(model.parts[1].morphs.at(1).positions.empty());
    const model::Array<float> &weights = model.rig.rest_weights;
    EXPECT_EQ(std::vector<float>(weights.begin(), weights.end()), (std::vector<float>{0.5f, 0.25f, 1, 0}));
}

TEST(Mesh, VertexColoursAreEncodedAndTheirAlphaIsNot)
{
    Maker maker;
    maker.triangle();
    maker.primitive()["attributes"]["COLOR_0"] =
        maker.floats("VEC4", 3, {0, 0.2158605f, 1, 0.5f, 2, -1, 0.0015f, 1, 0, 0, 0, 0});
    const model::Part part = load(maker.glb()).parts.at(0);
    EXPECT_EQ(part.colours[0], (std::array<uint8_t, 4>{0, 128, 255, 128}));
    EXPECT_EQ(part.colours[1], (std::array<uint8_t, 4>{255, 0, 5, 255}));
}

}  // namespace
}  // namespace claque::testing

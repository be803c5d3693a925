// Emission, BLEND and looks that are not shown, as read, and instances. Pictures of them are in
// tests/gl/file_light_test.cpp.
#include <algorithm>

#include <gtest/gtest.h>

#include "maker.h"
#include "tests/support/written_image.h"

namespace claque::testing
{
namespace
{

Maker lamp_file()
{
    Maker maker;
    maker.triangle();
    maker.add("materials", {{"name", "lamp"},
                            {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}},
                            {"emissiveFactor", {0, 1, 0}}});
    maker.primitive()["material"] = 0;
    return maker;
}

// The words of the only warning.
std::string only_warning(const model::Model &model)
{
    EXPECT_EQ(model.warnings.size(), 1u);
    return model.warnings.empty() ? "" : model.warnings[0];
}

TEST(Light, OfALampIsTheSameOnAllPeople)
{
    const model::Model model = load(lamp_file().glb());
    ASSERT_EQ(model.zones.size(), 1u);
    const model::HsbRange &range = model.zones[0].range;
    EXPECT_EQ(range.hue_min_deg, 120);
    EXPECT_EQ(range.hue_max_deg, 120);
    EXPECT_EQ(range.saturation_min, 1);
    EXPECT_EQ(range.brightness_min, 1);
    EXPECT_EQ(range.brightness_max, 1);
}

TEST(Light, OfAPictureThatIsNotReadIsNamedAndRefusesNothing)
{
    for (const bool black : {true, false}) {
        Maker maker = lamp_file();
        if (!black) maker.json["materials"][0].erase("pbrMetallicRoughness");
        maker.add("textures", {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
        maker.add("images", {{"uri", "glow.ktx2"}});
        maker.json["materials"][0]["emissiveTexture"]["index"] = 0;
        const model::Model model = load(maker.glb());
        EXPECT_NE(only_warning(model).find("'lamp' emits by a picture that is not read"), std::string::npos);
        EXPECT_EQ(model.materials[0].lighting, model::Lighting());
    }
}

TEST(Light, OfOneColourOverAPictureIsNamed)
{
    Maker maker = lamp_file();
    maker.json["materials"][0].erase("pbrMetallicRoughness");
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    const Bytes png = png_of(2, 2, [](uint32_t, uint32_t) { return Colour{90, 90, 90, 255}; });
    maker.add("images", {{"bufferView", maker.view(png)}, {"mimeType", "image/png"}});
    maker.add("textures", {{"source", 0}});
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    const model::Model model = load(maker.glb());
    EXPECT_NE(only_warning(model).find("emits one colour over a picture"), std::string::npos);
    EXPECT_EQ(model.materials[0].lighting.emission, (std::array<float, 3>{0, 1, 0}));
}

TEST(Light, LooksOfMaterialsThatNothingShowsAreNotNamed)
{
    Maker maker = lamp_file();
    maker.add("materials", {{"name", "unused"}, {"extensions", {{"KHR_materials_sheen", Json::object()}}}});
    EXPECT_EQ(load(maker.glb()).warnings.size(), 0u);
    maker.primitive()["material"] = 1;
    EXPECT_NE(only_warning(load(maker.glb())).find("KHR_materials_sheen"), std::string::npos);
}

// The warnings of one transparent material.
std::vector<std::string> warnings_of(const char *material, float alpha, asset::Blend blend = asset::Blend::unset)
{
    Maker maker = lamp_file();
    maker.json["materials"][0] = {
        {"name", material}, {"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}};
    const Bytes bytes = maker.glb();
    asset::LoadOptions options;
    options.blend = blend;
    return asset::load_gltf(bytes.data(), bytes.size(), options).warnings;
}

TEST(Blend, OfAFullyTransparentMaterialSaysWhatShowsIt)
{
    const std::vector<std::string> warnings = warnings_of("visor", 0.3f);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("left out, as alpha is below 0.5 everywhere; --blend opaque"), std::string::npos);
}

TEST(Blend, OfHairAndEyesIsNamedWithoutAdvice)
{
    for (const char *name : {"Hair_00_HAIR", "FaceBrow", "eyelashes", "EyeHighlight", "cornea"})
        for (const float alpha : {0.3f, 0.7f}) {
            const std::vector<std::string> warnings = warnings_of(name, alpha);
            ASSERT_EQ(warnings.size(), 1u);
            EXPECT_NE(warnings[0].find(alpha < 0.5f ? "left out" : "drawn as opaque"), std::string::npos)
                << warnings[0];
            EXPECT_EQ(warnings[0].find("--blend"), std::string::npos) << warnings[0];
        }
}

TEST(Blend, IsOneSentenceForMaterialsThatAreShownAlike)
{
    Maker maker = lamp_file();
    maker.json["materials"] = Json::array();
    const auto named = [](const char *name, float alpha) {
        return Json{
            {"name", name}, {"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}}};
    };
    const Json primitive = maker.primitive();
    Json &primitives = maker.json["meshes"][0]["primitives"];
    primitives = Json::array();
    for (const auto &[name, alpha] : {std::pair("visor", 0.7f), std::pair("veil", 0.8f), std::pair("haze", 0.2f)}) {
        primitives.push_back(primitive);
        primitives.back()["material"] = primitives.size() - 1;
        maker.json["materials"].push_back(named(name, alpha));
    }
    std::vector<std::string> warnings = load(maker.glb()).warnings;
    std::sort(warnings.begin(), warnings.end());
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_EQ(warnings[0].rfind("material 'haze' is transparent: left out", 0), 0u) << warnings[0];
    EXPECT_EQ(warnings[1].rfind("materials 'visor', 'veil' are transparent: drawn as opaque", 0), 0u) << warnings[1];
}

TEST(Blend, IsSilentOnceItIsChosen)
{
    for (const asset::Blend blend : {asset::Blend::mask, asset::Blend::opaque})
        for (const float alpha : {0.3f, 0.7f}) EXPECT_TRUE(warnings_of("visor", alpha, blend).empty());
}

// The lamp three times.
Maker three_lamps()
{
    Maker maker = lamp_file();
    maker.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        maker.floats("VEC3", 3, {1, 0, 0, 2, 0, 0, 3, 0, 0});
    return maker;
}

TEST(Instances, HangBelowTheirNode)
{
    const model::Model model = load(three_lamps().glb());
    ASSERT_EQ(model.parts.size(), 3u);
    ASSERT_EQ(model.rig.node_count(), 4u);
    for (uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(model.rig.parents[model.parts[i].node], 0u);
        EXPECT_EQ(model.rig.rest[model.parts[i].node].translation, glm::vec3(float(i) + 1, 0, 0));
    }
}

TEST(Instances, OfUnequalAttributesOrWrongRotationsAreRefused)
{
    const auto refusal = [](const char *name, const char *type, size_t count, const std::vector<float> &values) {
        Maker maker = three_lamps();
        maker.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"][name] =
            maker.floats(type, count, values);
        return outcome_of(maker.glb()).text;
    };
    EXPECT_NE(refusal("SCALE", "VEC3", 2, {1, 1, 1, 1, 1, 1}).find("SCALE has 2 instances"), std::string::npos);
    EXPECT_NE(refusal("ROTATION", "VEC4", 3, std::vector<float>(12, 0.1f)).find("rotation of instance 0"),
              std::string::npos);
}

TEST(Instances, AreNoNodesThatAFileCanName)
{
    Maker maker = three_lamps();
    const int times = maker.floats("SCALAR", 2, {0, 1}), places = maker.floats("VEC3", 2, {0, 0, 0, 1, 1, 1});
    maker.add("animations",
              {{"samplers", Json::array({{{"input", times}, {"output", places}}})},
               {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}})}});
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_FORMAT);
    maker.json["animations"][0]["channels"][0]["target"]["node"] = 0;
    EXPECT_EQ(outcome_of(maker.glb()).text, "");
}

TEST(Instances, OfASkinnedMeshAreOneWithAWarning)
{
    Maker maker = three_lamps();
    maker.add("nodes", {{"name", "bone"}});
    maker.add("skins", {{"joints", {1}}});
    maker.json["nodes"][0]["skin"] = 0;
    maker.primitive()["attributes"]["JOINTS_0"] = maker.accessor<uint8_t>(u8, "VEC4", 3, std::vector<uint8_t>(12, 0));
    maker.primitive()["attributes"]["WEIGHTS_0"] = maker.floats("VEC4", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const model::Model model = load(maker.glb());
    EXPECT_EQ(model.parts.size(), 1u);
    EXPECT_NE(only_warning(model).find("skin: shown once"), std::string::npos);
}

TEST(Instances, MoreThanTheFileJustifiesAreRefused)
{
    Maker maker = lamp_file();
    maker.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        maker.add("accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", 1000000}});
    EXPECT_EQ(outcome_of(maker.glb()).status, CLQ_LIMIT);
}

TEST(Instances, OfALongNameAreRefusedBeforeItIsCopied)
{
    Maker maker = lamp_file();
    maker.json["nodes"][0]["name"] = std::string(60000, 'n');
    maker.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        maker.floats("VEC3", 20000, std::vector<float>(60000, 0));
    const Outcome outcome = outcome_of(maker.glb());
    EXPECT_EQ(outcome.status, CLQ_LIMIT);
    EXPECT_NE(outcome.text.find("EXT_mesh_gpu_instancing"), std::string::npos) << outcome.text;
}

}  // namespace
}  // namespace claque::testing

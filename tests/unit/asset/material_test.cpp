// Materials, their images, and the zones that come from them.
#include <cmath>

#include <gtest/gtest.h>

#include "assets.h"
#include "lib/asset/decoders.h"
#include "png.h"

namespace claque::testing
{
namespace
{

// The triangle with one textured material; image 0 is a 2 x 2 grey PNG.
Maker textured()
{
    Maker maker;
    maker.triangle();
    maker.add("images", {{"bufferView", maker.view(make_png(2, 2, 8, {0, 10, 200}, 2))}, {"mimeType", "image/png"}});
    maker.add("textures", {{"source", 0}});
    maker.add("materials", {{"name", "Shirt"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    return maker;
}

TEST(Material, ImagesComeAsRgbaWithTheTopRowFirst)
{
    const model::Model model = load(textured().glb());
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].rgba, (Bytes{10, 10, 10, 255, 200, 200, 200, 255, 10, 10, 10, 255, 200, 200, 200, 255}));
    EXPECT_EQ(model.images[0].alpha, model::AlphaMeaning::opacity);
    EXPECT_EQ(model.parts[0].uvs.at(1), glm::vec2(1, 0));
}

TEST(Material, LinearFactorsAreEncoded)
{
    Maker maker = textured();
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0.2140411, 1, 0.5};
    const model::Material material = load(maker.glb()).materials.at(0);
    EXPECT_NEAR(material.base_colour[1], 0.5f, 1e-5f);
    EXPECT_EQ(material.base_colour[0], 0);
    EXPECT_EQ(material.base_colour[2], 1);
    EXPECT_EQ(material.base_colour[3], 0.5f);
}

TEST(Material, TextureTransformsAreBakedIntoCoordinates)
{
    Maker maker = textured();
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"offset", {0.5, 0.25}}, {"rotation", 1.57079632679}, {"scale", {2, 4}}};
    maker.json["extensionsRequired"] = {"KHR_texture_transform"};
    const model::Part part = load(maker.glb()).parts.at(0);
    // A quarter turn takes u to -v and v to u, after scaling.
    EXPECT_NEAR(part.uvs[1].x, 0.5, 1e-5);
    EXPECT_NEAR(part.uvs[1].y, 0.25 - 2, 1e-5);
    EXPECT_NEAR(part.uvs[2].x, 0.5 + 4, 1e-5);
    EXPECT_NEAR(part.uvs[2].y, 0.25, 1e-5);
}

TEST(Material, SamplersSetTheWrapAndAlphaModesTheirTest)
{
    Maker maker = textured();
    maker.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}});
    maker.json["textures"][0]["sampler"] = 0;
    maker.json["materials"][0].update({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}, {"doubleSided", true}});
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.2};
    const model::Material material = load(maker.glb()).materials.at(0);
    EXPECT_EQ(material.wrap_s, model::Wrap::clamp);
    EXPECT_EQ(material.wrap_t, model::Wrap::mirror);
    EXPECT_EQ(material.alpha_mode, model::AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.25f);
    EXPECT_TRUE(material.double_sided);
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 1};
    EXPECT_EQ(load(maker.glb()).materials[0].alpha_mode, model::AlphaMode::opaque) << "nothing is cut out";
    maker.json["materials"][0].update({{"alphaMode", "BLEND"}, {"alphaCutoff", 0.9}});
    const model::Model opaque = load(maker.glb());
    EXPECT_EQ(opaque.materials[0].alpha_mode, model::AlphaMode::opaque);
    EXPECT_EQ(opaque.warnings.size(), 0u);
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.4};
    const model::Model blended = load(maker.glb());
    EXPECT_EQ(blended.materials[0].alpha_mode, model::AlphaMode::mask);
    EXPECT_EQ(blended.materials[0].alpha_cutoff, 0.5f);
    EXPECT_EQ(blended.warnings.size(), 1u);
}

TEST(Material, WithoutTextureCoordinatesIsShownWithoutItsTexture)
{
    Maker maker = textured();
    maker.primitive()["attributes"].erase("TEXCOORD_0");
    const model::Model model = load(maker.glb());
    EXPECT_EQ(model.materials[model.parts[0].material].image, model::none);
    EXPECT_NE(model.materials[model.parts[0].material].zone, model::none);
    EXPECT_EQ(model.images.size(), 0u) << "nothing shows it";
    EXPECT_EQ(model.warnings.size(), 1u);
}

TEST(Material, CompressedTexturesFallBackToPngWhereThereIsOne)
{
    Maker maker = textured();
    for (const char *extension : {"EXT_texture_webp", "KHR_texture_basisu"}) {
        Maker with = maker;
        with.json["extensionsRequired"] = {extension};
        with.json["textures"][0]["extensions"][extension] = {{"source", 0}};
        EXPECT_EQ(load(with.glb()).images.size(), 1u) << extension;
        with.json["textures"][0].erase("source");
        const Outcome outcome = outcome_of(with.glb());
        const bool read = extension == std::string("EXT_texture_webp") && asset::has_decoder(asset::Decoder::webp);
        EXPECT_EQ(outcome.status, read ? 0 : CLQ_UNSUPPORTED) << extension;
        EXPECT_EQ(outcome.text.find(extension) == std::string::npos, read) << outcome.text;
    }
}

TEST(Material, AnImageThatIsNeededAndBrokenIsRefusedByName)
{
    Maker maker = textured();
    maker.json["images"][0]["name"] = "cloth";
    maker.binary[maker.json["bufferViews"][1]["byteOffset"].get<size_t>() + 12] = 'X';
    const Outcome outcome = outcome_of(maker.glb());
    EXPECT_EQ(outcome.status, CLQ_FORMAT);
    EXPECT_NE(outcome.text.find("'cloth'"), std::string::npos) << outcome.text;
}

TEST(Zones, AreOnePerNameAndColour)
{
    Maker maker;
    maker.triangle();
    const auto material = [](const char *name, double red) {
        return Json{{"name", name}, {"pbrMetallicRoughness", {{"baseColorFactor", {red, 0, 0, 1}}}}};
    };
    maker.json["materials"] = {material("Skin", 1), material("Skin", 1), material("Skin", 0.5), material("Cap", 1),
                               material("unused", 1)};
    const Json first = maker.primitive();
    for (int i = 0; i < 4; ++i) {
        maker.json["meshes"][0]["primitives"][i] = first;
        maker.json["meshes"][0]["primitives"][i]["material"] = i;
    }
    const model::Model model = load(maker.glb());
    ASSERT_EQ(model.zones.size(), 3u);
    EXPECT_EQ(model.materials[0].zone, model.materials[1].zone);
    EXPECT_EQ(model.zones[2].name, "Cap");
    EXPECT_EQ(model.materials[4].zone, model::none);
}

TEST(Zones, ComeFromExtrasWhereAlphaHoldsKeys)
{
    Maker maker = textured();
    const Json zones = Json::array({{{"name", "tunic"}, {"key", 140}, {"colour", {1, 0.5, 0}}},
                                    {{"name", "skin"},
                                     {"key", 0},
                                     {"hue_deg", {340, 20}},
                                     {"saturation", {0.25, 0.5}},
                                     {"brightness", {0.5, 1}}}});
    for (const char *list : {"images", "materials"}) {
        Maker keyed = maker;
        keyed.json[list][0]["extras"]["claque"]["zones"] = zones;
        const model::Model model = load(keyed.glb());
        EXPECT_EQ(model.images[0].alpha, model::AlphaMeaning::zone_keys) << list;
        ASSERT_EQ(model.zones.size(), 2u) << list;
        EXPECT_EQ(model.zones[0].key, 140);
        EXPECT_EQ(model.zones[0].colour[1], 0.5f);
        EXPECT_EQ(model.zones[1].range.hue_min_deg, 340);
        EXPECT_EQ(model.zones[1].range.hue_max_deg, 20);
        EXPECT_EQ(model.materials[0].zone, model::none);
    }
}

TEST(Zones, ThatContradictThemselvesAreRefused)
{
    const auto with = [](Json zones) {
        Maker maker = textured();
        maker.json["images"][0]["extras"] = {{"claque", {{"zones", std::move(zones)}}}};
        return outcome_of(maker.glb());
    };
    const Json good = {{"name", "a"}, {"key", 1}};
    EXPECT_EQ(with(Json::array({good, good})).status, 0);
    EXPECT_EQ(with(Json::array({good, {{"name", "b"}, {"key", 1}}})).status, CLQ_FORMAT);
    EXPECT_EQ(with(Json::array({{{"name", "b"}, {"key", 256}}})).status, CLQ_FORMAT);
    EXPECT_EQ(with(Json::array({{{"key", 1}}})).status, CLQ_FORMAT);
    EXPECT_EQ(with(Json::array({{{"name", "b"}, {"key", 1}, {"hue_deg", {0, 1}}}})).status, CLQ_FORMAT);
    EXPECT_EQ(with(Json::array({{{"name", "b"}, {"key", 1}, {"colour", {0, 0, 2}}}})).status, CLQ_FORMAT);
    EXPECT_EQ(with(Json::array()).status, CLQ_FORMAT);
    EXPECT_EQ(with("red").status, CLQ_FORMAT);
    Maker others = textured();
    others.json["images"][0]["extras"] = "anything";
    EXPECT_EQ(outcome_of(others.glb()).status, 0) << "extras of others are theirs";
}

}  // namespace
}  // namespace claque::testing

// Emission, unlit materials, BLEND and instances from small files to pixels.
#include <fstream>

#include "lib/asset/gltf.h"
#include "lib/asset/srgb.h"
#include "tests/gl/support/plates.h"
#include "tests/support/gltf_maker.h"
#include "tests/support/written_image.h"

namespace gltest
{
namespace
{

namespace asset = claque::asset;
using claque::testing::Bytes;
using claque::testing::Colour;
using claque::testing::Json;
using claque::testing::Maker;

// The colour that a linear factor becomes.
Rgb encoded(const std::array<float, 3> &factor)
{
    return {asset::byte_of(asset::encoded(factor[0])), asset::byte_of(asset::encoded(factor[1])),
            asset::byte_of(asset::encoded(factor[2]))};
}

// A rectangle that fills the picture, and its material.
Maker plate(const Json &material)
{
    Maker maker;
    const int positions = maker.floats("VEC3", 4, {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const int uvs = maker.floats("VEC2", 4, {0, 1, 1, 1, 1, 0, 0, 0});
    const int indices = maker.accessor<uint16_t>(claque::testing::u16, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
    maker.add("materials", material);
    maker.add("meshes", {{"primitives", Json::array({{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                                                      {"indices", indices},
                                                      {"material", 0}}})}});
    maker.add("nodes", {{"mesh", 0}});
    maker.json["scenes"] = Json::array({{{"nodes", {0}}}});
    return maker;
}

Json black_with(const std::array<float, 3> &emission)
{
    return {
        {"name", "lamp"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}}, {"emissiveFactor", emission}};
}

// The left half of the texture in one colour, the right in another.
int add_halves(Maker &maker, Colour left, Colour right)
{
    const Bytes png = claque::testing::png_of(8, 8, [&](uint32_t x, uint32_t) { return x < 4 ? left : right; });
    const int image = maker.add("images", {{"bufferView", maker.view(png)}, {"mimeType", "image/png"}});
    const int sampler = maker.add("samplers", {{"wrapS", 33071}, {"wrapT", 33071}});
    return maker.add("textures", {{"source", image}, {"sampler", sampler}});
}

model::Model read(const Maker &maker, asset::Blend blend = asset::Blend::unset)
{
    asset::LoadOptions options;
    options.blend = blend;
    const Bytes bytes = maker.glb();
    return asset::load_gltf(bytes.data(), bytes.size(), options);
}

class FileLight : public PlateTest
{
protected:
    Picture shown_of(const Maker &maker, asset::Blend blend = asset::Blend::unset)
    {
        model_ = read(maker, blend);
        return shown(split_unwhitened(model_));
    }
    void expect_no_warning() const
    {
        for (const std::string &warning : model_.warnings) ADD_FAILURE() << warning;
    }
    void expect_warning_of(const std::string &what) const
    {
        ASSERT_EQ(model_.warnings.size(), 1u);
        EXPECT_NE(model_.warnings[0].find(what), std::string::npos) << model_.warnings[0];
    }

    model::Model model_;
};

TEST_F(FileLight, ABlackEmittingPlateShowsItsEmissionUnderEveryLight)
{
    for (const Lights lights : all_lights) {
        set(lights);
        EXPECT_EQ(at(shown_of(plate(black_with({0.1f, 0.8f, 1}))), 0, 1), encoded({0.1f, 0.8f, 1}));
        expect_no_warning();
    }
}

TEST_F(FileLight, StrengthMultipliesEmissionAndIsClamped)
{
    Json material = black_with({0.1f, 0.2f, 0.4f});
    const auto shown_at = [&](float strength) {
        material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
        return at(shown_of(plate(material)), 0, 1);
    };
    EXPECT_EQ(shown_at(2), encoded({0.2f, 0.4f, 0.8f}));
    EXPECT_EQ(shown_at(4), encoded({0.4f, 0.8f, 1}));
    EXPECT_EQ(shown_at(0), encoded({0, 0, 0}));
}

TEST_F(FileLight, EmissionIsAddedToALitColour)
{
    Json material = black_with({0.1f, 0, 0.02f});
    material["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0.5, 0.02, 1};
    set(Lights::none);
    EXPECT_EQ(at(shown_of(plate(material)), 0, 1), encoded({0.1f, 0, 0.02f}));
    expect_no_warning();
    set(Lights::bright);
    const Rgb both = at(shown_of(plate(material)), 0, 1), e = encoded({0.1f, 0.5f, 0.02f});
    EXPECT_EQ(both[0], e[0]);
    EXPECT_EQ(both[1], e[1]);
    EXPECT_NEAR(both[2], 2 * e[2], 1);
}

// On nearly black too, as screens have it: 0.004 becomes 13 of 255.
TEST_F(FileLight, APictureOfEmissionOnBlackIsShownAsItIs)
{
    Json material = black_with({1, 1, 1});
    for (const float base : {0.0f, 0.004f}) {
        material["pbrMetallicRoughness"]["baseColorFactor"] = {base, base, base, 1};
        Maker maker = plate(material);
        maker.json["materials"][0]["emissiveTexture"]["index"] = add_halves(maker, {250, 20, 10, 255}, {0, 0, 0, 255});
        for (const Lights lights : {Lights::none, Lights::bright}) {
            set(lights);
            const Picture picture = shown_of(maker);
            EXPECT_EQ(at(picture, 0, 2), (Rgb{250, 20, 10}));
            EXPECT_EQ(at(picture, 1, 2), (Rgb{0, 0, 0}));
            expect_no_warning();
        }
    }
}

// As many exporters write people who shall not depend on light: emission by the picture of the base colour.
TEST_F(FileLight, EmissionByThePictureOfTheBaseColourIsAdded)
{
    Maker maker = plate({{"name", "skin"}, {"emissiveFactor", {1, 1, 1}}});
    const int texture = add_halves(maker, {250, 20, 10, 255}, {40, 50, 60, 255});
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = texture;
    maker.json["materials"][0]["emissiveTexture"]["index"] = texture;
    set(Lights::none);
    const Picture picture = shown_of(maker);
    EXPECT_EQ(at(picture, 0, 2), (Rgb{250, 20, 10}));
    EXPECT_EQ(at(picture, 1, 2), (Rgb{40, 50, 60}));
    expect_no_warning();
}

TEST_F(FileLight, APictureOfEmissionOverALitColourIsNamedUnlessItIsOfOneColour)
{
    Maker maker = plate({{"name", "robot"}, {"emissiveFactor", {1, 1, 1}}});
    maker.json["materials"][0]["emissiveTexture"]["index"] = add_halves(maker, {250, 20, 10, 255}, {0, 0, 0, 255});
    set(Lights::bright);
    EXPECT_EQ(at(shown_of(maker), 1, 2), (Rgb{255, 255, 255}));
    expect_warning_of("'robot' emits by a picture");
    for (const uint8_t value : {0, 80}) {
        Maker even = plate({{"name", "robot"}, {"emissiveFactor", {1, 1, 1}}});
        even.json["materials"][0]["emissiveTexture"]["index"] =
            add_halves(even, {value, value, value, 255}, {value, value, value, 255});
        set(Lights::none);
        EXPECT_EQ(at(shown_of(even), 0, 1), (Rgb{value, value, value}));
        expect_no_warning();
    }
}

TEST_F(FileLight, AnUnlitPlateShowsItsBaseColourUnderEveryLight)
{
    Maker maker = plate({{"name", "poster"},
                         {"pbrMetallicRoughness", {{"baseColorFactor", {0.2, 0.4, 0.6, 1}}}},
                         {"emissiveFactor", {1, 1, 1}},
                         {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    maker.json["extensionsRequired"] = {"KHR_materials_unlit"};
    for (const Lights lights : all_lights) {
        set(lights);
        EXPECT_EQ(at(shown_of(maker), 0, 1), encoded({0.2f, 0.4f, 0.6f}));
        expect_no_warning();
    }
}

TEST_F(FileLight, BlendLeavesOutTheTransparentHalfUnlessAskedForAll)
{
    Maker maker = plate({{"name", "veil"}, {"alphaMode", "BLEND"}});
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
        add_halves(maker, {200, 100, 50, 51}, {200, 100, 50, 204});
    const Rgb behind = {background[0], background[1], background[2]}, own = {200, 100, 50};
    Picture picture = shown_of(maker);
    EXPECT_EQ(at(picture, 0, 2), behind);
    EXPECT_EQ(at(picture, 1, 2), own);
    expect_warning_of("--blend opaque");
    EXPECT_EQ(shown_of(maker, asset::Blend::mask), picture);
    expect_no_warning();
    picture = shown_of(maker, asset::Blend::opaque);
    EXPECT_EQ(at(picture, 0, 2), own);
    EXPECT_EQ(at(picture, 1, 2), own);
    expect_no_warning();
}

TEST_F(FileLight, BlendOfAnOpaquePictureIsOpaqueWithoutAWord)
{
    Maker maker = plate({{"name", "coat"}, {"alphaMode", "BLEND"}});
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
        add_halves(maker, {200, 100, 50, 255}, {10, 20, 30, 254});
    const Picture picture = shown_of(maker);
    EXPECT_EQ(at(picture, 1, 2), (Rgb{10, 20, 30}));
    EXPECT_EQ(model_.materials[0].alpha_mode, model::AlphaMode::opaque);
    expect_no_warning();
}

TEST_F(FileLight, LooksThatGlLacksAreNamedInOneSentence)
{
    Maker maker = plate({{"name", "car"},
                         {"extensions",
                          {{"KHR_materials_clearcoat", Json::object()},
                           {"KHR_materials_sheen", Json::object()},
                           {"KHR_materials_emissive_strength", Json::object()}}}});
    shown_of(maker);
    expect_warning_of("KHR_materials_clearcoat, KHR_materials_sheen");
}

// A triangle at three places, and the same by nodes below the first.
TEST_F(FileLight, InstancesAreTheNodesThatTheyStandFor)
{
    const std::vector<float> at = {-0.7f, -0.5f, 0, 0.1f, -0.2f, 0.3f, 0.4f, 0.5f, -0.2f};
    const std::vector<float> turned = {0, 0, 0, 1, 0, 0, 0.3826834f, 0.9238795f, 0, 0, 1, 0};
    const std::vector<float> sized = {0.3f, 0.3f, 1, 0.5f, 0.2f, 1, 0.25f, 0.25f, 2};
    Maker instanced, written;
    for (Maker *maker : {&instanced, &written}) {
        maker->triangle();
        maker->json["nodes"][0]["translation"] = {0.05, 0, 0};
    }
    Json &attributes = instanced.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes["TRANSLATION"] = instanced.floats("VEC3", 3, at);
    attributes["ROTATION"] = instanced.floats("VEC4", 3, turned);
    attributes["SCALE"] = instanced.floats("VEC3", 3, sized);
    instanced.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    written.json["nodes"][0].erase("mesh");
    const auto slice = [](const std::vector<float> &of, size_t n, size_t i) {
        return std::vector<float>(of.begin() + ptrdiff_t(n * i), of.begin() + ptrdiff_t(n * (i + 1)));
    };
    for (size_t i = 0; i < 3; ++i) {
        written.json["nodes"][0]["children"].push_back(i + 1);
        written.add("nodes", {{"mesh", 0},
                              {"translation", slice(at, 3, i)},
                              {"rotation", slice(turned, 4, i)},
                              {"scale", slice(sized, 3, i)}});
    }
    const Picture three = shown_of(written), same = shown_of(instanced);
    expect_no_warning();
    EXPECT_EQ(model_.parts.size(), 3u);
    EXPECT_TRUE(three == same);
    instanced.json["nodes"][0].erase("extensions");
    EXPECT_FALSE(shown_of(instanced) == three);
}

// Inputs that went wrong in trials (../shared/cases), where they are.
TEST_F(FileLight, FilesOfTrialsShowWhatTheyHold)
{
    const std::string folder = std::string(CLAQUE_ASSETS_DIR) + "/../cases/characters/";
    std::ifstream lamp(folder + "emissive_only.glb", std::ios::binary);
    if (!lamp) GTEST_SKIP() << "no " << folder << "emissive_only.glb";
    const auto load = [](std::ifstream &file) {
        const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
        return asset::load_gltf(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size(), {});
    };
    set(Lights::none);
    const Picture picture = shown(split_unwhitened(load(lamp)));
    const size_t above = 3 * size_t(width * (height / 4) + width / 2);  // it stands on the middle of the picture
    EXPECT_EQ((Rgb{picture[above], picture[above + 1], picture[above + 2]}), encoded({0.1f, 0.8f, 1}));
    std::ifstream trio(folder + "gpu_instancing.glb", std::ios::binary);
    ASSERT_TRUE(trio.good());
    EXPECT_EQ(split_unwhitened(load(trio)).tmpl->report.triangles, 3u);
}

}  // namespace
}  // namespace gltest

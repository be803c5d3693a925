// KHR_materials_variants as texture sets.
#include <gtest/gtest.h>

#include "assets.h"
#include "png.h"

namespace claque::testing
{
namespace
{

Json textured(const char *name, int texture)
{
    return {{"name", name}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}};
}

// A triangle in one of three shirts; variant "night" shows the second, "day" the first and so itself.
Maker in_variants()
{
    Maker maker;
    maker.triangle();
    for (const uint8_t grey : {10, 90, 200}) {
        maker.add("images", {{"bufferView", maker.view(make_png(1, 1, 8, {0, grey}, 2))}, {"mimeType", "image/png"}});
        maker.add("textures", {{"source", maker.json["images"].size() - 1}});
    }
    maker.json["materials"] = {textured("Day", 0), textured("Night", 1), textured("Unused", 2)};
    maker.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "night"}}, {{"name", "day"}}};
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    maker.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}},
                                                                             {{"material", 0}, {"variants", {1}}}};
    return maker;
}

std::string refusal_of(const Maker &maker)
{
    const Outcome outcome = outcome_of(maker.glb());
    EXPECT_EQ(outcome.status, CLQ_FORMAT);
    return outcome.text;
}

Json &mappings_of(Maker &maker) { return maker.primitive()["extensions"]["KHR_materials_variants"]["mappings"]; }

}  // namespace

TEST(Variants, AreTextureSetsByNameWithTheOtherMaterialsImage)
{
    const model::Model model = load(in_variants().glb());
    ASSERT_EQ(model.texture_sets.size(), 2u);
    EXPECT_EQ(model.texture_sets[0].name, "night");
    EXPECT_EQ(model.texture_sets[1].name, "day");
    const uint32_t night = model.texture_sets[0].images.at(0);
    ASSERT_LT(night, model.images.size());
    EXPECT_EQ(model.images[night].rgba[0], 90);
    EXPECT_EQ(model.images[model.materials[0].image].rgba[0], 10);
    EXPECT_EQ(model.texture_sets[1].images.at(0), model::none) << "it shows itself";
    EXPECT_EQ(model.images.size(), 2u) << "what no variant shows is not decoded";
    EXPECT_TRUE(model.warnings.empty());
}

TEST(Variants, ThatDifferInMoreThanTheTextureAreTakenWithAWarning)
{
    Maker maker = in_variants();
    maker.json["materials"][1]["doubleSided"] = true;
    const model::Model model = load(maker.glb());
    EXPECT_NE(model.texture_sets[0].images.at(0), model::none);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("variant 'night': only the texture of material 'Night' is used"),
              std::string::npos)
        << model.warnings[0];
}

TEST(Variants, WhoseTextureCannotLieOnTheSameSurfaceShowTheMaterialsOwn)
{
    Maker maker = in_variants();
    maker.json["materials"][1]["pbrMetallicRoughness"].erase("baseColorTexture");
    model::Model model = load(maker.glb());
    EXPECT_EQ(model.texture_sets[0].images.at(0), model::none);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("cannot show material 'Night' for 'Day'"), std::string::npos);
    maker = in_variants();
    maker.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"scale", {2, 2}}};
    model = load(maker.glb());
    EXPECT_EQ(model.texture_sets[0].images.at(0), model::none);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("has another mapping"), std::string::npos);
}

TEST(Variants, ThatNameWhatThereIsNotAreRefusedByPlace)
{
    Maker maker = in_variants();
    mappings_of(maker)[0]["material"] = 9;
    EXPECT_NE(refusal_of(maker).find("mappings[0].material"), std::string::npos) << refusal_of(maker);
    maker = in_variants();
    mappings_of(maker)[0]["variants"] = {2};
    EXPECT_NE(refusal_of(maker).find("mappings[0].variants[0]"), std::string::npos) << refusal_of(maker);
    maker = in_variants();
    maker.json["extensions"]["KHR_materials_variants"]["variants"][1] = Json::object();
    EXPECT_NE(refusal_of(maker).find("variants[1].name"), std::string::npos) << refusal_of(maker);
}

TEST(Variants, OfAMaterialWithZoneKeysNeedZoneKeysOfTheirOwn)
{
    Maker maker = in_variants();
    const Json zones = {{"claque", {{"zones", {{{"name", "cloth"}, {"key", 255}, {"colour", {1, 1, 1}}}}}}}};
    maker.json["images"][0]["extras"] = zones;
    model::Model model = load(maker.glb());
    EXPECT_EQ(model.texture_sets[0].images.at(0), model::none);
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("only one of them has zone keys"), std::string::npos) << model.warnings[0];
    maker.json["images"][1]["extras"] = zones;
    model = load(maker.glb());
    ASSERT_NE(model.texture_sets[0].images.at(0), model::none);
    EXPECT_EQ(model.images[model.texture_sets[0].images[0]].alpha, model::AlphaMeaning::zone_keys);
}

}  // namespace claque::testing

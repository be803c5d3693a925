// Characters without zone keys stay near the colours of their files, and people stay people, by the names, colours and
// places that the usual makers give their parts.
#include "near_colours.h"

#include <gtest/gtest.h>

#include "lib/asset/near_colours.h"
#include "lib/asset/zone_map.h"
#include "lib/asset/zone_ranges.h"
#include "maker.h"
#include "tests/support/written_encoding.h"
#include "tests/support/written_image.h"

namespace claque::testing
{
namespace
{

// A material of a file, with a base colour (linear) and perhaps an image of two texels, side by side.
struct Paint {
    std::string name;
    std::array<double, 3> base = {1, 1, 1};
    std::vector<Colour> texels = {};
};
// A triangle that hangs on a bone; it shows the left or the right texel.
struct Piece {
    std::string bone;
    int material;
    bool right = false;
    std::string mesh = "Mesh";
};

const Colour tan = {220, 170, 140, 255}, pale = {250, 225, 210, 255}, dark = {70, 45, 30, 255},
             blue = {40, 60, 160, 255}, white = {255, 255, 255, 255}, pink = {240, 90, 170, 255};

model::Model model_of(const std::vector<Paint> &paints, const std::vector<Piece> &pieces,
                      const asset::LoadOptions &options = {})
{
    Maker maker;
    for (const Paint &paint : paints) {
        Json base = {{"baseColorFactor", {paint.base[0], paint.base[1], paint.base[2], 1}}};
        if (!paint.texels.empty())
            base["baseColorTexture"] = {{"index", add_texture(maker, png_of(2, 1, [&](uint32_t x, uint32_t) {
                                                                  return paint.texels[x % paint.texels.size()];
                                                              }))}};
        maker.add("materials", {{"name", paint.name}, {"pbrMetallicRoughness", base}});
    }
    maker.add("nodes", {{"name", "Hips"}, {"children", {1, 2}}});
    maker.add("nodes", {{"name", "mixamorig:Head"}, {"children", Json::array()}});
    maker.add("nodes", {{"name", "hand.L"}, {"children", Json::array()}});
    for (const Piece &piece : pieces) {
        const float u = piece.right ? 0.75f : 0.25f;
        const Json attributes = {{"POSITION", maker.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0})},
                                 {"TEXCOORD_0", maker.floats("VEC2", 3, {u, 0.5f, u, 0.5f, u, 0.5f})}};
        const int mesh = maker.add(
            "meshes", {{"name", piece.mesh},
                       {"primitives", Json::array({{{"attributes", attributes}, {"material", piece.material}}})}});
        const int node = maker.add("nodes", {{"mesh", mesh}});
        maker.json["nodes"][piece.bone == "head" ? 1 : piece.bone == "hand" ? 2 : 0]["children"].push_back(node);
    }
    for (Json &node : maker.json["nodes"])
        if (node.contains("children") && node["children"].empty()) node.erase("children");
    maker.json["scenes"] = Json::array({{{"nodes", {0}}}});
    return load(maker.glb(), options);
}

uint32_t zone_of(const model::Model &model, const std::string &material)
{
    for (const model::Material &one : model.materials)
        if (one.name == material) return one.zone;
    ADD_FAILURE() << "no material " << material;
    return 0;
}

// How far an individual's colour is from the file's.
double off(const model::Model &model, uint32_t zone, uint64_t i)
{
    return apart(drawn(model, zone, i), own_colour(model, zone));
}

// The characters of a maker, as far as their names and colours go.
struct Made {
    std::string name;
    std::vector<Paint> paints;
    std::vector<Piece> pieces;
    std::vector<std::string> skins, hair, kept, cloth;
};

const std::vector<Made> &makers()
{
    static const std::vector<Made> all = {
        {"ReadyPlayerMe",
         {{"Wolf3D_Body", {1, 1, 1}, {tan}},
          {"Wolf3D_Skin", {1, 1, 1}, {tan}},
          {"Wolf3D_Hair", {0.11, 0.05, 0.02}, {white}},
          {"Wolf3D_Eye", {1, 1, 1}, {white, dark}},
          {"Wolf3D_Teeth", {1, 1, 1}, {white}},
          {"Wolf3D_Outfit_Top", {1, 1, 1}, {blue}}},
         {{"hand", 0}, {"hips", 0}, {"head", 1}, {"head", 2}, {"head", 3}, {"head", 4}, {"hips", 5}},
         {"Wolf3D_Body", "Wolf3D_Skin"},
         {"Wolf3D_Hair"},
         {"Wolf3D_Eye", "Wolf3D_Teeth"},
         {"Wolf3D_Outfit_Top"}},
        {"VRoid",
         {{"N00_000_00_Face_00_SKIN (Instance)", {1, 1, 1}, {pale}},
          {"N00_000_00_Body_00_SKIN (Instance)", {1, 1, 1}, {pale, blue}},
          {"N00_000_00_EyeIris_00_EYE (Instance)", {1, 1, 1}, {blue}},
          {"N00_000_00_FaceEyelash_00_FACE (Instance)", {1, 1, 1}, {dark}},
          {"N00_000_Hair_00_HAIR_01 (Instance)", {1, 1, 1}, {dark}},
          {"N00_007_01_Tops_01_CLOTH (Instance)", {1, 1, 1}, {blue}}},
         {{"head", 0}, {"hand", 1}, {"hips", 1, true}, {"head", 2}, {"head", 3}, {"head", 4}, {"hips", 5}},
         {"N00_000_00_Face_00_SKIN (Instance)", "N00_000_00_Body_00_SKIN (Instance)"},
         {"N00_000_Hair_00_HAIR_01 (Instance)"},
         {"N00_000_00_EyeIris_00_EYE (Instance)", "N00_000_00_FaceEyelash_00_FACE (Instance)"},
         {"N00_007_01_Tops_01_CLOTH (Instance)"}},
        {"Reallusion",
         {{"Std_Skin_Head", {1, 1, 1}, {tan}},
          {"Std_Skin_Arm", {1, 1, 1}, {tan}},
          {"Std_Nails", {1, 1, 1}, {tan}},
          {"Std_Cornea_L", {1, 1, 1}, {white}},
          {"Std_Upper_Teeth", {1, 1, 1}, {white}},
          {"Std_Tongue", {1, 1, 1}, {pink}},
          {"Scalp_Transparency", {1, 1, 1}, {dark}},
          {"Jacket", {1, 1, 1}, {blue}}},
         {{"head", 0}, {"hand", 1}, {"hand", 2}, {"head", 3}, {"head", 4}, {"head", 5}, {"head", 6}, {"hips", 7}},
         {"Std_Skin_Head", "Std_Skin_Arm", "Std_Nails"},
         {"Scalp_Transparency"},
         {"Std_Cornea_L", "Std_Upper_Teeth", "Std_Tongue"},
         {"Jacket"}},
        {"Mixamo",
         {{"Ch22_body", {1, 1, 1}, {tan, blue}},
          {"Ch22_head", {1, 1, 1}, {tan, dark}},
          {"Ch22_Eyelashes", {1, 1, 1}, {dark}},
          {"Ch22_Shirt", {1, 1, 1}, {blue}}},
         {{"hand", 0}, {"hips", 0, true}, {"head", 1}, {"head", 1, true}, {"head", 2}, {"hips", 3}},
         {"Ch22_body", "Ch22_head"},
         {},
         {"Ch22_Eyelashes"},
         {"Ch22_Shirt"}},
        {"MakeHuman",
         {{"Human.young_lightskinned_male", {1, 1, 1}, {tan}},
          {"Human.high-poly_brown_eye", {1, 1, 1}, {white}},
          {"Human.eyebrow001", {1, 1, 1}, {dark}},
          {"Human.tongue01", {1, 1, 1}, {pink}},
          {"Human.short02_hair", {1, 1, 1}, {dark}},
          {"Human.male_casualsuit01", {1, 1, 1}, {blue}}},
         {{"head", 0}, {"hand", 0}, {"hips", 0}, {"head", 1}, {"head", 2}, {"head", 3}, {"head", 4}, {"hips", 5}},
         {"Human.young_lightskinned_male"},
         {"Human.short02_hair", "Human.eyebrow001"},
         {"Human.high-poly_brown_eye", "Human.tongue01"},
         {"Human.male_casualsuit01"}},
        {"Quaternius",
         {{"Skin", {0.62, 0.42, 0.24}},
          {"Hair", {0.07, 0.03, 0.01}},
          {"Eyebrows", {0.05, 0.03, 0.02}},
          {"Eye", {0.03, 0.02, 0.01}},
          {"Gold", {0.34, 0.19, 0.05}},
          {"LimeGreen", {0.05, 0.11, 0.05}}},
         {{"head", 0}, {"hand", 0}, {"head", 1}, {"head", 2}, {"head", 3}, {"hips", 4}, {"hips", 5}},
         {"Skin"},
         {"Hair", "Eyebrows"},
         {"Eye", "Gold"},
         {"LimeGreen"}},
        {"Blender",
         {{"Material", {0.7, 0.4, 0.26}},
          {"Material.001", {0.7, 0.4, 0.26}},
          {"Material.002", {0.03, 0.015, 0.01}},
          {"Material.003", {0.02, 0.05, 0.35}}},
         {{"hand", 0}, {"head", 1}, {"head", 1}, {"head", 2, false, "Hair"}, {"hips", 3}},
         {"Material", "Material.001"},
         {"Material.002"},
         {},
         {"Material.003"}},
        {"BlenderWithMoreHairThanFace",
         {{"Material", {0.7, 0.4, 0.26}},
          {"Material.001", {0.7, 0.4, 0.26}},
          {"Material.002", {0.2, 0.1, 0.05}},
          {"Material.003", {0.02, 0.05, 0.35}}},
         {{"hand", 0}, {"head", 1}, {"head", 2}, {"head", 2}, {"hips", 3}},
         {"Material", "Material.001"},
         {"Material.002"},
         {},
         {"Material.003"}},
        {"KayKit",
         {{"mage_texture", {1, 1, 1}, {tan, blue}}},
         {{"head", 0}, {"hand", 0}, {"hips", 0, true}, {"hips", 0, true}},
         {"mage_texture"},
         {},
         {},
         {}}};
    return all;
}

using NearColoursOf = ::testing::TestWithParam<Made>;

TEST_P(NearColoursOf, AMakerStayNearTheFileAndPeopleStayPeople)
{
    const Made &maker = GetParam();
    const model::Model model = model_of(maker.paints, maker.pieces);
    for (uint32_t zone = 0; zone < model.zones.size(); ++zone)
        EXPECT_LT(apart(mean_drawn(model, zone), own_colour(model, zone)), 0.15) << model.zones[zone].name;
    for (uint64_t i = 0; i < individuals; ++i) {
        for (const std::string &skin : maker.skins) {
            const Drawn one = drawn(model, zone_of(model, skin), i);
            EXPECT_LT(apart(one, drawn(model, zone_of(model, maker.skins[0]), i)), 0.005) << skin << " " << i;
            EXPECT_LT(apart(one, own_colour(model, zone_of(model, skin))), 0.2) << skin << " " << i;
        }
        for (const std::string &hair : maker.hair)
            EXPECT_TRUE(is_hair_of_people(drawn(model, zone_of(model, hair), i))) << hair << " " << i;
        for (const std::string &kept : maker.kept)
            EXPECT_LT(off(model, zone_of(model, kept), i), 0.002) << kept << " " << i;
    }
    const auto reach = [&](const std::string &material) {
        double sum = 0;
        for (uint64_t i = 0; i < individuals; ++i) sum += off(model, zone_of(model, material), i);
        return sum / double(individuals);
    };
    for (const std::string &skin : maker.skins) EXPECT_GT(reach(skin), 0.01) << skin;
    for (const std::string &cloth : maker.cloth) EXPECT_GT(reach(cloth), reach(maker.skins[0])) << cloth;
}

void PrintTo(const Made &made, std::ostream *out) { *out << made.name; }

INSTANTIATE_TEST_SUITE_P(Each, NearColoursOf, ::testing::ValuesIn(makers()),
                         [](const auto &info) { return info.param.name; });

void expect_near_own(const model::Model &model, double limit)
{
    for (uint32_t zone = 0; zone < model.zones.size(); ++zone)
        for (uint64_t i = 0; i < individuals; ++i) EXPECT_LT(off(model, zone, i), limit) << zone << " " << i;
}

TEST(NearColours, StayWhereTwoSkinsHaveTwoColours)
{
    const model::Model model =
        model_of({{"Skin", {0.62, 0.42, 0.24}}, {"Skin_Dark", {0.3, 0.17, 0.1}}}, {{"head", 0}, {"hand", 1}});
    expect_near_own(model, 0.002);
}

TEST(NearColours, OfSkinAndHairThatAreNoHumansStayNearThem)
{
    const model::Model model =
        model_of({{"Skin", {0.02, 0.02, 0.02}}, {"Hair", {0.25, 0.06, 0.14}}}, {{"head", 0}, {"hand", 0}, {"head", 1}});
    expect_near_own(model, 0.15);
}

TEST(NearColours, OfClothLikeSkinAreThoseOfCloth)
{
    model::Model model = model_of({{"Material", {0.7, 0.4, 0.26}}, {"Material.001", {0.68, 0.4, 0.25}}},
                                  {{"hand", 0}, {"hips", 1}, {"head", 0}});
    EXPECT_NE(zone_of(model, "Material"), zone_of(model, "Material.001"));
}

TEST(NearColours, GiveWayToWildOnesWhereThoseAreAskedFor)
{
    asset::LoadOptions options;
    options.colours = asset::Colours::wild;
    const model::Model model = model_of(makers()[0].paints, makers()[0].pieces, options);
    ASSERT_EQ(model.zones.size(), makers()[0].paints.size()) << "each material has its zone";
    const auto ends = [](const model::HsbRange &r) {
        return std::array<float, 4>{r.hue_min_deg, r.hue_max_deg, r.saturation_max, r.brightness_min};
    };
    for (const auto &zone : model.zones)
        EXPECT_EQ(ends(zone.range), ends(asset::default_range(zone.name, zone.colour, asset::Texturing::textured)));
}

TEST(NearColours, GiveWayToTheFilesOwnWhereThoseAreAskedFor)
{
    asset::LoadOptions options;
    options.colours = asset::Colours::own;
    for (const Made &maker : makers()) expect_near_own(model_of(maker.paints, maker.pieces, options), 0.002);
}

// The skin of an atlas is known by its colour on the hands, and the rest stays near its own.
TEST(NearColours, OfZonesThatAMapGivesAnAtlasFollowItsTexels)
{
    const std::vector<uint16_t> halves = {0, 1};
    const std::vector<asset::ZoneMapZone> zones = {{"zone 1", true, nullptr}, {"zone 2", true, nullptr}};
    for (const asset::Colours colours : {asset::Colours::near, asset::Colours::wild, asset::Colours::own}) {
        model::Model model = model_of({{"mage_texture", {1, 1, 1}, {tan, blue}}},
                                      {{"head", 0}, {"hand", 0}, {"hips", 0, true}, {"hips", 0, true}});
        asset::set_zone_map(model, 0, {2, 1, halves.data()}, zones, colours);
        double skin = 0, cloth = 0;
        for (uint64_t i = 0; i < individuals; ++i) {
            skin = std::max(skin, off(model, 0, i)), cloth = std::max(cloth, off(model, 1, i));
        }
        EXPECT_EQ(skin < 0.2, colours != asset::Colours::wild) << skin;
        EXPECT_EQ(cloth < 0.3, colours != asset::Colours::wild) << cloth;
        EXPECT_EQ(skin + cloth < 0.004, colours == asset::Colours::own) << skin << " " << cloth;
    }
}

}  // namespace
}  // namespace claque::testing

// The collected humanoids in the colours of 64 individuals each: no green hair, no hands of another colour than the
// face, eyes and metal as in the file.
#include <gtest/gtest.h>

#include "assets.h"
#include "lib/asset/decoders.h"
#include "near_colours.h"

namespace claque::testing
{
namespace
{

struct Humanoid {
    std::string file;
    std::vector<std::string> skins, hair, kept;  // materials
};

const std::vector<Humanoid> humanoids = {
    {"humanoids/gdquest/gdbot.glb", {}, {}, {"Glass"}},
    {"humanoids/kaykit/Barbarian.glb", {"barbarian_texture"}, {}, {}},
    {"humanoids/kaykit/Mage.glb", {"mage_texture"}, {}, {}},
    {"humanoids/kaykit/Rogue.glb", {"rogue_texture"}, {}, {}},
    {"humanoids/kenney/character.glb", {"colormap"}, {}, {}},
    {"humanoids/khronos/CesiumMan.glb", {}, {}, {}},
    {"humanoids/khronos/RiggedFigure.glb", {}, {}, {}},
    {"humanoids/quaternius-fbx/CyberCharacter.glb", {}, {}, {}},
    {"humanoids/quaternius-fbx/PlatformerCharacter.glb", {"Main_Light"}, {}, {"EyeColor"}},
    {"humanoids/quaternius-modular/Man_Suit.glb", {"Skin"}, {"Hair", "Eyebrows"}, {"Eye"}},
    {"humanoids/quaternius-modular/Woman_Formal.glb", {"Skin"}, {"Brown"}, {"Gold"}},
    {"humanoids/quaternius-ultimate/Casual2_Female.gltf", {"Skin"}, {"Hair"}, {}},
    {"humanoids/quaternius-ultimate/Casual3_Male.gltf", {"Skin"}, {"Hair"}, {}},
    {"humanoids/quaternius-ultimate/Casual_Male.gltf", {"Skin"}, {"Hair"}, {}},
    {"humanoids/quaternius-ultimate/Kimono_Female.gltf", {"Skin"}, {}, {}},  // hair of the colour of plums
    {"humanoids/quaternius-ultimate/OldClassy_Male.gltf", {"Skin"}, {"Hair"}, {}},
    {"humanoids/quaternius-ultimate/Suit_Female.gltf", {"Skin"}, {"Hair"}, {}},
    {"hipoly/Man_King.glb", {"Skin"}, {"Hair_White"}, {"Eye", "Metal", "Metal_Dark", "Gold"}},
    {"hipoly/mannequiny.glb", {}, {}, {}},
    {"compressed/Casual_Male-draco.gltf", {"Skin"}, {"Hair"}, {}},
    {"compressed/CesiumMan-Draco/CesiumMan.gltf", {}, {}, {}},
    {"compressed/valid-Asian_F_1_Busi.glb", {"_Body"}, {}, {}},
    {"conformance-real/yuka-soldier.glb", {}, {}, {}},
};

class NearColoursOfCollected : public ::testing::TestWithParam<Humanoid>
{
};

TEST_P(NearColoursOfCollected, PeopleStayNearTheirFiles)
{
    CLAQUE_NEEDS_ASSETS();
    const Humanoid &humanoid = GetParam();
    if (!std::filesystem::exists(path_of(humanoid.file))) GTEST_SKIP() << "no " << path_of(humanoid.file);
    model::Model model;
    try {
        model = load(read_asset(humanoid.file), options_for(humanoid.file));
    } catch (const base::Error &error) {
        if (error.status() != CLQ_UNSUPPORTED) throw;
        GTEST_SKIP() << error.what();  // a decoder that this build lacks
    }
    const auto zone_of = [&](const std::string &name) {
        for (const model::Material &material : model.materials)
            if (material.name == name) return material.zone;
        ADD_FAILURE() << "no material " << name;
        return 0u;
    };
    for (uint32_t zone = 0; zone < model.zones.size(); ++zone) {
        EXPECT_LT(apart(mean_drawn(model, zone), own_colour(model, zone)), 0.15) << model.zones[zone].name;
        for (uint64_t i = 0; i < individuals; ++i)
            EXPECT_LT(apart(drawn(model, zone, i), own_colour(model, zone)), 0.3) << model.zones[zone].name << " " << i;
    }
    for (uint64_t i = 0; i < individuals; ++i) {
        for (const std::string &skin : humanoid.skins)
            EXPECT_LT(apart(drawn(model, zone_of(skin), i), own_colour(model, zone_of(skin))), 0.2) << skin << " " << i;
        for (const std::string &hair : humanoid.hair)
            EXPECT_TRUE(is_hair_of_people(drawn(model, zone_of(hair), i))) << hair << " " << i;
        for (const std::string &kept : humanoid.kept)
            EXPECT_LT(apart(drawn(model, zone_of(kept), i), own_colour(model, zone_of(kept))), 0.002)
                << kept << " " << i;
    }
}

void PrintTo(const Humanoid &humanoid, std::ostream *out) { *out << humanoid.file; }

INSTANTIATE_TEST_SUITE_P(Each, NearColoursOfCollected, ::testing::ValuesIn(humanoids), [](const auto &info) {
    std::string name;
    for (const char c : info.param.file) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
});

}  // namespace
}  // namespace claque::testing

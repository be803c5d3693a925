// The law of zones on collected and written characters, posed within a clip.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "lib/asset/gltf.h"
#include "tests/gl/support/law_fixture.h"
#include "tests/gl/support/split.h"
#include "tests/support/written_characters.h"

namespace gltest
{
namespace
{

using CharactersLaw = LawTest;
class AllCharactersLaw : public LawTest
{
};

model::Model load(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    claque::asset::LoadOptions options;
    options.base_folder = path.substr(0, path.rfind('/'));
    // Alternatives that a hand holds all at once, their faces in one plane.
    options.hidden_nodes = {"Knife_Offhand", "1H_Crossbow", "2H_Crossbow", "Throwable", "Spellbook_open", "1H_Wand"};
    return claque::asset::load_gltf(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size(), options);
}

// Zones of these files are materials, so that no triangle has two. Here their images are bands and squares of zones
// instead, which charts, seams and triangles cut across as they come.
void rezone(model::Model &character, uint32_t zone_count)
{
    const ZoneMap map = torture_map(256, zone_count, 5);
    model::Image image;
    image.width = image.height = map.side;
    image.alpha = model::AlphaMeaning::zone_keys;
    for (const uint16_t zone : map.zones) image.rgba.insert(image.rgba.end(), {255, 255, 255, uint8_t(3 * zone)});
    character.images.assign(1, image);
    character.zones.clear();
    for (uint32_t i = 0; i < zone_count; ++i) {
        model::Zone zone;
        zone.name = "zone " + std::to_string(i);
        zone.key = static_cast<uint8_t>(3 * i);
        character.zones.push_back(zone);
    }
    for (model::Material &material : character.materials) {
        material.image = 0;
        material.zone = model::none;
        material.alpha_mode = model::AlphaMode::opaque;
    }
}

// In the midst of its first clip.
PosedModel posed_of(const model::Model &character)
{
    const bool still = character.rig.clips.empty();
    return split_posed(character, still ? model::none : 0, still ? 0 : character.rig.clips[0].start_s + 0.3);
}

const std::string folder = CLAQUE_ASSETS_DIR "/";
bool has_assets() { return bool(std::ifstream(folder + "inventory.json")); }

std::vector<std::string> characters()
{
    namespace fs = std::filesystem;
    std::vector<std::string> paths;
    for (const char *kind : {"humanoids", "animals", "machines"})
        for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder + kind))
            if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
                paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

TEST_P(AllCharactersLaw, HoldsOnRealCharacters)
{
    if (!has_assets()) GTEST_SKIP() << "no assets in " << folder;
    verdict_.most_ties_share = 1e-5;
    const std::vector<std::string> paths = characters();
    EXPECT_GT(paths.size(), 20u);
    for (const std::string &path : paths) {
        SCOPED_TRACE(path);
        const model::Model character = load(path);
        hold(posed_of(character), character);
    }
}

TEST_P(CharactersLaw, HoldsOnRealCharactersWithZonesAcrossTheirTriangles)
{
    if (!has_assets()) GTEST_SKIP() << "no assets in " << folder;
    verdict_.most_ties_share = 1e-5;
    for (const char *name :
         {"humanoids/kaykit/Mage.glb", "humanoids/kenney/character.glb", "humanoids/khronos/CesiumMan.glb",
          "animals/khronos/Fox.glb", "machines/khronos/CesiumMilkTruck.glb", "machines/quaternius/Leela.glb"}) {
        SCOPED_TRACE(name);
        model::Model character = load(folder + name);
        rezone(character, 10);
        const PosedModel posed = posed_of(character);
        EXPECT_GT(posed.tmpl->report.dirty, 50u);
        hold(posed, character);
    }
}

class WrittenCharactersLaw : public LawTest
{
};

TEST_P(WrittenCharactersLaw, Holds)
{
    verdict_.most_ties_share = 1e-5;
    for (const std::string &name : written::characters()) {
        SCOPED_TRACE(name);
        const model::Model character = load(written::folder() + name);
        hold(posed_of(character), character);
    }
}

TEST_P(WrittenCharactersLaw, HoldsWithZonesAcrossTheirTriangles)
{
    verdict_.most_ties_share = 1e-5;
    for (const std::string &name : written::people()) {
        SCOPED_TRACE(name);
        model::Model character = load(written::folder() + name);
        rezone(character, 10);
        const PosedModel posed = posed_of(character);
        EXPECT_GT(posed.tmpl->report.dirty, 50u);
        hold(posed, character);
    }
}

INSTANTIATE_TEST_SUITE_P(On, WrittenCharactersLaw, testing::ValuesIn(targets()), name_of_target);
INSTANTIATE_TEST_SUITE_P(On, AllCharactersLaw, testing::ValuesIn(targets_here(1)), name_of_target);
INSTANTIATE_TEST_SUITE_P(On, CharactersLaw, testing::ValuesIn(targets()), name_of_target);

}  // namespace
}  // namespace gltest

// Levels of detail of the written people, and of the collected characters, where they are: a few of them, or all with
// CLAQUE_ALL_CHARACTERS set.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "lib/asset/file.h"
#include "lib/asset/gltf.h"
#include "lib/lod/chain.h"
#include "lib/lod/surface/area_fractions.h"
#include "tests/support/written_characters.h"

namespace claque::test
{

namespace
{

namespace fs = std::filesystem;

std::vector<std::string> characters()
{
    if (!std::getenv("CLAQUE_ALL_CHARACTERS"))
        return {"humanoids/kaykit/Rogue.glb", "humanoids/quaternius-modular/Man_Suit.glb",
                "humanoids/khronos/CesiumMan.glb", "humanoids/kenney/character.glb",
                "animals/quaternius/Stegosaurus.glb"};
    std::vector<std::string> found;
    if (!fs::exists(CLAQUE_ASSETS_DIR "/inventory.json")) return found;
    for (const char *kind : {"humanoids", "animals", "machines"})
        for (const fs::directory_entry &entry :
             fs::recursive_directory_iterator(CLAQUE_ASSETS_DIR "/" + std::string(kind)))
            if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
                found.push_back(fs::relative(entry.path(), CLAQUE_ASSETS_DIR).string());
    std::sort(found.begin(), found.end());
    return found;
}

model::Model loaded(const std::string &name)
{
    const std::string path = written::path_of(name, CLAQUE_ASSETS_DIR);
    asset::LoadOptions options;
    options.base_folder = fs::path(path).parent_path().string();
    const std::vector<uint8_t> bytes = asset::read_file(path, 1u << 30);
    return asset::load_gltf(bytes.data(), bytes.size(), options);
}

std::vector<const model::Part *> shown_at(const model::Model &model, double distance_m)
{
    std::vector<const model::Part *> shown;
    for (const model::Part &part : model.parts)
        if (!part.hidden && double(part.lod_min_m) <= distance_m && distance_m < double(part.lod_max_m))
            shown.push_back(&part);
    return shown;
}

}  // namespace

std::string name_of(const testing::TestParamInfo<std::string> &character)
{
    std::string name = fs::path(character.param).stem().string();
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

class LevelsOfCharacters : public testing::TestWithParam<std::string>
{
};

TEST_P(LevelsOfCharacters, GoDownToAFewDozenTrianglesWithoutGapsAndKeepTheirZones)
{
    if (!written::is_written(GetParam()) && !fs::exists(CLAQUE_ASSETS_DIR "/inventory.json"))
        GTEST_SKIP() << "no characters in " CLAQUE_ASSETS_DIR;
    model::Model model = loaded(GetParam());
    lod::ChainOptions options;
    options.sampling.max_clips = 0;
    const std::vector<double> wanted = lod::zone_area_fractions(model, shown_at(model, 0));
    const std::vector<lod::LevelReport> chain = lod::make_chain(model, options);
    std::string reached;
    for (size_t k = 0; k < chain.size(); ++k) {
        reached += ' ' + std::to_string(chain[k].triangles);
        EXPECT_EQ(chain[k].flipped, 0u);
        EXPECT_EQ(chain[k].deviation.open_edges, 0u);
        if (k > 0 && chain[k - 1].triangles <= 1100) {
            EXPECT_GE(chain[k].triangles * 3, chain[k - 1].triangles) << reached;
        } else if (k > 0) {
            // What is hidden goes first, and with it half of a character of many layers.
            EXPECT_GE(chain[k].triangles * 4, chain[k - 1].triangles) << reached;
        }
        EXPECT_LE(chain[k].zone_area_error, chain[k].triangles < 20 ? 0.12 : 0.02) << chain[k].triangles;
        const double within = k + 1 < chain.size() ? 0.5 * (chain[k].distance_m + chain[k + 1].distance_m) : 1e30;
        const double least = chain[k].triangles < 20 ? std::max(0.01, chain[k].zone_area_error) : 0.01;
        EXPECT_FALSE(lod::loses_zone(wanted, lod::zone_area_fractions(model, shown_at(model, within)), least))
            << "a zone of at least " << least << " of the surface is lost at " << chain[k].triangles;
    }
    std::cout << GetParam() << reached << '\n';
    EXPECT_LE(chain.back().triangles, 30u);
}

INSTANTIATE_TEST_SUITE_P(Collected, LevelsOfCharacters, testing::ValuesIn(characters()), name_of);
INSTANTIATE_TEST_SUITE_P(Written, LevelsOfCharacters, testing::ValuesIn(written::people()), name_of);

}  // namespace claque::test

// The law of zones at every level of detail of collected characters, where they are, and of written people.
#include <fstream>

#include "lib/asset/gltf.h"
#include "tests/gl/support/levels.h"
#include "tests/support/written_characters.h"

namespace gltest
{
namespace
{

const std::string levels_folder = CLAQUE_ASSETS_DIR "/";

class LevelsOfCharacters : public LevelsTest, public testing::WithParamInterface<std::string>
{
};

model::Model load_character(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    claque::asset::LoadOptions options;
    options.base_folder = path.substr(0, path.rfind('/'));
    return claque::asset::load_gltf(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size(), options);
}

std::string name_of_character(const testing::TestParamInfo<std::string> &one)
{
    std::string name = one.param;
    for (char &c : name)
        if (!isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

TEST_P(LevelsOfCharacters, HoldTheLawOfZones)
{
    const bool is_written = written::is_written(GetParam());
    if (!is_written && !std::ifstream(levels_folder + "inventory.json"))
        GTEST_SKIP() << "no assets in " << levels_folder;
    const std::string path = written::path_of(GetParam(), levels_folder);
    // By turns in each context and format.
    const std::vector<Target> all = targets_here();
    const Target &target = all[std::hash<std::string>()(GetParam()) % all.size()];
    const uint32_t cameras = hold(target, load_character(path), 256, 4);
    if (IsSkipped()) return;
    EXPECT_GE(cameras, is_written ? 12u : 20u);
}

INSTANTIATE_TEST_SUITE_P(Are, LevelsOfCharacters,
                         testing::Values("humanoids/quaternius-ultimate/Casual_Male.gltf",
                                         "humanoids/quaternius-fbx/PlatformerCharacter.glb",
                                         "humanoids/khronos/CesiumMan.glb", "animals/quaternius/Horse.glb",
                                         "animals/khronos/Fox.glb"),
                         name_of_character);
INSTANTIATE_TEST_SUITE_P(Written, LevelsOfCharacters, testing::ValuesIn(written::people()), name_of_character);

}  // namespace
}  // namespace gltest

// The law of zones at every level of detail of real characters, where they are.
#include "lib/asset/gltf.h"
#include "tests/gl/support/levels.h"

#include <fstream>

namespace gltest
{
namespace
{

const std::string levels_folder = CLAQUE_ASSETS_DIR "/";

class LevelsOfCharacters : public LevelsTest, public testing::WithParamInterface<const char *>
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

TEST_P(LevelsOfCharacters, HoldTheLawOfZones)
{
    if (!std::ifstream(levels_folder + "inventory.json")) GTEST_SKIP() << "no assets in " << levels_folder;
    EXPECT_GE(hold(load_character(levels_folder + GetParam()), 256, 4), 20u);
}

INSTANTIATE_TEST_SUITE_P(Are, LevelsOfCharacters,
                         testing::Values("humanoids/quaternius-ultimate/Casual_Male.gltf",
                                         "humanoids/quaternius-fbx/PlatformerCharacter.glb",
                                         "humanoids/khronos/CesiumMan.glb", "animals/quaternius/Horse.glb",
                                         "animals/khronos/Fox.glb"),
                         [](const auto &one) {
                             std::string name = one.param;
                             for (char &c : name)
                                 if (!isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

}  // namespace
}  // namespace gltest

// The law of zones on real characters, posed within a clip.
#include "lib/asset/gltf.h"
#include "tests/gl/support/law_fixture.h"
#include "tests/gl/support/split.h"

#include <fstream>

namespace gltest
{
namespace
{

using CharactersLaw = LawTest;

model::Model load(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    claque::asset::LoadOptions options;
    options.base_folder = path.substr(0, path.rfind('/'));
    return claque::asset::load_gltf(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size(), options);
}

TEST_P(CharactersLaw, HoldsOnRealCharacters)
{
    const std::string folder = CLAQUE_ASSETS_DIR "/";
    if (!std::ifstream(folder + "inventory.json")) GTEST_SKIP() << "no assets in " << folder;
    most_ties_share_ = 1e-5;
    for (const char *name :
         {"humanoids/kaykit/Mage.glb", "humanoids/kaykit/Barbarian.glb",
          "humanoids/quaternius-modular/Woman_Formal.glb", "humanoids/quaternius-ultimate/Kimono_Female.gltf",
          "humanoids/kenney/character.glb", "humanoids/khronos/CesiumMan.glb", "animals/quaternius/Horse.glb",
          "machines/quaternius/George.glb"}) {
        SCOPED_TRACE(name);
        const model::Model model = load(folder + name);
        const bool still = model.rig.clips.empty();
        hold(split_figure(model, still ? model::none : 0, still ? 0 : model.rig.clips[0].start_s + 0.3));
    }
}

INSTANTIATE_TEST_SUITE_P(On, CharactersLaw, testing::ValuesIn(two_targets), name_of_target);

}  // namespace
}  // namespace gltest

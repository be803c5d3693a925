// The collection of old files: what Assimp reads is converted and moves as Assimp's scene does.
#include "tests/convert/old_files.h"

#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/collected_file.h"

namespace convert_test
{
namespace
{

const std::string folder = CLAQUE_ASSETS_DIR "/old/";

struct Row {
    const char *file;
    size_t joints, clips;  // at least so many nodes and exactly so many clips
};

constexpr Row readable[] = {{"collada/astro_maya/astro_maya.dae", 24, 1},
                            {"collada/box_nested_animation/box_nested_animation.dae", 1, 1},
                            {"fbx/arnaud/arnaud.fbx", 53, 0},
                            {"fbx/arnaud/walk.fbx", 66, 1},
                            {"fbx/animation_with_skeleton/animation_with_skeleton.fbx", 13, 1},
                            {"fbx/spider/spider.fbx", 0, 0},
                            {"fbx/cubes_with_names/cubes_with_names.fbx", 0, 0},
                            {"x/anim_test/anim_test.x", 2, 1},
                            {"x/Testwuson/Testwuson.X", 37, 3},
                            {"x/test_cube_binary/test_cube_binary.x", 1, 0},
                            {"3ds/test1/test1.3ds", 0, 0},
                            {"3ds/RotatingCube/RotatingCube.3DS", 0, 1},
                            {"obj/spider/spider.obj", 0, 0},
                            {"ogre-xml/ninja/ninja.mesh.xml", 28, 20},
                            {"b3d/ninja/ninja.b3d", 28, 1},
                            {"ms3d/jeep1/jeep1.ms3d", 0, 0},
                            {"smd/holy_grailref/holy_grailref.smd", 1, 1},
                            {"iqm/guy/guy.iqm", 0, 0},
                            {"md2/sydney/sydney.md2", 0, 0},
                            {"md5/SimpleCube/SimpleCube.md5mesh", 3, 0},
                            {"md5/BoarMan/BoarMan.md5mesh", 1, 0},
                            {"mdl-hl1/man/man.mdl", 8, 6},
                            {"ase/MotionCaptureROM/MotionCaptureROM.ase", 23, 1},
                            {"lwo/hierarchy/hierarchy.lwo", 4, 0}};

struct Refused {
    const char *file, *word;
};
constexpr Refused refused[] = {{"collada/library_animation_clips/library_animation_clips.dae", "real number"},
                               {"iqm/guy/guyanim.iqm", "neither triangles nor clips"},
                               {"egg/panda/panda-model.egg", "neither triangles nor clips"},
                               {"cal3d/cally/cally.cfg", "No suitable reader"}};

class OldFiles : public testing::TestWithParam<Row>
{
};

TEST_P(OldFiles, MoveAsTheyDoInAssimpsScene)
{
    CLAQUE_NEEDS_FILE(folder);
    const Row &row = GetParam();
    Both both(folder + row.file);
    EXPECT_GE(both.info().node_count, row.joints);
    EXPECT_EQ(both.info().clip_count, row.clips);
    EXPECT_EQ(expect_same_poses(both, row.file), 1 + 5 * row.clips);
}

std::string name_of(const testing::TestParamInfo<Row> &info)
{
    std::string name = info.param.file;
    name = name.substr(0, name.find('/')) + name.substr(name.find_last_of('/'));
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Assets, OldFiles, testing::ValuesIn(readable), name_of);

TEST(OldFilesThatAssimpCannotRead, AreRefusedByName)
{
    CLAQUE_NEEDS_FILE(folder);
    for (const Refused &row : refused) {
        try {
            convert::convert_file(folder + row.file, {}, {});
            ADD_FAILURE() << row.file << " was converted";
        } catch (const scenes::Failure &failure) {
            const std::string text = failure.what();
            EXPECT_NE(text.find(row.file), std::string::npos) << text;
            EXPECT_NE(text.find(row.word), std::string::npos) << text;
        }
    }
}

float height_of(const std::string &file, const convert::Options &options)
{
    const auto context = new_context();
    const auto asset = read_glb(context.get(), convert::convert_file(folder + file, options, {}).glb);
    clq_asset_info info = clq_asset_info_init();
    scenes::check(clq_asset_get_info(asset.get(), &info));
    return info.box_max[1] - info.box_min[1];
}

TEST(OldFilesOfPeople, StandUprightInMetres)
{
    CLAQUE_NEEDS_FILE(folder);
    convert::Options high, turned;
    high.height_m = 1.8;
    turned.up = 'z';
    EXPECT_NEAR(height_of("fbx/arnaud/arnaud.fbx", {}), 1.83f, 0.01f) << "centimetres, as FBX says";
    EXPECT_NEAR(height_of("ogre-xml/ninja/ninja.mesh.xml", {}), 191.65f, 0.5f) << "the format does not say";
    EXPECT_NEAR(height_of("ogre-xml/ninja/ninja.mesh.xml", high), 1.8f, 1e-4f);
    EXPECT_NEAR(height_of("smd/holy_grailref/holy_grailref.smd", turned), 23.3f, 0.1f) << "z is up";
}

// Whose bones Assimp lists side by side.
TEST(OldFilesOfPeople, OfHalfLifeStandAndHaveClipsOfTheirOwnNames)
{
    CLAQUE_NEEDS_FILE(folder);
    const auto context = new_context();
    const auto asset = read_glb(context.get(), convert::convert_file(folder + "mdl-hl1/man/man.mdl", {}, {}).glb);
    clq_asset_info info = clq_asset_info_init();
    scenes::check(clq_asset_get_info(asset.get(), &info));
    const float wide = std::max(info.box_max[0] - info.box_min[0], info.box_max[2] - info.box_min[2]);
    EXPECT_GT(info.box_max[1] - info.box_min[1], 1.8f * wide);
    std::set<std::string> names;
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_asset_get_clip(asset.get(), i, &clip));
        names.insert(clip.name);
    }
    EXPECT_EQ(names.size(), 6u);
    EXPECT_EQ(names.count("arms_up.4"), 1u);
}

TEST(OldFilesPictures, AreFoundWhateverTheirPathAndCase)
{
    CLAQUE_NEEDS_FILE(folder);
    const struct {
        const char *file;
        uint32_t images;
        size_t warnings;
    } rows[] = {{"fbx/spider/spider.fbx", 4, 0}, {"obj/spider/spider.obj", 4, 0},
                {"3ds/test1/test1.3ds", 3, 0},   {"smd/holy_grailref/holy_grailref.smd", 1, 0},
                {"mdl-hl1/man/man.mdl", 3, 0},   {"collada/astro_maya/astro_maya.dae", 0, 1}};
    const auto context = new_context();
    for (const auto &row : rows) {
        const convert::Converted made = convert::convert_file(folder + row.file, {}, {});
        const auto asset = read_glb(context.get(), made.glb);
        clq_asset_info info = clq_asset_info_init();
        scenes::check(clq_asset_get_info(asset.get(), &info));
        EXPECT_EQ(info.image_count, row.images) << row.file;
        EXPECT_EQ(made.warnings.size(), row.warnings) << row.file << (made.warnings.empty() ? "" : made.warnings[0]);
    }
}

TEST(OldFilesTwice, GiveTheSameBytes)
{
    CLAQUE_NEEDS_FILE(folder);
    for (const char *file : {"ogre-xml/ninja/ninja.mesh.xml", "fbx/arnaud/walk.fbx"})
        EXPECT_EQ(convert::convert_file(folder + file, {}, {}).glb, convert::convert_file(folder + file, {}, {}).glb);
}

}  // namespace
}  // namespace convert_test

// What the files of osgdb_claque (samples/hosts/osg/plugin) say, and how they are refused.
#include <osg/Geode>
#include <osg/ShapeDrawable>

#include "tests/hosts/osg_plugin_fixture.h"

namespace
{

using namespace osg_plugin_test;

class OsgPluginFiles : public OsgPlugin
{
};

std::string refusal(const std::string &text)
{
    const File file("refused.claque", text);
    osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode(file.path(), nullptr, false);
    EXPECT_FALSE(result.validNode()) << text;
    return result.message();
}

TEST_F(OsgPluginFiles, ShowsTheSceneOfAScenario)
{
    const std::filesystem::path folder = testing::TempDir() + "osg_plugin_scenario";
    std::filesystem::create_directories(folder);
    for (const char *name : {"corner.csv", "corner.wkt", "corner.toml"})
        std::filesystem::copy_file(std::string(CLAQUE_SOURCE_DIR "/samples/scenarios/") + name, folder / name,
                                   std::filesystem::copy_options::overwrite_existing);
    std::filesystem::rename(folder / "corner.toml", folder / "crowd.claque");
    const osg::ref_ptr<osg::Node> scenario = read(folder / "crowd.claque");
    std::filesystem::remove_all(folder);
    ASSERT_TRUE(scenario);
    osg::ref_ptr<osg::Geode> box = new osg::Geode;
    box->addDrawable(new osg::ShapeDrawable(new osg::Box({0, 0, 3}, 1)));
    box->getOrCreateStateSet()->setRenderBinDetails(20, "RenderBin");
    root_->addChild(box);
    look_from({0, -22, 6}, {0, 0, 1});
    const std::vector<uint8_t> alone = picture(9);
    root_->insertChild(0, scenario);
    const std::vector<uint8_t> rgb = picture(9), later = picture(10);
    // Sky and ground are all round.
    EXPECT_GT(differing(rgb, alone), rgb.size() / 3 * 9 / 10);
    // People walk on, and the surroundings stay.
    EXPECT_GT(differing(later, rgb), 100u);
    EXPECT_LT(differing(later, rgb), rgb.size() / 3 / 10);
    // The box is as it was.
    root_->removeChild(scenario);
    EXPECT_EQ(picture(9), alone);
}

TEST_F(OsgPluginFiles, RefusesADescriptionByItsLine)
{
    EXPECT_NE(refusal("character = \"citizen\"\ngait = \"hop\"\n")
                  .find("refused.claque:2:8: the person has the gait 'hop': walk or run"),
              std::string::npos)
        << refusal("character = \"citizen\"\ngait = \"hop\"\n");
    EXPECT_NE(refusal("character = \"citizen\"\nturn_deg = 180\n").find("refused.claque:2:12: the person has turn_deg"),
              std::string::npos)
        << refusal("character = \"citizen\"\nturn_deg = 180\n");
    EXPECT_NE(refusal("character = \"citizen\"\nblend = \"opaque\"\n").find("refused.claque:2:9: the person has blend"),
              std::string::npos);
    EXPECT_NE(refusal("character = \"citizen\"\n\nhat = 1\n").find("refused.claque:3"), std::string::npos);
    EXPECT_NE(refusal("character = \"nixie\"\n").find("nixie"), std::string::npos);
    EXPECT_NE(refusal("character = \"citizen\"\n[palette]\nwings = { hue = [0, 9], saturation = [0, 1], "
                      "brightness = [0, 1] }\n")
                  .find("no such zone"),
              std::string::npos);
    EXPECT_NE(refusal("character = \"citizen\"\ncolours = \"none.toml\"\n").find("refused.claque:2"),
              std::string::npos);
    EXPECT_NE(refusal("name = \"nothing\"\n").find("does not say where its people are"), std::string::npos);
    EXPECT_NE(refusal("character = \n").find("refused.claque:1"), std::string::npos);
}

TEST_F(OsgPluginFiles, NamesTheClassesThatAreNearAWrongOne)
{
    const File map("map.toml",
                   "[[classes]]\nname = \"senators\"\ntemplate = \"citizen\"\n[classes.zones]\n"
                   "tunic = { hue = [240, 240], saturation = [1, 1], brightness = [0.8, 0.8] }\n");
    const std::string said =
        refusal("character = \"citizen\"\ncolours = \"" + std::filesystem::path(map.path()).filename().string() +
                "\"\nclass = \"senator\"\n");
    EXPECT_NE(said.find("has no class named senator: 'senators' is near"), std::string::npos) << said;
}

TEST_F(OsgPluginFiles, LoadsNoMechanismThatAScenarioNames)
{
    EXPECT_NE(refusal("name = \"m\"\n[[characters]]\nname = \"h\"\ncharacter = \"herald\"\n[[people]]\nclass = \"h\"\n"
                      "at = [0, 0, 0]\nmechanism = \"./nod.so\"\n")
                  .find("refused.claque:8:13: the mechanism ./nod.so is not loaded"),
              std::string::npos);
}

TEST_F(OsgPluginFiles, ColoursPeopleByPaletteAndByMap)
{
    const File palette("red.claque",
                       "character = \"citizen\"\n[palette]\n"
                       "tunic = { hue = [0, 0], saturation = [1, 1], brightness = [0.8, 0.8] }\n");
    const File map("map.toml",
                   "[[classes]]\nname = \"blue\"\ntemplate = \"citizen\"\n[classes.zones]\n"
                   "tunic = { hue = [240, 240], saturation = [1, 1], brightness = [0.8, 0.8] }\n");
    const File mapped("blue.claque", "character = \"citizen\"\ncolours = \"" +
                                         std::filesystem::path(map.path()).filename().string() +
                                         "\"\nclass = \"blue\"\n");
    stand(*read(palette.path()), {-1.5, 0, 0});
    stand(*read(mapped.path()), {1.5, 0, 0});
    look_from({0, -5, 1}, {0, 0, 0.9});
    const std::vector<uint8_t> rgb = picture(0);
    const auto pure = [&](int x0, int x1, int channel) {
        const std::vector<uint8_t> pixels = people_in(rgb, x0, x1);
        size_t count = 0;
        for (size_t i = 0; i < pixels.size(); i += 3)
            count += pixels[i + static_cast<size_t>(channel)] > 60 && pixels[i + 1] < 12 &&
                     pixels[i + static_cast<size_t>(2 - channel)] < 12;
        return count;
    };
    EXPECT_GT(pure(0, side_px / 2, 0), 200u);
    EXPECT_GT(pure(side_px / 2, side_px, 2), 200u);
    EXPECT_EQ(pure(0, side_px / 2, 2) + pure(side_px / 2, side_px, 0), 0u);
}

}  // namespace

// claque labels: folders that appear whole, go on where they stopped, and refuse what they cannot write.
#include <fstream>
#include <map>
#include <sstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

class LabelsCommand : public Drawing
{
protected:
    Outcome label(const std::string &folder, std::vector<std::string> more) const
    {
        std::vector<std::string> all = {"labels", "--scene", "plaza",      "--count", "6", "--size",
                                        "64x48",  "--out",   path(folder), "--fps",   "10"};
        all.insert(all.end(), more.begin(), more.end());
        return claque(all);
    }
    std::map<std::string, std::string> contents(const std::string &folder) const
    {
        std::map<std::string, std::string> out;
        for (const auto &entry : fs::recursive_directory_iterator(path(folder)))
            if (entry.is_regular_file()) {
                std::ifstream file(entry.path(), std::ios::binary);
                std::ostringstream bytes;
                bytes << file.rdbuf();
                out[fs::relative(entry.path(), path(folder)).string()] = bytes.str();
            }
        return out;
    }
};

const char *const all_formats = "coco,panoptic,mot,kitti-flow,flo,depth,normals,boxes3d,heads,npz,sheet";

TEST_F(LabelsCommand, WritesTheSameFolderAtOnceAndInParts)
{
    ASSERT_EQ(label("whole", {"--frames", "0:3", "--write", all_formats}).code, 0);
    const auto whole = contents("whole");
    for (const char *file :
         {"coco.json", "panoptic.json", "mot/gt/gt.txt", "boxes3d.json", "heads.json", "cameras.json",
          "images/000003.png", "arrays/000000.npz", "sheets/000002.png", "flow_forward/000001.flo"})
        EXPECT_EQ(whole.count(file), 1u) << file;
    ASSERT_EQ(label("parts", {"--frames", "2:3", "--write", all_formats}).code, 0);
    // A picture that was cut off has no JSON of its own, and is made again.
    fs::remove(path("parts") + "/frames/000003.json");
    std::ofstream(path("parts") + "/images/000003.png") << "cut";
    ASSERT_EQ(label("parts", {"--frames", "0:3", "--write", all_formats}).code, 0);
    EXPECT_TRUE(contents("parts") == whole);
    // Three jobs, and a run that puts their pictures together.
    for (const char *share : {"0/3", "1/3", "2/3"})
        ASSERT_EQ(label("jobs", {"--frames", "0:3", "--write", all_formats, "--chunk", share}).code, 0);
    EXPECT_EQ(contents("jobs").count("coco.json"), 0u);
    ASSERT_EQ(label("jobs", {"--frames", "0:3", "--write", all_formats}).code, 0);
    EXPECT_TRUE(contents("jobs") == whole);
    // One thread or four.
    ASSERT_EQ(label("threads", {"--frames", "0:3", "--write", all_formats, "--threads", "4"}).code, 0);
    EXPECT_TRUE(contents("threads") == whole);
}

TEST_F(LabelsCommand, KeepsFinishedPicturesOfTheSameSettings)
{
    ASSERT_EQ(label("f", {"--frames", "0:1"}).code, 0);
    const fs::file_time_type before = fs::last_write_time(path("f") + "/images/000000.png");
    ASSERT_EQ(label("f", {"--frames", "0:1"}).code, 0);
    EXPECT_EQ(fs::last_write_time(path("f") + "/images/000000.png"), before);
    ASSERT_EQ(label("f", {"--frames", "0:1", "--again"}).code, 0);
    EXPECT_NE(fs::last_write_time(path("f") + "/images/000000.png"), before);
}

TEST_F(LabelsCommand, RefusesToMixLabelsOfDifferentSettingsInAFolder)
{
    ASSERT_EQ(label("f", {"--frames", "0:1"}).code, 0);
    const auto before = contents("f");
    const std::vector<std::pair<std::vector<std::string>, std::string>> others = {
        {{"--hour", "9"}, "/scene/hour is 0.0 there and 9.0 here"},
        {{"--lod", "off"}, "/scene/levels/0 is \"on\" there and \"off\" here"},
        {{"--lod-scale", "2"}, "/scene/levels/1 is 1.0 there and 2.0 here"},
        {{"--seed", "7"}, "/scene/seed is 1 there and 7 here"},
        {{"--write", "mot"}, "/write/0 is \"coco\" there and \"mot\" here"},
        {{"--keypoints", "smpl"}, "/keypoints is \"coco\" there and \"smpl\" here"},
        {{"--flat", "0"}, "/scene/levels/2 is 64 there and 0 here"},
    };
    for (const auto &[options, sentence] : others) {
        std::vector<std::string> all = {"--frames", "0:2"};
        all.insert(all.end(), options.begin(), options.end());
        const Outcome refused = label("f", all);
        EXPECT_EQ(refused.code, 1) << options[0];
        EXPECT_NE(refused.err.find("has labels of other settings: " + sentence), std::string::npos) << refused.err;
    }
    EXPECT_TRUE(contents("f") == before);
    // All anew, if that is said; a picture that was not made anew is not taken for one of these.
    ASSERT_EQ(label("f", {"--frames", "0", "--seed", "7", "--again"}).code, 0);
    const Outcome mixed = label("f", {"--frames", "0:1", "--seed", "7"});
    EXPECT_EQ(mixed.code, 1);
    EXPECT_NE(mixed.err.find("has labels of other settings for frame 1"), std::string::npos) << mixed.err;
}

TEST_F(LabelsCommand, RefusesToGoOnWhereAFileOfTheScenarioHasChanged)
{
    const std::string from = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/corridor";
    for (const char *end : {".toml", ".csv", ".wkt"}) fs::copy_file(from + end, path(std::string("corridor") + end));
    const auto labelled = [&] {
        return claque(
            {"labels", "--scenario", path("corridor.toml"), "--size", "48x36", "--frames", "0:1", "--out", path("f")});
    };
    ASSERT_EQ(labelled().code, 0);
    ASSERT_EQ(labelled().code, 0);
    std::ofstream(path("corridor.csv"), std::ios::app) << "\n";
    const Outcome refused = labelled();
    EXPECT_EQ(refused.code, 1);
    EXPECT_NE(refused.err.find("/scene/scenario_files/"), std::string::npos) << refused.err;
}

TEST_F(LabelsCommand, RefusesFormatsAndFoldersByName)
{
    const Outcome format = label("f", {"--write", "coco,yolo"});
    EXPECT_EQ(format.code, 2);
    EXPECT_NE(format.err.find("no format 'yolo' of labels; there are coco, panoptic, mot"), std::string::npos)
        << format.err;
    std::ofstream(path("file")) << "not a folder";
    const Outcome folder = label("file", {});
    EXPECT_EQ(folder.code, 1);
    EXPECT_NE(folder.err.find("cannot make the folder"), std::string::npos) << folder.err;
    EXPECT_EQ(label("f", {"--frames", "3:1"}).code, 2);
}

}  // namespace
}  // namespace cli_test

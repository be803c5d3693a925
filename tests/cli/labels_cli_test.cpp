// claque labels: folders that appear whole, go on where they stopped, and refuse what they cannot write.
#include <fstream>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

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

TEST_F(LabelsCommand, MakesAnewPicturesOfWhichAFileWasChanged)
{
    const auto make = [&] { return label("f", {"--frames", "0:3", "--write", "coco,npz"}).code; };
    ASSERT_EQ(make(), 0);
    const auto whole = contents("f");
    std::ofstream(path("f") + "/images/000000.png") << "a text";
    fs::remove(path("f") + "/arrays/000001.npz");
    fs::copy_file(path("f") + "/arrays/000003.npz", path("f") + "/arrays/000002.npz",
                  fs::copy_options::overwrite_existing);
    std::string words = file_text(path("f") + "/frames/000003.json");
    const size_t at = words.find("\"visible_px\":") + 13;
    ASSERT_LT(at, words.size());
    words[at] = words[at] == '9' ? '8' : '9';
    std::ofstream(path("f") + "/frames/000003.json") << words;
    ASSERT_EQ(make(), 0);
    EXPECT_TRUE(contents("f") == whole);
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

const char *const some_rules = R"(time_s = [0, 20]
[people]
count = [4, 30]
[camera]
height_m = [1, 4]
distance_m = [2, 9]
[light]
hour = [7, 17]
[haze]
visibility_m = [50, 500]
)";
const char *const a_sensor = R"([sensor]
read_noise = [1, 4]
shot_noise = [0, 5]
)";

class VariedLabels : public LabelsCommand
{
protected:
    void SetUp() override
    {
        LabelsCommand::SetUp();
        std::ofstream(path("rules.toml")) << some_rules;
        std::ofstream(path("sensor.toml")) << some_rules << a_sensor;
    }
    Outcome vary(const std::string &folder, std::vector<std::string> more, const char *rules = "sensor.toml") const
    {
        std::vector<std::string> all = {"labels",     "--scene", "plaza",     "--size", "96x72", "--out",
                                        path(folder), "--vary",  path(rules), "--seed", "5"};
        all.insert(all.end(), more.begin(), more.end());
        return claque(all);
    }
};

TEST_F(VariedLabels, MakeAnySampleAgainAloneByteForByte)
{
    const std::string formats = "coco,panoptic,flo,depth,normals,boxes3d,heads,npz";
    ASSERT_EQ(vary("all", {"--frames", "0:5", "--write", formats}).code, 0);
    const auto all = contents("all");
    std::set<std::string> pictures;
    for (int k = 0; k < 6; ++k) pictures.insert(all.at("images/00000" + std::to_string(k) + ".png"));
    EXPECT_EQ(pictures.size(), 6u);
    ASSERT_EQ(vary("one", {"--frames", "4", "--write", formats, "--threads", "3"}).code, 0);
    size_t same = 0;
    for (const auto &[name, bytes] : contents("one"))
        if (name.find("000004") != std::string::npos) {
            EXPECT_TRUE(bytes == all.at(name)) << name;
            ++same;
        }
    EXPECT_EQ(same, 10u);
}

TEST_F(VariedLabels, OfAScenarioHaveFewerPeopleOfItsClasses)
{
    std::ofstream(path("classes.toml"))
        << "time_s = [0, 50]\n[people]\nclasses = { plebeians = [0, 0.1], patricians = 0 }\n";
    const auto sampled = [&](const char *folder, const char *frames) {
        const Outcome made = claque({"labels", "--scene", "odeon", "--camera", "overview", "--size", "96x72", "--lod",
                                     "off", "--out", path(folder), "--vary", path("classes.toml"), "--frames", frames});
        EXPECT_EQ(made.code, 0) << made.err;
        return contents(folder);
    };
    const auto both = sampled("both", "0:1"), one = sampled("one", "1");
    for (const char *name : {"images/000001.png", "frames/000001.json"}) EXPECT_TRUE(one.at(name) == both.at(name));
    const auto frame = nlohmann::json::parse(one.at("frames/000001.json"));
    std::map<std::string, size_t> people;
    for (const auto &person : frame["people"]) ++people[person["character"]];
    EXPECT_GT(people["decurion"], 20u);
    EXPECT_EQ(people["patrician"], 0u);
    EXPECT_LT(people["plebeian"], 60u);
}

TEST_F(VariedLabels, RecordEveryChoice)
{
    ASSERT_EQ(vary("f", {"--frames", "3"}).code, 0);
    const auto choice = nlohmann::json::parse(contents("f").at("frames/000003.json"))["choice"];
    EXPECT_EQ(choice["seed"], 5);
    EXPECT_EQ(choice["sample"], 3);
    for (const char *key : {"/scene_seed", "/time_s", "/people/count", "/camera/person", "/camera/attempt",
                            "/camera/height_m", "/camera/distance_m", "/camera/heading_deg", "/camera/fov_deg",
                            "/light/hour", "/haze/visibility_m", "/sensor/read_noise", "/sensor/shot_noise"})
        EXPECT_TRUE(choice.contains(nlohmann::json::json_pointer(key))) << key;
    EXPECT_GE(choice["/light/hour"_json_pointer], 7);
    EXPECT_LE(choice["/light/hour"_json_pointer], 17);
}

TEST_F(VariedLabels, HaveTheNoiseOfSensorsInTheirPicturesAlone)
{
    ASSERT_EQ(vary("noisy", {"--frames", "0:1", "--write", "panoptic,depth,flo"}).code, 0);
    ASSERT_EQ(vary("clean", {"--frames", "0:1", "--write", "panoptic,depth,flo"}, "rules.toml").code, 0);
    const auto noisy = contents("noisy"), clean = contents("clean");
    size_t labels = 0;
    for (const auto &[name, bytes] : noisy)
        if (name.rfind("images/", 0) == 0) EXPECT_FALSE(bytes == clean.at(name)) << name;
        else if (name.find('/') != std::string::npos && name.rfind("frames/", 0) != 0) {
            EXPECT_TRUE(bytes == clean.at(name)) << name;
            ++labels;
        }
    EXPECT_EQ(labels, 10u);
}

TEST_F(VariedLabels, RefuseRulesThatASceneCannotFollow)
{
    const auto refused = [&](const std::string &rules, std::vector<std::string> scene, const std::string &sentence) {
        std::ofstream(path("wrong.toml")) << rules;
        std::vector<std::string> all = {"labels",     "--size", "48x36",           "--out",
                                        path("none"), "--vary", path("wrong.toml")};
        all.insert(all.end(), scene.begin(), scene.end());
        const Outcome outcome = claque(all);
        EXPECT_NE(outcome.code, 0) << rules;
        EXPECT_NE(outcome.err.find("wrong.toml:" + sentence), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(path("none"))) << rules;
    };
    const std::string corridor = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/corridor.toml";
    refused("[people]\ncount = 5", {"--scenario", corridor},
            "2:9: the scene 'corridor' says itself how many people there are");
    refused("[people]\nclasses = { senators = 1 }", {"--scene", "odeon"},
            "2:24: the scene 'odeon' has no class 'senators'; there are: decurions, patricians, plebeians");
    refused("[people]\nclasses = { senators = 1 }", {"--scene", "plaza"},
            "2:24: the scene 'plaza' has no class 'senators'; there are none");
    refused("[light]\nsun = 0.5", {"--scene", "vehicle"},
            "2:7: the scene 'vehicle' has light of its own, which no rule changes");
    refused("[light]\nsky = 0.5", {"--scenario", std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/market.toml"},
            "2:7: the scene 'market' has light of its own, which no rule changes");
    refused("[camera]\n", {"--scene", "plaza", "--camera", "close"},
            "1:1: a rule chooses the camera; leave out --camera and --path");
    refused("[camera]\nheight_m = [2, 1]", {"--scene", "plaza"}, "2:12: [camera] has 'height_m' = [2, 1]");
    const Outcome film = vary("none", {"--write", "mot"});
    EXPECT_EQ(film.code, 2);
    EXPECT_NE(film.err.find("mot is about the frames of a film"), std::string::npos) << film.err;
}

TEST_F(VariedLabels, ThatFitNoCameraSaySo)
{
    std::ofstream(path("wrong.toml")) << "[camera]\nfaces_m = 900\n";
    const Outcome outcome = vary("none", {"--frames", "7"}, "wrong.toml");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(
        outcome.err.find("sample 7: none of 100 cameras fits the rules; of the last one a face is nearer than 900 m"),
        std::string::npos)
        << outcome.err;
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

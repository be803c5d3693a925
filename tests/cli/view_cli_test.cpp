// claque view by scripts: films, and files that are dropped on the window.
#include <cstdlib>
#include <fstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

class ViewCommand : public Drawing
{
protected:
    Outcome view(std::vector<std::string> arguments, const std::vector<std::string> &steps) const
    {
        std::ofstream out(path("steps.toml"));
        out << "steps = [\n";
        for (const std::string &step : steps) out << "    '" << step << "',\n";
        out << "]\n";
        out.close();
        arguments.insert(arguments.begin(), "view");
        for (const char *more : {"--size", "640x480", "--script"}) arguments.emplace_back(more);
        arguments.push_back(path("steps.toml"));
        arguments.emplace_back("--shots");
        arguments.push_back(path(""));
        return claque(arguments);
    }
    void write(const std::string &name, const std::string &text) const { std::ofstream(path(name)) << text; }
    std::string drop(const std::string &file) const { return "drop \"" + file + "\""; }
};

TEST_F(ViewCommand, ShowsWhatIsDroppedOnIt)
{
    ASSERT_EQ(claque({"prepare", "citizen", "--out", path("citizen.clq")}).code, 0);
    std::string table = "id,frame,x,y\n";
    for (int frame = 0; frame <= 50; ++frame)
        table += "anna," + std::to_string(frame) + "," + std::to_string(0.12 * frame) + ",1\n";
    write("walk.csv", table);
    const Outcome outcome = view(
        {"--scene", "parade", "--count", "2", "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m"},
        {drop(path("citizen.clq")), "see \"citizen.clq is shown\"", "click person 1", "see \"citizen\"",
         drop(std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/corner.toml"), "see \"corner.toml is shown\"",
         drop(path("walk.csv")), "see \"walk.csv is shown\"", "click \"Camera\"", "click \"Frame\"", "see \"of 1\""});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(ViewCommand, GivesItsPeopleTheColoursThatAreDropped)
{
    const std::string colours = std::string(CLAQUE_SOURCE_DIR) + "/samples/maps/roman-classes.toml";
    const Outcome outcome =
        view({"patrician", "--count", "3"}, {"click \"pause\"", "wait 0.1", "shot own.png", drop(colours),
                                             "see \"roman-classes.toml is shown\"", "wait 0.1", "shot classes.png"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(file_text(path("own.png")), file_text(path("classes.png")));
}

TEST_F(ViewCommand, StaysWithWhatItShowedWhereAFileCannotBeShown)
{
    write("broken.glb", "no character");
    write("picture.png", "no picture");
    const Outcome outcome = view(
        {"--scene", "parade", "--count", "2"},
        {"click person 2", drop(path("broken.glb")), "see \"broken.glb\"", "click person 2", "see \"2, made once\"",
         drop(path("picture.png")), "see \"no character is shown\"", drop(path("absent.toml")), "see \"absent.toml\"",
         "click \"Camera\"", "click \"Person\"", "click \"Frame\"", "see \"of 2\""});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(ViewCommand, RefusesAFolderThatIsNotThereBeforeItOpens)
{
    write("steps.toml", "steps = ['wait 1']\n");
    const Outcome outcome = claque(
        {"view", "--scene", "parade", "--script", path("steps.toml"), "--shots", path("absent"), "--size", "640x480"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find(path("absent")), std::string::npos) << outcome.err;
}

// An encoder that keeps the pixels as they are.
class Films : public ViewCommand
{
protected:
    void SetUp() override
    {
        ViewCommand::SetUp();
        before_ = std::getenv("PATH");
        std::filesystem::create_directory(path("bin"));
        write("bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\nexec /bin/cat > \"$last\"\n");
        std::filesystem::permissions(path("bin/ffmpeg"), std::filesystem::perms::owner_all);
    }
    void TearDown() override { setenv("PATH", before_.c_str(), 1); }

    std::string before_;
};

TEST_F(Films, HaveOneFrameForEachOfTheScriptAndAppearWhole)
{
    setenv("PATH", (path("bin") + ":" + before_).c_str(), 1);
    const Outcome outcome =
        view({"--scene", "parade", "--count", "2"},
             {"key tab", "click \"film\"", "wait 1", "see \"view-1.mp4 is being made\"", "click \"film\"",
              "see \"view-1.mp4 is saved, 30 frames\"", "click \"film\"", "wait 0.2"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string first = file_text(path("view-1.mp4"));
    EXPECT_FALSE(file_text(path("view-2.mp4")).empty()) << "the end of the script ends a film";
    // Each is the picture without the bar of 78 lines.
    EXPECT_EQ(first.size(), 30u * 3 * 640 * (480 - 78));
    for (const std::string &name : left()) EXPECT_EQ(name.find("part"), std::string::npos) << name;
}

TEST_F(Films, NeedFfmpegAndSayWhenItIsAbsentOrFails)
{
    const std::vector<std::string> scene = {"--scene", "parade", "--count", "1"};
    setenv("PATH", path("empty").c_str(), 1);
    Outcome outcome = view(scene, {"click \"film\"", "see \"there is no ffmpeg\"", "wait 0.2"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    setenv("PATH", (path("bin") + ":" + before_).c_str(), 1);
    write("bin/ffmpeg", "#!/bin/sh\nexit 1\n");
    outcome = view(scene, {"click \"film\"", "wait 1", "see \"no film\""});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string &name : left()) EXPECT_EQ(name.find("mp4"), std::string::npos) << name;
}

}  // namespace
}  // namespace cli_test

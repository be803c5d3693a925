// claque view by scripts: films, and files that are dropped on the window.
#include <cstdlib>
#include <fstream>

#include "tests/cli/run.h"
#include "tests/support/written_characters.h"

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

    const std::string samples_ = std::string(CLAQUE_SOURCE_DIR) + "/samples";
    const std::string classes_ = samples_ + "/maps/roman-classes.toml";
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

TEST_F(ViewCommand, GivesItsPeopleTheColoursThatAreDroppedAndLetsThemBeEdited)
{
    const Outcome outcome = view({"patrician", "--count", "3"},
                                 {"click \"pause\"", "wait 0.1", "click \"picture\"", drop(classes_), "wait 0.1",
                                  "see \"roman-classes.toml is worn\"", "see \"1 changes to undo\"",
                                  "click \"picture\"", "click \"undo\"", "wait 0.1", "click \"picture\""});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(file_text(path("view-1.png")), file_text(path("view-2.png")));
    EXPECT_EQ(file_text(path("view-1.png")), file_text(path("view-3.png")));
}

TEST_F(ViewCommand, ShowsWhatItsFilesWouldShowIfTheyWereDropped)
{
    const auto shows = [this](const std::vector<std::string> &arguments, const std::string &text) {
        const Outcome outcome = view(arguments, {"click \"Camera\"", "see \"" + text + "\""});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
    };
    shows({"parade", "--count", "2"}, "Click a person");
    shows({samples_ + "/scenarios/corner.toml"}, "Click a person");
    // A map is worn by whatever is named beside it, in any order.
    shows({classes_, "patrician", "--count", "2"}, "0 changes to undo");
    shows({classes_, "--scene", "parade", "--count", "2"}, "0 changes to undo");
}

// The odeon's own path turns to the stage after some seconds.
TEST_F(ViewCommand, ShowsThePeopleOfASceneThatHasAPathOfItsOwn)
{
    Outcome outcome =
        view({"odeon", "--count", "30"}, {"click person 1", "see \"1, made once\"", "click \"camera: path\"",
                                          "wait 6 2", "wait 0.1", "see \"out of view\""});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // A path that is named is what the window shows first.
    outcome = view({"--scene", "odeon", "--count", "30", "--path", samples_ + "/scenes/odeon/path.toml"},
                   {"wait 6 2", "click person 1"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("person 1 is nowhere"), std::string::npos) << outcome.err;
}

TEST_F(ViewCommand, SaysWhatItsFilesLackOrExclude)
{
    write("picture.png", "no picture");
    write("old.fbx", "Kaydara");
    const auto said = [this](const std::vector<std::string> &arguments, int code) {
        const Outcome outcome = view(arguments, {"wait 0.1"});
        EXPECT_EQ(outcome.code, code) << outcome.err;
        return outcome.err;
    };
    EXPECT_NE(said({path("picture.png")}, 1).find("is a texture, and no character is shown"), std::string::npos);
    EXPECT_NE(said({path("bow.bvh")}, 1).find("is a motion, and no character is shown"), std::string::npos);
    EXPECT_NE(said({"--clips", "bow.bvh"}, 2).find("name one as FILE"), std::string::npos);
    EXPECT_NE(said({path("old.fbx")}, 1).find("claque convert " + path("old.fbx")), std::string::npos);
    const std::string clips = written::folder() + "WrittenClips.glb";
    EXPECT_NE(said({clips}, 1).find("--clips " + clips + " adds them"), std::string::npos);
    EXPECT_NE(said({"--characters", clips}, 1).find("--clips " + clips + " adds them"), std::string::npos);
    EXPECT_NE(said({samples_ + "/scenarios/corner.csv", "--characters", clips, "--columns", "id,frame,x,y", "--rate",
                    "2", "--unit", "m"},
                   1)
                  .find("--clips " + clips + " adds them"),
              std::string::npos);
    EXPECT_NE(said({"--characters", "citizen", "--clips", "bow.bvh"}, 2).find("name one as FILE"), std::string::npos);
    const std::string unknown = said({"plazza"}, 2);
    EXPECT_NE(unknown.find("plazza is no scene (plaza, odeon,"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("no built-in character (citizen,"), std::string::npos) << unknown;
    EXPECT_NE(said({"citizen", "plaza"}, 2).find("'plaza' is one more"), std::string::npos);
    EXPECT_NE(said({"citizen", "--legs", "a,b"}, 2).find("--legs: is for a file of trajectories"),
              std::string::npos);
    EXPECT_NE(said({"citizen", "--colours", "wldi"}, 2).find("'wldi' is no file, and 'wild' is near"),
              std::string::npos);
    EXPECT_NE(said({"citizen", "--scene", "plaza"}, 2).find("'citizen' is one more"), std::string::npos);
}

TEST_F(ViewCommand, PlaysTheMotionsThatAreNamedOrDropped)
{
    write("nod.bvh",
          "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition Zposition Zrotation "
          "Xrotation Yrotation\n  End Site\n  {\n    OFFSET 0 1 0\n  }\n}\nMOTION\nFrames: 3\nFrame Time: "
          "0.5\n0 0 0 0 0 0\n0 0 0 0 40 0\n0 0 0 0 0 0\n");
    write("nod.toml", "[joints]\nHips = \"spine\"\n");
    const std::vector<std::string> sees = {"click person 1", "see \"nod at\"", "click \"Character\"",
                                           "click \"clip: nod\""};
    Outcome outcome = view({path("nod.bvh"), "citizen", "--map", path("nod.toml"), "--count", "1"}, sees);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> dropped = {drop(path("nod.bvh")), "see \"nod.bvh is shown\""};
    dropped.insert(dropped.end(), sees.begin(), sees.end());
    outcome = view({"citizen", "--map", path("nod.toml"), "--count", "1"}, dropped);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // The latest comes first.
    write("bow.bvh", file_text(path("nod.bvh")));
    outcome = view({path("bow.bvh"), "citizen", "--map", path("nod.toml"), "--count", "1"}, dropped);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(ViewCommand, ShowsACharacterOfAnyNameThatIsNamedOrDropped)
{
    const std::string hero = file_text(written::folder() + "WrittenSkins.glb");
    for (const char *name : {"hero.vrm", "hero.download", "hero.txt"}) {
        write(name, hero);
        Outcome outcome = view({path(name), "--count", "1"}, {"click person 1", "see \"made once\""});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        outcome = view({"citizen", "--count", "1"}, {drop(path(name)), std::string("see \"") + name + " is shown\""});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
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
    EXPECT_NE(outcome.err.find("there is no folder " + path("absent")), std::string::npos) << outcome.err;
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

// Half an hour of people who test characters, in seconds: their scripts are played at a frame every two seconds.
#include <filesystem>

#include "samples/io/files.h"
#include "samples/view/ground/save.h"
#include "tests/support/collected_file.h"
#include "tests/view/staged.h"

namespace
{

using view_test::Stage;
using view_test::Staged;

class HalfHours : public Staged
{
protected:
    // Plays a script of samples/view/scripts; returns the scripted time.
    double spend(const std::string &name)
    {
        const std::string path = std::string(CLAQUE_SCRIPTS) + "/" + name;
        std::string text;
        EXPECT_EQ(io::read_whole(path, text), "");
        double spent_s = 0;
        play(view::read_script(text, name), [&](const view::Input &input) { spent_s += input.elapsed_s; });
        return spent_s;
    }
    // What the crowd refused was said in the message, and taken back.
    void expect_roles_performed()
    {
        for (const auto &[index1, role] : session().model().ground.roles)
            EXPECT_LE(role.motion.fades.size(), scenes::roles::most_fades);
        EXPECT_NE(view::scenario_text(session().world(), session().model()).find("[[people]]"), std::string::npos);
    }
};

TEST_F(HalfHours, OfAUserWithACharacter)
{
    Stage stage;
    stage.width = 640, stage.height = 480, stage.count = 3;
    stage.file = std::string(CLAQUE_ASSETS_DIR) + "/humanoids/kaykit/Barbarian.glb";
    CLAQUE_NEEDS_FILE(stage.file);
    open(stage);
    EXPECT_GE(spend("character.toml"), 1800);
    expect_roles_performed();
    EXPECT_TRUE(session().model().ground.treadmill);
    EXPECT_GT(session().model().ground.treadmill->steps, 8u);
    EXPECT_LT(session().model().ground.treadmill->drift_most_mm, 20);
}

TEST_F(HalfHours, OfAnAnimator)
{
    Stage stage;
    stage.width = 640, stage.height = 480, stage.count = 2, stage.character = "herald";
    open(stage);
    EXPECT_GE(spend("animator.toml"), 1800);
    expect_roles_performed();
}

}  // namespace

// Where a person of a file faces: a warning names it with the turn that it needs, and no walker goes backwards because
// of a file.
#include <cmath>
#include <filesystem>
#include <functional>

#include "tests/api/loaded_asset.h"
#include "tests/support/walking_figure.h"
#include "tests/support/written_characters.h"

namespace
{

using claque::testing::FigureTraits;
using claque::testing::walking_figure;
using loaded::Own;

using Break = std::function<void(clq_locomotion_def &)>;

class Facing : public loaded::Loading
{
protected:
    static clq_asset_options turned(double turn_deg)
    {
        clq_asset_options options = clq_asset_options_init();
        options.turn_deg = turn_deg;
        return options;
    }
    std::string warned(const FigureTraits &traits, double turn_deg = 0)
    {
        const Own<clq_asset> asset = load(walking_figure(traits), turned(turn_deg));
        EXPECT_TRUE(asset) << said_;
        return asset ? warnings(asset.get()) : "";
    }
    // What is said of its walk, or "" for one that walks.
    std::string refused(
        const clq_asset *asset, const Break &breaks = [](clq_locomotion_def &) {})
    {
        const Own<clq_template> tmpl = build(asset);
        clq_locomotion_def def = clq_locomotion_def_init();
        def.tmpl = tmpl.get(), def.walk = clq_template_find_clip(tmpl.get(), "Walk");
        breaks(def);
        clq_locomotion *made = nullptr;
        const clq_status status = clq_locomotion_create(context_.get(), &def, &made);
        const std::string said = status == CLQ_OK ? "" : clq_last_error();
        if (made) {
            clq_locomotion_info info = clq_locomotion_info_init();
            EXPECT_EQ(clq_locomotion_get_info(made, &info), CLQ_OK);
            EXPECT_NEAR(double(info.walk_stride), 4 * 0.87 * std::sin(25 * M_PI / 180), 0.2);
        }
        clq_locomotion_destroy(made);
        return said;
    }
    std::string refused(
        const FigureTraits &traits, double turn_deg = 0, const Break &breaks = [](clq_locomotion_def &) {})
    {
        const Own<clq_asset> asset = load(walking_figure(traits), turned(turn_deg));
        EXPECT_TRUE(asset) << said_;
        return asset ? refused(asset.get(), breaks) : "";
    }
};

FigureTraits facing(float heading_deg)
{
    FigureTraits traits;
    traits.heading_deg = heading_deg;
    return traits;
}

TEST_F(Facing, IsNamedByToesElseByEyesElseByLegsWithTheTurnThatItNeeds)
{
    FigureTraits traits = facing(180);
    EXPECT_NE(warned(traits).find("the toes of '' point to -z, and characters face +z: turn_deg 180 (--turn 180) turns "
                                  "it"),
              std::string::npos)
        << warned(traits);
    traits.toes = false, traits.heading_deg = 90;
    EXPECT_NE(warned(traits).find("the eyes of '' look to +x, and characters face +z: turn_deg -90 (--turn -90) turns "
                                  "it"),
              std::string::npos)
        << warned(traits);
    traits.eyes = false, traits.heading_deg = -95;
    EXPECT_NE(warned(traits).find("the legs of '' stand as if it faced -x, and characters face +z: turn_deg 90 (--turn "
                                  "90) turns it"),
              std::string::npos)
        << warned(traits);
}

TEST_F(Facing, IsNotNamedWhereItIsRightOrNothingSaysIt)
{
    for (const bool toes : {true, false})
        for (const bool eyes : {true, false}) {
            FigureTraits traits = facing(20);
            traits.toes = toes, traits.eyes = eyes;
            EXPECT_EQ(warned(traits), "");
            traits.heading_deg = 180;
            EXPECT_EQ(warned(traits, 180), "") << "it is turned";
        }
    FigureTraits strange = facing(180), lying;
    strange.strange_names = true, lying.lies = true;
    EXPECT_EQ(warned(strange), "") << "its legs have no names";
    EXPECT_EQ(warned(lying), "");
    for (const std::string &name : written::characters()) {
        const Own<clq_asset> asset = load_file(written::path_of(name, ""));
        EXPECT_EQ(warnings(asset.get()).find("characters face +z"), std::string::npos) << name;
    }
}

// A rest pose may face anywhere: pictures show clips.
TEST_F(Facing, IsThatOfTheClips)
{
    FigureTraits traits;
    traits.rest_deg = 90;
    EXPECT_EQ(warned(traits), "");
    traits.heading_deg = 180, traits.rest_deg = 180;
    EXPECT_NE(warned(traits).find("the toes of '' point to -z, and characters face +z: turn_deg 180 "),
              std::string::npos)
        << warned(traits);
    traits.turns_deg = 200;
    EXPECT_EQ(warned(traits), "") << "it faces nowhere for long";
    // Five of seven moments show its back: toes of runners swing.
    traits.turns_deg = 110;
    EXPECT_NE(warned(traits).find("point to -z"), std::string::npos) << warned(traits);
    traits.turns_deg = 0, traits.heading_deg = 0, traits.walks_backwards = true;
    EXPECT_NE(refused(traits).find("its toes say that it faces +z: the clip walks backwards"), std::string::npos)
        << refused(traits);
}

TEST_F(Facing, IsThatOfTheHipsWhereFeetAreControls)
{
    FigureTraits traits = facing(90);
    traits.feet = traits.toes = traits.eyes = false;
    EXPECT_NE(warned(traits).find("the legs of '' stand as if it faced +x, and characters face +z: turn_deg -90 "),
              std::string::npos)
        << warned(traits);
}

TEST_F(Facing, WarnsOfAPersonOfAnotherSizeThanPeopleHave)
{
    FigureTraits traits;
    traits.size = 12;
    EXPECT_EQ(warned(traits), "") << "it has no arms, as animals";
    traits.arms = true;
    for (const float size : {0.45f, 1.0f, 2.0f}) {
        traits.size = size;
        EXPECT_EQ(warned(traits), "") << size;
    }
    traits.size = 12;
    EXPECT_NE(warned(traits).find("high, and people are 0.6 to 4: height_m 1.75 (--height 1.75) or scale 0.085 "),
              std::string::npos)
        << warned(traits);
    traits.size = 0.1f;
    const std::string small = warned(traits);
    EXPECT_NE(small.find("(--height 1.75)"), std::string::npos) << small;
    clq_asset_options options = clq_asset_options_init();
    options.height_m = 1.75;
    EXPECT_EQ(warnings(load(walking_figure(traits), options).get()), "");
    options.height_m = 0, options.scale = 1;
    EXPECT_EQ(warnings(load(walking_figure(traits), options).get()), "") << "its size is wanted";
    traits.lies = true;
    EXPECT_EQ(warned(traits), "") << "it is no person that stands";
}

// As three.js's Soldier rests: toes point 58 degrees aside, hips 44.
TEST_F(Facing, IsThatOfTheHipsWhereFeetAreTurned)
{
    FigureTraits traits = facing(0);
    traits.feet_deg = 60;
    EXPECT_EQ(warned(traits), "");
    traits.heading_deg = 180;
    EXPECT_NE(warned(traits).find("the toes of '' point to -z, and characters face +z: turn_deg 180 "),
              std::string::npos)
        << warned(traits);
    traits.heading_deg = 136;
    EXPECT_NE(warned(traits).find("point to -z, and characters face +z: turn_deg 180 "), std::string::npos)
        << warned(traits);
}

TEST_F(Facing, IsSaidWithTheTurnThatIsThereAlready)
{
    EXPECT_NE(warned(facing(180), 90).find("point to -x, and characters face +z: turn_deg 180 "), std::string::npos)
        << warned(facing(180), 90);
}

// Whichever turn is given, that of the sentence ends both sentences.
TEST_F(Facing, IsRightAfterTheTurnThatASentenceNames)
{
    for (const double given : {180.0, 90.0, -90.0, 270.0}) {
        EXPECT_NE(warned(facing(0), given).find("characters face +z: leave turn_deg (--turn) out"), std::string::npos)
            << warned(facing(0), given);
        const std::string said = refused(facing(0), given);
        const size_t more = said.find(" degrees more of turn_deg (--turn) turn it");
        ASSERT_NE(more, std::string::npos) << said;
        const double turn = given + std::stod(said.substr(said.rfind(' ', more - 1)));
        EXPECT_EQ(warned(facing(0), turn), "") << given;
        EXPECT_EQ(refused(facing(0), turn), "") << given;
    }
}

TEST_F(Facing, ElsewhereIsRefusedOfAWalkerWithTheTurnThatItNeeds)
{
    EXPECT_EQ(refused(facing(0)), "");
    EXPECT_EQ(refused(facing(30)), "");
    const std::string said = refused(facing(180));
    EXPECT_NE(said.find("the feet of clip 0 ('Walk') of template '' move forward at stance: the character faces -z; "
                        "turn_deg 180 (--turn 180) turns it"),
              std::string::npos)
        << said;
    EXPECT_NE(refused(facing(90)).find("move sideways at stance: the character faces +x; turn_deg -90 "),
              std::string::npos)
        << refused(facing(90));
    EXPECT_EQ(refused(facing(180), 180), "");
    EXPECT_EQ(refused(facing(90), -90), "");
    FigureTraits strange = facing(180);
    strange.strange_names = true;
    const Break by_hand = [](clq_locomotion_def &def) {
        for (uint32_t side = 0; side < 2; ++side) {
            const char *names[2][4] = {{"A1", "A2", "A3", "A4"}, {"B1", "B2", "B3", "B4"}};
            const auto node = [&](int part) { return clq_template_find_node(def.tmpl, names[side][part]); };
            def.legs[side] = {node(0), node(1), node(2), node(3)};
        }
    };
    EXPECT_NE(refused(strange, 0, by_hand).find("the character faces -z"), std::string::npos);
    EXPECT_EQ(refused(strange, 180, by_hand), "");
    EXPECT_NE(refused(strange).find("no node is named like a left thigh: name the nodes of the legs (legs of a "
                                    "scenario's class, --legs of the command, clq_locomotion_def.legs)"),
              std::string::npos)
        << refused(strange);
}

TEST_F(Facing, AheadOfAClipThatWalksBackwardsBlamesTheClip)
{
    FigureTraits traits;
    traits.walks_backwards = true;
    EXPECT_NE(
        refused(traits).find("the feet of clip 0 ('Walk') of template '' move forward at stance, and its toes say "
                             "that it faces +z: the clip walks backwards; name another one"),
        std::string::npos)
        << refused(traits);
}

TEST_F(Facing, AheadInOtherClipsBlamesTheWalkThatIsTurned)
{
    FigureTraits traits;
    traits.walk_deg = 90;
    EXPECT_EQ(warned(traits), "");
    EXPECT_NE(refused(traits).find("move sideways at stance, and its toes say that it faces +z: the clip walks aside; "
                                   "name another one"),
              std::string::npos)
        << refused(traits);
}

TEST_F(Facing, OfTheRunClipIsBlamedOnTheRunClip)
{
    const Break runs = [](clq_locomotion_def &def) { def.run = clq_template_find_clip(def.tmpl, "Run"); };
    EXPECT_EQ(refused(facing(0), 0, runs), "");
    FigureTraits traits;
    traits.runs = false;
    EXPECT_NE(refused(traits, 0, runs).find("at gait 2: clip 1 ('Run'), not clip 0 ('Walk'), does not run"),
              std::string::npos)
        << refused(traits, 0, runs);
}

TEST_F(Facing, OfTheCollectedWalkerIsRefusedAndTurned)
{
    const std::string path = CLAQUE_ASSETS_DIR "/../cases/characters/walker_faces_minus_z.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    EXPECT_NE(warnings(load_file(path).get()).find("turn_deg 180 (--turn 180) turns it"), std::string::npos);
    const std::string said = refused(load_file(path).get());
    EXPECT_NE(said.find("the character faces -z; turn_deg 180 (--turn 180) turns it"), std::string::npos) << said;
    EXPECT_EQ(warnings(load_file(path, turned(180)).get()), "");
    const Own<clq_template> tmpl = build(load_file(path, turned(180)).get());
    clq_locomotion_def def = clq_locomotion_def_init();
    def.tmpl = tmpl.get(), def.walk = clq_template_find_clip(tmpl.get(), "Walk");
    clq_locomotion *made = nullptr;
    EXPECT_EQ(clq_locomotion_create(context_.get(), &def, &made), CLQ_OK) << clq_last_error();
    clq_locomotion_destroy(made);
}

}  // namespace

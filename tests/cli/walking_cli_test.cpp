// --legs, --walk, --idle and --clips: the nodes and clips by which characters of files walk.
#include "tests/cli/placement.h"

namespace cli_test
{

TEST_F(PlacementOptions, RefuseAWalkerThatFacesBackAndTurnIt)
{
    const Outcome back = tracks({"--characters", path("back.glb")});
    EXPECT_EQ(back.code, 1);
    EXPECT_TRUE(says(back, "move forward at stance: the character faces -z; turn_deg 180 (--turn 180) turns it"))
        << back.err;
    const Outcome turned = tracks({"--characters", path("back.glb"), "--turn", "180"});
    EXPECT_EQ(turned.code, 0) << turned.err;
}

TEST_F(PlacementOptions, NameTheNodesOfLegs)
{
    const Outcome unnamed = tracks({"--characters", path("strange.glb"), "--turn", "180"});
    EXPECT_TRUE(says(unnamed, "--legs of the command")) << unnamed.err;
    const Outcome named =
        tracks({"--characters", path("strange.glb"), "--turn", "180", "--legs", "A1,A2,A3,A4,B1,B2,B3,B4"});
    EXPECT_EQ(named.code, 0) << named.err;
    const Outcome without_toes =
        tracks({"--characters", path("strange.glb"), "--turn", "180", "--legs", "A1,A2,A3,B1,B2,B3", "--head", "Head"});
    EXPECT_EQ(without_toes.code, 0) << without_toes.err;
    EXPECT_TRUE(says(tracks({"--characters", path("strange.glb"), "--turn", "180", "--legs", "A1,A2,A3,B1"}),
                     "are 4 names; 6 or 8 are wanted"));
    EXPECT_TRUE(says(tracks({"--characters", path("strange.glb"), "--turn", "180", "--legs", "A1,A2,A3,B1,B2,B9"}),
                     "has no node named B9; there are: "));
}

TEST_F(PlacementOptions, FindTheWalkBehindAWordThatMostClipsBeginWith)
{
    FigureTraits man;
    man.before_clips = "HumanArmature|Man_";
    write("man.glb", man);
    const Outcome found = tracks({"--characters", path("man.glb")});
    EXPECT_EQ(found.code, 0) << found.err;
    man.before_clips = "Sneak";
    write("man.glb", man);
    const char *const borrows =
        "has no clip named walk (it has: SneakWalk, SneakRun) and takes the gaits of the built-in "
        "citizen: --walk NAME, or walk in";
    const Outcome none = tracks({"--characters", path("man.glb")});
    EXPECT_EQ(none.code, 0) << none.err;
    EXPECT_TRUE(says(none, borrows)) << none.err;
    const Outcome named = tracks({"--characters", path("man.glb"), "--walk", "SneakWalk"});
    EXPECT_EQ(named.code, 0) << named.err;
    EXPECT_FALSE(says(named, "citizen")) << named.err;
    EXPECT_TRUE(says(tracks({"--characters", path("man.glb"), "--walk", "SneakWlak"}), "no clip named SneakWlak"));
}

// Joints that nothing names take no clips of others.
TEST_F(PlacementOptions, RefuseACharacterWithoutAWalkAndTakeItsOnlyClipForOne)
{
    FigureTraits strange;
    strange.strange_names = true, strange.before_clips = "Sneak";
    write("man.glb", strange);
    const std::vector<std::string> man = {"--characters", path("man.glb"), "--legs", "A1,A2,A3,A4,B1,B2,B3,B4"};
    const Outcome two = tracks(man);
    EXPECT_EQ(two.code, 1);
    EXPECT_TRUE(
        says(two, "has no clip named walk; it has: SneakWalk, SneakRun; --walk NAME where people walk on tracks"))
        << two.err;
    strange.has_run = false;
    write("man.glb", strange);
    const Outcome one = tracks(man);
    EXPECT_EQ(one.code, 0) << one.err;
}

// Legs and a head are no person: their clips would be half of a walk.
TEST_F(PlacementOptions, LendNoGaitsToAFewJoints)
{
    FigureTraits man;
    man.toes = false, man.before_clips = "Sneak";
    write("man.glb", man);
    const Outcome refused = tracks({"--characters", path("man.glb")});
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(says(refused, "has no clip named walk; it has: SneakWalk, SneakRun")) << refused.err;
    EXPECT_FALSE(says(refused, "citizen")) << refused.err;
}

TEST_F(PlacementOptions, SayWhatAWalkBesideItsOriginDoes)
{
    FigureTraits man;
    man.offset_m = 0.4f;
    write("man.glb", man);
    const Outcome near = tracks({"--characters", path("man.glb")});
    EXPECT_FALSE(says(near, "beside")) << near.err;
    man.offset_m = 1;
    write("man.glb", man);
    const Outcome far = tracks({"--characters", path("man.glb")});
    EXPECT_TRUE(says(far, "man.glb: its clip 'Walk' walks 1 m beside its origin")) << far.err;
}

TEST_F(PlacementOptions, FindTheWalkBeforeANumber)
{
    FigureTraits man;
    man.before_clips = "M_", man.after_clips = "_001";
    write("man.glb", man);
    const Outcome found = tracks({"--characters", path("man.glb")});
    EXPECT_EQ(found.code, 0) << found.err;
    EXPECT_TRUE(says(found, "man.glb has no clip named idle or stand, so it stands in its rest pose: --idle"));
    const Outcome named = tracks({"--characters", path("man.glb"), "--idle", "M_Run_001"});
    EXPECT_EQ(named.code, 0) << named.err;
    EXPECT_FALSE(says(named, "rest pose")) << named.err;
    EXPECT_TRUE(says(tracks({"--characters", path("man.glb"), "--idle", "M_Rnu_001"}), "'M_Run_001' is near"));
}

// What play will do.
TEST_F(PlacementOptions, SayWhichGaitsAreBorrowedWhenTheFileIsInspected)
{
    FigureTraits man;
    man.before_clips = "Sneak";
    write("man.glb", man);
    const Outcome outcome = claque({"inspect", path("man.glb"), "--nodes"});
    EXPECT_NE(outcome.out.find("walk  clip \"walk\""), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("run  clip \"jog\""), std::string::npos) << outcome.out;
    EXPECT_TRUE(says(outcome, "takes the gaits of the built-in citizen")) << outcome.err;
    EXPECT_TRUE(says(outcome, "none as leftUpperArm, ")) << outcome.err;
}

TEST_F(PlacementOptions, NameTheNodesAndClipsThatInspectSays)
{
    FigureTraits strange;
    strange.strange_names = true, strange.before_clips = "Sneak";
    write("strange.glb", strange);
    const auto inspected = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {"inspect", path("strange.glb")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_EQ(inspected({}).find("locomotion"), std::string::npos);
    const std::string unnamed = inspected({"--walk", "SneakWalk"});
    EXPECT_NE(unnamed.find("no locomotion: "), std::string::npos) << unnamed;
    EXPECT_NE(unnamed.find("--legs"), std::string::npos) << unnamed;
    const std::string named = inspected({"--walk", "SneakWalk", "--idle", "SneakRun", "--legs", "A1,A2,A3,B1,B2,B3"});
    EXPECT_NE(named.find("left_leg  thigh \"A1\"  shin \"A2\"  foot \"A3\"\n"), std::string::npos) << named;
    EXPECT_NE(named.find("walk  clip \"SneakWalk\""), std::string::npos) << named;
    EXPECT_NE(named.find("idle  clip \"SneakRun\""), std::string::npos) << named;
    EXPECT_EQ(named.find("\nnodes\n"), std::string::npos) << named;
    EXPECT_NE(inspected({"--walk", "SneakWlak"}).find("'SneakWalk' is near"), std::string::npos);
}

TEST_F(PlacementOptions, LetAPreparedFileWalk)
{
    ASSERT_EQ(claque({"prepare", path("back.glb"), "--turn", "180", "--out", path("back.clq")}).code, 0);
    const Outcome walks = tracks({"--characters", path("back.clq")});
    EXPECT_EQ(walks.code, 0) << walks.err;
    EXPECT_TRUE(says(tracks({"--characters", path("back.clq"), "--turn", "180"}),
                     "back.clq is prepared already, with claque prepare, which takes --turn"));
    EXPECT_TRUE(says(claque({"inspect", "citizen", "--clips", path("back.clq")}), "it is a prepared template"));
}

TEST_F(PlacementOptions, AddClipsToWhoWalks)
{
    FigureTraits still, walks, offset;
    still.before_clips = "Other", walks.before_clips = "", offset.offset_m = 1;
    write("still.glb", still), write("walks.glb", walks), write("offset.glb", offset);
    offset.walk = "walk";
    write("named.glb", offset);
    const auto played = [&](const char *who, const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {
            "play",         path("way.csv"), "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m",
            "--characters", path(who),       "--size",    "64x48",        "--time", "1",  "--out",  path("played.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome;
    };
    const auto borrows = [&](const Outcome &outcome) {
        return says(outcome, "takes the gaits of the built-in citizen");
    };
    EXPECT_TRUE(borrows(played("still.glb", {})));
    EXPECT_FALSE(borrows(played("still.glb", {"--clips", path("walks.glb")})));
    // The remedy helps, also where its name is taken.
    for (const auto &[who, walk] : {std::pair("offset.glb", "walk"), {"named.glb", "walk.2"}}) {
        EXPECT_TRUE(says(played(who, {}), std::string("--clips citizen --walk ") + walk + " of play")) << who;
        EXPECT_FALSE(says(played(who, {"--clips", "citizen", "--walk", walk}), "beside its origin")) << who;
    }
}

}  // namespace cli_test

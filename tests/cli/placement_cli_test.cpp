// --turn, --height, --scale and --blend of commands that load characters, and the same keys of scenarios.
#include "tests/cli/placement.h"

namespace cli_test
{

TEST_F(PlacementOptions, TurnAndSizeTheCharacterOfAFile)
{
    const std::vector<float> plain = dumped({}), turned = dumped({"--turn", "180"}), half = dumped({"--scale", "0.5"});
    ASSERT_EQ(plain.size(), turned.size());
    double low = 1e9, high = -1e9;
    const std::vector<float> tall = dumped({"--height", "2.5", "--turn", "90"});
    for (size_t i = 0; i < plain.size(); i += 3) {
        EXPECT_NEAR(turned[i], -plain[i], 1e-5);
        EXPECT_NEAR(turned[i + 2], -plain[i + 2], 1e-5);
        EXPECT_NEAR(half[i + 1], plain[i + 1] / 2, 1e-5);
        low = std::min(low, double(tall[i + 1])), high = std::max(high, double(tall[i + 1]));
    }
    EXPECT_NEAR(high - low, 2.5, 1e-5);
}

TEST_F(PlacementOptions, SayWhatBecomesOfMaterialsThatBlend)
{
    write_visor();
    const auto inspected = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {"inspect", path("visor.glb")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        return outcome.out + outcome.err;
    };
    EXPECT_NE(inspected({}).find("'visor' is transparent: left out"), std::string::npos);
    for (const char *chosen : {"mask", "opaque"})
        EXPECT_EQ(inspected({"--blend", chosen}).find("transparent"), std::string::npos) << chosen;
    EXPECT_NE(inspected({"--blend", "add"}).find("--blend"), std::string::npos);
}

TEST_F(PlacementOptions, OfAPreparedFileAreThoseOfTheFileThatItWasMadeFrom)
{
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
    write("front.glb", {});
    ASSERT_EQ(claque({"prepare", path("front.glb"), "--out", path("front.clq")}).code, 0);
    const auto drawn = [&](const std::string &name, std::vector<std::string> arguments) {
        for (std::string &word : arguments)
            if (word == "FILE") word = path(name);
        arguments.insert(arguments.end(), {"--out", "-"});
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    };
    const std::vector<std::vector<std::string>> commands = {
        {"render", "FILE", "--lod", "off", "--count", "1", "--size", "96x72"},
        {"render", "FILE", "--lod", "off", "--count", "5", "--size", "96x72"},
        {"variety", "FILE", "--count", "3", "--size", "160x90"},
        {"play", path("way.csv"), "--columns", "id,frame,x,y", "--rate", "10", "--unit", "m", "--characters", "FILE",
         "--time", "2", "--size", "96x72"}};
    for (const std::vector<std::string> &command : commands) {
        const std::string of_file = drawn("front.glb", command);
        EXPECT_FALSE(of_file.empty()) << command[0];
        EXPECT_TRUE(of_file == drawn("front.clq", command)) << command[0] << " --count " << command[5];
    }
    std::vector<std::string> turned = commands.back();
    turned[9] = path("front.clq");
    turned.insert(turned.end(), {"--turn", "180", "--out", "-"});
    EXPECT_TRUE(says(claque(turned), "front.clq is prepared already, with claque prepare"));
}

TEST_F(PlacementOptions, AreAskedForASizeWhereItMatters)
{
    FigureTraits giant;
    giant.arms = true, giant.size = 12;
    write("giant.glb", giant);
    for (const std::vector<std::string> &asks : {std::vector<std::string>{"inspect", path("giant.glb")},
                                                 {"prepare", path("giant.glb"), "--out", path("giant.clq")},
                                                 {"lods", path("giant.glb")}})
        EXPECT_TRUE(says(claque(asks), "--height 1.75")) << asks[0];
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
    for (const std::vector<std::string> &draws :
         {std::vector<std::string>{"render", path("giant.glb"), "--count", "1", "--lod", "off"},
          {"render", path("giant.glb"), "--count", "1"},
          {"variety", path("giant.glb"), "--count", "1"}}) {
        std::vector<std::string> arguments = draws;
        arguments.insert(arguments.end(), {"--size", "160x90", "--out", path("giant.png")});
        const Outcome drawn = claque(arguments);
        EXPECT_EQ(drawn.code, 0) << drawn.err;
        EXPECT_EQ(drawn.err, "") << draws[0];
    }
}

TEST_F(PlacementOptions, HideNodesOfPeopleThatWalk)
{
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
    write("front.glb", {});
    const auto played = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {
            "play", path("way.csv"), "--columns",       "id,frame,x,y", "--rate", "10",    "--unit", "m", "--time",
            "2",    "--characters",  path("front.glb"), "--size",       "96x72",  "--out", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return claque(arguments);
    };
    const Outcome whole = played({}), hidden = played({"--hide", "Head"});
    EXPECT_EQ(hidden.code, 0) << hidden.err;
    EXPECT_EQ(hidden.out.size(), whole.out.size());
    EXPECT_FALSE(hidden.out == whole.out);
    EXPECT_TRUE(says(played({"--hide", "Haed"}), "'Head'"));
}

TEST_F(PlacementOptions, AreRefusedWhereTheyMeanNothing)
{
    EXPECT_TRUE(says(claque({"dump", "citizen", "--turn", "180", "--out", path("d.npy")}),
                     "citizen is built in; --turn, --height, --scale, --blend and --hide are for files"));
    for (const char *chosen : {"mask", "opaque"})
        EXPECT_NE(claque({"dump", "citizen", "--blend", chosen, "--out", path("d.npy")}).code, 0) << chosen;
    const std::string none =
        "--turn, --height, --scale, --blend and --hide are for characters of files, and none is shown";
    EXPECT_TRUE(says(tracks({"--characters", "citizen", "--turn", "180"}), none));
    EXPECT_TRUE(says(claque({"render", "--scene", "plaza", "--turn", "180", "--out", path("s.png")}), none));
    EXPECT_NE(claque({"dump", path("back.glb"), "--height", "1", "--scale", "2", "--out", path("d.npy")}).code, 0);
    ASSERT_EQ(claque({"prepare", path("back.glb"), "--turn", "180", "--out", path("back.clq")}).code, 0);
    EXPECT_TRUE(says(claque({"split", path("back.clq"), "--turn", "180"}),
                     "back.clq is prepared already, with claque prepare; --turn, --height, --scale, --blend and --hide "
                     "are for files"));
}

// Walkers that face backwards are refused, and the turn of the command puts them right.
TEST_F(PlacementOptions, TurnTheWalkersOfEachCommandThatHasSome)
{
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
    std::ofstream(path("steps.toml")) << "steps = ['wait 0.1']\n";
    std::ofstream(path("guest.toml"))
        << "machine = \"guest\"\n[states.stands]\nenter = [ { look = [4.0, 1.0, 4.0] } ]\n";
    std::ofstream(path("stage.toml")) << "name = \"stage\"\n[stage]\nseconds = 1.0\n[[characters]]\nname = \"guests\"\n"
                                         "character = \"back.glb\"\n[navigation]\nrectangle = [-3, -3, 3, 3]\n"
                                         "[[agents]]\nclass = \"guests\"\nmachine = \"guest.toml\"\ncount = 2\n"
                                         "area = [-2, -2, 2, 2]\n";
    const std::vector<std::string> way = {path("way.csv"), "--columns", "id,frame,x,y", "--rate",        "10",
                                          "--unit",        "m",         "--characters", path("back.glb")};
    const std::vector<std::vector<std::string>> commands = {
        {"tracks"},
        {"play", "--time", "2", "--size", "96x72", "--out", path("way.png")},
        {"labels", "--frames", "10:10", "--size", "96x72", "--out", path("labels")},
        {"view", "--size", "640x480", "--script", path("steps.toml"), "--shots", path("")},
        {"bench", "--frames", "1", "--size", "96x72"},
        {"stage", path("stage.toml"), "--json", "-"}};
    for (std::vector<std::string> command : commands) {
        if (command[0] != "stage") command.insert(command.begin() + 1, way.begin(), way.end());
        const Outcome back = claque(command);
        EXPECT_NE(back.code, 0) << command[0];
        EXPECT_TRUE(says(back, "(--turn 180) turns it")) << command[0] << back.err;
        command.insert(command.end(), {"--turn", "180"});
        const Outcome turned = claque(command);
        EXPECT_EQ(turned.code, 0) << command[0] << turned.err;
        EXPECT_FALSE(says(turned, "turns it")) << command[0] << turned.err;
    }
}

TEST_F(PlacementOptions, AreKeysOfAClassInAScenario)
{
    const Outcome back = scenario("back.glb", "");
    EXPECT_EQ(back.code, 1);
    EXPECT_TRUE(says(back, "the character faces -z; turn_deg 180 (--turn 180) turns it")) << back.err;
    EXPECT_FALSE(says(scenario("back.glb", "turn_deg = 180\nheight_m = 1.6\n"), "faces -z"));
    EXPECT_TRUE(says(scenario("strange.glb", "turn_deg = 180\nlegs = [\"A1\", \"A2\"]\n"), "are 2 names"));
    EXPECT_TRUE(says(scenario("back.glb", "height_m = 1.6\nscale = 2\n"), "has a height_m and a scale"));
    EXPECT_TRUE(says(scenario("citizen", "turn_deg = 180\n"), "has turn_deg, which is for files; citizen is built in"));
    EXPECT_TRUE(says(scenario("back.glb", "blend = \"add\"\n"), "has the blend 'add': mask or opaque"));
}

TEST_F(PlacementOptions, PlaceTheCharacterWhoseColoursAreSaved)
{
    const auto saved = [&](const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {"colours", "save", "--out", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return claque(arguments);
    };
    const std::string turn = "(--turn 180) turns it";
    const Outcome back = saved({path("back.glb")}), turned = saved({path("back.glb"), "--turn", "180"});
    EXPECT_TRUE(says(back, turn)) << back.err;
    EXPECT_EQ(turned.code, 0) << turned.err;
    EXPECT_FALSE(says(turned, turn)) << turned.err;
    EXPECT_EQ(turned.out, back.out);
    scenario("back.glb", "turn_deg = 180\n");
    const Outcome described = saved({"--scenario", path("scenario.toml")});
    EXPECT_EQ(described.code, 0) << described.err;
    EXPECT_FALSE(says(described, turn)) << described.err;
    EXPECT_TRUE(says(saved({"odeon", "--turn", "180"}), "odeon is no character; --turn"));
    EXPECT_TRUE(says(saved({"--scenario", path("scenario.toml"), "--turn", "180"}), "has keys of its own for this"));
}

TEST_F(PlacementOptions, BlendAsAClassOfAScenarioSaysOrElseAsTheCommandDoes)
{
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
    FigureTraits veiled;
    veiled.alpha = 0.4f;
    write("veil.glb", veiled);
    const auto drawn = [&](const std::string &lines, const std::vector<std::string> &more) {
        scenario("veil.glb", lines);
        std::vector<std::string> arguments = {"render", "--scenario", path("scenario.toml"), "--time", "1", "--size",
                                              "64x48",  "--out",      path("drawn.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(says(outcome, "'cloth' is transparent"), lines.find("blend") == lines.npos && more.empty()) << lines;
        return file_text(path("drawn.png"));
    };
    const std::string nobody = drawn("", {}), somebody = drawn("blend = \"opaque\"\n", {});
    EXPECT_NE(nobody, somebody);
    EXPECT_EQ(drawn("turn_deg = 0\n", {"--blend", "opaque"}), somebody);
    EXPECT_EQ(drawn("blend = \"mask\"\n", {"--blend", "opaque"}), nobody);
}

}  // namespace cli_test

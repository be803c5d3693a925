// Exit codes and their messages: 0 done, 1 failed with one sentence, 2 wrong usage.
#include <algorithm>
#include <fstream>

#include "tests/cli/help.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Usage = Command;

size_t lines(const std::string &text) { return static_cast<size_t>(std::count(text.begin(), text.end(), '\n')); }

TEST_F(Usage, HelpIsThereForEveryCommandAndCostsNothing)
{
    for (std::vector<std::string> command : all_commands()) {
        command.emplace_back("--help");
        const Outcome help = claque(command);
        EXPECT_EQ(help.code, 0) << command[0];
        EXPECT_NE(help.out.find("Usage"), std::string::npos) << command[0];
        EXPECT_EQ(help.err, "") << command[0];
    }
    EXPECT_EQ(claque({"--help"}).code, 0);
    EXPECT_EQ(claque({"--version"}).out.substr(0, 7), "claque ");
}

// As the manual page and the pages of docs are read, whatever the version of CLI11.
TEST_F(Usage, HasTheSameFormEverywhere)
{
    const std::string frames = claque({"frames", "--help"}).out;
    EXPECT_EQ(frames.find("Check the frames of a film that several jobs drew\n"
                          "Usage: claque frames [OPTIONS] SUBCOMMAND\n\n"
                          "Options:\n"
                          "  -h,--help                   Print this help message and exit\n\n"
                          "Subcommands:\n"
                          "  check                       Compare "),
              0u)
        << frames;
    const std::string render = claque({"render", "--help"}).out;
    EXPECT_NE(render.find("\n  FILE TEXT Excludes: --scenario --scene\n"), std::string::npos) << render;
}

TEST_F(Usage, ASmallStackIsRefusedWithASentenceAndTheLeastOneIsEnough)
{
    const auto with_stack = [](const char *kilobytes, std::vector<std::string> arguments) {
        std::vector<std::string> words = {"sh", "-c", "ulimit -s \"$0\" && exec \"$@\"", kilobytes, CLAQUE_COMMAND};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_program(words);
    };
    std::vector<std::vector<std::string>> works = {{"inspect", "citizen"}, {"cost"}, {"lods", "citizen"}};
#ifdef CLAQUE_STAGED
    works.push_back({"stage", CLAQUE_SOURCE_DIR "/samples/scenarios/evacuation.toml", "--seconds", "1"});
#endif
    for (const std::vector<std::string> &arguments : works) {
        for (const char *kilobytes : {"64", "255"}) {
            const Outcome refused = with_stack(kilobytes, arguments);
            EXPECT_EQ(refused.code, 1) << arguments[0] << " " << kilobytes << " ended by signal " << refused.signal;
            EXPECT_EQ(refused.err, "claque: a stack may have " + std::string(kilobytes) +
                                       " kB, and 256 are wanted: ulimit -s 8192 allows more.\n");
        }
        const Outcome enough = with_stack("256", arguments);
        EXPECT_EQ(enough.code, 0) << arguments[0] << " ended by signal " << enough.signal << ": " << enough.err;
    }
}

TEST_F(Usage, HelpThatCannotBeWrittenIsAFailure)
{
    std::vector<std::vector<std::string>> asked = {{"--version"}, {"--help"}, {"parity", "--help"}};
    for (std::vector<std::string> command : all_commands()) {
        command.emplace_back("--help");
        asked.push_back(command);
    }
    EXPECT_GT(asked.size(), 20u);
    for (const std::vector<std::string> &words : asked) {
        const Outcome full = claque(words, "/dev/full");
        EXPECT_EQ(full.code, 1) << words[0];
        EXPECT_EQ(full.err, "claque: standard output could not be written.\n") << words[0];
    }
}

TEST_F(Usage, WhatIsWrongIsNamedWithTheWayOut)
{
    // CLI11 2.6 looks for required options before it reads values.
    const std::string out = path("x.png");
    const struct {
        std::vector<std::string> arguments;
        std::string says;
    } cases[] = {
        {{}, "claque needs a subcommand; there are: render, sheet, "},
        {{"paint"}, "'paint' is no subcommand of claque; there are: render, sheet, "},
        {{"parity", "paint"}, "'paint' is no subcommand of parity; there are: export, capture, compare\n"},
        {{"render", "--out", path("x.jpg")}, "'" + path("x.jpg") + "' would hold a PNG picture"},
        {{"play", "people.csv", "--out", path("x.png")}, "--time draws a single one"},
        {{"render", "--out", out, "--seed", "99999999999999999999999"},
         "--seed: '99999999999999999999999' is not a whole number of digits that 64 bits hold"},
        {{"render", "--out", out, "--seed", "18446744073709551616"},
         "--seed: '18446744073709551616' is not a whole number"},
        {{"render", "--out", out, "--seed", "-1"}, "--seed: '-1' is not a whole number"},
        {{"view", "--seed", "0x10"}, "--seed: '0x10' is not a whole number"},
        {{"variety", "citizen", "--out", out, "--count", "0401"}, "--count: Value 401 not in range "},
        {{"render", "--out", out, "--lod-scale", "nan"}, "--lod-scale: 'nan' is not a finite number"},
        {{"render", "--out", out, "--lod-scale", "1e999"}, "--lod-scale: '1e999' is not a finite number"},
    };
    for (const auto &c : cases) {
        const Outcome outcome = claque(c.arguments);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(claque({"inspect", path("none.glb")}).err,
              "claque: clq_asset_load_file: '" + path("none.glb") + "' cannot be opened: No such file or directory.\n");
}

TEST_F(Usage, WrongArgumentsAreCode2)
{
    const std::string out = path("x.png");
    const std::vector<std::vector<std::string>> wrong = {
        {},
        {"paint"},
        {"render"},
        {"render", "--out", out, "--size", "12"},
        {"render", "--out", out, "--size", "0x5"},
        {"render", "--out", out, "--size", "99999x5"},
        {"render", "--out", out, "--count", "0"},
        {"render", "--out", out, "--count", "-3"},
        {"render", "--out", out, "--strategy", "gaudy"},
        {"render", "--out", out, "--cache", "some"},
        {"render", "--out", out, "--context", "metal"},
        {"render", "--out", out, "--camera", "hidden"},
        {"render", "--out", out, "--scene", "moon"},
        {"render", "--out", out, "--threads", "0"},
        {"render", "--out", out, "--time", "inf"},
        {"render", "--out", out, "--time", "soon"},
        {"render", "--out", out, "--frames", "1:2"},
        {"render", "--out", path("x-%05d.png"), "--frames", "5:2"},
        {"render", "--out", path("x-%05d.png"), "--frames", "five"},
        {"render", "--out", path("x-%05d-%05d.png"), "--frames", "0:1"},
        {"render", "--out", path("x-%s.png"), "--frames", "0:1"},
        {"render", "--out", path("x-%05d.png")},
        {"render", "--out", out, "--stride", "2"},
        {"render", "a.glb", "--scene", "plaza", "--out", out},
        {"inspect"},
        {"dump", "citizen"},
        {"dump", "citizen", "--time", "1", "--out", path("x.npy")},
        {"split", "citizen", "--picture", out, "--scale", "99"},
        {"prepare", "citizen"},
        {"bench"},
        {"bench", "plaza", "--count", "1,x"},
        {"bench", "odeon", "--count", "10,20"},
        {"bench", "odeon", "--cache", "some"},
        {"bench", "odeon", "--strategy", "gaudy"},
        {"bench", "odeon", "--frames", "0"},
        {"bench", "odeon", "--json", "--markdown"},
        {"bench", "odeon", "--camera", "close", "--path", "p.toml"},
        {"bench", "plaza", "--markdown"},
        {"bench", "plaza", "--camera", "path"},
        {"render", "--out", out, "--camera", "path"},
        {"render", "--out", out, "--scenario", "t.toml", "--scene", "plaza"},
        {"render", "citizen", "--out", out, "--scenario", "t.toml"},
        {"sheet", "--out", out, "--scenario", "t.toml", "--scene", "plaza"},
        {"bench", "plaza", "--scenario", "t.toml"},
        {"parity", "export", "--out", path("x")},
        {"parity", "capture", "plaza", "--scenario", "t.toml", "--out", path("x")},
        {"play", "t.csv", "--scenario", "t.toml", "--out", out},
        {"render", "--out", path("x-%05d.png"), "--frames", "all"},
        {"sheet"},
        {"sheet", "--out", out, "--scene", "plaza"},
        {"sheet", "--out", out, "--camera", "close"},
        {"sheet", "--out", "-", "--json", "-"},
        {"plot"},
        {"plot", "b.json"},
        {"plot", "b.json", "--out", path("x.jpg")},
        {"cost", "--plot", path("x.gif")},
        {"cost", "--json", "-", "--plot", "-"},
        {"cost", "--json", "-", "--markdown"},
    };
    for (const std::vector<std::string> &arguments : wrong) {
        std::string line;
        for (const std::string &argument : arguments) line += argument + " ";
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 2) << line << "\n" << outcome.err;
        EXPECT_NE(outcome.err, "") << line;
        EXPECT_EQ(outcome.out, "") << line;
    }
    EXPECT_TRUE(left().empty());
}

TEST_F(Usage, WhatFailsSaysWhyInOneSentence)
{
    const std::string bad = path("bad.glb"), clq = path("bad.clq");
    const std::string toml = path("bad.toml");
    for (const std::string &file : {bad, clq, toml}) std::ofstream(file) << "this is no character";
    const std::vector<std::vector<std::string>> failing = {
        {"render", path("none.glb"), "--out", path("x.png")},
        {"render", bad, "--out", path("x.png")},
        {"render", clq, "--out", path("x.png")},
        {"render", "--count", "3", "--out", path("no/such/folder/x.png")},
        {"inspect", path("none.glb")},
        {"inspect", bad},
        {"inspect", "senator"},
        {"dump", bad, "--out", path("x.npy")},
        {"dump", "citizen", "--clip", "dance", "--out", path("x.npy")},
        {"dump", "citizen", "--clip", "99", "--out", path("x.npy")},
        {"dump", "citizen", "--out", path("no/x.npy")},
        {"split", bad, "--picture", path("x.png")},
        {"split", "citizen", "--picture", path("x.png"), "--texture", "7"},
        {"prepare", bad, "--out", path("x.clq")},
        {"bench", path("none.glb")},
        {"bench", "odeon", "--path", path("none.toml")},
        {"render", "--scenario", toml, "--out", path("x.png")},
        {"render", "--scenario", path("none.toml"), "--out", path("x.png")},
        {"sheet", "--scenario", toml, "--out", path("x.png")},
        {"bench", "--scenario", toml},
        {"parity", "export", "--scenario", toml, "--out", path("x")},
        {"colours", "save", "--scenario", toml, "--out", path("x.toml")},
        {"render", "--path", toml, "--out", path("x.png")},
        {"render", "--path", path("none.toml"), "--out", path("x.png")},
        {"sheet", "--path", toml, "--out", path("x.png")},
        {"sheet", "--out", path("no/x.png")},
        {"plot", path("none.json"), "--out", path("x.svg")},
        {"plot", toml, "--out", path("x.svg")},
        {"plot", toml, "--out", path("x.png")},
        {"cost", "--measured", path("none.json")},
        {"cost", "--measured", toml, "--plot", path("x.png"), "--json", path("x.json")},
        {"cost", "--plot", path("no/x.png")},
    };
    for (const std::vector<std::string> &arguments : failing) {
        std::string line;
        for (const std::string &argument : arguments) line += argument + " ";
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 1) << line;
        EXPECT_EQ(lines(outcome.err), 1u) << line << "\n" << outcome.err;
        EXPECT_EQ(outcome.err.substr(0, 8), "claque: ") << line;
        EXPECT_EQ(outcome.out, "") << line;
    }
    EXPECT_EQ(left(), (std::vector<std::string>{"bad.clq", "bad.glb", "bad.toml"}))
        << "a failed command leaves no file";
}

// A sheet takes no character's file, so it has no nodes to hide.
TEST_F(Usage, HideIsAnOptionOfCommandsThatTakeAFile)
{
    const Outcome refused = claque({"sheet", "--hide", "hat", "--out", path("x.png")});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("--hide"), std::string::npos) << refused.err;
    EXPECT_EQ(claque({"sheet", "--help"}).out.find("--hide"), std::string::npos);
    for (const char *command : {"render", "play", "stage", "labels", "bench", "inspect", "split", "prepare", "lods"})
        EXPECT_NE(claque({command, "--help"}).out.find("--hide"), std::string::npos) << command;
}

TEST_F(Usage, AClipThatIsNotThereIsAnsweredWithThoseThatAre)
{
    const Outcome outcome = claque({"dump", "citizen", "--clip", "dance", "--out", path("x.npy")});
    for (const char *clip : {"dance", "stand", "walk", "applaud", "cheer"})
        EXPECT_NE(outcome.err.find(clip), std::string::npos) << clip;
}

}  // namespace
}  // namespace cli_test

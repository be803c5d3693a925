// colours: colour maps are saved, used by other commands, shown, and changed while frames are drawn.
#include <cstdio>
#include <fstream>

#include "tests/cli/run.h"
#include "tests/support/written_characters.h"

namespace cli_test
{
namespace
{

class Colours : public Drawing
{
protected:
    static std::vector<std::string> bench_of(const std::string &what)
    {
        return {"bench", what,         "--count", "9",      "--frames", "1",     "--cache",
                "full",  "--strategy", "fused",   "--size", "160x120",  "--json"};
    }
    std::vector<std::string> capture_of(const std::string &what) const
    {
        return {"parity", "capture", what, "--count", "9", "--size", "160x120", "--out", path("captured")};
    }
    // The picture that a command draws, or its hash.
    std::string drawn_by(const std::vector<std::string> &words) const
    {
        const Outcome done = claque(words);
        EXPECT_EQ(done.code, 0) << done.err;
        for (const char *file : {"drawn.png", "labelled/images/000000.png", "captured/colour.npy"})
            if (std::filesystem::exists(path(file))) {
                const std::string picture = file_text(path(file));
                std::filesystem::remove(path(file));
                return picture;
            }
        const size_t hash = done.out.find("\"picture_hash\"");
        return hash == std::string::npos ? done.out : done.out.substr(hash, 40);
    }
};
using ColoursUsage = Command;

TEST_F(ColoursUsage, ASavedMapIsSavedAgainByteForByte)
{
    for (const char *from : {"odeon", "roman-classes", "patrician"}) {
        const Outcome once = claque({"colours", "save", from, "--out", path("once.toml")});
        ASSERT_EQ(once.code, 0) << once.err;
        const Outcome twice = claque({"colours", "save", path("once.toml"), "--out", "-"});
        EXPECT_EQ(twice.code, 0) << twice.err;
        EXPECT_EQ(twice.out, file_text(path("once.toml"))) << from;
        EXPECT_NE(twice.out.find("template = \"patrician\""), std::string::npos) << twice.out;
    }
    EXPECT_EQ(left(), (std::vector<std::string>{"once.toml"}));
}

TEST_F(ColoursUsage, WhatCannotBeDoneIsOneSentence)
{
    std::ofstream(path("broken.toml")) << "[[classes]]\nname = \"a\"\nzones.skin = { hue = [1, 2, 3] }\n";
    std::ofstream(path("bare.toml")) << "[[classes]]\nname = \"a\"\n";
    const struct {
        std::vector<std::string> arguments;
        int code;
        std::string says;
    } cases[] = {
        {{"colours"}, 2, "subcommand"},
        {{"colours", "save", "centurion", "--out", "-"}, 1, "centurion"},
        {{"colours", "save", path("broken.toml"), "--out", "-"}, 1, "line 3, column 22"},
        {{"colours", "save", "citizen", "--scenario", "x.toml", "--out", "-"}, 2, "--scenario"},
        {{"colours", "save", "--out", "-"}, 2, "--scenario"},
        {{"colours", "classes", "--colours", path("bare.toml"), "--out", path("a.png")}, 1, "names no template"},
        {{"render", "citizen", "--colours", path("broken.toml"), "--out", path("a.png")}, 1, "line 3, column 22"},
        {{"variety", "citizen", "--colours", "wild", "--class", "b", "--out", path("a.png")}, 1, "needs a map"},
        {{"render", "citizen", "--colours", "wild", "--reload", "--out", path("a.png")}, 1, "name none"},
        {{"render", "citizen", "--reload", "--out", path("a.png")}, 2, "--colours"},
        {{"variety", "citizen", "--colours", path("bare.toml"), "--out", path("a.png")},
         1,
         "no class for the template"},
        {{"variety", "citizen", "--colours", path("bare.toml"), "--class", "b", "--out", path("a.png")}, 1, "'b'"},
    };
    for (const auto &c : cases) {
        const Outcome outcome = claque(c.arguments);
        EXPECT_EQ(outcome.code, c.code) << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(left(), (std::vector<std::string>{"bare.toml", "broken.toml"}));
}

TEST_F(Colours, TheMapOfTheOdeonChangesNothingInTheOdeonAndAnotherOneDoes)
{
    ASSERT_EQ(claque({"colours", "save", "odeon", "--out", path("odeon.toml")}).code, 0);
    ASSERT_EQ(claque({"colours", "save", "roman-classes", "--out", path("roman.toml")}).code, 0);
    const std::vector<std::string> scene = {"--scene", "odeon", "--camera", "close"};
    const auto with = [&](const std::string &map) {
        std::vector<std::string> arguments = scene;
        arguments.insert(arguments.end(), {"--colours", path(map)});
        return picture_hash(arguments);
    };
    const std::string own = picture_hash(scene);
    EXPECT_EQ(with("odeon.toml"), own);
    EXPECT_NE(with("roman.toml"), own);
}

TEST_F(Colours, ActorsOfATemplateGetTheClassThatIsMadeForIt)
{
    std::ofstream(path("red.toml"))
        << "[[classes]]\nname = \"reds\"\ntemplate = \"citizen\"\nzones.tunic = { colour = \"#ff0000\" }\n";
    const auto draw = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments = {"variety", "citizen", "--count", "3", "--size", "300x160", "--out", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    };
    ASSERT_EQ(claque({"colours", "save", "citizen", "--out", path("own.toml")}).code, 0);
    const std::string own = draw({});
    EXPECT_TRUE(draw({"--colours", path("own.toml")}) == own);
    const std::string red = draw({"--colours", path("red.toml")});
    EXPECT_FALSE(red == own);
    EXPECT_TRUE(draw({"--colours", path("red.toml"), "--class", "reds"}) == red);
}

TEST_F(Colours, OfCharactersFromFilesAreWildOrTheFilesOwnWhereThatIsAsked)
{
    const std::string person = written::folder() + "WrittenPerson.glb";
    ASSERT_FALSE(written::people().empty());  // writes it
    const std::vector<std::string> render = {"render", person, "--count", "9", "--size", "160x120", "--out", "-"},
                                   variety = {"variety", person, "--count", "4", "--size", "300x160", "--out", "-"},
                                   prepare = {"prepare", person, "--out", "-"},
                                   lods = {"lods", person, "--size", "640x240", "--picture", path("drawn.png")};
    for (std::vector<std::string> words : {render, variety, prepare, lods, bench_of(person), capture_of(person)}) {
        const std::string near = drawn_by(words);
        words.insert(words.end(), {"--colours", "wild"});
        const std::string wild = drawn_by(words);
        words.back() = "own";
        const std::string own = drawn_by(words);
        EXPECT_FALSE(near == wild || near == own || wild == own) << words[0];
    }
}

TEST_F(Colours, OfAFileAreWornInEveryCommandThatDrawsPeople)
{
    std::ofstream(path("red.toml"))
        << "[[classes]]\nname = \"reds\"\ntemplate = \"citizen\"\nzones.tunic = { colour = \"#ff0000\" }\n";
    const std::vector<std::string> lods = {"lods", "citizen", "--size", "640x240", "--picture", path("drawn.png")},
                                   labels = {"labels",   "plaza", "--count", "40",    "--size",        "160x120",
                                             "--frames", "0",     "--again", "--out", path("labelled")};
    for (std::vector<std::string> words : {lods, labels, bench_of("plaza"), capture_of("plaza")}) {
        const std::string own = drawn_by(words);
        words.insert(words.end(), {"--colours", path("red.toml")});
        EXPECT_FALSE(own == drawn_by(words)) << words[0];
    }
}

TEST_F(Colours, ClassesAndTheComparisonArePictures)
{
    std::ofstream(path("one.toml")) << "[[classes]]\nname = \"a\"\ntemplate = \"citizen\"\n"
                                       "[[classes]]\nname = \"b\"\ntemplate = \"citizen\"\n"
                                       "zones.tunic = { colour = \"#ff0000\" }\n";
    for (const char *picture : {"classes", "compare"}) {
        const auto draw = [&](const char *seed) {
            const Outcome outcome = claque({"colours", picture, "--colours", path("one.toml"), "--count", "2", "--size",
                                            "160x120", "--seed", seed, "--out", "-"});
            EXPECT_EQ(outcome.code, 0) << outcome.err;
            return outcome.out;
        };
        const std::string one = draw("1");
        EXPECT_EQ(one.size(), 3u * 160 * 120);
        EXPECT_FALSE(draw("2") == one);
    }
}

// A frame is larger than a pipe: after drawing frame 1 the command blocks until most of it is read, and only then looks
// at the file.
TEST_F(Colours, AChangedFileIsUsedByTheFollowingFrames)
{
    const auto write =
        [&](const std::string &colour) {
            std::ofstream(path("new.toml"))
                << "[[classes]]\nname = \"reds\"\ntemplate = \"citizen\"\nzones.tunic = { colour = \"" + colour +
                       "\" }\n";
            ASSERT_EQ(std::rename(path("new.toml").c_str(), path("map.toml").c_str()), 0);
        };
    const std::string options =
        " render citizen --count 2 --size 320x240 --colours " + path("map.toml") + " --out - --frames ";
    constexpr size_t bytes = 3 * 320 * 240;
    const auto frame = [&](FILE *from) {
        std::string rgb(bytes, ' ');
        EXPECT_EQ(std::fread(rgb.data(), 1, bytes, from), bytes);
        return rgb;
    };
    const auto alone = [&](const char *number) {
        FILE *pipe = popen((CLAQUE_COMMAND + options + number + ":" + number).c_str(), "r");
        const std::string rgb = frame(pipe);
        EXPECT_EQ(pclose(pipe), 0);
        return rgb;
    };
    write("#ff0000");
    const std::string red_0 = alone("0"), red_2 = alone("2");
    write("#0000ff");
    const std::string blue_2 = alone("2"), blue_4 = alone("4");
    ASSERT_FALSE(red_2 == blue_2);
    write("#ff0000");
    FILE *pipe = popen((CLAQUE_COMMAND + options + "0:4 --reload 2>" + path("said.txt")).c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    EXPECT_TRUE(frame(pipe) == red_0);
    write("#0000ff");
    frame(pipe);
    EXPECT_TRUE(frame(pipe) == blue_2);
    write("blue");
    frame(pipe);
    EXPECT_TRUE(frame(pipe) == blue_4);
    EXPECT_EQ(pclose(pipe), 0);
    const std::string said = file_text(path("said.txt"));
    EXPECT_NE(said.find("map.toml, line 4, column 26: 'colour' is not a string like"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), said.size() - 1) << "once: " << said;
}

}  // namespace
}  // namespace cli_test

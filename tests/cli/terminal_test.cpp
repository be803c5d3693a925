// Control characters in names that files give never reach a terminal: they are shown, and letters stay as they are.
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

#include "tests/cli/run.h"
#include "tests/support/written_characters.h"

namespace cli_test
{
namespace
{

class Terminal : public Command
{
protected:
    static void expect_text(const std::string &text)
    {
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            EXPECT_TRUE(byte >= ' ' || c == '\n' || c == '\t') << int{byte} << " in " << text;
            EXPECT_NE(byte, 0x7f) << text;
        }
    }
    Outcome rendered(const std::string &class_name) const
    {
        std::ofstream(path("s.toml")) << "name = 's'\n[[characters]]\nname = 'h'\ncharacter = 'herald'\n"
                                      << "[[people]]\nclass = \"" << class_name << "\"\nat = [0, 0, 0]\n";
        return claque({"render", "--scenario", path("s.toml"), "--out", path("p.png")});
    }
};

TEST_F(Terminal, GetsNoControlCharactersInMessages)
{
    const struct {
        const char *in_the_file, *shown;
    } names[] = {
        {R"(\u001b[2J)", R"('\x1b[2J')"},
        {R"(\u001b]0;owned\u0007)", R"('\x1b]0;owned\x07')"},
        {R"(a\rb)", R"('a\x0db')"},
        {R"(a\bb\u007f)", R"('a\x08b\x7f')"},
        {R"(\u009b31m)", R"('\xc2\x9b31m')"},
        {R"(\u00a0Zo\u00eb)", "'\u00a0Zo\u00eb'"},
        {R"(\u4eba \U0001F3AD)", "'\u4eba \U0001F3AD'"},
    };
    for (const auto &name : names) {
        const Outcome outcome = rendered(name.in_the_file);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_NE(outcome.err.find(name.shown), std::string::npos) << outcome.err << " lacks " << name.shown;
        expect_text(outcome.err);
    }
}

TEST_F(Terminal, GetsNoControlCharactersOfArguments)
{
    for (const std::vector<std::string> &words : {std::vector<std::string>{"\x1b[2J"},
                                                  {"inspect", path("\x1b[2J.glb")},
                                                  {"render", "--out", path("x.png"), "--scene", "\x1b[2J"},
                                                  {"inspect", path("\x9b\xff\xc3.glb")}}) {
        const Outcome outcome = claque(words);
        EXPECT_NE(outcome.code, 0);
        expect_text(outcome.err);
        EXPECT_NE(outcome.err.find(words.back().find("[2J") != std::string::npos ? R"(\x1b[2J)" : R"(\x9b\xff\xc3)"),
                  std::string::npos)
            << outcome.err;
    }
}

TEST_F(Terminal, GetsNoControlCharactersInTables)
{
    std::string table = "id,frame,x,y\n";
    for (int frame = 0; frame < 5; ++frame) table += "\x1b[31mred,0" + std::to_string(frame) + ",1,2\n";
    std::ofstream(path("t\x1b[2J.csv")) << table;
    const Outcome outcome =
        claque({"tracks", path("t\x1b[2J.csv"), "--columns", "id,frame,x,y", "--rate", "2", "--unit", "m"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(outcome.out.empty());
    expect_text(outcome.out);
    expect_text(outcome.err);
}

// Bytes that are asked for on standard output are no text.
TEST_F(Terminal, GetsTheBytesOfAPicture)
{
    const Outcome file = claque({"dump", "citizen", "--out", path("d.npy")});
    const Outcome piped = claque({"dump", "citizen", "--out", "-"});
    ASSERT_EQ(file.code, 0) << file.err;
    ASSERT_EQ(piped.code, 0) << piped.err;
    EXPECT_TRUE(piped.out == file_text(path("d.npy")));
}

// Levels take seconds: a terminal is told so, and for how long already.
TEST_F(Terminal, IsToldThatLevelsAreMade)
{
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(grantpt(terminal) + unlockpt(terminal), 0);
    const std::string name = ptsname(terminal);
    const int held = open(name.c_str(), O_RDWR | O_NOCTTY);  // what is written stays until it is read
    ASSERT_GE(held, 0);
    const auto lods = [&](const std::string &errors) {
        return run_program({"sh", "-c",
                            CLAQUE_COMMAND " lods " + written::path_of("WrittenPerson.glb", "") +
                                " --targets 300 --json 2> " + errors});
    };
    const Outcome shown = lods(name);
    EXPECT_EQ(shown.code, 0);
    std::string text(4096, '\0');
    const ssize_t size = read(terminal, text.data(), text.size());
    text.resize(size > 0 ? static_cast<size_t>(size) : 0);
    close(held), close(terminal);
    EXPECT_NE(text.find("claque: making levels of detail of "), std::string::npos) << text;
    EXPECT_NE(text.find("WrittenPerson.glb, 0 s"), std::string::npos) << text;
    EXPECT_EQ(text.substr(text.size() < 4 ? 0 : text.size() - 4), "\r\033[K") << "the line is empty at the end";
    EXPECT_EQ(shown.out.find("making levels"), std::string::npos);
    EXPECT_EQ(lods(path("errors")).out, shown.out);
    EXPECT_EQ(file_text(path("errors")), "");
}

}  // namespace
}  // namespace cli_test

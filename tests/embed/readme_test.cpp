// What README.md and docs/hosts.md say about building a program with claque, done word for word: their files are
// written and their commands run, each way in a home of its own. Three things replace what would take minutes: `make`
// installs the existing build instead of building again (`-o installed`), `apt-get` does nothing, and the project that
// has claque as a folder takes objects from that build where it compiles the same source in the same way (reuse.sh).
#include "tests/embed/readme.h"

#include <gtest/gtest.h>

#include "tests/embed/scratch.h"

namespace
{

struct Section {
    const char *page, *title;
};
const Section window = {"/README.md", "A crowd in your own window"};
const Section embedding = {"/docs/hosts.md", "Embedding"};

std::string environment(const Scratch &home)
{
    const std::string source = CLAQUE_SOURCE_DIR, build = CLAQUE_BUILD_DIR, here = CLAQUE_SOURCE_DIR "/tests/embed/";
    return "export HOME='" + home.path() + "' CMAKE_GENERATOR=Ninja CMAKE_BUILD_TYPE='" CLAQUE_BUILD_TYPE "'\n" +
           "export CFLAGS='" CLAQUE_C_FLAGS "' CXXFLAGS='" CLAQUE_CXX_FLAGS "' ASAN_OPTIONS=detect_leaks=0\n" +
           "export CLAQUE_REUSE_BUILD='" + build + "' CLAQUE_REUSE_SOURCE='" + source + "'\n" +
           "export CMAKE_C_COMPILER_LAUNCHER='" + here + "reuse.sh' CMAKE_CXX_COMPILER_LAUNCHER='" + here +
           "reuse.sh'\n" + "unset MAKEFLAGS MAKELEVEL MFLAGS DESTDIR\n" +
           "make() { command make --no-print-directory -C '" + source + "' -o installed BUILD='" + build +
           "' \"$@\"; }\n" + "cc() { command cc $CFLAGS \"$@\"; }\n" + "alias apt-get=:\n";
}

class Readme : public testing::Test
{
protected:
    // Follows the parts of a section in order. Returns what the last command printed.
    std::string follow(const Section &section, const std::vector<std::string> &parts)
    {
        std::string said;
        for (const std::string &part : parts)
            for (const Block &block :
                 blocks_of(text_of_file(std::string(CLAQUE_SOURCE_DIR) + section.page), section.title)) {
                if (block.part != part) continue;
                ++blocks_;
                if (block.language != "sh") {
                    EXPECT_FALSE(block.file.empty()) << "no file is named for\n" << block.text;
                    home_.write(block.file, block.text);
                    continue;
                }
                const auto [code, printed] = home_.run(environment(home_) + block.text);
                EXPECT_EQ(code, 0) << block.text << printed;
                said = printed;
            }
        return said;
    }

    void expect_a_crowd(const std::string &said)
    {
        EXPECT_NE(said.find("of 100 in view"), std::string::npos) << said;
        EXPECT_EQ(said.find(": 0 of"), std::string::npos) << said;
    }

    Scratch home_;
    int blocks_ = 0;
};

// A program that still draws after five seconds has not failed: it ends with a message at the first call that fails.
TEST_F(Readme, ShowsAProgramThatDrawsInAWindow)
{
    if (home_.run("pkg-config --exists glut").first != 0) GTEST_SKIP() << "needs freeglut (Debian: libglut-dev)";
    follow(window, {""});
    EXPECT_EQ(blocks_, 2);
    if (!has_command("xvfb-run")) GTEST_SKIP() << "compiled, but not run: needs xvfb-run (Debian: xvfb)";
    const auto [code, printed] = home_.run(
        "export LD_LIBRARY_PATH=$PWD/.local/lib ASAN_OPTIONS=detect_leaks=0\n"
        "xvfb-run -a sh -c 'timeout 5 ./window; test $? = 124'");
    EXPECT_EQ(code, 0) << printed;
}

TEST_F(Readme, SaysHowToEmbedWithPkgConfig)
{
    expect_a_crowd(follow(embedding, {"", "With pkg-config"}));
    EXPECT_EQ(blocks_, 3);
}

TEST_F(Readme, SaysHowToEmbedWithCmake)
{
    expect_a_crowd(follow(embedding, {"", "With CMake"}));
    EXPECT_EQ(blocks_, 4);
}

TEST_F(Readme, SaysHowToEmbedClaqueAsAFolder)
{
    ASSERT_EQ(home_.run("ln -s '" CLAQUE_SOURCE_DIR "' claque").first, 0);
    expect_a_crowd(follow(embedding, {"", "As a folder of your project"}));
    EXPECT_EQ(blocks_, 4);
}

}  // namespace

// README.md's section 'Embedding', followed word for word: its files are written, its commands run, each way of embedding in a home
// of its own. Two things stand in for what would take minutes: `make` installs the build that is there instead of making it again
// (`-o build`), and the project that has claque as a folder takes objects from that build wherever it compiles the same source in
// the same way (reuse.sh).
#include <gtest/gtest.h>

#include "tests/embed/readme.h"
#include "tests/embed/scratch.h"

namespace
{

const char *const section = "Embedding";

std::string environment(const Scratch &home)
{
    const std::string source = CLAQUE_SOURCE_DIR, build = CLAQUE_BUILD_DIR, here = CLAQUE_SOURCE_DIR "/tests/embed/";
    return "export HOME='" + home.path() + "' CMAKE_GENERATOR=Ninja CMAKE_BUILD_TYPE='" CLAQUE_BUILD_TYPE "'\n" +
           "export CFLAGS='" CLAQUE_C_FLAGS "' CXXFLAGS='" CLAQUE_CXX_FLAGS "' ASAN_OPTIONS=detect_leaks=0\n" +
           "export CLAQUE_REUSE_BUILD='" + build + "' CLAQUE_REUSE_SOURCE='" + source + "'\n" +
           "export CMAKE_C_COMPILER_LAUNCHER='" + here + "reuse.sh' CMAKE_CXX_COMPILER_LAUNCHER='" + here +
           "reuse.sh'\n" + "unset MAKEFLAGS MAKELEVEL MFLAGS DESTDIR\n" +
           "make() { command make --no-print-directory -C '" + source + "' -o build BUILD='" + build + "' \"$@\"; }\n" +
           "cc() { command cc $CFLAGS \"$@\"; }\n";
}

class Readme : public testing::Test
{
protected:
    // What the parts say, one after the other; what the last command printed.
    std::string follow(const std::vector<std::string> &parts)
    {
        std::string said;
        for (const std::string &part : parts)
            for (const Block &block : blocks_of(text_of_file(CLAQUE_SOURCE_DIR "/README.md"), section)) {
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

TEST_F(Readme, SaysHowToEmbedWithPkgConfig)
{
    expect_a_crowd(follow({"", "With pkg-config"}));
    EXPECT_EQ(blocks_, 3);
}

TEST_F(Readme, SaysHowToEmbedWithCmake)
{
    expect_a_crowd(follow({"", "With CMake"}));
    EXPECT_EQ(blocks_, 4);
}

TEST_F(Readme, SaysHowToEmbedClaqueAsAFolder)
{
    ASSERT_EQ(home_.run("ln -s '" CLAQUE_SOURCE_DIR "' claque").first, 0);
    expect_a_crowd(follow({"", "As a folder of your project"}));
    EXPECT_EQ(blocks_, 4);
}

}  // namespace

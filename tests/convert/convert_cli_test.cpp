// claque convert, as a user sees it where things go wrong.
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/cli/run.h"

namespace convert_test
{
namespace
{

using cli_test::claque;
using cli_test::Outcome;

struct ConvertCommand : cli_test::Command {
    // One sentence on stderr, code 1, and nothing written: what was there stays.
    void expect_refused(const std::string &file, const std::vector<std::string> &words,
                        std::vector<std::string> options = {})
    {
        const std::string out = path("new.glb");
        std::ofstream(out) << "old";
        std::vector<std::string> arguments = {"convert", file, "--out", out};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome done = claque(arguments);
        EXPECT_EQ(done.code, 1) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
        for (const std::string &word : words) EXPECT_NE(done.err.find(word), std::string::npos) << done.err;
        EXPECT_EQ(cli_test::file_text(out), "old");
        for (const std::string &name : left()) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
    }
    std::string file_of(const std::string &name, const std::string &text)
    {
        std::ofstream(path(name)) << text;
        return path(name);
    }
};

#ifdef CLAQUE_HAS_ASSIMP

TEST_F(ConvertCommand, ACrashOfAssimpIsOneSentence)
{
    setenv("ASAN_OPTIONS", "handle_segv=0", 1);  // where it would catch the signal, it would end with a code instead
    // Its JSON reader calls itself for every bracket.
    const std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(4000000, '[');
    expect_refused(file_of("deep.gltf", deep), {"deep.gltf", "Assimp", "crashed", "SEGV"});
}

// A triangle in so many frames inside each other, as X files have them.
std::string frames(int deep)
{
    std::string text = "xof 0303txt 0032\n";
    for (int i = 0; i < deep; ++i) text += "Frame f" + std::to_string(i) + " {\n";
    text += "Mesh m { 3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,1,2;; }\n";
    for (int i = 0; i < deep; ++i) text += "}\n";
    return text;
}

TEST_F(ConvertCommand, NodesThatAreNestedTooDeepAreOneSentence)
{
    const Outcome done = claque({"convert", file_of("chain.x", frames(400)), "--out", path("chain.glb")});
    EXPECT_EQ(done.code, 0) << done.err;
    expect_refused(file_of("deep.x", frames(600)), {"deep.x", "its nodes are nested too deep"});
}

TEST_F(ConvertCommand, RefusesANameOfAnotherFormatForItsGlb)
{
    const Outcome outcome = claque({"convert", path("a.fbx"), "--out", path("b.fbx")});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("b.fbx' would hold a GLB, so its name must end in .glb"), std::string::npos)
        << outcome.err;
}

TEST_F(ConvertCommand, WhatIsNoModelIsRefusedByName)
{
    expect_refused(file_of("notes.txt", "nothing"), {"notes.txt", "Assimp"});
    expect_refused(file_of("empty.obj", ""), {"empty.obj"});
    expect_refused(path("missing.fbx"), {"missing.fbx"});
    const std::string converter = "OgreXMLConverter (package ogre-1.12-tools)";
    expect_refused(file_of("man.mesh", std::string("\0\x10[MeshSerializer_v1.100]", 25)), {"by Assimp: ", converter});
    EXPECT_EQ(claque({"convert", file_of("text.mesh", "nothing"), "--out", path("new.glb")}).err.find(converter),
              std::string::npos);
}

TEST_F(ConvertCommand, MoreMemoryThanAllowedIsOneSentence)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers reserve more address space than any limit";
#endif
    std::string large;
    for (int i = 0; i < 400000; ++i) large += "v 0 0 " + std::to_string(i) + "\n";
    for (int i = 1; i < 399999; ++i)
        large += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
    expect_refused(file_of("large.obj", large), {"large.obj"}, {"--memory", "64"});
}

#else

TEST_F(ConvertCommand, NamesThePackageThatIsMissing)
{
    expect_refused(file_of("bar.obj", "v 0 0 0\n"), {"bar.obj", "libassimp-dev"});
}

#endif

}  // namespace
}  // namespace convert_test

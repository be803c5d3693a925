// No file runs code: the libraries that the command opens for any file are those that it opens without one.
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/cli/run.h"
#include "tests/support/written_characters.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

using Words = std::vector<std::string>;
using Names = std::set<std::string>;

const fs::path whole_tree = CLAQUE_SOURCE_DIR, cases = whole_tree.parent_path() / "shared/cases";

class LoadedCode : public Drawing
{
protected:
    Outcome run(const Words &words, Names &opened, const std::string &program = CLAQUE_COMMAND) const
    {
        const std::string notes = path("notes");
        fs::remove(notes);
        setenv("CLAQUE_NOTED_DLOPEN", notes.c_str(), 1);
        setenv("LD_PRELOAD", CLAQUE_NOTES_DLOPEN, 1);
        setenv("ASAN_OPTIONS", "intercept_tls_get_addr=0:verify_asan_link_order=0", 1);
        Words all = {program};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = run_program(all);
        unsetenv("LD_PRELOAD");
        std::stringstream lines(file_text(notes));
        for (std::string line; std::getline(lines, line);) opened.insert(line);
        return outcome;
    }
    Names opened_by(const Words &words) const
    {
        Names opened;
        run(words, opened);
        return opened;
    }
    static Words with(Words words, const std::string &file)
    {
        for (std::string &word : words)
            if (word == "FILE") word = file;
        return words;
    }
    // Files of a folder, those of one ending or all.
    static std::vector<fs::path> files_of(const fs::path &folder, const std::string &ending = "")
    {
        std::vector<fs::path> found;
        if (!fs::exists(folder)) return found;
        for (const auto &entry : fs::directory_iterator(folder))
            if (entry.is_regular_file() && (ending.empty() || entry.path().extension() == ending))
                found.push_back(entry.path());
        return found;
    }
    // `words` with each file open what `without` opens at most. A file is read under a name of this ending.
    void expect_no_more(const Words &words, const Words &without, const std::vector<fs::path> &files,
                        const std::string &ending = "") const
    {
        const Names usual = opened_by(without);
        for (const fs::path &file : files) {
            std::string read = file.string();
            if (!ending.empty()) {
                read = path("input" + ending);
                fs::copy_file(file, read, fs::copy_options::overwrite_existing);
            }
            for (const std::string &name : opened_by(with(words, read)))
                EXPECT_EQ(usual.count(name), 1u) << name << " is opened for " << file;
        }
    }
    // A scenario of a herald that names a mechanism in its eighth line.
    std::string naming(const std::string &mechanism) const
    {
        std::ofstream(path("named.toml"))
            << "name = 'named'\n[[characters]]\nname = 'h'\ncharacter = 'herald'\n"
            << "[[people]]\nclass = 'h'\nat = [0, 0, 0]\nmechanism = '" << mechanism << "'\n";
        return path("named.toml");
    }
    Words drawn(Words first) const
    {
        first.insert(first.end(), {"--size", "16x12", "--out", path("p.png")});
        return first;
    }
};

TEST_F(LoadedCode, IsNoneThatAScenarioNames)
{
    fs::create_directory(path("sub"));
    fs::copy_file(CLAQUE_NOD, path("evil.so"));
    fs::copy_file(CLAQUE_NOD, path("sub/evil.so"));
    std::ofstream(path("wait.toml")) << "steps = ['wait 0.1']\n";
    const std::string file = path("named.toml");
    const std::vector<Words> commands = {
        drawn({"render", "--scenario", file}),
        drawn({"sheet", "--scenario", file}),
        {"labels", "--scenario", file, "--frames", "0:1", "--out", path("labels")},
        {"bench", "--scenario", file, "--frames", "1"},
        {"parity", "export", "--scenario", file, "--size", "16x12", "--out", path("scene")},
        {"colours", "save", "--scenario", file, "--out", path("c.toml")},
#ifdef CLAQUE_STAGED
        {"stage", file},
#endif
#ifdef CLAQUE_VIEWED
        {"view", file, "--script", path("wait.toml"), "--size", "64x48"},
#endif
    };
    for (const std::string &name : {std::string("evil.so"), std::string("sub/../evil.so"), path("sub/evil.so")}) {
        naming(name);
        for (const Words &words : commands) {
            Names opened;
            const Outcome outcome = run(words, opened);
            EXPECT_EQ(outcome.code, 1) << words[0] << outcome.err;
            for (const std::string &one : opened) EXPECT_EQ(one.find("evil"), std::string::npos) << words[0];
            EXPECT_NE(outcome.err.find(file + ":8:13: the mechanism " + name + " is not loaded"), std::string::npos)
                << words[0] << ": " << outcome.err;
            EXPECT_NE(outcome.err.find("--allow-mechanisms FOLDER"), std::string::npos) << outcome.err;
        }
    }
}

TEST_F(LoadedCode, IsThatOfTheFolderThatTheCommandAllows)
{
    fs::create_directory(path("trusted"));
    fs::create_directory(path("other"));
    fs::copy_file(CLAQUE_NOD, path("trusted/nod.so"));
    fs::create_symlink(CLAQUE_NOD, path("trusted/link.so"));
    fs::copy_file(CLAQUE_NOD, path("other/nod.so"));
    const Words words =
        drawn({"render", "--allow-mechanisms", path("trusted"), "--scenario", naming("trusted/nod.so")});
    Names opened;
    Outcome outcome = run(words, opened);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(opened.count(fs::canonical(path("trusted/nod.so"))), 1u) << "the counter counts";
    for (const char *name : {"other/nod.so", "trusted/link.so", "trusted/../other/nod.so"}) {
        naming(name);
        opened.clear();
        outcome = run(words, opened);
        EXPECT_EQ(outcome.code, 1) << name;
        EXPECT_NE(outcome.err.find("which is not in"), std::string::npos) << outcome.err;
        for (const std::string &one : opened) EXPECT_EQ(one.find("nod.so"), std::string::npos) << one;
    }
}

#ifdef CLAQUE_VIEWED
TEST_F(LoadedCode, IsNeverThatOfADropOrOfAServedWindow)
{
    fs::copy_file(CLAQUE_NOD, path("nod.so"));
    naming("nod.so");
    std::ofstream(path("drop.toml")) << "steps = ['drop \"" << path("named.toml")
                                     << "\"', 'wait 0.1', 'see \"only --allow-mechanisms\"']\n";
    Names opened;
    const Outcome dropped = run({"view", "--scene", "parade", "--count", "1", "--allow-mechanisms", path(""),
                                 "--script", path("drop.toml"), "--size", "640x480"},
                                opened);
    EXPECT_EQ(dropped.code, 0) << dropped.err;
    const Outcome served = run({"view", path("named.toml"), "--allow-mechanisms", path(""), "--serve"}, opened);
    EXPECT_EQ(served.code, 2);
    EXPECT_NE(served.err.find("--allow-mechanisms excludes --serve"), std::string::npos) << served.err;
    for (const std::string &one : opened) EXPECT_EQ(one.find("nod.so"), std::string::npos) << one;
}
#endif

TEST_F(LoadedCode, IsTheUsualForEveryScenario)
{
    std::vector<fs::path> scenarios = files_of(whole_tree / "samples/scenarios", ".toml");
    scenarios.push_back(whole_tree / "samples/scenes/odeon/odeon.toml");
    fs::copy(whole_tree / "samples/scenarios/evacuation", path("evacuation"), fs::copy_options::recursive);
    for (const fs::path &file : files_of(cases / "stage")) fs::copy_file(file, path(file.filename()));
    for (const fs::path &file : files_of(path(""), ".toml")) scenarios.push_back(file);
    EXPECT_GE(scenarios.size(), 6u);
    const Words without = drawn({"render", "--scene", "parade", "--count", "1"});
    EXPECT_FALSE(opened_by(without).empty()) << "a context comes from a library";
    expect_no_more(drawn({"render", "--scenario", "FILE", "--time", "0"}), without, scenarios);
    const std::vector<fs::path> corpus = files_of(whole_tree / "tests/fuzz/corpus/toml");
    EXPECT_GE(corpus.size(), 20u);
    expect_no_more(drawn({"render", "--scenario", "FILE", "--time", "0"}), without, corpus, ".toml");
}

TEST_F(LoadedCode, IsTheUsualForEveryCharacterPictureClipAndTrack)
{
    const fs::path corpus = whole_tree / "tests/fuzz/corpus";
    const std::string person = written::folder() + "WrittenPerson.glb";
    const Words inspect = {"inspect", "citizen"};
    expect_no_more({"inspect", "FILE"}, inspect, files_of(corpus / "gltf"), ".glb");
    expect_no_more({"inspect", "FILE"}, inspect, files_of(corpus / "prepared"), ".clq");
    expect_no_more({"inspect", "FILE"}, inspect, files_of(cases / "characters", ".glb"));
    expect_no_more({"inspect", person, "--clips", "FILE"}, inspect, files_of(corpus / "bvh"), ".bvh");
    expect_no_more({"prepare", person, "--zones", "FILE", "--out", path("p.clq")}, inspect, files_of(corpus / "image"),
                   ".png");
    expect_no_more({"tracks", "FILE"}, inspect, files_of(corpus / "trajectories"), ".csv");
    expect_no_more({"tracks", "FILE"}, inspect, files_of(cases / "tracks"));
    expect_no_more({"tracks", "FILE"}, inspect, files_of(whole_tree / "samples/scenarios", ".csv"));
    expect_no_more({"colours", "save", "FILE", "--out", path("c.toml")}, inspect,
                   files_of(whole_tree / "samples/maps"));
}

#ifdef CLAQUE_REPLAY
// Saves, records, areas, machines, calls and so on, which libraries read.
TEST_F(LoadedCode, IsTheUsualForTheCorporaOfAllReaders)
{
    Names usual, opened;
    EXPECT_EQ(run({"--gtest_filter=None"}, usual, CLAQUE_REPLAY).code, 0);
    const Outcome replayed = run({"--gtest_filter=*Corpus.*"}, opened, CLAQUE_REPLAY);
    EXPECT_EQ(replayed.code, 0) << replayed.out;
    EXPECT_NE(replayed.out.find("record"), std::string::npos) << replayed.out;
    EXPECT_EQ(opened, usual);
}
#endif

}  // namespace
}  // namespace cli_test

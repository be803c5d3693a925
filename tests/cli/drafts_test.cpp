// Files that take the place of others: they keep owner and mode, and one that cannot be whole is a sentence.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class Drafts : public Command
{
protected:
    void SetUp() override
    {
        setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
        std::ofstream table(path("few.csv"));
        table << "id,frame,x,y\n";
        for (int frame = 0; frame < 50; ++frame) table << "1," << frame << "," << 0.1 * frame << ",0\n";
    }

    Words play(const std::string &out) const
    {
        return {"play",   path("few.csv"), "--columns", "id,frame,x,y", "--rate",   "10", "--unit", "m",
                "--size", "32x24",         "--frames",  "0:3",          "--record", out,  "--out",  path("f-%d.png")};
    }

    static mode_t mode_of(const std::string &file)
    {
        struct stat facts = {};
        EXPECT_EQ(stat(file.c_str(), &facts), 0) << file;
        return facts.st_mode & 07777;
    }

    // Runs a command of which no file may have more than so many half KiB.
    static Outcome small_files(const Words &words, const char *most = "8")
    {
        Words all = {"sh", "-c", "ulimit -f " + std::string(most) + "; exec \"$@\"", "sh", CLAQUE_COMMAND};
        all.insert(all.end(), words.begin(), words.end());
        return run_program(all);
    }
};

TEST_F(Drafts, KeepTheModeOfTheFileWhosePlaceTheyTake)
{
    const std::string out = path("out.npy");
    const mode_t mask = umask(022);
    for (const mode_t mode : {0600u, 0640u, 0664u}) {
        std::ofstream(out) << "older";
        ASSERT_EQ(chmod(out.c_str(), mode), 0);
        ASSERT_EQ(claque({"dump", "citizen", "--out", out}).code, 0);
        EXPECT_EQ(mode_of(out), mode);
        EXPECT_GT(fs::file_size(out), 1000u);
    }
    fs::remove(out);
    ASSERT_EQ(claque({"dump", "citizen", "--out", out}).code, 0);
    EXPECT_EQ(mode_of(out), 0644u) << "of a new file";
    umask(mask);
}

TEST_F(Drafts, KeepTheOwnerWhereTheSystemAllowsIt)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root gives files away, and this is user " << geteuid();
    const std::string out = path("out.npy");
    std::ofstream(out) << "older";
    ASSERT_EQ(chown(out.c_str(), 1234, 5678), 0) << std::strerror(errno);
    ASSERT_EQ(claque({"dump", "citizen", "--out", out}).code, 0);
    struct stat facts = {};
    ASSERT_EQ(stat(out.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_uid, 1234u);
    EXPECT_EQ(facts.st_gid, 5678u);
}

TEST_F(Drafts, BeyondTheLimitOfFilesAreASentence)
{
    const std::string out = path("out.clq");
    for (const Words &words : {Words{"prepare", "citizen", "--out", out}, Words{"dump", "citizen", "--out", out}}) {
        const Outcome done = small_files(words);
        EXPECT_EQ(done.code, 1) << words[0] << " ends by the signal " << done.signal;
        EXPECT_EQ(done.err, "claque: " + out + " could not be written: File too large.\n");
    }
    for (const auto &[name, text] : contents("")) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
    EXPECT_FALSE(fs::exists(out));
    const Outcome said = small_files({"inspect", "citizen", "--json"});
    EXPECT_EQ(said.code, 1) << "ends by the signal " << said.signal;
    EXPECT_NE(said.err.find("standard output could not be written"), std::string::npos) << said.err;
}

TEST_F(Drafts, OfRecordsAreAsThoseOfOtherFiles)
{
    const std::string why = why_no_context("any");
    if (!why.empty()) GTEST_SKIP() << why;
    const std::string out = path("run.clt");
    std::ofstream(out) << "older";
    ASSERT_EQ(chmod(out.c_str(), 0600), 0);
    ASSERT_EQ(claque(play(out)).code, 0);
    EXPECT_EQ(mode_of(out), 0600u);
    EXPECT_GT(fs::file_size(out), 1000u);
    std::ofstream(out) << "older";
    const Outcome done = small_files(play(out), "2");
    EXPECT_EQ(done.code, 1) << "ends by the signal " << done.signal;
    EXPECT_EQ(file_text(out), "older");
    for (const auto &[name, text] : contents("")) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
}

}  // namespace
}  // namespace cli_test

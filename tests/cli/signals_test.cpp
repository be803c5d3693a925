// Signals and outputs that cannot be written: the command ends at once by the signal, as a shell expects, and leaves no
// file that was not there.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sys/wait.h>
#include <thread>

#include "tests/cli/run.h"
#include "tests/cli/running.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Contents = std::map<std::string, std::string>;  // contents by name

class Signals : public Command
{
protected:
    void SetUp() override
    {
        // Prepared templates would go into the user's own folder.
        setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    }

    // Sends the signal at several moments of a command that takes `whole_ms` or longer. Returns how often it was still
    // running.
    int interrupt(const Words &words, int number, double whole_ms, const Contents &whole)
    {
        int interrupted = 0;
        for (const double share : {0.1, 0.4, 0.8}) {
            Running running(words);
            std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(share * whole_ms));
            const Ended end = running.end_by(number);
            const int state = end.state;
            EXPECT_LE(end.cpu_s, end.most_s) << words[0] << " goes on after the signal";
            // Where the machine was quicker this time, the command had ended before the signal, even if only just.
            const bool ended = WIFEXITED(state) && WEXITSTATUS(state) == 0;
            EXPECT_TRUE(ended || (WIFSIGNALED(state) && WTERMSIG(state) == number))
                << words[0] << " " << words[1] << " after " << share * whole_ms << " ms: " << state;
            interrupted += !ended;
            const Contents left = left_files();
            EXPECT_TRUE(!ended || left.size() == whole.size()) << words[0] << " exits with 0 and leaves too little";
            for (const auto &[name, text] : left) expect_whole(name, text, whole, words);
        }
        return interrupted;
    }

    // A command that was about to end may have completed its output: the same as that of the run to the end.
    static void expect_whole(const std::string &name, const std::string &text, const Contents &whole,
                             const Words &words)
    {
        const auto same = whole.find(name);
        ASSERT_NE(same, whole.end()) << words[0] << " leaves " << name;
        if (words[0] == "bench") {  // which has times
            EXPECT_EQ(text.substr(text.size() - std::min<size_t>(text.size(), 2)), "}\n") << words[0];
        } else {
            EXPECT_TRUE(text == same->second) << words[0] << " leaves a part of " << name;
        }
    }

    // Takes away the files that a command left, by their paths: all but the cache of prepared templates, whose finished
    // entries are whole, and the chart.
    Contents left_files() const
    {
        Contents files;
        for (const auto &entry : fs::recursive_directory_iterator(path(""))) {
            const std::string name = fs::relative(entry.path(), path("")).string();
            const bool cached = name.compare(0, 5, "cache") == 0 && entry.path().extension() != ".part";
            if (cached || name == "chart") continue;
            files[name] = entry.is_directory() ? "" : file_text(entry.path());
        }
        for (const auto &[name, text] : files) fs::remove_all(path(name));
        return files;
    }

    void write_chart() const
    {
        std::ofstream chart(path("chart"));
        chart << R"({"kind": "lines", "title": "t", "series": [)";
        for (int line = 0; line < 16; ++line) {
            chart << (line > 0 ? ", " : "") << R"({"name": "s", "points": [)";
            for (int point = 0; point < 20000; ++point)
                chart << (point > 0 ? ", " : "") << "[" << point << ", " << (point * 7 + line) % 101 << "]";
            chart << "]}";
        }
        chart << "]}";
    }

    std::vector<Words> commands() const
    {
        const std::string png = path("out.png"), json = path("out.json");
        return {
            {"render", "--scene", "ten_thousand", "--count", "400", "--size", "1600x1200", "--out", png},
            {"sheet", "--out", png},
            {"inspect", "citizen", "--json"},
            {"dump", "citizen", "--out", path("out.npy")},
            {"split", "citizen", "--picture", png},
            {"variety", "citizen", "--out", png},
            {"colours", "classes", "--out", png},
            {"lods", "patrician", "--out", png},
            {"blend", "citizen", "--out", png},
            {"prepare", "patrician", "--out", path("out.claque")},
            {"bench", "ten_thousand", "--count", "500", "--frames", "40", "--save", json},
            {"plot", path("chart"), "--out", path("out.svg")},
            {"cost", "--json", json},
            {"parity", "capture", "ten_thousand", "--count", "200", "--size", "1600x1200", "--out", path("capture")},
            {"parity", "export", "ten_thousand", "--count", "200", "--size", "1600x1200", "--out", path("scene")}};
    }
};

TEST_F(Signals, EndEverySubcommandAtOnceAndLeaveNothing)
{
    write_chart();
    int tries = 0, interrupted = 0;
    for (const Words &words : commands()) {
        const Clock::time_point begin = Clock::now();
        EXPECT_EQ(claque(words).code, 0) << words[0];
        const double whole_ms =
            std::min(600.0, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
        const Contents whole = left_files();
        for (const int number : {SIGINT, SIGTERM}) interrupted += interrupt(words, number, whole_ms, whole), tries += 3;
    }
    EXPECT_GT(interrupted, tries / 2) << "the commands ended too early: this test saw too little";
}

TEST_F(Signals, ThatAreIgnoredStayIgnored)
{
    struct sigaction ignored = {}, before = {};
    ignored.sa_handler = SIG_IGN;
    sigaction(SIGHUP, &ignored, &before);
    {
        Running running({"lods", "citizen", "--targets", "600"});
        sigaction(SIGHUP, &before, nullptr);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        if (!running.has_ended()) running.send(SIGHUP);
        const int state = running.wait_for_end();
        EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0) << state;
    }
}

TEST_F(Signals, AFileWhereAFolderIsExpectedIsNamed)
{
    std::ofstream(path("file")) << "x";
    const std::string out = path("file") + "/out.png";
    for (const Words &words : {Words{"lods", "citizen", "--out", out}, Words{"blend", "citizen", "--out", out},
                               Words{"sheet", "--out", out}, Words{"split", "citizen", "--picture", out}}) {
        const Outcome done = claque(words);
        EXPECT_EQ(done.code, 1) << words[0];
        EXPECT_NE(done.err.find(out + " could not be written: " + path("file") + " is not a folder"), std::string::npos)
            << done.err;
    }
    EXPECT_EQ(file_text(path("file")), "x");
}

}  // namespace
}  // namespace cli_test

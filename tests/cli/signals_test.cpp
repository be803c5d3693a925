// Signals and outputs that cannot be written: the command ends at once by the signal, as a shell expects, and leaves no
// file that was not there.
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <map>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/cli/run.h"

extern char **environ;

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;
using Contents = std::map<std::string, std::string>;  // contents by name

// A command that runs while the test goes on.
class Running
{
public:
    // out: a file descriptor for its standard output; -1: /dev/null.
    explicit Running(const Words &words, int out = -1)
    {
        std::vector<char *> argv = {const_cast<char *>(CLAQUE_COMMAND)};
        for (const std::string &word : words) argv.push_back(const_cast<char *>(word.c_str()));
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        if (out < 0) posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
        else posix_spawn_file_actions_adddup2(&actions, out, 1);
        posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t usual;  // as a shell starts it: a test's own parent may ignore some
        sigemptyset(&usual);
        for (const int number : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&usual, number);
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
        if (posix_spawn(&child_, CLAQUE_COMMAND, &actions, &attributes, argv.data(), environ) != 0) child_ = 0;
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }
    ~Running()
    {
        if (child_ > 0) kill(child_, SIGKILL), wait_for_end();
    }
    Running(const Running &) = delete;
    Running &operator=(const Running &) = delete;

    bool has_ended()
    {
        if (child_ > 0 && waitpid(child_, &state_, WNOHANG) == child_) child_ = 0;
        return child_ == 0;
    }
    void send(int number) const { kill(child_, number); }
    int wait_for_end()
    {
        if (child_ > 0) waitpid(child_, &state_, 0);
        child_ = 0;
        return state_;
    }

private:
    pid_t child_ = 0;
    int state_ = 0;
};

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
            running.send(number);
            const int state = running.wait_for_end();
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
    // entries are whole, and the pipe.
    Contents left_files() const
    {
        Contents files;
        for (const auto &entry : fs::recursive_directory_iterator(path(""))) {
            const std::string name = fs::relative(entry.path(), path("")).string();
            const bool cached = name.compare(0, 5, "cache") == 0 && entry.path().extension() != ".part";
            if (cached || name == "pipe") continue;
            files[name] = entry.is_directory() ? "" : file_text(entry.path());
        }
        for (const auto &[name, text] : files) fs::remove_all(path(name));
        return files;
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
            {"plot", path("pipe"), "--out", path("out.svg")},
            {"cost", "--json", json},
            {"parity", "capture", "ten_thousand", "--count", "200", "--size", "1600x1200", "--out", path("capture")},
            {"parity", "export", "ten_thousand", "--count", "200", "--size", "1600x1200", "--out", path("scene")}};
    }
};

TEST_F(Signals, EndEverySubcommandAtOnceAndLeaveNothing)
{
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);  // opening it waits for a writer
    int tries = 0, interrupted = 0;
    for (const Words &words : commands()) {
        double whole_ms = 100;
        Contents whole;
        if (words[0] != "plot") {  // which waits
            const Clock::time_point begin = Clock::now();
            EXPECT_EQ(claque(words).code, 0) << words[0];
            whole_ms = std::min(600.0, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
            whole = left_files();
        }
        for (const int number : {SIGINT, SIGTERM}) interrupted += interrupt(words, number, whole_ms, whole), tries += 3;
    }
    EXPECT_GT(interrupted, tries / 2) << "the commands ended too early: this test saw too little";
}

// Nothing but the signal ends this one within hours: it needs no poll.
TEST_F(Signals, EndALongCommandThatNothingPolls)
{
    Running running({"bench", "ten_thousand", "--count", "2000", "--frames", "100000"});
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    ASSERT_FALSE(running.has_ended());
    running.send(SIGINT);
    const int state = running.wait_for_end();
    EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == SIGINT) << state;
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

TEST_F(Signals, ABrokenPipeEndsTheCommandSilently)
{
    for (const Words &words : {Words{"inspect", "citizen", "--json"}, Words{"cost"}, Words{"--help"}}) {
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        close(ends[0]);  // nothing reads
        Running running(words, ends[1]);
        close(ends[1]);
        const int state = running.wait_for_end();
        EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == SIGPIPE) << words[0] << ": " << state;
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

// Signals to commands that run for long: each ends by the signal with no more than a tenth of a second of work on each
// processor, wherever it is, and what it leaves is whole.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/cli/running.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

const std::string samples = std::string(CLAQUE_SOURCE_DIR) + "/samples/";

// What each of these writes at its end, so that nothing of it may be there before; or pictures one by one.
struct Long {
    Words words;
    double cap_s = 20;       // of the clock, before a signal is sent to a command that waits for others
    const char *draft = "";  // how a file begins that has to be there before
};

class SignalsAnywhere : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        if (IsSkipped()) return;
        setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
        for (const char *folder : {"in", "out"}) fs::create_directories(path(folder));
        search_ = std::getenv("PATH");
        setenv("PATH", (path("in") + ":" + search_).c_str(), 1);
    }
    void TearDown() override { setenv("PATH", search_.c_str(), 1); }
    std::string in(const std::string &name) const { return path("in") + "/" + name; }
    std::string out(const std::string &name) const { return path("out") + "/" + name; }

    void write_people(const char *name, int people) const
    {
        std::ofstream table(in(name));
        table << "id,frame,x,y\n";
        for (int frame = 0; frame < 600; ++frame)
            for (int person = 0; person < people; ++person)
                table << person << "," << frame << "," << 0.1 * frame << "," << 0.7 * person << "\n";
    }

    // Large enough that a processor of several times the usual speed still works on them when a signal comes.
    void write_inputs() const
    {
        std::ofstream(in("steps.toml")) << "steps = ['wait 3600']\n";
        std::ofstream(in("film.toml")) << "steps = ['key tab', 'click \"film\"', 'wait 3600']\n";
        std::ofstream(in("ffmpeg")) << "#!/bin/sh\nfor last; do :; done\nexec /bin/cat > \"$last\"\n";
        fs::permissions(in("ffmpeg"), fs::perms::owner_all);
        write_people("crowd.csv", 1200);
        write_people("few.csv", 10);
        std::ofstream grid(in("grid.obj"));
        constexpr int side = 600;
        for (int i = 0; i < side * side; ++i)
            grid << "v " << i % side << " " << i / side << " " << i % 7 << "\nvn 0 0 1\nvt 0." << i << " 0\n";
        for (int i = 0; i < (side - 1) * side; ++i)
            if (i % side < side - 1)
                for (const auto &[b, c] : {std::pair(i + 1, i + side + 1), std::pair(i + side + 1, i + side)})
                    grid << "f " << i + 1 << "/" << i + 1 << "/1 " << b + 1 << "/" << b + 1 << "/1 " << c + 1 << "/"
                         << c + 1 << "/1\n";
        grid.close();
        EXPECT_EQ(claque({"parity", "capture", "plaza", "--size", "1600x1200", "--out", in("capture")}).code, 0);
        EXPECT_EQ(claque({"render", "--scene", "plaza", "--count", "1", "--size", "32x24", "--frames", "0:1", "--out",
                          in("f-%d.png"), "--manifest", in("film.json")})
                      .code,
                  0);
        fs::resize_file(in("f-1.png"), uintmax_t{700} << 20);  // takes long to hash
    }

    std::vector<Long> commands() const
    {
        const Words film = {"--size", "320x240", "--frames", "0:9999", "--out", out("f-%04d.png")};
        const Words table = {"--columns", "id,frame,x,y", "--rate", "10", "--unit", "m"};
        const std::string stage = samples + "scenarios/evacuation.toml";
        const auto with = [](Words first, const Words &more) {
            first.insert(first.end(), more.begin(), more.end());
            return first;
        };
        return {
            {with({"render", "--scene", "plaza", "--count", "60"}, film)},
            {with({"render", "--scene", "plaza", "--count", "60", "--processes", "2", "--divide", "tiles"}, film), 1},
            {with({"render", "--scenario", samples + "scenarios/corridor.toml"}, film)},
            {{"sheet", "--size", "1600x1200", "--out", out("sheet.png")}},
            {{"labels", "--scene", "plaza", "--frames", "0:9999", "--out", out("labels")}},
            {{"labels", "--scene", "plaza", "--frames", "0:9999", "--processes", "2", "--out", out("labels")}, 1},
            {with(with({"play", in("few.csv")}, table), with({"--record", out("run.clt")}, film)), 20, "run.clt.part"},
            {with(with({"tracks", in("crowd.csv")}, table), {"--plot", out("plan.svg")})},
            {{"stage", stage, "--fps", "100", "--record", out("run.clt"), "--size", "320x240", "--frames", "0:7000",
              "--out", out("f-%04d.png")},
             20,
             "run.clt.part"},
            {{"view", "--size", "320x240", "--script", in("steps.toml"), "--shots", path("out")}},
            {{"view", "--size", "640x480", "--scene", "parade", "--count", "2", "--script", in("film.toml"), "--shots",
              path("out")},
             20,
             "view-1.part"},
            {{"bench", "ten_thousand", "--count", "2000", "--frames", "100000", "--save", out("bench.json")}},
            {{"bench", "readers", "--count", "10000", "--save", out("bench.json")}},
            {{"bench", "keypose-path", "--save", out("bench.json")}},
            {{"bench", "growth", "--save", out("bench.json")}},
            {{"lods", "patrician", "--compare"}},
            {{"parity", "compare", in("capture"), in("capture"), "--html", out("compare.html")}},
            {{"frames", "check", path("in")}},
            {{"convert", in("grid.obj"), "--out", out("grid.glb")}, 0.2}};
    }

    bool is_begun(const std::string &draft) const
    {
        const fs::directory_iterator files(path("out"));
        return draft.empty() || std::any_of(begin(files), end(files), [&](const fs::directory_entry &file) {
                   return file.path().filename().string().rfind(draft, 0) == 0;
               });
    }

    // Pictures and JSON one by one are whole; nothing else may be there, and nothing beside its place.
    void expect_whole_files(const Words &words) const
    {
        const auto ends_with = [](const std::string &text, const std::string &end) {
            return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
        };
        const auto all = contents("out");
        for (const auto &[name, text] : all) {
            SCOPED_TRACE(words[0] + " leaves " + name);
            EXPECT_EQ(name.find(".part"), std::string::npos);
            if (ends_with(name, ".png")) EXPECT_TRUE(ends_with(text, "IEND\xae\x42\x60\x82"));
            else if (ends_with(name, ".json")) EXPECT_FALSE(nlohmann::json::parse(text, nullptr, false).is_discarded());
            else ADD_FAILURE() << "the command was not done";
        }
        for (const auto &entry : fs::recursive_directory_iterator(path("out")))
            EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }

    void interrupt(const Long &one, int number, double cpu_s)
    {
        std::string all;
        for (const std::string &word : one.words) all += word + " ";
        SCOPED_TRACE(all);
        Running running(one.words);
        running.work_until(cpu_s, one.cap_s);
        for (int waits = 0; waits < 6000 && !is_begun(one.draft); ++waits) usleep(5000);
        ASSERT_TRUE(is_begun(one.draft));
        ASSERT_FALSE(running.has_ended()) << "it ended by itself, as " << running.wait_for_end();
        const Ended end = running.end_by(number);
        EXPECT_TRUE(WIFSIGNALED(end.state) && WTERMSIG(end.state) == number) << end.state;
        EXPECT_FALSE(end.killed) << "the signal did not end it";
        EXPECT_LE(end.cpu_s, end.most_s) << "after " << cpu_s << " s";
        longest_ms_ = std::max(longest_ms_, end.wall_ms);
        longest_cpu_s_ = std::max(longest_cpu_s_, end.cpu_s);
        expect_whole_files(one.words);
        fs::remove_all(path("out"));
        fs::create_directories(path("out"));
    }

    std::set<std::string> subcommands() const
    {
        const std::string said = claque({}).err, before = "there are: ";
        std::istringstream list(said.substr(said.find(before) + before.size()));
        std::set<std::string> names;
        for (std::string name; list >> name && name != "Run";) names.insert(name.substr(0, name.find(',')));
        return names;
    }

    double longest_ms_ = 0, longest_cpu_s_ = 0;
    std::string search_;
};

// Where the build lacks Recast there is no `stage`.
TEST_F(SignalsAnywhere, EndEveryLongCommandAndLeaveOnlyWhatIsWhole)
{
    write_inputs();
    const std::set<std::string> known = subcommands();
    for (const Long &one : commands())
        if (known.count(one.words[0])) {
            interrupt(one, SIGINT, 0.1);
            interrupt(one, SIGTERM, 0.5);
        }
    RecordProperty("longest_ms", std::to_string(longest_ms_));
    RecordProperty("longest_cpu_s", std::to_string(longest_cpu_s_));
}

// The encoder is another process. It opens its file when the command has ended.
TEST_F(SignalsAnywhere, LeaveNothingOfAFilmWhoseEncoderIsLate)
{
    std::ofstream(in("film.toml")) << "steps = ['key tab', 'click \"film\"', 'wait 3600']\n";
    std::ofstream(in("ffmpeg")) << "#!/bin/sh\nfor last; do :; done\n: > '" << in("begun") << "'\nwhile [ ! -e '"
                                << in("ended") << "' ]; do sleep 0.01; done\necho film > \"$last\"\n: > '"
                                << in("written") << "'\n";
    fs::permissions(in("ffmpeg"), fs::perms::owner_all);
    const auto wait_for = [&](const char *name) {
        for (int waits = 0; waits < 6000 && !fs::exists(in(name)); ++waits) usleep(5000);
        return fs::exists(in(name));
    };
    Running running({"view", "--size", "640x480", "--scene", "parade", "--count", "2", "--script", in("film.toml"),
                     "--shots", path("out")});
    ASSERT_TRUE(wait_for("begun"));
    ASSERT_FALSE(running.has_ended());
    running.end_by(SIGINT);
    std::ofstream(in("ended")) << "\n";
    ASSERT_TRUE(wait_for("written"));
    EXPECT_TRUE(contents("out").empty());
}

// Others are done in a second: Signals.EndEverySubcommandAtOnceAndLeaveNothing ends these.
TEST_F(SignalsAnywhere, KnowEverySubcommand)
{
    std::set<std::string> here = {"inspect", "dump", "split", "variety", "colours", "blend", "prepare", "plot", "cost"};
    for (const Long &one : commands()) here.insert(one.words[0]);
    const std::set<std::string> known = subcommands();
    EXPECT_GT(known.size(), 18u);
    for (const std::string &name : known) EXPECT_EQ(here.count(name), 1u) << name;
}

// The numbers that C libraries keep for themselves cannot be sent. SIGXFSZ is ignored: Drafts.BeyondTheLimitOfFiles...
TEST_F(SignalsAnywhere, OfEveryKindEndTheCommandAndLeaveNothing)
{
    write_people("few.csv", 10);
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const std::set<int> others = {SIGKILL, SIGSTOP, SIGXFSZ, SIGCHLD, SIGCONT,
                                  SIGTSTP, SIGTTIN, SIGTTOU, SIGURG,  SIGWINCH};
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // which end the process by themselves
    const std::set<int> faults = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS, SIGTRAP};
#else
    const std::set<int> faults;
#endif
    const Words record = {"play",     in("few.csv"), "--columns", "id,frame,x,y",   "--rate", "10",
                          "--unit",   "m",           "--record",  out("run.clt"),   "--size", "32x24",
                          "--frames", "0:9999",      "--out",     out("f-%04d.png")};
    Words first = record;  // which prepares the people
    first[first.size() - 3] = "0:1";
    EXPECT_EQ(claque(first).code, 0);
    fs::remove_all(path("out")), fs::create_directories(path("out"));
    std::vector<int> numbers = {SIGRTMIN, SIGRTMAX};
    for (int number = 1; number < 32; ++number)
        if (others.count(number) == 0 && faults.count(number) == 0) numbers.push_back(number);
    for (const int number : numbers) {
        SCOPED_TRACE(number);
        interrupt({record, 20, "run.clt.part"}, number, 0);
    }
}

// A terminal's signal may arrive at any thread that does not block it, as Mesa's do.
TEST_F(SignalsAnywhere, EndTheCommandWhicheverThreadGetsThem)
{
    const Words words = {"bench",  "ten_thousand", "--count", "2000",   "--frames",
                         "100000", "--threads",    "3",       "--save", out("bench.json")};
    const auto takes = [](pid_t process, pid_t thread, int number) {
        std::ifstream status("/proc/" + std::to_string(process) + "/task/" + std::to_string(thread) + "/status");
        for (std::string line; std::getline(status, line);)
            if (line.rfind("SigBlk:", 0) == 0)
                return (std::stoull(line.substr(7), nullptr, 16) >> (number - 1) & 1) == 0;
        return false;
    };
    size_t others = 0, threads = 2;
    for (size_t k = 1; k < threads; ++k) {
        Running running(words);
        ASSERT_TRUE(running.work_until(1, 60));
        const std::vector<pid_t> all = running.threads();
        threads = std::max(threads, all.size());
        if (k >= all.size() || !takes(running.process(), all[k], SIGTERM)) continue;
        ++others;
        const Ended end = running.end_by(SIGTERM, all[k]);
        EXPECT_TRUE(WIFSIGNALED(end.state) && WTERMSIG(end.state) == SIGTERM) << end.state;
        EXPECT_LE(end.cpu_s, end.most_s);
        EXPECT_TRUE(contents("out").empty());
    }
    EXPECT_GE(others, 1u) << "no thread but the main one takes signals";
}

}  // namespace
}  // namespace cli_test

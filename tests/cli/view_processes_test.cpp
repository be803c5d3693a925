// claque view --processes: the pictures of one process, whatever is clicked on and whichever process ends.
#include <chrono>
#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/cli/started.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

class ViewProcesses : public Drawing
{
protected:
    Words words(const std::string &folder, const char *processes, const Words &steps) const
    {
        fs::create_directories(path(folder));
        std::ofstream out(path("steps.toml"));
        out << "measured = true\nsteps = [\n";
        for (const std::string &step : steps) out << "    '" << step << "',\n";
        out << "]\n";
        return {"view",
                "--scene",
                "plaza",
                "--count",
                "20",
                "--size",
                "480x400",
                "--script",
                path("steps.toml"),
                "--shots",
                path(folder),
                "--threads",
                "1",
                "--processes",
                processes,
                "--rates",
                path(folder) + ".json"};
    }
    Json rates(const std::string &folder) const { return Json::parse(file_text(path(folder) + ".json")); }
    void expect_same(const std::string &folder, const std::string &other) const
    {
        for (const auto &shot : fs::directory_iterator(path(folder)))
            EXPECT_TRUE(file_text(shot.path()) == file_text(path(other) + "/" + shot.path().filename().string()))
                << shot.path().filename();
    }
};

// What is picked, tinted and switched in one process is so in all.
TEST_F(ViewProcesses, ShowTheWindowThatOneProcessShows)
{
    const Words steps = {"wait 0.2",        "shot moving.png",        "click person 3",   "drag view 0.3 0.3 0.4 0.35",
                         "wheel 2",         "shot picked.png",        "click \"Camera\"", "click \"Person\"",
                         "click \"Frame\"", "click \"caches: none\"", "wait 0.1",         "shot frame.png",
                         "key tab",         "size 400x380",           "wait 0.1",         "shot narrow.png"};
    ASSERT_EQ(claque(words("one", "1", steps)).code, 0);
    const Outcome done = claque(words("three", "3", steps));
    ASSERT_EQ(done.code, 0) << done.err;
    for (const char *shot : {"moving.png", "picked.png", "narrow.png"})  // the panel Frame tells times
        EXPECT_TRUE(file_text(path("one") + "/" + shot) == file_text(path("three") + "/" + shot)) << shot;
    EXPECT_EQ(rates("three")["processes"], 3);
    EXPECT_EQ(rates("three")["ended_processes"], 0);
    EXPECT_TRUE(rates("three")["median_ms"]["crowd"].is_null()) << "another process draws it";
    EXPECT_FALSE(rates("one")["median_ms"]["update"].is_null());
}

TEST_F(ViewProcesses, ThatEndLeaveTheirPartToOthers)
{
    const Words steps = {"wait 1", "shot a.png", "wait 4", "shot b.png"};
    ASSERT_EQ(claque(words("one", "1", steps)).code, 0);
    const pid_t process = start_claque(words("killed", "3", steps));
    ASSERT_NE(process, 0);
    int state = 0;
    while (children_of(process).size() < 3 && waitpid(process, &state, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::vector<pid_t> workers = children_of(process);
    ASSERT_EQ(workers.size(), 3u);
    kill(workers[1], SIGKILL);  // while it loads
    while (!fs::exists(path("killed") + "/a.png") && waitpid(process, &state, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(workers[0], SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(workers[2], SIGKILL);
    waitpid(process, &state, 0);
    ASSERT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0) << state;
    expect_same("one", "killed");
    EXPECT_EQ(rates("killed")["ended_processes"], 3);
}

}  // namespace
}  // namespace cli_test

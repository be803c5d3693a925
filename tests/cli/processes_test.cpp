// Pictures by several processes: the same as one process draws, however they share the work and whenever they end.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

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
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class Processes : public Drawing
{
protected:
    // A film of four frames of a scene, and the hash of its pictures.
    std::string film(const std::string &name, const Words &scene, const Words &more)
    {
        fs::create_directories(path(name));
        Words words = {"render",    "--size", "200x150", "--frames", "0:60/20",
                       "--again",   "--seed", "3",       "--out",    path(name) + "/f-%02d.png",
                       "--threads", "1"};
        words.insert(words.end(), scene.begin(), scene.end());
        words.insert(words.end(), more.begin(), more.end());
        const Outcome done = claque(words);
        EXPECT_EQ(done.code, 0) << done.err;
        return pixels(name);
    }
    // The report of a picture.
    Json picture(const std::string &scene, const std::string &count, const Words &more)
    {
        Words words = {"render",  "--scene", scene,         "--count", count,         "--size",
                       "200x150", "--out",   path("p.png"), "--json",  path("p.json")};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome done = claque(words);
        EXPECT_EQ(done.code, 0) << done.err;
        return Json::parse(file_text(path("p.json")));
    }
    std::string pixels(const std::string &name) const
    {
        std::string all;
        for (const int frame : {0, 20, 40, 60})
            all += file_text(path(name) + (frame == 0 ? "/f-00.png" : "/f-" + std::to_string(frame) + ".png"));
        return all;
    }
};

// Shadows of both kinds, impostors and batches, key-poses, groups: what is chosen is chosen by the whole picture.
TEST_F(Processes, DrawTheFilmThatOneProcessDraws)
{
    const std::string scenarios = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/";
    const Words scenes[] = {
        {"--scene", "plaza", "--count", "120", "--lod", "on", "--shadows", "mesh", "--filter", "linear"},
        {"--scene", "odeon", "--count", "150", "--lod", "on", "--cache", "keypose-intermittent"},
        {"--scene", "ten_thousand", "--count", "600", "--shadows", "blob-stencil"},
        {"--scene", "vehicle", "--count", "200"},
        {"--scenario", scenarios + "corridor.toml", "--show", "spheres"}};
    for (const Words &scene : scenes) {
        const std::string one = film("one", scene, {});
        for (const char *tiles : {"1", "2", "3", "5"})
            EXPECT_TRUE(film("tiles", scene, {"--processes", tiles, "--divide", "tiles"}) == one)
                << scene[1] << " in " << tiles << " tiles";
        EXPECT_TRUE(film("frames", scene, {"--processes", "3"}) == one) << scene[1];
    }
}

TEST_F(Processes, DrawSamplesAndRawPixelsInTheirOrder)
{
    const Words words = {"render", "--scene", "plaza", "--count",  "20",  "--size",    "96x64", "--out",
                         "-",      "--fps",   "5",     "--frames", "0:9", "--samples", "2"};
    const Outcome one = claque(words);
    ASSERT_EQ(one.out.size(), 10u * 96 * 64 * 3);
    for (const char *divide : {"frames", "tiles"}) {
        Words shared = words;
        shared.insert(shared.end(), {"--processes", "3", "--divide", divide});
        EXPECT_TRUE(claque(shared).out == one.out) << divide;
    }
}

// Culled tiles are drawn by fewer people than the whole picture, and the report says by how many.
TEST_F(Processes, LeaveOutIndividualsInNoTileOfTheirs)
{
    const Json one = picture("ten_thousand", "1000", {})["frames"][0];
    const Json three = picture("ten_thousand", "1000", {"--processes", "3"})["frames"][0];
    EXPECT_EQ(three["picture_hash"], one["picture_hash"]);
    ASSERT_EQ(three["tiles"].size(), 3u);
    uint32_t sum = 0;
    for (const Json &tile : three["tiles"]) {
        EXPECT_LT(tile["drawn"]["individuals"], one["drawn"]["individuals"].get<uint32_t>() * 2 / 3);
        sum += tile["drawn"]["individuals"].get<uint32_t>();
    }
    EXPECT_GE(sum, one["drawn"]["individuals"].get<uint32_t>());
    EXPECT_LT(sum, one["drawn"]["individuals"].get<uint32_t>() * 3 / 2);
}

TEST_F(Processes, OfASchedulersJobAreAsManyAsItsCores)
{
    setenv("SLURM_JOB_ID", "7", 1);
    setenv("SLURM_CPUS_PER_TASK", "2", 1);
    const Json shared = picture("plaza", "5", {});
    unsetenv("SLURM_CPUS_PER_TASK");
    const Json alone = picture("plaza", "5", {});
    unsetenv("SLURM_JOB_ID");
    EXPECT_EQ(shared["processes"], 2);
    EXPECT_EQ(shared["threads"], 1);
    EXPECT_FALSE(alone.contains("processes"));
    EXPECT_EQ(shared["frames"][0]["picture_hash"], alone["frames"][0]["picture_hash"]);
}

TEST_F(Processes, ThatFailSayWhyAndLeaveNothing)
{
    const Outcome missing = claque({"render", path("none.glb"), "--processes", "2", "--out", path("a.png")});
    EXPECT_EQ(missing.code, 1);
    EXPECT_NE(missing.err.find("none.glb"), std::string::npos) << missing.err;
    EXPECT_TRUE(left().empty());
    for (const Words &wrong : {Words{"--colours", path("c.toml"), "--reload"}, Words{"--divide", "frames"},
                               Words{"--close-textures", "16"}}) {
        Words words = {"render", "--scene", "plaza", "--processes", "2", "--out", path("a.png")};
        words.insert(words.end(), wrong.begin(), wrong.end());
        EXPECT_EQ(claque(words).code, 2);
    }
}

class Killed : public Processes
{
protected:
    // A leak checker looks from a child process, which a kill may meet; the checker then waits for ever.
    Killed() { setenv("ASAN_OPTIONS", "detect_leaks=0", 1); }
    Words film_words(const std::string &name, const std::string &divide, int frames) const
    {
        return {"render",      "--scene",
                "plaza",       "--count",
                "12",          "--size",
                "64x48",       "--again",
                "--frames",    "0:" + std::to_string(frames - 1),
                "--processes", "3",
                "--divide",    divide,
                "--out",       path(name) + "/f-%03d.png",
                "--json",      path(name) + "/report.json"};
    }
    std::string film_of(const std::string &name, int frames) const
    {
        std::string all;
        for (int k = 0; k < frames; ++k) {
            std::string number = std::to_string(k);
            number.insert(0, 3 - number.size(), '0');
            all += file_text(path(name) + "/f-" + number + ".png");
        }
        return all;
    }
};

// A hundred workers are killed at random moments: while they start, draw, answer or wait.
TEST_F(Killed, WorkersAreReplacedAndTheFilmIsWhole)
{
    constexpr int frames = 120;
    fs::create_directories(path("whole"));
    Words words = film_words("whole", "frames", frames);
    *std::next(std::find(words.begin(), words.end(), "--processes")) = "1";
    ASSERT_EQ(claque(words).code, 0);
    const std::string whole = film_of("whole", frames);
    std::mt19937 random(5);
    int killed = 0, replaced = 0;
    for (int run = 0; killed < 100 && run < 60; ++run) {
        const std::string divide = run % 2 == 0 ? "frames" : "tiles", name = "run-" + std::to_string(run);
        fs::create_directories(path(name));
        const pid_t process = start_claque(film_words(name, divide, frames));
        int state = 0;
        // Few enough in a run that no worker ends again and again before it has drawn anything.
        for (int k = 0; k < 10 && waitpid(process, &state, WNOHANG) == 0; ++k) {
            std::this_thread::sleep_for(std::chrono::milliseconds(random() % 250));
            const std::vector<pid_t> workers = children_of(process);
            if (!workers.empty() && kill(workers[random() % workers.size()], SIGKILL) == 0) ++killed;
        }
        waitpid(process, &state, 0);
        ASSERT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0) << divide << ": " << state;
        EXPECT_TRUE(film_of(name, frames) == whole) << divide;
        replaced += Json::parse(file_text(path(name) + "/report.json"))["replaced_processes"].get<int>();
        EXPECT_EQ(std::distance(fs::directory_iterator(path(name)), fs::directory_iterator()), frames + 1);
        fs::remove_all(path(name));
    }
    EXPECT_GE(killed, 100);
    EXPECT_GE(replaced, 40) << "workers that had work";
}

TEST_F(Killed, ACommandTakesItsWorkersWithItAndLeavesNoPart)
{
    for (const int number : {SIGINT, SIGTERM, SIGKILL})
        for (const int after_ms : {30, 400, 900}) {
            fs::create_directories(path("film"));
            const pid_t process = start_claque(film_words("film", after_ms == 400 ? "tiles" : "frames", 900));
            std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
            const std::vector<pid_t> workers = children_of(process);
            const Clock::time_point sent = Clock::now();
            if (number == SIGINT) kill(-process, number);  // as a terminal does
            else kill(process, number);
            int state = 0;
            waitpid(process, &state, 0);
            EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == number) << state;
            for (const pid_t worker : workers)
                while (kill(worker, 0) == 0 && ms_since(sent) < 5000) {
                    std::ifstream about("/proc/" + std::to_string(worker) + "/stat");
                    std::string id, name, letter;
                    about >> id >> name >> letter;
                    if (letter == "Z") break;  // ended; its new parent has yet to notice
                    std::this_thread::sleep_for(std::chrono::milliseconds(2));
                }
            RecordProperty("ended_after_ms_" + std::to_string(number), std::to_string(ms_since(sent)));
            EXPECT_LT(ms_since(sent), 5000) << "a worker outlives its command";
            for (const auto &file : fs::directory_iterator(path("film")))
                if (number != SIGKILL) {
                    EXPECT_EQ(file.path().string().find(".part"), std::string::npos) << file.path();
                }
            fs::remove_all(path("film"));
        }
}

TEST_F(Killed, AWorkerThatEndsAgainAndAgainEndsTheCommand)
{
    const pid_t process = start_claque(film_words("none", "tiles", 1));  // its folder is missing: nothing is written
    int state = 0;
    waitpid(process, &state, 0);
    EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 1);
    fs::create_directories(path("film"));
    const pid_t other = start_claque(film_words("film", "frames", 900));
    const Clock::time_point begun = Clock::now();
    while (waitpid(other, &state, WNOHANG) == 0 && ms_since(begun) < 60000) {
        for (const pid_t worker : children_of(other)) kill(worker, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 1) << state;
}

}  // namespace
}  // namespace cli_test

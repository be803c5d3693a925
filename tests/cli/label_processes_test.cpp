// claque labels --processes: the folder that one process writes, whenever its workers end.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <random>
#include <sys/file.h>
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

class LabelProcesses : public Drawing
{
protected:
    Words words(const std::string &folder, const Words &more) const
    {
        Words all = {"labels",
                     "--scene",
                     "plaza",
                     "--count",
                     "8",
                     "--size",
                     "64x48",
                     "--out",
                     path(folder),
                     "--json",
                     path(folder) + ".json"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Json label(const std::string &folder, const Words &more) const
    {
        const Outcome done = claque(words(folder, more));
        EXPECT_EQ(done.code, 0) << done.err;
        return Json::parse(file_text(path(folder) + ".json"));
    }
};

const char *const every_format = "coco,panoptic,mot,kitti-flow,flo,depth,normals,boxes3d,heads,npz,sheet";

TEST_F(LabelProcesses, WriteTheFolderThatOneProcessWrites)
{
    label("one", {"--frames", "0:6", "--write", every_format});
    const auto one = contents("one");
    ASSERT_EQ(one.count("arrays/000006.npz"), 1u);
    for (const char *count : {"1", "2", "3"}) {
        const std::string folder = std::string("by-") + count;
        const Json report = label(folder, {"--frames", "0:6", "--write", every_format, "--processes", count});
        EXPECT_EQ(report["processes"], std::stoi(count));
        EXPECT_EQ(report["frames"].size(), 7u);
        EXPECT_TRUE(contents(folder) == one) << count << " processes";
    }
    // More processes than pictures, which go on in a folder that has some.
    label("parts", {"--frames", "2,4", "--write", every_format});
    const Json rest = label("parts", {"--frames", "0:6", "--write", every_format, "--processes", "7"});
    EXPECT_EQ(rest["frames"].size(), 5u);
    EXPECT_TRUE(contents("parts") == one);
}

TEST_F(LabelProcesses, MakeTheSamplesThatOneProcessMakes)
{
    std::ofstream(path("rules.toml")) << "time_s = [0, 20]\n[people]\ncount = [4, 12]\n[camera]\n[haze]\n"
                                         "visibility_m = [50, 500]\n[sensor]\nread_noise = 2\n";
    const Words rules = {"--vary", path("rules.toml"), "--frames", "0:5", "--write", "npz,coco"};
    Words shared = rules;
    shared.insert(shared.end(), {"--processes", "3"});
    Words one = words("one", rules), three = words("three", shared);
    for (Words *all : {&one, &three}) all->erase(all->begin() + 3, all->begin() + 5);  // the rules count the people
    ASSERT_EQ(claque(one).code, 0);
    ASSERT_EQ(claque(three).code, 0);
    EXPECT_TRUE(contents("three") == contents("one"));
}

TEST_F(LabelProcesses, AreReplacedWhereTheyEndAndTheFolderIsWhole)
{
    const Words frames = {"--frames", "0:59", "--write", "coco,flo,mot"};
    label("one", frames);
    const auto one = contents("one");
    Words shared = frames;
    shared.insert(shared.end(), {"--processes", "3"});
    std::mt19937 random(7);
    int killed = 0, replaced = 0;
    for (int run = 0; killed < 12 && run < 12; ++run) {
        const std::string folder = "run-" + std::to_string(run);
        const pid_t process = start_claque(words(folder, shared));
        int state = 0;
        for (int k = 0; k < 6 && waitpid(process, &state, WNOHANG) == 0; ++k) {
            std::this_thread::sleep_for(std::chrono::milliseconds(random() % 200));
            const std::vector<pid_t> workers = children_of(process);
            if (!workers.empty() && kill(workers[random() % workers.size()], SIGKILL) == 0) ++killed;
        }
        waitpid(process, &state, 0);
        ASSERT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0) << state;
        EXPECT_TRUE(contents(folder) == one);
        replaced += Json::parse(file_text(path(folder) + ".json"))["replaced_processes"].get<int>();
    }
    EXPECT_GE(killed, 12);
    EXPECT_GE(replaced, 4) << "workers that had work";
}

// Each run ends while it writes a file, and the last one as it should.
TEST_F(LabelProcesses, KilledAndStartedAgainMakeTheSameFolder)
{
    const Words frames = {"--frames", "0:5", "--write", every_format};
    label("one", frames);
    const auto has_draft = [&] {
        std::error_code gone;
        for (fs::recursive_directory_iterator at(path("killed"), gone), end; at != end && !gone; at.increment(gone))
            if (at->path().filename().string().find(".part") != std::string::npos) return true;
        return false;
    };
    int drafts = 0;
    for (int run = 0; run < 4; ++run) {
        const pid_t process = start_claque(words("killed", frames));
        int state = 0;
        while (waitpid(process, &state, WNOHANG) == 0) {
            if (!has_draft()) continue;
            kill(process, SIGSTOP);
            if (has_draft()) kill(process, SIGKILL);
            kill(process, SIGCONT);
        }
        drafts += has_draft();
    }
    EXPECT_GT(drafts, 0) << "no run was killed while it wrote";
    label("killed", frames);
    EXPECT_TRUE(contents("killed") == contents("one"));
}

// Another job of an array may be writing.
TEST_F(LabelProcesses, LeaveDraftsThatAreWritten)
{
    const Words frames = {"--frames", "0", "--write", "coco"};
    fs::create_directories(path("one/images"));
    const std::string written = path("one/images/000001.png.part1"), left = path("one/images/000002.png.part1"),
                      other = path("one/images/notes.part");
    for (const std::string &file : {written, left, other}) std::ofstream(file) << "x";
    const int draft = open(written.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(flock(draft, LOCK_EX), 0);
    label("one", frames);
    EXPECT_TRUE(fs::exists(written));
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(other));
    close(draft);
}

TEST_F(LabelProcesses, ThatFailSayWhyAndKeepWhatIsWhole)
{
    std::ofstream(path("rules.toml")) << "[people]\ncount = 3\n[camera]\nfaces_m = 900\n";
    const Outcome failed = claque({"labels", "--scene", "plaza", "--size", "64x48", "--frames", "0:3", "--out",
                                   path("f"), "--vary", path("rules.toml"), "--processes", "2"});
    EXPECT_EQ(failed.code, 1);
    EXPECT_NE(failed.err.find("none of 100 cameras fits the rules"), std::string::npos) << failed.err;
    EXPECT_FALSE(fs::exists(path("f")));
    label("g", {"--frames", "0:2", "--processes", "2"});
    const auto before = contents("g");
    const Outcome other = claque(words("g", {"--frames", "0:3", "--seed", "9", "--processes", "2"}));
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("has labels of other settings: /scene/seed"), std::string::npos) << other.err;
    EXPECT_TRUE(contents("g") == before);
}

}  // namespace
}  // namespace cli_test

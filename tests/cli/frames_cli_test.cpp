// Films that several jobs draw: claque render --chunk and --manifest, claque frames check, samples/farm.
#include <csignal>
#include <cstdlib>
#include <fstream>
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
using Json = nlohmann::json;

class Film : public Drawing
{
protected:
    std::vector<std::string> words(const std::string &folder, std::vector<std::string> more,
                                   const std::string &frames = "0:5") const
    {
        std::vector<std::string> all = {"render",
                                        "--scene",
                                        "plaza",
                                        "--count",
                                        "6",
                                        "--size",
                                        "48x36",
                                        "--frames",
                                        frames,
                                        "--threads",
                                        "1",
                                        "--out",
                                        path(folder) + "/f-%03d.png"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Outcome draw(const std::string &folder, std::vector<std::string> more, const std::string &frames = "0:5") const
    {
        fs::create_directories(path(folder));
        return claque(words(folder, std::move(more), frames));
    }
    void draw_share(const std::string &folder, int share, int shares) const
    {
        const std::string n = std::to_string(share);
        const Outcome done = draw(
            folder, {"--chunk", n + "/" + std::to_string(shares), "--manifest", path(folder) + "/m" + n + ".json"});
        ASSERT_EQ(done.code, 0) << done.err;
    }
    Outcome check(const std::string &folder, std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(), {"frames", "check", path(folder)});
        return claque(more);
    }
    std::string frame(const std::string &folder, int number) const
    {
        return path(folder) + "/f-00" + std::to_string(number) + ".png";
    }
    std::string pixels(const std::string &folder) const
    {
        std::string all;
        for (int k = 0; k < 6; ++k) all += file_text(frame(folder, k));
        return all;
    }
};

TEST_F(Film, OfSeveralJobsIsThatOfOne)
{
    for (int share = 0; share < 4; ++share) draw_share("jobs", share, 4);
    const Outcome whole = check("jobs");
    EXPECT_EQ(whole.code, 0) << whole.err;
    EXPECT_EQ(whole.out, "6 frames are whole\n");
    ASSERT_EQ(draw("one", {}).code, 0);
    EXPECT_EQ(pixels("jobs"), pixels("one"));
    const Outcome longer = check("jobs", {"--frames", "0:5,8,11:13"});
    EXPECT_EQ(longer.code, 1);
    EXPECT_EQ(longer.out, "6 frames are whole, 4 are missing\n8,11-13\n");
}

TEST_F(Film, OfAScenarioIsDrawnAgainWhereAFileThatItNamesHasChanged)
{
    const std::string from = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/corridor";
    for (const char *end : {".toml", ".csv", ".wkt"}) fs::copy_file(from + end, path(std::string("corridor") + end));
    const auto skipped = [&] {
        const Outcome drawn =
            claque({"render", "--scenario", path("corridor.toml"), "--size", "48x36", "--frames", "0:2", "--out",
                    path("f-%d.png"), "--manifest", path("m.json"), "--json", path("r.json")});
        EXPECT_EQ(drawn.code, 0) << drawn.err;
        return Json::parse(file_text(path("r.json")))["skipped"].size();
    };
    EXPECT_EQ(skipped(), 0u);
    EXPECT_EQ(skipped(), 3u);
    std::ofstream(path("corridor.csv"), std::ios::app) << "\n";
    EXPECT_EQ(skipped(), 0u);
}

TEST_F(Film, FusedMultiplyAddMakesAnotherFilm)
{
    const auto drivers = [&](const char *value) {
        setenv("CLAQUE_SIMD", value, 1);
        draw_share(value, 0, 1);
        unsetenv("CLAQUE_SIMD");
        return Json::parse(file_text(path(value) + "/m0.json"))["about"]["drivers"];
    };
    EXPECT_EQ(drivers("fma")["CLAQUE_SIMD"], "fma");
    EXPECT_FALSE(drivers("128").contains("CLAQUE_SIMD"));
}

TEST_F(Film, FramesThatAreGoneOrWereChangedAreNamedAndDrawnAgain)
{
    draw_share("jobs", 0, 1);
    const std::string before = pixels("jobs");
    fs::remove(frame("jobs", 2));
    std::ofstream(frame("jobs", 4), std::ios::app) << "x";
    const Outcome wrong = check("jobs");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.out.find(frame("jobs", 2) + " is gone"), std::string::npos) << wrong.out;
    EXPECT_NE(wrong.out.find(frame("jobs", 4) + " was changed after it was drawn"), std::string::npos) << wrong.out;
    EXPECT_NE(wrong.out.find("4 frames are whole, 2 are missing\n2,4\n"), std::string::npos) << wrong.out;
    ASSERT_EQ(draw("jobs", {"--manifest", path("jobs") + "/m0.json", "--json", path("r.json")}).code, 0);
    EXPECT_EQ(Json::parse(file_text(path("r.json")))["skipped"], Json({0, 1, 3, 5}));
    EXPECT_EQ(pixels("jobs"), before);
    EXPECT_EQ(check("jobs").code, 0);
}

// A signal ends a process later the more memory it holds.
TEST_F(Film, OfLargeFramesIsCheckedInLittleMemory)
{
    ASSERT_EQ(draw("film", {"--manifest", path("film") + "/film.json"}, "0:1").code, 0);
    fs::resize_file(frame("film", 1), uintmax_t{700} << 20);
    Running running({"frames", "check", path("film")});
    const auto held_mb = [&] {
        std::ifstream status("/proc/" + std::to_string(running.process()) + "/status");
        for (std::string line; std::getline(status, line);)
            if (line.rfind("VmRSS:", 0) == 0) return std::stoul(line.substr(6)) / 1024;
        return 0ul;
    };
    ASSERT_TRUE(running.work_until(0.1, 60));
    const unsigned long before = held_mb();
    EXPECT_GT(before, 0u);
    ASSERT_TRUE(running.work_until(0.6, 60));
    EXPECT_LT(held_mb(), before + 16);
}

TEST_F(Film, OfDifferentScenesOrProcessorsIsRefused)
{
    draw_share("jobs", 0, 2);
    const std::string other = path("jobs") + "/m1.json";
    ASSERT_EQ(draw("jobs", {"--chunk", "1/2", "--manifest", other, "--seed", "2"}).code, 0);
    Outcome wrong = check("jobs");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.out.find("scene_hash differs"), std::string::npos) << wrong.out;
    // Entries of another scene are not taken over: their frames are drawn again.
    ASSERT_EQ(draw("jobs", {"--chunk", "1/2", "--manifest", other, "--portable"}).code, 0);
    wrong = check("jobs");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.out.find("processor differs"), std::string::npos) << wrong.out;
    EXPECT_EQ(wrong.out.find("scene_hash differs"), std::string::npos) << wrong.out;
    draw_share("jobs", 1, 2);
    EXPECT_EQ(check("jobs").code, 0);
}

TEST_F(Film, OfAnotherHourIsAnother)
{
    draw_share("jobs", 0, 2);
    ASSERT_EQ(draw("jobs", {"--chunk", "1/2", "--manifest", path("jobs") + "/m1.json", "--hour", "9"}).code, 0);
    const Outcome wrong = check("jobs");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.out.find("scene_hash differs"), std::string::npos) << wrong.out;
}

TEST_F(Film, OfAJobThatWasKilledGoesOnWhereItStopped)
{
    const std::string manifest = path("jobs") + "/m.json";
    fs::create_directories(path("jobs"));
    for (const size_t enough : {1, 3}) {
        std::vector<std::string> all = words("jobs", {"--manifest", manifest});
        all.insert(all.begin(), CLAQUE_COMMAND);
        std::vector<char *> arguments;
        for (std::string &one : all) arguments.push_back(one.data());
        arguments.push_back(nullptr);
        const pid_t job = fork();
        ASSERT_GE(job, 0);
        if (job == 0) {
            execv(CLAQUE_COMMAND, arguments.data());
            _exit(127);
        }
        int status = 0;
        const auto drawn = [&] {
            const Json json = fs::exists(manifest) ? Json::parse(file_text(manifest), nullptr, false) : Json();
            return json.is_object() ? json["frames"].size() : 0;
        };
        while (drawn() < enough && waitpid(job, &status, WNOHANG) == 0) usleep(200);
        kill(job, SIGKILL);
        waitpid(job, &status, 0);
    }
    const Json left = Json::parse(file_text(manifest));
    ASSERT_EQ(draw("jobs", {"--manifest", manifest, "--json", path("r.json")}).code, 0);
    EXPECT_EQ(Json::parse(file_text(path("r.json")))["skipped"].size(), left["frames"].size());
    EXPECT_EQ(check("jobs", {"--frames", "0:5"}).code, 0);
    ASSERT_EQ(draw("one", {}).code, 0);
    EXPECT_EQ(pixels("jobs"), pixels("one"));
}

class FrameLists : public Command
{
};

TEST_F(FrameLists, ThatAreNoneAreRefused)
{
    for (const auto &[list, sentence] :
         std::vector<std::pair<std::string, std::string>>{{"5:3", "is not a range"},
                                                          {"1,1", "names frame 1 twice"},
                                                          {"0:9,4", "names frame 4 twice"},
                                                          {"0:9/0", "a stride is a number from 1"},
                                                          {"3/2", "is not a list of frames"},
                                                          {"1,,2", "is not a list of frames"},
                                                          {"0:999999999", "has more than 10000000 frames"}}) {
        const Outcome done = claque({"render", "--frames", list, "--out", path("f-%d.png")});
        EXPECT_EQ(done.code, 2) << list;
        EXPECT_NE(done.err.find(sentence), std::string::npos) << list << ": " << done.err;
    }
    for (const char *share : {"3/3", "-1/3", "1/0", "1", "a/b", "1/2x"}) {
        const Outcome done = claque({"render", "--frames", "0:5", "--chunk", share, "--out", path("f-%d.png")});
        EXPECT_EQ(done.code, 2) << share;
    }
}

TEST_F(FrameLists, HaveSingleFramesRangesAndStrides)
{
    if (const std::string why = why_no_context("any"); !why.empty()) GTEST_SKIP() << why;
    const Outcome done = claque({"render", "--scene", "plaza", "--count", "2", "--size", "16x12", "--frames",
                                 "0:1,7,10:20/5", "--out", path("f-%d.png")});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(left(), (std::vector<std::string>{"f-0.png", "f-1.png", "f-10.png", "f-15.png", "f-20.png", "f-7.png"}));
}

TEST_F(FrameLists, FoldersWithoutAWholeManifestAreRefused)
{
    Outcome done = claque({"frames", "check", path("none")});
    EXPECT_EQ(done.code, 1);
    EXPECT_NE(done.err.find("could not be read"), std::string::npos) << done.err;
    std::ofstream(path("other.json")) << "{\"a\": 1}";
    done = claque({"frames", "check", path(".")});
    EXPECT_NE(done.err.find("has no manifest"), std::string::npos) << done.err;
    for (const char *text :
         {"{\"claque_manifest\": 2}", "{\"claque_manifest\": 1}",
          "{\"claque_manifest\": 1, \"about\": {}, \"asked\": \"0\", \"frames\": [{\"frame\": \"a\"}]}",
          "{\"claque_manifest\": 1, \"about\": {}, \"asked\": \"0,0\", \"frames\": []}"}) {
        std::ofstream(path("m.json")) << text;
        done = claque({"frames", "check", path(".")});
        EXPECT_EQ(done.code, 1) << text;
        EXPECT_NE(done.err.find("m.json"), std::string::npos) << done.err;
    }
    std::ofstream(path("m.json")) << "[1, 2";
    EXPECT_NE(claque({"frames", "check", path(".")}).err.find("has no manifest"), std::string::npos);
}

}  // namespace
}  // namespace cli_test

// Films by the tasks of a job array: samples/farm, with this test as the scheduler.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

class Farm : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        setenv("CLAQUE", CLAQUE_COMMAND, 1);
    }
    void TearDown() override
    {
        for (const char *name : {"SLURM_ARRAY_TASK_ID", "SLURM_JOB_ID", "CLAQUE", "FPS", "CHUNK"}) unsetenv(name);
    }
    static std::string without_ffmpeg()
    {
        for (const char *program : {"ffmpeg", "ffprobe"})
            if (std::system((std::string("command -v ") + program + " > /dev/null").c_str()) != 0)
                return std::string("there is no ") + program + " (package ffmpeg)";
        return "";
    }
    // The exit status; what it says is in `said`.
    int task(const std::string &share, const std::string &shares, const std::string &options)
    {
        setenv("CHUNK", share.c_str(), 1);
        return std::system((farm_ + "film.sh " + path("array") + " " + shares + " " + options + " --threads 1 > " +
                            path("said") + " 2>&1")
                               .c_str());
    }
    int join(const std::string &shares, const std::string &film)
    {
        return std::system(
            (farm_ + "join.sh " + path("array") + " " + shares + " " + film + " 2> " + path("said")).c_str());
    }
    std::string said() const { return file_text(path("said")); }
    static std::string decoded(const std::string &file)
    {
        return run_program({"ffmpeg", "-v", "error", "-i", file, "-f", "rawvideo", "-"}).out;
    }

    const std::string farm_ = CLAQUE_SOURCE_DIR "/samples/farm/";
};

TEST_F(Farm, MakesAWholeFilmOfAJobArray)
{
    const std::string folder = path("array");
    const std::string line = farm_ + "film.sh " + folder + " 3 0:5 --scene plaza --count 6 --size 48x36";
    for (const char *task : {"2", "0", "1"}) {
        setenv("SLURM_ARRAY_TASK_ID", task, 1);
        setenv("SLURM_JOB_ID", "7", 1);
        ASSERT_EQ(std::system((line + " > /dev/null").c_str()), 0) << task;
    }
    unsetenv("SLURM_ARRAY_TASK_ID");
    EXPECT_EQ(claque({"frames", "check", folder, "--frames", "0:5"}).code, 0);
    EXPECT_NE(std::system((line + " > /dev/null 2>&1").c_str()), 0) << "without the number of the task";
}

// film.sh encodes shares, join.sh joins them: each frame once, at its time, and the pictures of the shares unchanged.
TEST_F(Farm, JoinsEncodedSharesWithoutASeam)
{
    if (const std::string why = without_ffmpeg(); !why.empty()) GTEST_SKIP() << why;
    setenv("FPS", "25", 1);
    const std::string folder = path("array"), film = path("film.mp4");
    const std::string options = "0:9 --scene plaza --count 6 --size 64x48";
    for (const char *share : {"3", "0", "1"}) ASSERT_EQ(task(share, "4", options), 0) << said();
    EXPECT_NE(join("4", film), 0) << "a share is missing";
    EXPECT_NE(said().find("share 2 is not encoded"), std::string::npos) << said();
    EXPECT_FALSE(fs::exists(film));
    ASSERT_EQ(task("2", "4", options), 0) << said();
    // As if frames of it were drawn again by a task that ended before it encoded them.
    const std::string manifest = folder + "/share-1.json";
    const auto drawn = fs::last_write_time(manifest);
    fs::last_write_time(manifest, fs::last_write_time(folder + "/share-1.h264") + std::chrono::milliseconds(10));
    EXPECT_NE(join("4", film), 0);
    EXPECT_NE(said().find("share-1.h264 is older than its manifest"), std::string::npos) << said();
    EXPECT_FALSE(fs::exists(film));
    fs::last_write_time(manifest, drawn);
    ASSERT_EQ(join("4", film), 0) << said();

    const Outcome times = run_program({"ffprobe", "-v", "error", "-show_entries", "frame=pts_time", "-of",
                                       "default=noprint_wrappers=1:nokey=1", film});
    std::istringstream lines(times.out);
    std::vector<double> seconds;
    for (double time = 0; lines >> time;) seconds.push_back(time);
    ASSERT_EQ(seconds.size(), 10u) << times.out << times.err;
    for (size_t k = 0; k < seconds.size(); ++k) EXPECT_NEAR(seconds[k], static_cast<double>(k) / 25, 1e-6);

    std::string shares;
    for (const char *share : {"0", "1", "2", "3"}) shares += decoded(folder + "/share-" + share + ".h264");
    EXPECT_EQ(shares.size(), 10u * 64 * 48 * 3 / 2);
    EXPECT_TRUE(decoded(film) == shares);
}

// The manifest of a scenario names the scenario's files too.
TEST_F(Farm, EncodesTheFramesOfAScenarioAlone)
{
    if (const std::string why = without_ffmpeg(); !why.empty()) GTEST_SKIP() << why;
    setenv("FPS", "25", 1);
    const std::string scenario = CLAQUE_SOURCE_DIR "/samples/scenarios/corridor.toml";
    ASSERT_EQ(task("0", "1", "0:2 --size 64x48 --scenario " + scenario), 0) << said();
    ASSERT_NE(file_text(path("array") + "/share-0.json").find("corridor.csv"), std::string::npos);
    EXPECT_EQ(decoded(path("array") + "/share-0.h264").size(), 3u * 64 * 48 * 3 / 2);
}

// A picture that is lost between the two steps of a task.
TEST_F(Farm, EncodesNoShareOfWhichAPictureIsGone)
{
    if (const std::string why = without_ffmpeg(); !why.empty()) GTEST_SKIP() << why;
    const std::string loser = path("loser"), folder = path("array");
    std::ofstream(loser) << "#!/bin/sh\n" << CLAQUE_COMMAND << " \"$@\" && rm " << folder << "/f-000001.png\n";
    fs::permissions(loser, fs::perms::owner_all);
    setenv("CLAQUE", loser.c_str(), 1);
    setenv("FPS", "25", 1);
    EXPECT_NE(task("0", "1", "0:2 --scene plaza --count 6 --size 64x48"), 0);
    EXPECT_NE(said().find("f-000001.png of " + folder + "/share-0.json cannot be read"), std::string::npos) << said();
    EXPECT_FALSE(fs::exists(folder + "/share-0.h264"));
}

}  // namespace
}  // namespace cli_test

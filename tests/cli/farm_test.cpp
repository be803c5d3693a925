// Films by the tasks of a job array: samples/farm, with this test as the scheduler.
#include <cstdlib>
#include <sstream>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

class Farm : public Drawing
{
};

TEST_F(Farm, MakesAWholeFilmOfAJobArray)
{
    setenv("CLAQUE", CLAQUE_COMMAND, 1);
    const std::string folder = path("array"), script = CLAQUE_SOURCE_DIR "/samples/farm/film.sh";
    const std::string line = script + " " + folder + " 3 0:5 --scene plaza --count 6 --size 48x36";
    for (const char *task : {"2", "0", "1"}) {
        setenv("SLURM_ARRAY_TASK_ID", task, 1);
        setenv("SLURM_JOB_ID", "7", 1);
        ASSERT_EQ(std::system((line + " > /dev/null").c_str()), 0) << task;
    }
    for (const char *name : {"SLURM_ARRAY_TASK_ID", "SLURM_JOB_ID", "CLAQUE"}) unsetenv(name);
    EXPECT_EQ(claque({"frames", "check", folder, "--frames", "0:5"}).code, 0);
    EXPECT_NE(std::system((line + " > /dev/null 2>&1").c_str()), 0) << "without the number of the task";
}

// film.sh encodes shares, join.sh joins them: each frame once, at its time, and the pictures of the shares unchanged.
TEST_F(Farm, JoinsEncodedSharesWithoutASeam)
{
    for (const char *program : {"ffmpeg", "ffprobe"})
        if (std::system((std::string("command -v ") + program + " > /dev/null").c_str()) != 0)
            GTEST_SKIP() << "there is no " << program << " (package ffmpeg)";
    setenv("CLAQUE", CLAQUE_COMMAND, 1);
    setenv("FPS", "25", 1);
    const std::string folder = path("array"), film = path("film.mp4"), farm = CLAQUE_SOURCE_DIR "/samples/farm/";
    const std::string task = farm + "film.sh " + folder + " 4 0:9 --scene plaza --count 6 --size 64x48 > /dev/null";
    const std::string join = farm + "join.sh " + folder + " 4 " + film + " 2> " + path("said");
    for (const char *share : {"3", "0", "1"}) {
        setenv("CHUNK", share, 1);
        ASSERT_EQ(std::system(task.c_str()), 0) << share;
    }
    EXPECT_NE(std::system(join.c_str()), 0) << "a share is missing";
    EXPECT_NE(file_text(path("said")).find("share 2 is not encoded"), std::string::npos) << file_text(path("said"));
    EXPECT_FALSE(fs::exists(film));
    setenv("CHUNK", "2", 1);
    ASSERT_EQ(std::system(task.c_str()), 0);
    ASSERT_EQ(std::system(join.c_str()), 0) << file_text(path("said"));
    for (const char *name : {"CLAQUE", "FPS", "CHUNK"}) unsetenv(name);

    const Outcome times = run_program({"ffprobe", "-v", "error", "-show_entries", "frame=pts_time", "-of",
                                       "default=noprint_wrappers=1:nokey=1", film});
    std::istringstream lines(times.out);
    std::vector<double> seconds;
    for (double time = 0; lines >> time;) seconds.push_back(time);
    ASSERT_EQ(seconds.size(), 10u) << times.out << times.err;
    for (size_t k = 0; k < seconds.size(); ++k) EXPECT_NEAR(seconds[k], static_cast<double>(k) / 25, 1e-6);

    const auto decoded = [&](const std::string &file) {
        return run_program({"ffmpeg", "-v", "error", "-i", file, "-f", "rawvideo", "-"}).out;
    };
    std::string shares;
    for (const char *share : {"0", "1", "2", "3"}) shares += decoded(folder + "/share-" + share + ".h264");
    EXPECT_EQ(shares.size(), 10u * 64 * 48 * 3 / 2);
    EXPECT_TRUE(decoded(film) == shares);
}

}  // namespace
}  // namespace cli_test

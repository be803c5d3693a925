// Pictures by the ranks of an MPI job: the same as one process draws; a rank that fails ends the job and is named.
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class Ranks : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        if (IsSkipped()) return;
        if (std::system("command -v mpirun > /dev/null") != 0) GTEST_SKIP() << "there is no mpirun (openmpi-bin)";
#ifndef CLAQUE_MPI
        GTEST_SKIP() << "this build has no claque-mpi.so (libopenmpi-dev)";
#endif
        for (const auto &[name, value] :
             {std::pair("OMPI_ALLOW_RUN_AS_ROOT", "1"), std::pair("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"),
              std::pair("OMPI_MCA_btl", "self,vader"), std::pair("OMPI_MCA_plm_rsh_agent", "/bin/false"),
              // Open MPI itself keeps memory to the end; what claque would lose, processes without it would too.
              std::pair("ASAN_OPTIONS", "detect_leaks=0")})
            setenv(name, value, 1);
    }
    Outcome mpirun(int ranks, const Words &words)
    {
        Words all = {"mpirun", "--map-by", "slot:oversubscribe", "-n", std::to_string(ranks), CLAQUE_COMMAND};
        all.insert(all.end(), words.begin(), words.end());
        return run_program(all);
    }
    Words film_words(const std::string &name, const Words &scene) const
    {
        fs::create_directories(path(name));
        Words words = {"render",   "--size",  "160x120",
                       "--frames", "0:30/10", "--threads",
                       "1",        "--out",   path(name) + "/f-%02d.png"};
        words.insert(words.end(), scene.begin(), scene.end());
        return words;
    }
    std::string pixels(const std::string &name) const
    {
        std::string all;
        for (const char *frame : {"00", "10", "20", "30"}) all += file_text(path(name) + "/f-" + frame + ".png");
        return all;
    }
};

TEST_F(Ranks, DrawTheFilmThatOneProcessDraws)
{
    const std::string scenarios = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/";
    const Words scenes[] = {{"--scene", "plaza", "--count", "60", "--lod", "on", "--shadows", "mesh"},
                            {"--scene", "odeon", "--count", "100"},
                            {"--scene", "vehicle", "--count", "60"},
                            {"--scenario", scenarios + "corridor.toml"}};
    for (const Words &scene : scenes) {
        ASSERT_EQ(claque(film_words("one", scene)).code, 0);
        const std::string one = pixels("one");
        ASSERT_FALSE(one.empty());
        for (const int ranks : {1, 2, 4})
            for (const char *divide : {"frames", "tiles"}) {
                Words words = film_words("ranks", scene);
                words.insert(words.end(), {"--divide", divide});
                const Outcome done = mpirun(ranks, words);
                EXPECT_EQ(done.code, 0) << done.err;
                EXPECT_TRUE(pixels("ranks") == one) << scene[1] << ", " << ranks << " ranks, " << divide;
                fs::remove_all(path("ranks"));
            }
        fs::remove_all(path("one"));
    }
}

TEST_F(Ranks, LabelThePicturesThatOneProcessLabels)
{
    const auto words = [&](const char *folder) {
        return Words{"labels",   "--scene", "plaza",   "--count",          "10",    "--size",    "64x48",
                     "--frames", "0:6",     "--write", "coco,flo,mot,npz", "--out", path(folder)};
    };
    ASSERT_EQ(claque(words("one")).code, 0);
    for (const int ranks : {2, 3}) {
        const std::string folder = "by-" + std::to_string(ranks);
        const Outcome done = mpirun(ranks, words(folder.c_str()));
        EXPECT_EQ(done.code, 0) << done.err;
        EXPECT_TRUE(contents(folder) == contents("one")) << ranks << " ranks";
    }
}

TEST_F(Ranks, PassOnRawPixelsInTheirOrder)
{
    const Words words = {"render", "--scene", "plaza", "--count", "20",       "--size", "96x64",
                         "--out",  "-",       "--fps", "5",       "--frames", "0:9"};
    const Outcome one = claque(words);
    ASSERT_EQ(one.out.size(), 10u * 96 * 64 * 3);
    EXPECT_TRUE(mpirun(3, words).out == one.out);
}

TEST_F(Ranks, ThatFailAreNamedAndEndTheJob)
{
    const Outcome missing = mpirun(3, {"render", path("none.glb"), "--out", path("a.png")});
    EXPECT_NE(missing.code, 0);
    EXPECT_NE(missing.err.find("of 3, on "), std::string::npos) << missing.err;
    EXPECT_NE(missing.err.find("none.glb"), std::string::npos) << missing.err;
    const Outcome both = mpirun(2, {"render", "--scene", "plaza", "--processes", "2", "--out", path("a.png")});
    EXPECT_NE(both.code, 0);
    EXPECT_NE(both.err.find("mpirun started 2 ranks"), std::string::npos) << both.err;
    EXPECT_TRUE(left().empty());
}

// Slurm counts the cores of each rank.
TEST_F(Ranks, TakeAsManyThreadsAsTheirSchedulerGaveCores)
{
    // Their environment alone says so: mpirun would look for Slurm.
    const auto threads = [this](const Words &variables) {
        Words words = {"mpirun", "--map-by", "slot:oversubscribe", "-n", "2", "env", "SLURM_JOB_ID=7"};
        words.insert(words.end(), variables.begin(), variables.end());
        words.insert(words.end(), {CLAQUE_COMMAND, "render", "--scene", "plaza", "--count", "2", "--size", "32x24",
                                   "--out", path("a.png"), "--json", path("a.json")});
        const Outcome done = run_program(words);
        EXPECT_EQ(done.code, 0) << done.err;
        return nlohmann::json::parse(file_text(path("a.json")))["threads"].get<int>();
    };
    EXPECT_EQ(threads({}), 1);
    EXPECT_EQ(threads({"SLURM_CPUS_PER_TASK=3"}), 3);
}

// A job that is started again draws what is missing.
TEST_F(Ranks, GoOnWhereAJobStopped)
{
    const Words scene = {"--scene", "plaza", "--count", "20", "--manifest", path("ranks.json")};
    ASSERT_EQ(mpirun(2, film_words("film", scene)).code, 0);
    const std::string whole = pixels("film");
    fs::remove(path("film") + "/f-10.png");
    fs::remove(path("film") + "/f-30.png");
    Words again = film_words("film", scene);
    again.insert(again.end(), {"--json", path("again.json")});
    ASSERT_EQ(mpirun(3, again).code, 0);
    EXPECT_TRUE(pixels("film") == whole);
    const nlohmann::json report = nlohmann::json::parse(file_text(path("again.json")));
    EXPECT_EQ(report["frames"].size(), 2u);
    EXPECT_EQ(report["skipped"], nlohmann::json({0, 20}));
}

// Each rank draws frames that follow each other, and makes the tracks that these show.
TEST_F(Ranks, ReadWhatTheirFramesShow)
{
    std::ofstream table(path("long.csv"));
    table << "time,id,x,y\n";
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k <= 20; ++k) table << 5 * i + 0.5 * k << ",p" << i << ',' << 0.6 * k << ',' << i % 7 << '\n';
    table.close();
    const auto words = [&](const std::string &name) {
        return Words{"play",      path("long.csv"),
                     "--columns", "time,id,x,y",
                     "--unit",    "m",
                     "--size",    "96x64",
                     "--fps",     "1",
                     "--frames",  "0:199",
                     "--json",    path(name + ".json"),
                     "--out",     path(name + "-%03d.png")};
    };
    ASSERT_EQ(claque(words("one")).code, 0);
    const Outcome done = mpirun(4, words("four"));
    ASSERT_EQ(done.code, 0) << done.err;
    const nlohmann::json one = nlohmann::json::parse(file_text(path("one.json")))["frames"];
    const nlohmann::json four = nlohmann::json::parse(file_text(path("four.json")))["frames"];
    ASSERT_EQ(four.size(), 200u);
    int most = 0;
    for (size_t i = 0; i < 200; ++i) {
        EXPECT_EQ(four[i]["picture_hash"], one[i]["picture_hash"]) << i;
        most = std::max(most, four[i]["read"]["read"].get<int>());
    }
    EXPECT_EQ(one.back()["read"]["read"], 40);
    EXPECT_LT(most, 35) << "tracks that a rank made";
}

}  // namespace
}  // namespace cli_test

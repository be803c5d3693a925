// A broken pipe ends each subcommand that writes to standard output as it ends other commands: by SIGPIPE, without a
// word.
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/cli/run.h"
#include "tests/cli/running.h"
#include "tests/gl/support/absent.h"

namespace cli_test
{
namespace
{

class BrokenPipe : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    }

    // Nothing reads what the command writes.
    void expect_silent_end(const Words &words) const
    {
        std::string all;
        for (const std::string &word : words) all += word + " ";
        SCOPED_TRACE(all);
        int ends[2];
        ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
        close(ends[0]);
        const std::string said = path("err");
        const int err = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        Running running(words, ends[1], err);
        close(ends[1]), close(err);
        const int state = running.wait_for_end();
        EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == SIGPIPE) << state;
        EXPECT_EQ(file_text(said), "");
    }

    const std::string scenarios_ = std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/";
};

TEST_F(BrokenPipe, EndsWhatTellsOfFilesSilently)
{
    std::ofstream(path("lines.json")) << R"({"kind": "lines", "title": "t", "x": {"title": "x"}, "y": {"title": "y"},
        "series": [{"name": "s", "points": [[1, 1], [2, 3]]}]})";
    const std::string table = scenarios_ + "corner.csv";
    const auto tracks = [&](const Words &more) {
        Words words = {"tracks", table, "--columns", "id,frame,x,y", "--rate", "2", "--unit", "m"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    for (const Words &words :
         {Words{"--help"}, Words{"--version"}, Words{"render", "--help"}, Words{"inspect", "citizen"},
          Words{"inspect", "citizen", "--json"}, Words{"dump", "citizen", "--out", "-"}, Words{"split", "citizen"},
          Words{"prepare", "citizen", "--out", "-"}, Words{"colours", "save", "odeon", "--out", "-"},
          Words{"lods", "citizen", "--targets", "600"}, Words{"lods", "citizen", "--targets", "600", "--json"},
          Words{"plot", path("lines.json"), "--out", "-"}, Words{"cost"}, Words{"cost", "--markdown"},
          Words{"cost", "--json", "-"}, tracks({}), tracks({"--json", "-"}), tracks({"--plot", "-"})})
        expect_silent_end(words);
}

TEST_F(BrokenPipe, EndsWhatDrawsSilently)
{
    const std::string png = path("out.png");
    const auto small = [](Words words, const Words &more) {
        words.insert(words.end(), {"--count", "2", "--size", "32x24"});
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    const Words plaza = {"render", "--scene", "plaza"};
    const Words table = {"play",      scenarios_ + "corner.csv",
                         "--columns", "id,frame,x,y",
                         "--rate",    "2",
                         "--unit",    "m",
                         "--size",    "32x24",
                         "--time",    "9"};
    const auto playing = [&](const Words &more) {
        Words words = table;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    for (const Words &words :
         {small(plaza, {"--out", "-"}), small(plaza, {"--out", "-", "--frames", "0:99", "--processes", "2"}),
          small(plaza, {"--out", png, "--json", "-"}), playing({"--out", "-"}), playing({"--out", png, "--json", "-"}),
          small({"sheet"}, {"--out", "-"}), small({"sheet"}, {"--out", png, "--json", "-"}),
          Words{"variety", "citizen", "--out", "-"}, Words{"colours", "classes", "--out", "-"},
          Words{"blend", "citizen", "--out", png},
          small({"labels", "--scene", "plaza"}, {"--frames", "0:1", "--out", path("labels"), "--json", "-"}),
          small({"bench", "plaza"}, {"--frames", "1"}), small({"bench", "plaza"}, {"--frames", "1", "--json"})})
        expect_silent_end(words);
}

TEST_F(BrokenPipe, EndsWhatComparesAndChecksSilently)
{
    const std::string result = path("result");
    ASSERT_EQ(claque({"parity", "capture", "plaza", "--count", "2", "--size", "64x48", "--out", result}).code, 0);
    for (const Words &more : {Words{}, Words{"--json", "-"}, Words{"--html", "-"}}) {
        Words words = {"parity", "compare", result, result, "--tolerance", "exact"};
        words.insert(words.end(), more.begin(), more.end());
        expect_silent_end(words);
    }
    ASSERT_EQ(claque({"render", "--scene", "plaza", "--count", "1", "--size", "32x24", "--frames", "0:1", "--out",
                      path("f-%d.png"), "--manifest", path("film.json")})
                  .code,
              0);
    expect_silent_end({"frames", "check", path("")});
}

// What a build has only with other libraries: Assimp, Recast, SDL2 and LibVNCServer.
TEST_F(BrokenPipe, EndsWhatNeedsOtherLibrariesSilently)
{
    const std::string known = claque({}).err;
    std::ofstream(path("o.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    if (claque({"convert", path("o.obj"), "--out", path("o.glb")}).err.find("without Assimp") == std::string::npos)
        expect_silent_end({"convert", path("o.obj"), "--out", "-"});
    if (known.find("stage") != std::string::npos)
        expect_silent_end({"stage", scenarios_ + "evacuation.toml", "--seconds", "2", "--json", "-"});
    if (known.find("view") != std::string::npos && gltest::can_load("libvncserver.so.1"))
        expect_silent_end({"view", "--serve", "127.0.0.1:0", "--scene", "parade", "--count", "1"});
}

}  // namespace
}  // namespace cli_test

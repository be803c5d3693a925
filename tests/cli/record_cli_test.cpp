// play --record, and play of what it wrote: the same draw lists, frame by frame and each alone.
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

std::string key(int time_s, const std::string &eye)
{
    return "[[keys]]\ntime_s = " + std::to_string(time_s) + ".0\neye = " + eye +
           "\ntarget = [0.0, 1.0, 0.0]\nfov_deg = 40.0\nnear_m = 0.5\n";
}

class RecordCommand : public Drawing
{
protected:
    void SetUp() override
    {
        Drawing::SetUp();
        std::ofstream table(path("two.csv"));
        table << "id,frame,x,y\n";
        for (int frame = 0; frame <= 60; ++frame) {
            table << "anna," << frame << ',' << 0.12 * frame - 4 << ",1\n";
            if (frame > 20) table << "ben," << frame << ',' << 4 - 0.14 * (frame - 20) << ",-1\n";
        }
        std::ofstream(path("eye.toml")) << "far_m = 900.0\n" + key(0, "[0.0, 2.0, 10.0]") + key(6, "[4.0, 3.0, 8.0]");
    }
    // The report of a command that draws two people.
    nlohmann::json drawn(const std::string &file, const std::vector<std::string> &more) const
    {
        std::vector<std::string> arguments = {"play",   path(file),          "--size",   "160x120",
                                              "--json", path("report.json"), "--camera", "path",
                                              "--path", path("eye.toml")};
        if (file == "two.csv")
            for (const char *one : {"--columns", "id,frame,x,y", "--rate", "10", "--unit", "m"})
                arguments.push_back(one);
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = claque(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.code == 0 ? nlohmann::json::parse(file_text(path("report.json"))) : nlohmann::json();
    }
    nlohmann::json recorded() const
    {
        return drawn("two.csv", {"--frames", "0:24", "--fps", "4", "--out", path("live-%02d.png"), "--record",
                                 path("run.clt"), "--characters", "citizen,patrician"});
    }
};

}  // namespace

TEST_F(RecordCommand, ShowsWhatWasRecordedFrameByFrameAndEachAlone)
{
    const nlohmann::json live = recorded();
    const nlohmann::json again = drawn("run.clt", {"--frames", "0:24", "--fps", "4", "--out", path("again-%02d.png")});
    ASSERT_EQ(live["frames"].size(), 25u);
    ASSERT_EQ(again["frames"].size(), 25u);
    for (size_t i = 0; i < 25; ++i)
        EXPECT_EQ(again["frames"][i]["list_hash"], live["frames"][i]["list_hash"]) << "frame " << i;
    EXPECT_NE(live["frames"][0]["list_hash"], live["frames"][20]["list_hash"]);
    const nlohmann::json alone = drawn("run.clt", {"--time", "4.5", "--out", path("alone.png")});
    EXPECT_EQ(alone["frames"][0]["list_hash"], live["frames"][18]["list_hash"]);
    EXPECT_EQ(alone["frames"][0]["picture_hash"], again["frames"][18]["picture_hash"]);
    // It goes on where it ended.
    std::remove(path("again-07.png").c_str());
    const nlohmann::json rest = drawn("run.clt", {"--frames", "0:24", "--fps", "4", "--out", path("again-%02d.png")});
    ASSERT_EQ(rest["frames"].size(), 1u);
    EXPECT_EQ(rest["frames"][0]["list_hash"], live["frames"][7]["list_hash"]);
}

TEST_F(RecordCommand, ShowsTheWholeRecordAndFollowsAnActor)
{
    recorded();
    ASSERT_EQ(claque({"play", path("run.clt"), "--size", "160x120", "--fps", "2", "--out", path("all-%02d.png")}).code,
              0);
    EXPECT_TRUE(std::ifstream(path("all-12.png")).good()) << "six seconds";
    EXPECT_FALSE(std::ifstream(path("all-13.png")).good());
    ASSERT_EQ(claque({"play", path("run.clt"), "--size", "160x120", "--time", "4", "--camera", "follow:1", "--out",
                      path("one.png")})
                  .code,
              0);
    EXPECT_NE(picture_of(path("one.png")).rgb, picture_of(path("all-08.png")).rgb);
    const Outcome early = claque({"play", path("run.clt"), "--size", "160x120", "--time", "1", "--camera", "follow:2",
                                  "--out", path("early.png")});
    EXPECT_NE(early.err.find("actor 2 is absent"), std::string::npos) << "ben comes after two seconds: " << early.err;
    for (const char *command : {"play", "labels"}) {
        const Outcome nobody = claque({command, path("run.clt"), "--size", "160x120", "--frames", "8", "--camera",
                                       "follow:4000", "--out", path("none-%d.png")});
        EXPECT_EQ(nobody.code, 1) << command;
        EXPECT_NE(nobody.err.find("no actor has the number 4000 that the camera is to follow; there are: 1, 2"),
                  std::string::npos)
            << nobody.err;
    }
}

TEST_F(RecordCommand, SaysHowMuchOfARecordThatWasCutOffIsShown)
{
    recorded();
    const std::string bytes = file_text(path("run.clt"));
    std::ofstream(path("cut.clt"), std::ios::binary) << bytes.substr(0, bytes.size() * 17 / 20);
    for (const std::string file : {"run.clt", "cut.clt"})
        for (const char *command : {"play", "labels", "tracks"}) {
            std::vector<std::string> words = {command, path(file)};
            if (std::string(command) != "tracks")
                words.insert(words.end(), {"--size", "32x24", "--frames", "0", "--out", path(file + "-%d")});
            const Outcome outcome = claque(words);
            EXPECT_EQ(outcome.code, 0) << outcome.err;
            const size_t at = outcome.err.find(file + " was cut off: ");
            EXPECT_EQ(at != std::string::npos, file == "cut.clt") << command << ": " << outcome.err;
            double seconds = 0, from = -1, to = 0;
            if (at == std::string::npos) continue;
            EXPECT_EQ(std::sscanf(outcome.err.c_str() + at,
                                  "cut.clt was cut off: %lf s of the run could be read, from %lf to %lf s", &seconds,
                                  &from, &to),
                      3)
                << outcome.err;
            EXPECT_EQ(from, 0);
            EXPECT_TRUE(to > 0 && to < 6) << outcome.err;
            EXPECT_EQ(outcome.err.find("was cut off", at + 20), std::string::npos) << "once: " << outcome.err;
        }
}

TEST_F(RecordCommand, RefusesWhatIsNotForRecordsAndRecordsThatAreBroken)
{
    recorded();
    std::string bytes = file_text(path("run.clt"));
    std::ofstream(path("cut.clt"), std::ios::binary) << bytes.substr(0, bytes.size() - 100);
    EXPECT_EQ(claque({"play", path("cut.clt"), "--size", "160x120", "--time", "1", "--out", path("cut.png")}).code, 0);
    bytes[bytes.size() / 2] ^= 1;
    std::ofstream(path("changed.clt"), std::ios::binary) << bytes;
    const struct {
        std::vector<std::string> arguments;
        int code;
        const char *says;
    } cases[] = {
        {{"play", path("changed.clt"), "--time", "1", "--out", path("a.png")}, 1, "was changed"},
        {{"play", path("two.csv"), "--record", path("run.mp4"), "--time", "1", "--out", path("a.png")},
         2,
         "run.mp4' would hold a record, so its name must end in .clt"},
        {{"play", path("run.clt"), "--rate", "10", "--time", "1", "--out", path("a.png")}, 2, "FILE is a record"},
        {{"play", path("run.clt"), "--record", path("b.clt"), "--time", "1", "--out", path("a.png")},
         2,
         "FILE is a record"},
    };
    for (const auto &c : cases) {
        const Outcome outcome = claque(c.arguments);
        EXPECT_EQ(outcome.code, c.code) << outcome.err;
        EXPECT_NE(outcome.err.find(c.says), std::string::npos) << outcome.err;
    }
}

}  // namespace cli_test

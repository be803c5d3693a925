// Shared key-poses on the command line: S3's experiments with small numbers, their tables and charts.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using KeyPosesUsage = Command;
using Json = nlohmann::json;

Json report_of(const std::vector<std::string> &arguments)
{
    const Outcome done = claque(arguments);
    EXPECT_EQ(done.code, 0) << done.err;
    return Json::parse(done.out, nullptr, false);
}

TEST_F(KeyPosesUsage, TheChoiceIsNearlyTheBestOfAllAndBetterThanThatOfS3AndTheNaiveOnes)
{
    const Json report = report_of({"bench", "keypose-choice", "--json"});
    ASSERT_EQ(report["runs"].size(), 4u);
    const int sizes[] = {7, 15, 22, 30};
    for (size_t i = 0; i < 4; ++i) {
        const Json &run = report["runs"][i];
        EXPECT_EQ(run["key-poses kept"], sizes[i]);
        const double best = run["every set tried"], greedy = run["claque"];
        EXPECT_LE(greedy, best);
        EXPECT_GE(greedy, 0.97 * best);
        EXPECT_LE(best, 30.0);
        if (sizes[i] >= 22) {
            EXPECT_EQ(greedy, 30.0) << "room for all";
            continue;
        }
        EXPECT_LT(run["fullest bins (S3)"], greedy);
        EXPECT_LT(run["the first n"], greedy);
        EXPECT_LT(run["n at random"], greedy);
    }
}

TEST_F(KeyPosesUsage, MoreRoomServesMoreOfTheMultitudeAndRoomForAllServesAll)
{
    const Json report = report_of({"bench", "keypose-path", "--count", "150", "--threads", "1", "--json"});
    ASSERT_EQ(report["runs"].size(), 8u);
    ASSERT_EQ(report["series"].size(), 8u);
    for (size_t method = 0; method < 2; ++method)
        for (size_t size = 0; size < 4; ++size) {
            const Json &run = report["runs"][4 * method + size];
            EXPECT_LE(run["least %"], run["served %"]);
            const double less_room = size > 0 ? report["runs"][4 * method + size - 1]["served %"].get<double>() : 0;
            EXPECT_GE(run["served %"], less_room);
            EXPECT_TRUE(size < 3 || run["served %"] == 100.0) << "200 key-poses, and room for 200";
        }
    EXPECT_LT(report["runs"][0]["served %"], 100.0);
    EXPECT_LE(report["runs"][4]["served %"], report["runs"][0]["served %"]) << "two at a time are harder to have";
}

TEST_F(KeyPosesUsage, OneClipIsServedWholeAndFiveAreNot)
{
    const Json report = report_of({"bench", "keypose-script", "--count", "800", "--threads", "1", "--json"});
    ASSERT_EQ(report["runs"].size(), 12u);
    for (size_t method = 0; method < 2; ++method) {
        const Json &five = report["runs"][6 * method], &one = report["runs"][6 * method + 1];
        EXPECT_EQ(one["served"], one["of"]);
        EXPECT_LT(one["updated a frame"], five["updated a frame"]);
        EXPECT_LT(five["served"], five["of"]);
        EXPECT_LT(one["wanted"], five["wanted"]);
    }
}

TEST_F(KeyPosesUsage, TablesForAReadmeHaveARowForEachRun)
{
    const Outcome done = claque({"bench", "keypose-choice", "--markdown", "--save", path("c.json")});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(std::count(done.out.begin(), done.out.end(), '\n'), 2 + 2 + 4) << done.out;
    EXPECT_NE(done.out.find("| key-poses kept | every set tried |"), std::string::npos);
    EXPECT_EQ(claque({"plot", path("c.json"), "--out", path("c.svg")}).code, 0);
    EXPECT_NE(file_text(path("c.svg")).find("individuals served, of 30"), std::string::npos);
}

TEST_F(KeyPosesUsage, UnknownSizesAreRefusedWithTheValidNames)
{
    for (const char *cache :
         {"keypose", "keypose-intermittent:", "keypose-interpolated:many", "full:7", "keypose-intermittent:12345678"}) {
        const Outcome outcome = claque({"bench", "odeon", "--cache", cache});
        EXPECT_EQ(outcome.code, 2) << cache;
        EXPECT_NE(outcome.err.find("keypose-intermittent:100"), std::string::npos) << outcome.err;
    }
}

class KeyPoseBench : public Drawing
{
protected:
    Json measured(const std::string &caches, const std::string &scene = "odeon") const
    {
        return report_of({"bench", scene, "--frames", "1", "--count", "40", "--size", "48x36", "--strategy", "fused",
                          "--cache", caches, "--json"});
    }
};

// The command fails when runs of one key-pose mode show different pictures.
TEST_F(KeyPoseBench, EverySizeOfAKeyPoseModeDrawsTheSamePicture)
{
    const std::string kinds[] = {"keypose-intermittent", "keypose-interpolated"};
    for (const char *scene : {"odeon", "multitude"}) {
        const Json report = measured(kinds[0] + "," + kinds[0] + ":0," + kinds[1] + ":3," + kinds[1], scene);
        ASSERT_GE(report["sections"].size(), 4u);
        ASSERT_EQ(report["runs"].size(), 4 * report["sections"].size());
        for (const Json &run : report["runs"]) {
            const std::string cache = run["cache"];
            const double asked = run["key_poses_requested"], served = run["key_poses_served"];
            if (cache == kinds[0] + ":0") {
                EXPECT_EQ(served, 0.0);
            } else if (cache == kinds[1] + ":3") {
                EXPECT_LE(served, asked);
            } else {
                EXPECT_EQ(served, asked) << cache;
            }
        }
    }
}

TEST_F(KeyPoseBench, IsPrintedAsATableAndPlottedWithTheLibraryAndGlApart)
{
    const Outcome done =
        claque({"bench", "odeon", "--frames", "1", "--count", "40", "--size", "48x36", "--strategy", "fused", "--cache",
                "none,keypose-intermittent,keypose-interpolated:4", "--markdown", "--save", path("b.json")});
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_NE(done.out.find("served by key-poses | key-poses skinned"), std::string::npos);
    EXPECT_NE(done.out.find("| 100 % |"), std::string::npos) << done.out;
    EXPECT_EQ(std::count(done.out.begin(), done.out.end(), '\n'), 1 + 1 + 2 + 4 * 3);
    EXPECT_EQ(claque({"plot", path("b.json"), "--out", path("b.svg")}).code, 0);
    const std::string chart = file_text(path("b.svg"));
    for (const char *words : {"The library's share", "Drawing the crowd, with GL", "keypose-interpolated:4"})
        EXPECT_NE(chart.find(words), std::string::npos) << words;
}

}  // namespace
}  // namespace cli_test

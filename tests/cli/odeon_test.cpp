// The odeon on the command line: frames along the camera path, the sheet, the bench by sections and its chart.
#include <algorithm>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Odeon = Drawing;
using Json = nlohmann::json;

const std::vector<std::string> small = {"--count", "40", "--size", "48x36"};

std::vector<std::string> joined(std::vector<std::string> arguments, const std::vector<std::string> &more)
{
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// Output of the command with these arguments, which must succeed.
std::string output(const std::vector<std::string> &arguments)
{
    const Outcome done = claque(arguments);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    return done.out;
}

TEST_F(Odeon, FramesFollowThePathAndEachIsTheSameAlone)
{
    const std::string both =
        output(joined({"render", "--scene", "odeon", "--frames", "100:900", "--stride", "800", "--out", "-"}, small));
    const size_t bytes = 48 * 36 * 3;
    ASSERT_EQ(both.size(), 2 * bytes);
    const std::string late =
        output(joined({"render", "--scene", "odeon", "--camera", "path", "--time", "36", "--out", "-"}, small));
    EXPECT_EQ(both.substr(bytes), late);
    EXPECT_NE(both.substr(0, bytes), late);
    const std::string overview = output(joined({"render", "--scene", "odeon", "--time", "36", "--out", "-"}, small));
    EXPECT_NE(overview, late) << "a single picture is the overview unless the path is requested";
}

TEST_F(Odeon, AUsersPathReplacesTheBuiltInOneInAnyScene)
{
    const std::string toml = path("p.toml");
    std::ofstream(toml)
        << "far_m = 500\n"
           "[[keys]]\ntime_s = 0\neye = [0, 3, 20]\ntarget = [0, 1, 0]\nfov_deg = 40\nnear_m = 0.5\n"
           "[[keys]]\ntime_s = 0.08\neye = [4, 3, 20]\ntarget = [0, 1, 0]\nfov_deg = 40\nnear_m = 0.5\n";
    const std::string all = output(joined({"render", "--path", toml, "--frames", "all", "--out", "-"}, small));
    EXPECT_EQ(all.size(), 3u * 48 * 36 * 3) << "frames 0, 1 and 2, which is the last key frame";
    EXPECT_NE(output(joined({"render", "--path", toml, "--time", "0", "--out", "-"}, small)),
              output(joined({"render", "--path", toml, "--time", "1", "--out", "-"}, small)));
    const Outcome no_sections = claque(joined({"sheet", "--path", toml, "--out", path("s.png")}, small));
    EXPECT_EQ(no_sections.code, 1);
    EXPECT_NE(no_sections.err.find("no sections"), std::string::npos) << no_sections.err;
}

TEST_F(Odeon, ASheetShowsTheMiddleOfEachSectionAsItIsRenderedAlone)
{
    const std::string json = path("s.json");
    const std::string sheet = output(joined({"sheet", "--out", "-", "--json", json}, small));
    const Json report = Json::parse(file_text(json));
    ASSERT_EQ(report["tiles"].size(), 4u);
    const size_t wide = report["size_px"][0], high = report["size_px"][1];
    EXPECT_EQ(wide, 48u + 6 + 48);
    EXPECT_EQ(high, 36u + 6 + 36);
    ASSERT_EQ(sheet.size(), wide * high * 3);
    for (size_t tile = 0; tile < 4; ++tile) {
        const Json &about = report["tiles"][tile];
        const std::string alone = output(joined(
            {"render", "--scene", "odeon", "--camera", "path", "--time", about["time_s"].dump(), "--out", "-"}, small));
        ASSERT_EQ(alone.size(), 48u * 36 * 3);
        const size_t left = tile % 2 * (48 + 6), top = tile / 2 * (36 + 6);
        for (size_t y = 0; y < 36; ++y)
            ASSERT_EQ(sheet.substr(((top + y) * wide + left) * 3, 48 * 3), alone.substr(y * 48 * 3, 48 * 3))
                << about["section"] << " row " << y;
    }
    for (size_t y = 0; y < high; ++y)
        for (size_t x = 48; x < 48 + 6; ++x) ASSERT_EQ(sheet[(y * wide + x) * 3], 24) << "between the tiles";
}

class Bench : public Drawing
{
protected:
    Json measured(const std::vector<std::string> &more) const
    {
        return Json::parse(output(joined({"bench", "odeon", "--frames", "2", "--json"}, joined(small, more))));
    }
};

TEST_F(Bench, HasARunForEachSectionCacheAndStrategy)
{
    const Json report = measured({});
    EXPECT_EQ(report["scene"], "odeon");
    EXPECT_EQ(report["count"], 40);
    EXPECT_EQ(report["frames"], 2);
    EXPECT_GE(report["machine"]["cores"].get<int>(), 1);
    ASSERT_EQ(report["sections"].size(), 4u);
    ASSERT_EQ(report["runs"].size(), 4u * 3 * 3);
    std::set<std::string> runs;
    for (const Json &run : report["runs"]) {
        runs.insert(run["section"].get<std::string>() + "/" + run["cache"].get<std::string>() + "/" +
                    run["strategy"].get<std::string>());
        for (const char *name : {"update_ms", "environment_ms", "draw_ms", "frame_ms"}) {
            EXPECT_GT(run[name]["minimum"].get<double>(), 0.0) << name;
            EXPECT_LE(run[name]["minimum"].get<double>(), run[name]["median"].get<double>()) << name;
        }
        for (const char *name : {"draws", "triangles_sent", "vertices_sent", "animated", "skinned"})
            EXPECT_TRUE(run[name].is_number()) << name;
    }
    EXPECT_EQ(runs.size(), report["runs"].size());
    for (const Json &section : report["sections"]) {
        EXPECT_LE(section["people"]["minimum"].get<double>(), section["people"]["mean"].get<double>());
        EXPECT_LE(section["people"]["mean"].get<double>(), section["people"]["maximum"].get<double>());
        EXPECT_LE(section["people"]["maximum"].get<int>(), 40);
        EXPECT_EQ(section["pictures_hash"].get<std::string>().size(), 16u);
    }
    EXPECT_EQ(report["sections"][3]["people"]["maximum"], 40) << "all actors are in view in the last section";
}

TEST_F(Bench, FindsMoreWorkWithoutCachesAndTheSamePictures)
{
    const Json with = measured({"--cache", "full"}), without = measured({"--cache", "none"});
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(with["sections"][i]["pictures_hash"], without["sections"][i]["pictures_hash"]);
    double animated_with = 0, animated_without = 0;
    for (const Json &run : with["runs"]) animated_with += run["animated"].get<double>();
    for (const Json &run : without["runs"]) animated_without += run["animated"].get<double>();
    EXPECT_LT(animated_with, animated_without);
}

TEST_F(Bench, IsPrintedAsTablesAndPlottedAsAChart)
{
    const std::string json = path("b.json"), svg = path("b.svg");
    const std::vector<std::string> quick =
        joined({"--frames", "1", "--cache", "none,full", "--strategy", "per-zone,fused"}, small);
    const std::string table = output(joined({"bench", "odeon", "--save", json}, quick));
    const std::string markdown = output(joined({"bench", "odeon", "--markdown"}, quick));
    const Json report = Json::parse(file_text(json));
    for (const Json &section : report["sections"]) {
        EXPECT_NE(table.find(section["name"].get<std::string>() + ":"), std::string::npos);
        EXPECT_NE(markdown.find("| " + section["name"].get<std::string>() + " |"), std::string::npos);
    }
    EXPECT_EQ(std::count(markdown.begin(), markdown.end(), '\n'), 1 + 1 + 2 + 4 * 2);

    output({"plot", json, "--out", svg});
    const std::string chart = file_text(svg);
    EXPECT_EQ(chart.substr(0, 4), "<svg");
    for (const char *word : {"frames a second", "milliseconds a frame", "caches: full", "per-zone", "people in view"})
        EXPECT_NE(chart.find(word), std::string::npos) << word;
    EXPECT_EQ(output({"plot", json, "--out", "-"}), chart);
    output({"plot", json, "--out", path("chart.png")});
    EXPECT_EQ(file_text(path("chart.png")).substr(1, 3), "PNG");
}

TEST_F(Bench, OtherFilesAreNoChart)
{
    const Json report = measured({"--cache", "full", "--strategy", "fused"});
    Json no_runs = report, no_time = report, odd_time = report, no_size = report;
    no_runs["runs"] = Json::array();
    no_time["runs"][1].erase("frame_ms");
    odd_time["runs"][1]["frame_ms"]["median"] = -4;
    no_size["size_px"] = "big";
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"not JSON at all", "not JSON"},
        {"[1, 2]", "lacks 'scene'"},
        {no_runs.dump(), "'runs'"},
        {no_time.dump(), "lacks 'frame_ms'"},
        {odd_time.dump(), "'median' is not a number"},
        {no_size.dump(), "'size_px'"},
    };
    for (const auto &[text, said] : wrong) {
        std::ofstream(path("b.json"), std::ios::trunc) << text;
        const Outcome outcome = claque({"plot", path("b.json"), "--out", path("b.svg")});
        EXPECT_EQ(outcome.code, 1) << said;
        EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
    EXPECT_EQ(left(), (std::vector<std::string>{"b.json"}));
}

}  // namespace
}  // namespace cli_test

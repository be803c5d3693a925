// lods: levels of detail in numbers and in a picture.
#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Lods = Drawing;
using LodsUsage = Command;
using Json = nlohmann::json;

TEST_F(LodsUsage, ListsLevelsFromTheFinestWithGrowingErrors)
{
    const Outcome outcome = claque({"lods", "citizen", "--targets", "600,200,50", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json levels = Json::parse(outcome.out);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[0]["min_m"], 0.0);
    for (size_t i = 1; i < levels.size(); ++i) {
        EXPECT_LT(levels[i]["triangles"].get<int>(), levels[i - 1]["triangles"].get<int>());
        EXPECT_GT(levels[i]["error_mm"].get<double>(), levels[i - 1]["error_mm"].get<double>());
        EXPECT_GT(levels[i]["min_m"].get<double>(), levels[i - 1]["min_m"].get<double>());
        EXPECT_EQ(levels[i]["open_edges"], 0);
    }
}

TEST_F(LodsUsage, ComparesWithQuadricOnlyAtEqualTriangles)
{
    const Outcome outcome = claque({"lods", "citizen", "--targets", "600,60", "--compare", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json beside = Json::parse(outcome.out);
    ASSERT_EQ(beside["claque"].size(), 3u);
    ASSERT_EQ(beside["quadric_only"].size(), 3u);
    for (size_t i = 1; i < 3; ++i) {
        const int ours = beside["claque"][i]["triangles"].get<int>(),
                  plain = beside["quadric_only"][i]["triangles"].get<int>();
        EXPECT_NEAR(ours, plain, 1);
        EXPECT_EQ(beside["claque"][i]["flipped_uvs"], 0);
        EXPECT_GT(beside["quadric_only"][i]["flipped_uvs"], 0);
        EXPECT_GT(beside["quadric_only"][i]["posed_rms_mm"], 0.0);
    }
}

TEST_F(LodsUsage, SaysHowMuchOfTheSurfaceEachZoneHas)
{
    const Outcome outcome = claque({"lods", "citizen", "--targets", "60"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("share of the surface %   1092     60"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\ntunic"), std::string::npos) << outcome.out;
}

TEST_F(LodsUsage, RefusesTargetsThatGoUp)
{
    const Outcome outcome = claque({"lods", "citizen", "--targets", "100,200"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("200 triangles"), std::string::npos) << outcome.err;
}

TEST_F(Lods, APictureIsAPngOfTheSizeThatWasAskedFor)
{
    const Outcome outcome =
        claque({"lods", "citizen", "--targets", "300,60", "--size", "300x200", "--picture", path("lods.png")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string png = file_text(path("lods.png"));
    ASSERT_GT(png.size(), 500u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 300);
}

// The command fails when caches change a picture, with levels or without.
TEST_F(Lods, SaveTrianglesInTheOdeonAndEveryCacheShowsTheSame)
{
    const Outcome done = claque({"bench", "odeon", "--frames", "1", "--count", "40", "--size", "64x48", "--strategy",
                                 "fused", "--cache", "none,full", "--lod", "off,on", "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(done.out);
    ASSERT_EQ(report["runs"].size(), 4 * report["sections"].size());
    for (const Json &section : report["sections"]) {
        std::map<std::string, double> sent;
        for (const Json &run : report["runs"])
            if (run["section"] == section["name"]) sent[run["cache"]] = run["triangles_sent"];
        ASSERT_EQ(sent.size(), 4u);
        EXPECT_EQ(sent["none, levels"], sent["full, levels"]);
        EXPECT_EQ(sent["none"], sent["full"]);
        EXPECT_LT(sent["full, levels"], sent["full"]) << section["name"];
    }
}

TEST_F(Lods, OfTenThousandAreDrawnInBatches)
{
    const Outcome done = claque({"render", "--scene", "ten_thousand", "--count", "400", "--size", "64x48", "--out",
                                 path("t.png"), "--json", "-"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json drawn = Json::parse(done.out)["frames"][0]["drawn"];
    EXPECT_EQ(drawn["individuals"], 400);
    EXPECT_LT(drawn["draws"].get<int>() * 8, 400);
    EXPECT_LT(drawn["triangles_sent"].get<int>(), 400 * 130);
}

// Whole frames include the environment; the parts of a draw add up to one; flushing changes no pixel.
TEST_F(Lods, BenchReportsHowFramesOfTenThousandGrowAndTheirParts)
{
    std::string hashes[2];
    for (const char *flush : {"0", "50"}) {
        const Outcome done =
            claque({"bench", "ten_thousand", "--count", "20,60", "--frames", "2", "--size", "64x48", "--cache", "full",
                    "--strategy", "fused", "--flush", flush, "--save", path("grow.json")});
        ASSERT_EQ(done.code, 0) << done.err;
        EXPECT_NE(done.out.find("vertices"), std::string::npos) << done.out;
        const Json report = Json::parse(file_text(path("grow.json")));
        EXPECT_EQ(report["series"].size(), 5u);
        for (const Json &line : report["series"]) ASSERT_EQ(line["points"].size(), 2u) << line;
        EXPECT_EQ(report["series"][0]["points"][1][0], 60);
        for (const Json &run : report["runs"]) {
            double sum = 0;
            for (const auto &[name, part] : run["draw_parts_ms"].items()) sum += part["minimum"].get<double>();
            EXPECT_GT(sum, 0);
            EXPECT_GT(run["frame_ms"]["median"].get<double>(), run["draw_parts_ms"]["claque"]["minimum"]);
            hashes[flush[0] != '0'] += run["picture_hash"].get<std::string>();
        }
        EXPECT_EQ(claque({"plot", path("grow.json"), "--out", path("grow.svg")}).code, 0);
        EXPECT_NE(file_text(path("grow.svg")).find("GL, pixels"), std::string::npos);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

// The fastest way of drawing unless an option says otherwise.
TEST_F(Lods, BenchDrawsTenThousandCachedInOneDrawByDefault)
{
    const auto runs_of = [&](std::vector<std::string> more) {
        std::vector<std::string> command = {"bench", "ten_thousand", "--count", "20",    "--frames",
                                            "1",     "--size",       "64x48",   "--json"};
        command.insert(command.end(), more.begin(), more.end());
        const Outcome done = claque(command);
        EXPECT_EQ(done.code, 0) << done.err;
        return Json::parse(done.out)["runs"];
    };
    const Json usual = runs_of({});
    ASSERT_EQ(usual.size(), 1u);
    EXPECT_EQ(usual[0]["cache"], "full");
    EXPECT_EQ(usual[0]["strategy"], "fused");
    EXPECT_EQ(runs_of({"--strategy", "binned,fused", "--cache", "none,full"}).size(), 4u);
    EXPECT_NE(runs_of({"--flat", "0"})[0]["vertices_sent"], usual[0]["vertices_sent"]);
}

TEST_F(LodsUsage, AreRefusedWhereNoPathComparesThemAndWhereThereAreNoPeople)
{
    for (const auto &[scene, lod, word] :
         {std::tuple("plaza", "off,on", "theatre"), {"multitude", "off,on", "theatre"}, {"growth", "on", "people"}}) {
        const Outcome outcome = claque({"bench", scene, "--lod", lod});
        EXPECT_NE(outcome.code, 0);
        EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    }
}

}  // namespace
}  // namespace cli_test

// render and bench: pictures are the same however they are made, and files are complete or absent.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"
#include "tests/support/collected_file.h"
#include "tests/support/written_characters.h"

namespace cli_test
{
namespace
{

using Render = Drawing;
using Json = nlohmann::json;

TEST_F(Render, APictureIsAPngOfTheSizeThatWasAskedFor)
{
    render({"--out", path("a.png")});
    const std::string png = file_text(path("a.png"));
    ASSERT_GT(png.size(), 500u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(static_cast<unsigned char>(png[19]), 96);
    EXPECT_EQ(static_cast<unsigned char>(png[23]), 72);
    EXPECT_NE(png.find("Mesa"), std::string::npos) << "the picture says which context it was made with";
    EXPECT_EQ(left(), (std::vector<std::string>{"a.png"}));
}

TEST_F(Render, TheSameFrameAloneAndInASequenceHasTheSamePixels)
{
    render({"--frames", "0:6", "--stride", "3", "--out", path("s-%05d.png")});
    EXPECT_EQ(left(), (std::vector<std::string>{"s-00000.png", "s-00003.png", "s-00006.png"}));
    render({"--time", "0.24", "--out", path("alone.png")});
    // Frames have their settings too.
    const auto from_pixels_on = [&](const std::string &file) {
        const std::string png = file_text(path(file));
        return png.substr(png.find("IDAT"));
    };
    EXPECT_EQ(from_pixels_on("alone.png"), from_pixels_on("s-00006.png"));
    EXPECT_NE(from_pixels_on("s-00000.png"), from_pixels_on("s-00006.png"));
}

TEST_F(Render, ASequenceSkipsWhatIsFinishedAndMendsWhatIsNot)
{
    render({"--frames", "0:2", "--out", path("s-%05d.png")});
    const std::string first = file_text(path("s-00000.png")), last = file_text(path("s-00002.png"));
    // A complete frame stays; a truncated one is drawn again.
    std::ofstream(path("s-00001.png"), std::ios::binary) << last.substr(0, last.size() / 2);
    std::filesystem::remove(path("s-00002.png"));
    render({"--frames", "0:2", "--out", path("s-%05d.png"), "--json", path("s.json")});
    EXPECT_EQ(file_text(path("s-00000.png")), first);
    EXPECT_EQ(file_text(path("s-00002.png")), last);
    const Json report = Json::parse(file_text(path("s.json")));
    EXPECT_EQ(report["skipped"], Json({0}));
    EXPECT_EQ(report["frames"].size(), 2u);
    // A complete frame of another time is refused.
    std::filesystem::copy_file(path("s-00002.png"), path("s-00000.png"),
                               std::filesystem::copy_options::overwrite_existing);
    const Outcome other =
        claque({"render", "--count", "30", "--size", "96x72", "--frames", "0:2", "--out", path("s-%05d.png")});
    EXPECT_EQ(other.code, 1);
    EXPECT_NE(other.err.find("s-00000.png is a picture of other settings: /time_s is 0.08 there and 0.0 here"),
              std::string::npos)
        << other.err;
    render({"--frames", "0:2", "--again", "--out", path("s-%05d.png")});
    EXPECT_EQ(file_text(path("s-00000.png")), first);
}

// The highest lines of a picture of one person show the backdrop alone, which changes little from pixel to pixel.
TEST_F(Render, APersonWithClipsInWhichItSitsIsInThePictureFromHeadToFoot)
{
    for (const char *person : {"citizen", "patrician", "decurion"}) {
        constexpr size_t width = 160, height = 120;
        const Outcome one = claque({"render", person, "--count", "1", "--size", "160x120", "--out", "-"});
        ASSERT_EQ(one.code, 0) << one.err;
        ASSERT_EQ(one.out.size(), 3 * width * height);
        int most = 0;
        for (size_t y : {size_t(0), size_t(1), height - 1})
            for (size_t k = 3; k < 3 * width; ++k) {
                const auto at = [&](size_t i) { return static_cast<unsigned char>(one.out[3 * width * y + i]); };
                most = std::max(most, std::abs(at(k) - at(k - 3)));
            }
        EXPECT_LT(most, 12) << person;
    }
}

TEST_F(Render, TheRawStreamHasThreeBytesAPixelAndNothingElse)
{
    const Outcome one = claque({"render", "--count", "9", "--size", "50x30", "--time", "0.04", "--out", "-"});
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(one.out.size(), 50u * 30u * 3u);
    EXPECT_EQ(one.err, "");
    const Outcome three = claque({"render", "--count", "9", "--size", "50x30", "--frames", "0:2", "--out", "-"});
    ASSERT_EQ(three.out.size(), 3 * one.out.size());
    EXPECT_EQ(three.out.substr(one.out.size(), one.out.size()), one.out) << "frame 1 is that of 0.04 s";
}

TEST_F(Render, ThreadsDoNotChangeThePicture)
{
    const std::string one = picture_hash({"--threads", "1"});
    EXPECT_EQ(one.size(), 16u);
    for (const char *threads : {"2", "4", "7"}) EXPECT_EQ(picture_hash({"--threads", threads}), one) << threads;
    EXPECT_NE(picture_hash({"--threads", "1", "--seed", "2"}), one) << "a check that cannot fail is none";
}

TEST_F(Render, CachesAndStrategiesDoNotChangeThePicture)
{
    const std::string plain = picture_hash({});
    for (const char *cache : {"none", "animation", "full"})
        for (const char *strategy : {"per-zone", "binned", "fused"})
            EXPECT_EQ(picture_hash({"--cache", cache, "--strategy", strategy}), plain) << cache << " " << strategy;
    EXPECT_EQ(picture_hash({"--cache-mib", "1"}), plain);
}

// All of them show poses that the first one made.
TEST_F(Render, SamplesSmoothEdgesAndSkinNothingAgain)
{
    EXPECT_EQ(picture_hash({"--samples", "1"}), picture_hash({}));
    EXPECT_EQ(picture_hash({"--samples", "5"}), picture_hash({"--samples", "5"}));
    EXPECT_NE(picture_hash({"--samples", "5"}), picture_hash({}));
    render({"--samples", "5", "--out", path("s.png"), "--json", path("s.json")});
    const Json counters = Json::parse(file_text(path("s.json")))["frames"][0]["counters"];
    EXPECT_EQ(counters["skinned"], 0);
    EXPECT_EQ(counters["animated"], 0);
    EXPECT_GT(counters["visible"].get<int>(), 20);
}

TEST_F(Render, ShadowsByClaqueAreAnotherPictureAndSkinNothing)
{
    const std::string none = picture_hash({"--shadows", "none"}), mesh = picture_hash({"--shadows", "mesh"});
    const Json report = Json::parse(file_text(path("hash.json")));
    EXPECT_GT(report["frames"][0]["shadows"]["individuals"], 20);
    EXPECT_NE(mesh, none);
    EXPECT_NE(picture_hash({"--shadows", "blob"}), mesh);
    const Json blobs = Json::parse(file_text(path("hash.json")));
    EXPECT_EQ(report["frames"][0]["counters"]["skinned"], blobs["frames"][0]["counters"]["skinned"]);
    EXPECT_EQ(picture_hash({"--shadows", "painted"}), picture_hash({}));
    const Outcome seats = claque({"render", "--scene", "odeon", "--shadows", "mesh", "--out", path("a.png")});
    EXPECT_EQ(seats.code, 1);
    EXPECT_NE(seats.err.find("'odeon' has no ground that shadows could fall on"), std::string::npos) << seats.err;
}

TEST_F(Render, APersonIsInTheSameLightWithEveryKindOfShadows)
{
    const auto upper_half = [&](const char *kind) {
        const Outcome drawn = claque(
            {"render", "citizen", "--count", "1", "--lod", "off", "--size", "96x72", "--shadows", kind, "--out", "-"});
        EXPECT_EQ(drawn.code, 0) << drawn.err;
        EXPECT_EQ(drawn.out.size(), 96u * 72 * 3);
        return drawn.out.substr(0, drawn.out.size() / 2);
    };
    const std::string none = upper_half("none");
    for (const char *kind : {"mesh", "blob"}) EXPECT_TRUE(upper_half(kind) == none) << kind;
}

TEST_F(Render, BenchComparesKindsOfShadowsInOneRun)
{
    const Outcome done = claque({"bench", "plaza", "--count", "20", "--frames", "2", "--size", "96x72", "--shadows",
                                 "none,blob,mesh-stencil", "--lod", "off", "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json runs = Json::parse(done.out)["runs"];
    ASSERT_EQ(runs.size(), 3u);
    EXPECT_EQ(runs[1]["skinned"], runs[2]["skinned"]) << "no kind of shadow skins for itself";
    EXPECT_EQ(runs[0]["drawn"]["individuals"], 0);
    EXPECT_EQ(runs[1]["drawn"]["blobs"], runs[1]["drawn"]["individuals"]);
    EXPECT_GT(runs[2]["drawn"]["triangles"], 1000);
}

TEST_F(Render, BenchFindsOnePictureByEveryStrategyWhereDepthsTie)
{
    // One pixel of the second frame shows two triangles of one person at one depth.
    const Outcome done = claque({"bench", "plaza", "--count", "500", "--cache", "none", "--strategy", "fused,binned",
                                 "--frames", "2", "--size", "1024x768", "--json"});
    EXPECT_EQ(done.code, 0) << done.err;
}

TEST_F(Render, OsmesaAndEglDrawTheSamePicture)
{
    for (const char *kind : {"osmesa", "egl"})
        if (!why_no_context(kind).empty()) GTEST_SKIP() << why_no_context(kind);
    EXPECT_EQ(picture_hash({"--context", "osmesa"}), picture_hash({"--context", "egl"}));
}

TEST_F(Render, TheReportCountsAllActorsAndVisibleOnes)
{
    render({"--out", path("a.png"), "--json", path("a.json")});
    const Json report = Json::parse(file_text(path("a.json")));
    const Json &counters = report["frames"][0]["counters"];
    EXPECT_EQ(counters["actors"], 30);
    EXPECT_GT(counters["visible"].get<int>(), 20);
    EXPECT_EQ(counters["visible"].get<int>() + counters["culled"].get<int>(), 30);
    EXPECT_EQ(report["frames"][0]["drawn"]["individuals"], counters["visible"]);
    ASSERT_FALSE(report["measured"]["bands"].empty());
    for (const Json &band : report["measured"]["bands"]) {
        EXPECT_GE(band["rate_hz"].get<double>(), 0.0);
        EXPECT_LE(band["rate_hz"].get<double>(), 51.0) << "no rung is faster than 50 Hz";
    }
    EXPECT_NE(report["context"].get<std::string>().find("Mesa"), std::string::npos);
}

TEST_F(Render, OneCharacterIsShownTwelveTimesByDefault)
{
    const Outcome outcome =
        claque({"render", "citizen", "--size", "96x72", "-o", path("a.png"), "--json", path("a.json")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(file_text(path("a.json")))["frames"][0]["counters"]["actors"], 12);
}

TEST_F(Render, APictureThatFailsLeavesTheOneBeforeIt)
{
    std::ofstream(path("a.png")) << "before";
    const Outcome outcome = claque({"render", path("none.glb"), "--out", path("a.png"), "--json", path("a.json")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(file_text(path("a.png")), "before");
    EXPECT_EQ(left(), (std::vector<std::string>{"a.png"}));
}

TEST_F(Render, BothCamerasAndBothFormatsShowSomethingElse)
{
    const std::string overview = picture_hash({});
    EXPECT_NE(picture_hash({"--camera", "close"}), overview);
    EXPECT_NE(picture_hash({"--format", "rgb565"}), overview);
}

class RenderOf : public Render, public testing::WithParamInterface<const char *>
{
};

TEST_P(RenderOf, ACharacterOfAFileIsDrawn)
{
    const std::string file = written::path_of(GetParam(), CLAQUE_ASSETS_DIR);
    CLAQUE_NEEDS_FILE(file);
    render({file, "--quiet", "--out", path("a.png")});
    EXPECT_GT(std::filesystem::file_size(path("a.png")), 500u);
}

INSTANTIATE_TEST_SUITE_P(Collected, RenderOf, testing::Values("animals/khronos/Fox.glb"),
                         [](const auto &) { return std::string("Fox"); });
INSTANTIATE_TEST_SUITE_P(Written, RenderOf, testing::Values("WrittenPerson.glb", "WrittenRigid.glb", "WrittenOdd.gltf"),
                         [](const auto &file) { return written::case_name(file.param); });

TEST_F(Render, BenchHasARunForEachOfItsMatrixAndOneHash)
{
    const Outcome outcome = claque(
        {"bench", "plaza", "--count", "5,9", "--frames", "2", "--size", "64x48", "--cache", "none,full", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json report = Json::parse(outcome.out);
    ASSERT_EQ(report["runs"].size(), 2u * 2u * 3u);
    for (const Json &run : report["runs"]) {
        EXPECT_GT(run["draw_ms"]["minimum"].get<double>(), 0.0);
        EXPECT_LE(run["draw_ms"]["minimum"].get<double>(), run["draw_ms"]["median"].get<double>());
        EXPECT_EQ(run["picture_hash"], report["runs"][run["count"] == 5 ? 0 : 6]["picture_hash"]);
    }
    EXPECT_NE(report["runs"][0]["picture_hash"], report["runs"][6]["picture_hash"]);
}

TEST_F(Render, FiltersCleanTrianglesOnRequestAndReportsThem)
{
    const auto render = [&](const char *filter, const char *name) {
        const Outcome outcome =
            claque({"render", "--scene", "plaza", "--count", "12", "--camera", "close", "--size", "160x120", "--filter",
                    filter, "--out", path(std::string(name) + ".png"), "--json", path(std::string(name) + ".json")});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return nlohmann::json::parse(file_text(path(std::string(name) + ".json")));
    };
    const nlohmann::json nearest = render("nearest", "a"), linear = render("linear", "b");
    EXPECT_FALSE(nearest.contains("filtering"));
    ASSERT_EQ(linear["filtering"].size(), 1u);
    EXPECT_GT(linear["filtering"][0]["filtered"].get<int>(), 100);
    EXPECT_GT(linear["filtering"][0]["luminance_step"]["mean"].get<double>(), 0);
    EXPECT_NE(nearest["frames"][0]["picture_hash"], linear["frames"][0]["picture_hash"]);
    EXPECT_EQ(nearest["frames"][0]["list_hash"], linear["frames"][0]["list_hash"]);
}

}  // namespace
}  // namespace cli_test

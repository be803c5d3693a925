// claque bench hundred_actors --operations, and claque cost --measured on its output.
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Hundred = Drawing;
using Json = nlohmann::json;

TEST_F(Hundred, CountsOfARunAreThoseOfTable2AndStandBesideThePaperS)
{
    const Outcome bench = claque(
        {"bench", "hundred_actors", "--frames", "2", "--rigid-mode", "matrices", "--operations", path("counts.json")});
    ASSERT_EQ(bench.code, 0) << bench.err;
    const Json counts = Json::parse(file_text(path("counts.json")));
    EXPECT_EQ(counts["NO_01"], 1200);
    EXPECT_EQ(counts["NO_02"], 100);
    EXPECT_EQ(counts["NO_03"], 80);
    EXPECT_EQ(counts["NO_04a"], 800);
    // 100 Refpoint Bspheres, 80 Sklsroot Bspheres, 8 of C3.1; of C3.2 each at least two and at most all.
    EXPECT_GE(counts["NO_04b"], 100 + 80 + 8 + 2 * 2);
    EXPECT_LE(counts["NO_04b"], 100 + 80 + 8 + 2 * 80);
    EXPECT_EQ(counts["NO_05"], 80);
    EXPECT_DOUBLE_EQ(counts["fTrack"], 1 / 3.0);
    EXPECT_GT(counts["fCoh"], 0);
    EXPECT_LT(counts["fCoh"], 1);
    EXPECT_EQ(counts["traditional"]["NO_01"], 4000);
    EXPECT_EQ(counts["traditional"]["NO_03"], 100);
    EXPECT_EQ(counts["traditional"]["NO_04a"], 8000);

    const Outcome cost = claque({"cost", "--measured", path("counts.json")});
    ASSERT_EQ(cost.code, 0) << cost.err;
    EXPECT_NE(cost.out.find("Measured: scene hundred_actors, 100 actors"), std::string::npos) << cost.out;
}

TEST_F(Hundred, BothModesDrawOnePicture)
{
    std::string pictures[2];
    for (const size_t k : {0u, 1u}) {
        const Outcome done = claque({"render", "--scene", "hundred_actors", "--cull", k ? "traditional" : "actor",
                                     "--out", path("picture.png")});
        ASSERT_EQ(done.code, 0) << done.err;
        pictures[k] = file_text(path("picture.png"));
    }
    EXPECT_FALSE(pictures[0].empty());
    EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_F(Hundred, CountsAreForScenesOfActors)
{
    const Outcome outcome = claque({"bench", "plaza", "--operations", path("counts.json")});
    EXPECT_NE(outcome.code, 0);
    EXPECT_NE(outcome.err.find("--operations"), std::string::npos) << outcome.err;
    EXPECT_TRUE(left().empty());
}

TEST_F(Hundred, AnotherNumberOfActorsIsRefused)
{
    const Outcome outcome =
        claque({"render", "--scene", "hundred_actors", "--count", "40", "--out", path("picture.png")});
    EXPECT_NE(outcome.code, 0);
    EXPECT_NE(outcome.err.find("40 were requested"), std::string::npos) << outcome.err;
    EXPECT_TRUE(left().empty());
}

}  // namespace
}  // namespace cli_test

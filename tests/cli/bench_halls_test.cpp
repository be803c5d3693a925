// claque bench doors and walking: rows with demands, and reports that can be plotted.
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;
using BenchHalls = Command;

TEST_F(BenchHalls, TellWhatPassesEachDoorAndPlotIt)
{
    const Outcome done = claque({"bench", "doors", "--seeds", "1", "--save", path("doors.json")});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(file_text(path("doors.json")));
    ASSERT_EQ(report["runs"].size(), 5u);
    ASSERT_EQ(report["series"].size(), 4u);
    for (size_t i = 0; i < 5; ++i) {
        const Json &run = report["runs"][i];
        EXPECT_EQ(run["left"], 0) << run;
        EXPECT_GE(run["flow"]["least"], run["flow_demanded"]["least"]) << run;
        EXPECT_EQ(run["flow"]["least"], run["flow"]["most"]) << run;  // of one seed
        // The chart has people a second, the table people a second and metre.
        const Json &point = report["series"][0]["points"][i];
        EXPECT_EQ(point[0], run["width_m"]);
        EXPECT_NEAR(point[1].get<double>(), run["flow"]["least"].get<double>() * run["width_m"].get<double>(), 1e-9);
    }
    ASSERT_EQ(report["meetings"].size(), 6u);
    for (const Json &row : report["meetings"]) {
        EXPECT_EQ(row["left"], 0) << row;
        EXPECT_LT(row["last_s"]["most"], 150) << row;
        EXPECT_EQ(row["last_s"]["least"], row["last_s"]["most"]) << row;
    }
    EXPECT_NE(done.out.find("opening m"), std::string::npos) << done.out;
    EXPECT_NE(done.out.find("1.2     150    1.1 to 1.9"), std::string::npos) << done.out;
    EXPECT_EQ(claque({"plot", path("doors.json"), "--out", path("doors.svg")}).code, 0);
}

TEST_F(BenchHalls, AloneTakeSeeds)
{
    const Outcome done = claque({"bench", "growth", "--seeds", "2"});
    EXPECT_EQ(done.code, 2);
    EXPECT_NE(done.err.find("--seeds"), std::string::npos) << done.err;
    EXPECT_EQ(claque({"bench", "doors", "--seed", "2"}).code, 2);
}

TEST_F(BenchHalls, AreNamedWhereOneLetterIsMissing)
{
    const Outcome done = claque({"bench", "door"});
    EXPECT_EQ(done.code, 2);
    EXPECT_NE(done.err.find("'doors'"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace cli_test

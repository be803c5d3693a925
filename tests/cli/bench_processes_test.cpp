// claque bench SCENE --processes: equal pictures, and a model that agrees with the numbers that it is fitted to.
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;

class BenchProcesses : public Drawing
{
};

TEST_F(BenchProcesses, MeasureTilesAndFitAModel)
{
    const Outcome done = claque({"bench", "ten_thousand", "--count", "300", "--size", "128x96", "--frames", "2",
                                 "--processes", "1,2,3", "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(done.out), &runs = report["runs"];
    ASSERT_EQ(runs.size(), 3u);
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(runs[i]["processes"], i + 1);
    for (size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(runs[i]["modelled_tile_cpu_ms"].get<double>(), runs[i]["mean_tile_cpu_ms"]["median"].get<double>(),
                    1e-6);
    EXPECT_EQ(runs[0]["individuals"], 300);
    EXPECT_GT(runs[2]["individuals"].get<double>(), 300);
    EXPECT_GT(runs[2]["vertices"].get<double>(), runs[0]["vertices"].get<double>());
    EXPECT_EQ(report["series"][1]["points"].back()[0], 64);
    EXPECT_EQ(claque({"bench", "growth", "--processes", "1,2"}).code, 2);
}

}  // namespace
}  // namespace cli_test

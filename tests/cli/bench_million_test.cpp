// claque bench million: people out of view take little memory, and the report can be plotted.
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Json = nlohmann::json;
using BenchMillion = Command;

TEST_F(BenchMillion, PeopleOutOfViewTakeNoMemoryOfUpdates)
{
    const Outcome done =
        claque({"bench", "million", "--count", "1000,9000", "--frames", "1", "--save", path("city.json")});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json report = Json::parse(file_text(path("city.json")));
    ASSERT_EQ(report["series"].size(), 4u);
    size_t compared = 0;
    for (const Json &run : report["runs"]) {
        EXPECT_GT(run["update_ms"]["minimum"].get<double>(), 0);
        EXPECT_GT(run["restore_s"].get<double>(), 0);
        if (!run.contains("bytes_each_more")) continue;
        ++compared;
        // 643 if updates and caches held something for everyone, 1500 if they held all.
        const bool is_indexed = run["kind"] == "some in view, with a scene index";
        EXPECT_GT(run["bytes_each_more"].get<double>(), 200);
        EXPECT_LT(run["bytes_each_more"].get<double>(), is_indexed ? 480 : 290) << run;
    }
    EXPECT_EQ(compared, 3u);
    EXPECT_EQ(claque({"plot", path("city.json"), "--out", path("city.svg")}).code, 0);
}

}  // namespace
}  // namespace cli_test

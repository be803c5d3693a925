// lods: levels of detail in numbers and in a picture.
#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Lods = Drawing;
using LodsUse = Command;
using Json = nlohmann::json;

TEST_F(LodsUse, lists_levels_from_the_finest_with_growing_errors)
{
    const Outcome outcome = claque({"lods", "citizen", "--targets", "600,200,50", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json levels = Json::parse(outcome.out);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[0]["first_m"], 0.0);
    for (size_t i = 1; i < levels.size(); ++i) {
        EXPECT_LT(levels[i]["triangles"].get<int>(), levels[i - 1]["triangles"].get<int>());
        EXPECT_GT(levels[i]["error_mm"].get<double>(), levels[i - 1]["error_mm"].get<double>());
        EXPECT_GT(levels[i]["first_m"].get<double>(), levels[i - 1]["first_m"].get<double>());
        EXPECT_EQ(levels[i]["open_edges"], 0);
    }
}

TEST_F(LodsUse, refuses_targets_that_go_up)
{
    const Outcome outcome = claque({"lods", "citizen", "--targets", "100,200"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("200 triangles"), std::string::npos) << outcome.err;
}

TEST_F(Lods, a_picture_is_a_png_of_the_size_that_was_asked_for)
{
    const Outcome outcome =
        claque({"lods", "citizen", "--targets", "300,60", "--size", "300x200", "--picture", path("lods.png")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string png = file_text(path("lods.png"));
    ASSERT_GT(png.size(), 500u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 300);
}

}  // namespace
}  // namespace cli_test

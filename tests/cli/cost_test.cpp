// claque cost: its tables, its JSON, measured counts and the plot.
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/cli/picture.h"
#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

using Cost = Command;
using Json = nlohmann::json;

constexpr const char *counts = R"({"note": "a run by hand", "NO_01": 1180, "NO_02": 100, "NO_03": 80, "NO_04a": 790,
    "NO_04b": 231, "NO_05": 60, "fTrack": 0.5, "fCoh": 0.25})";

// Output of the command with these arguments, which must succeed.
std::string cost_output(const std::vector<std::string> &arguments)
{
    const Outcome done = claque(arguments);
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    return done.out;
}

TEST_F(Cost, AllTablesArePrintedAndWhatDoesNotFollow)
{
    const std::string text = cost_output({"cost"});
    for (const char *words : {"Table 1.", "Table 2.", "Table 3.", "Table 4.", "Table 5.", "Table 6.", "Equation (3)",
                              "23 100", "21 600", "22 880", "4 206 240", "220", "80 pass the first cull"})
        EXPECT_NE(text.find(words), std::string::npos) << words;
    EXPECT_EQ(text, cost_output({"cost"}));
}

TEST_F(Cost, MarkdownHasEveryTableToo)
{
    const std::string text = cost_output({"cost", "--markdown"});
    EXPECT_NE(text.find("**Table 5. Operations in a frame, actor processing**\n\n|  | printed |"), std::string::npos);
    EXPECT_NE(text.find("\n- NO_04b of actor processing"), std::string::npos);
}

TEST_F(Cost, MeasuredCountsStandBesideThePaperS)
{
    std::ofstream(path("counts.json")) << counts;
    const std::string text = cost_output({"cost", "--measured", path("counts.json"), "--json", path("cost.json")});
    for (const char *words : {"measured", "1 180", "fTrack 0.5, fCoh 0.25", "a run by hand"})
        EXPECT_NE(text.find(words), std::string::npos) << words;
    const Json json = Json::parse(file_text(path("cost.json")));
    const Json &last = json["readings"].back();
    EXPECT_EQ(last["key"], "measured");
    EXPECT_EQ(last["counts"]["actor"]["NO_04b"], 231);
    // (4000 + 100 + 100) / (1180 / 2 + 100 + 80 / 2), and / (1180 + 100 + 80)
    const std::string remark = json["remarks"].back();
    EXPECT_EQ(remark.rfind("Measured: a run by hand, fTrack 0.5, fCoh 0.25. The improvement is ", 0), 0u) << remark;
    EXPECT_NE(remark.find("tends to 5.8, or to 3.1 with"), std::string::npos) << remark;
    EXPECT_EQ(cost_output({"cost", "--measured", path("counts.json"), "--json", "-"}), file_text(path("cost.json")));
}

TEST_F(Cost, AFileWithoutCountsIsRefusedInOneSentence)
{
    std::ofstream(path("counts.json")) << R"({"NO_01": 4})";
    const Outcome outcome = claque({"cost", "--measured", path("counts.json"), "--plot", path("x.png")});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "claque: " + path("counts.json") + " is not a report of counts: it lacks 'NO_02'.\n");
    EXPECT_EQ(left(), std::vector<std::string>{"counts.json"});
}

TEST_F(Cost, ThePlotShowsFourCurvesAsPrintedAndFourByTheOrderOfWork)
{
    cost_output({"cost", "--plot", path("a.png")});
    cost_output({"cost", "--plot", path("b.png")});
    EXPECT_EQ(file_text(path("a.png")), file_text(path("b.png")));
    const Picture picture = picture_of(path("a.png"));
    ASSERT_EQ(picture.width, 1920);
    ASSERT_GT(picture.height, 800);
    for (const std::array<int, 3> &curve :
         {std::array<int, 3>{0x2f, 0x80, 0xc9}, {0xe0, 0x8a, 0x1e}, {0x3d, 0x9a, 0x5f}, {0xa3, 0x5b, 0xb5}})
        EXPECT_GT(picture.count_of(curve), 4000) << std::hex << curve[0];
    EXPECT_EQ(picture.count_of({0xd0, 0x45, 0x4c}), 0) << "nothing was measured";
}

TEST_F(Cost, ThePlotShowsWhatWasMeasured)
{
    std::ofstream(path("counts.json")) << counts;
    cost_output({"cost", "--measured", path("counts.json"), "--plot", path("a.png")});
    EXPECT_GT(picture_of(path("a.png")).count_of({0xd0, 0x45, 0x4c}), 1000);
}

TEST_F(Cost, ThePlotIsSvgWhereItsNameSaysSo)
{
    cost_output({"cost", "--plot", path("a.svg")});
    const std::string svg = cost_output({"cost", "--plot", "-"});
    EXPECT_EQ(svg, file_text(path("a.svg")));
    EXPECT_EQ(svg.rfind("<svg", 0), 0u);
    for (const char *words : {"improvement factor", "AverageCost", "printed: fTrack 1, fCoh 1", "section 4.2"})
        EXPECT_NE(svg.find(words), std::string::npos) << words;
}

}  // namespace
}  // namespace cli_test

// The cost report: S0's tables, its inconsistencies, JSON and curves.
#include "samples/cost/report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "samples/cost/curves.h"
#include "samples/cost/measured.h"

namespace cost
{
namespace
{

const Scene scene;

std::string all_remarks()
{
    std::string all;
    for (const std::string &remark : remarks_of(scene)) all += remark + "\n";
    return all;
}

TEST(Report, BothNumbersOfEveryInconsistencyAreSaid)
{
    const std::string all = all_remarks();
    for (const char *words : {
             "printed as 4 206 240; Table 5 times Table 6 gives 4 206 240: it follows",
             "NO_04b of actor processing is printed as 200; its formula in Table 5 gives 220",
             "printed as 23 100; the counts of Table 5 give 21 600, with NO_04b from its formula 22 880",
             "printed as 11 600 fTrack fCoh + 21 200 fTrack + 12 350 fCoh + 35 290; Table 6 expands it to 11 600 "
             "fTrack "
             "fCoh + 21 200 fTrack + 12 350 fCoh + 35 290: it follows",
             "80 pass the first cull (B+C) and 60 the second (B+C2+C3); Table 5 counts B = 30 for NO_03 and C2 = 20",
             "printed as 315 AverageCost; Tables 5 and 6 give 315: it follows",
         })
        EXPECT_NE(all.find(words), std::string::npos) << words << "\nnot in\n" << all;
}

TEST(Report, OnlyOneCountOfTable5DiffersFromItsFormula)
{
    const std::string all = all_remarks();
    size_t parting = 0;
    for (size_t at = 0; (at = all.find("its formula in Table 5 gives", at)) != std::string::npos; ++at) ++parting;
    EXPECT_EQ(parting, 1u);
}

TEST(Report, EveryTableIsPresentAndRectangular)
{
    Measured measured;
    measured.actor = {1, 1, 1, 1, 1, 1};
    for (const Measured *counts : {static_cast<const Measured *>(nullptr), static_cast<const Measured *>(&measured)}) {
        const Report report = report_of(scene, counts);
        const std::string text = text_of(report);
        for (const char *title : {"Table 1.", "Table 2.", "Table 3.", "Table 4.", "Table 5.", "Table 6.",
                                  "Equation (2)", "Equation (3), printed", "Equation (3), section 4.2"})
            EXPECT_NE(text.find(title), std::string::npos) << title;
        EXPECT_EQ(text.find("Equation (3), measured") != std::string::npos, counts != nullptr);
        for (const Table &table : report.tables)
            for (const auto &row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.title;
    }
}

TEST(Report, MissingCountsHaveNoColumn)
{
    Measured measured;
    measured.actor = {1, 1, 1, 1, 1, 1};
    const auto columns = [&] { return tables_of_counts(readings_of(scene, &measured))[0].columns; };
    EXPECT_EQ(columns(), (std::vector<std::string>{"", "printed", "formulas", "section 4.2", "the paper's formula"}));
    measured.traditional = measured.actor;
    EXPECT_EQ(columns()[4], "measured");
}

TEST(Report, JsonHoldsEquation3OfEveryReading)
{
    const auto json = json_of(report_of(scene, nullptr), readings_of(scene, nullptr));
    ASSERT_EQ(json["readings"].size(), 4u);
    EXPECT_EQ(json["readings"][0]["improvement"].size(), 4 * average_costs.size());
    EXPECT_NEAR(json["readings"][0]["improvement"][0]["factor"].get<double>(), 4206240.0 / 35290, 1e-9);
    EXPECT_EQ(json["readings"][3]["counts"]["actor"]["NO_01"], 1200);
}

TEST(Report, CurvesAreEquation3)
{
    const charts::LineChart chart = curves_of(scene, nullptr);
    ASSERT_EQ(chart.series.size(), 8u);
    const auto at = [&](size_t series, double average) {
        for (const charts::Point &point : chart.series[series].points)
            if (point.x == average) return point.y;
        return -1.0;
    };
    EXPECT_NEAR(at(0, 0), 119.2, 0.05);
    EXPECT_NEAR(at(1, 100), 58.5, 0.05);
    EXPECT_NEAR(at(2, 500), 29.5, 0.05);
    EXPECT_NEAR(at(3, 1000), 21.3, 0.05);
    EXPECT_NEAR(at(7, 0), 20.0, 0.05);
    EXPECT_EQ(chart.series[0].name, "printed: fTrack 0, fCoh 0");
    EXPECT_EQ(chart.series[7].dash, charts::Dash::dashed);
}

}  // namespace
}  // namespace cost

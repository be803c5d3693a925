// Reports of a comparison as JSON, HTML, text and pictures.
#include "samples/parity/report.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/parity/base64.h"
#include "samples/parity/pictures.h"
#include "tests/unit/parity/capture_files.h"

namespace parity
{
namespace
{

using Json = nlohmann::json;

std::string coded(const std::string &text) { return base64({text.begin(), text.end()}); }

TEST(Base64, HasTheValuesOfTheStandard)
{
    const std::vector<std::pair<std::string, std::string>> rfc_4648 = {{"", ""},
                                                                       {"f", "Zg=="},
                                                                       {"fo", "Zm8="},
                                                                       {"foo", "Zm9v"},
                                                                       {"foob", "Zm9vYg=="},
                                                                       {"fooba", "Zm9vYmE="},
                                                                       {"foobar", "Zm9vYmFy"}};
    for (const auto &[plain, expected] : rfc_4648) EXPECT_EQ(coded(plain), expected);
    EXPECT_EQ(base64({255, 254, 253}), "//79");
}

class Reports : public parity_test::CaptureFiles
{
protected:
    Reports()
    {
        write_result("a");
        a = read_capture(folder("a"));
        b = a;
        b.folder = "b <&\">";
        b.colour->rgb[3 * 2] = 90;  // one pixel of actor 2
        b.depth.reset();
        comparison = compare(a, b, 67);
        verdict = verdict_of(comparison, tolerance_of("gpu"));
    }
    Report report() const { return {a, b, comparison, verdict}; }

    Capture a, b;
    Comparison comparison;
    Verdict verdict;
};

TEST_F(Reports, ForMachinesHoldEveryMeasureAndLimit)
{
    const Json json = Json::parse(report_json(report()));
    EXPECT_EQ(json["format"], "claque-parity-report");
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_EQ(json["tolerance"], "gpu");
    EXPECT_EQ(json["result"]["folder"], b.folder);
    EXPECT_EQ(json["time_s"], 1.5);
    EXPECT_EQ(json["measures"].size(), comparison.measures.size());
    EXPECT_EQ(json["measures"]["colour.max"]["value"], 44);  // 90 - 46
    const Json &over = json["measures"]["colour.over_2"];
    EXPECT_DOUBLE_EQ(over["value"].get<double>(), 1.0 / (11 * 12));
    EXPECT_EQ(over["at_most"], 0.001);
    EXPECT_EQ(over["kept"], false);
    EXPECT_EQ(json["measures"]["positions.max_m"]["value"], 0);
    EXPECT_EQ(json["not_compared"][0]["group"], "depth");
    b = a;
    comparison = compare(a, b, 67);
    verdict = verdict_of(comparison, tolerance_of("gpu"));
    const Json same = Json::parse(report_json(report()));
    EXPECT_EQ(same["verdict"], "pass");
    EXPECT_EQ(same["measures"]["colour.psnr_db"]["value"], "infinite");
}

TEST_F(Reports, ForPeopleAreOnePageWithoutLinks)
{
    const std::string page = report_html(report(), {{"Reference <1>", "seen", {1, 2, 3}}});
    EXPECT_NE(page.find("<span class=\"fail\">fail</span>"), std::string::npos);
    EXPECT_NE(page.find("b &lt;&amp;&quot;&gt;"), std::string::npos);
    EXPECT_EQ(page.find(b.folder), std::string::npos);
    EXPECT_NE(page.find("src=\"data:image/png;base64,AQID\""), std::string::npos);
    EXPECT_NE(page.find("Reference &lt;1&gt;"), std::string::npos);
    for (const Measure &m : comparison.measures) EXPECT_NE(page.find("<td>" + m.name + "</td>"), std::string::npos);
    EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
    for (const char *outside : {"http:", "https:", "<script", "<link", "url("})
        EXPECT_EQ(page.find(outside), std::string::npos);
}

TEST_F(Reports, AsTextHaveALineAMeasure)
{
    const std::string text = report_text(report());
    EXPECT_NE(text.find("colour.over_2             0.007575758             FAILS at most 0.001"), std::string::npos)
        << text;
    EXPECT_NE(text.find("depth: not compared, the result has no depth.npy\n"), std::string::npos);
}

TEST_F(Reports, PicturesShowWhere)
{
    const Picture difference = difference_picture(*a.colour, *b.colour);
    EXPECT_EQ(difference.rgb[6], 255);
    EXPECT_EQ(difference.rgb[7], 0);
    Map<Mark> marks(3, 1, Mark::same);
    marks.values[1] = Mark::border;
    marks.values[2] = Mark::outside;
    EXPECT_EQ(marks_picture(marks, nullptr).rgb, (std::vector<uint8_t>{0, 0, 0, 255, 180, 0, 255, 40, 40}));
    Map<float> near(3, 1, 0.5f), far = near;
    far.values[1] += 1e-3f;
    far.values[2] = std::nanf("");
    const Map<float> depth = depth_difference(near, far);
    EXPECT_EQ(depth.values[0], 0);
    EXPECT_NEAR(depth.values[1], 4.0 / 7, 1e-4);
    EXPECT_EQ(depth.values[2], 1);
    EXPECT_EQ(heat_picture(Map<float>(1, 1, 0)).rgb, (std::vector<uint8_t>{0, 0, 0}));
    EXPECT_EQ(heat_picture(Map<float>(1, 1, 1)).rgb, (std::vector<uint8_t>{255, 250, 200}));
}

}  // namespace
}  // namespace parity

// Areas that are none, by accident or on purpose.
#include "../heap_meter.h"
#include "fixture.h"
#include "lib/base/hash.h"

namespace claque::testing
{
namespace
{

const char nav[] =
    "4\n0 0\n2 0\n2 2\n0 2\n1\n0 2 0 1\n2\n0 1 0 1\n1 2 0 -1\ngroup\n2\n0 0 3 0 1 2 0 0 1 1 0 2 0 1\n0 0 3 0 2 3 0.5 0 "
    "1 1 "
    "0 0\n";

void expect(const std::string &text, int status, const char *sentence)
{
    const Refusal refusal = area_refusal(text);
    EXPECT_EQ(refusal.status, status) << refusal.text;
    EXPECT_NE(refusal.text.find(sentence), std::string::npos) << "'" << refusal.text << "' lacks '" << sentence << "'";
}

TEST(AreaRefusals, SayWhereAndWhat)
{
    expect("", CLQ_FORMAT, "the file is no area: WKT");
    expect("POLYGON (0 0, 1 1)", CLQ_FORMAT, "byte 10 of the WKT: ( is wanted instead of '0 0, 1 1)'");
    expect("POLYGON ((0 0, 1 1, 1", CLQ_FORMAT, "byte 22 of the WKT: a number up to 1e9 is wanted instead of its end");
    expect("POLYGON ((0 0, 1 1, 1 0)", CLQ_FORMAT, ", or ) is wanted instead of its end");
    expect("POLYGON ((0 0, 1 1, 1 inf))", CLQ_FORMAT, "a number up to 1e9 is wanted instead of 'inf))'");
    expect("POLYGON ((0 0, 4 0, 4 4)) POLYGON", CLQ_FORMAT, "nothing is wanted instead of 'POLYGON'");
    expect("CIRCLE (0 0)", CLQ_FORMAT,
           "POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION is wanted instead of 'CIRCLE (0 0)'");
    expect("GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1))", CLQ_UNSUPPORTED, "the WKT has a LINESTRING");
    expect("POLYGON ((0 0, 5 5, 4 0, 0 4))", CLQ_FORMAT, "polygon 1 has edges that cross, from (");
    expect("POLYGON ((0 0, 4 0, 4 4, 0 4), (2 2, 2 3, 7 2))", CLQ_FORMAT, "has edges that cross");
    expect("POLYGON ((0 0, 4 0, 4 4, 0 4), (12 2, 12 3, 17 2))", CLQ_FORMAT, "polygon 1 has its hole 1 outside");
    expect("POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 1 8, 8 8), (2 3, 2 4, 3 4))", CLQ_FORMAT,
           "has its hole 2 in its hole 1");
    EXPECT_EQ(read_area_text("POLYGON ((0 0, 4 4, 4 0, 0 4))").warnings.at(0),
              "ring 1 of polygon 1 encloses nothing: left out");
    EXPECT_EQ(read_area_text("POLYGON ((0 0, 4 0, 4 4), (1 1, 1 1, 2 1))").warnings.at(0),
              "ring 2 of polygon 1 encloses nothing: left out");
    expect("{\"a\": 1}", CLQ_FORMAT, "no scenario.topography: it is not a scenario of Vadere");
    expect("4 0 0 1", CLQ_FORMAT, "line 1: 4 vertices are more than the file can hold");
    expect("1\n0 x\n", CLQ_FORMAT, "line 2: 'x' instead of a vertex");
    std::string far = nav;
    far.replace(far.find("0 2 0 1"), 7, "0 4 0 1");
    expect(far, CLQ_FORMAT, "line 7: a vertex is 4: a whole number below 4 is wanted");
    far = nav;
    far.replace(far.find("1 2 0 -1"), 8, "1 2 2 -1");
    expect(far, CLQ_FORMAT, "an obstacle belongs to node 2: there are 2");
}

TEST(AreaRefusals, DoNotMeetAMeshThatIsGood)
{
    const asset::Area area = read_area_text(nav);
    EXPECT_EQ(area.polygons, 2u);
    EXPECT_EQ(area.area_m2, 4);
    EXPECT_EQ(area.points[3 * 4 + 2], 2) << "1 m and half of its x";
    EXPECT_EQ(area.walls.size(), 4u);
}

TEST(AreaRefusals, HoldWhateverTheDepthAndTheNumberOfPoints)
{
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "GEOMETRYCOLLECTION(";
    expect(deep, CLQ_LIMIT, "more than 128 collections in each other");
    std::string many = "POLYGON((0 0";
    for (int i = 1; i < 10002; ++i) many += base::text_of(",%d %d", i, i * i);
    expect(many + "))", CLQ_LIMIT, "polygon 1 has more than 10000 points");
}

TEST(AreaRefusals, OfCutAndDamagedFilesAreSentencesOrNothing)
{
    const std::string texts[] = {
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1)), POLYGON EMPTY)", nav,
        "<geometry><subroom><polygon><vertex px=\"0\" py=\"0\"/><vertex px=\"4\" py=\"0\"/><vertex px=\"4\" py=\"4\"/>"
        "<vertex px=\"0\" py=\"0\"/></polygon></subroom></geometry>",
        "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": 0, \"width\": 8, \"height\": "
        "6}}, "
        "\"obstacles\": [{\"shape\": {\"type\": \"POLYGON\", \"points\": [{\"x\": 1, \"y\": 1}, {\"x\": 2, \"y\": 1}, "
        "{\"x\": 1, \"y\": 2}]}}]}}}"};
    for (const std::string &whole : texts) {
        for (size_t size = 0; size < whole.size(); ++size)
            EXPECT_FALSE(area_refusal(whole.substr(0, size)).text.empty());
        uint64_t read = 0;
        for (uint64_t run = 0; run < 2000; ++run) {
            std::string text = whole;
            uint64_t thrown = 0;
            const auto below = [&](uint64_t limit) { return base::hash(run, thrown++, base::Purpose::pick) % limit; };
            for (uint64_t n = 1 + below(4); n > 0; --n)
                text[below(text.size())] = below(2) ? static_cast<char>(below(256)) : "0123456789-.,() "[below(16)];
            const Refusal refusal = area_refusal(text);
            EXPECT_NE(refusal.status, CLQ_ARGUMENT) << refusal.text;
            read += refusal.status == CLQ_OK;
        }
        EXPECT_GE(read, whole[0] == '<' && !missing_library("geo.xml").empty() ? 0u : 20u) << whole.substr(0, 20);
    }
}

TEST(AreaRefusals, TakeMemoryInProportion)
{
    std::string text = "MULTIPOLYGON(((0 0,1 0,1 1))";
    while (text.size() < 1000000) text += ",((0 0,1 0,1 1))";
    EXPECT_LE(peak_heap_bytes([&] { EXPECT_EQ(area_refusal(text + ")").status, CLQ_OK); }), 64 * text.size());
}

}  // namespace
}  // namespace claque::testing

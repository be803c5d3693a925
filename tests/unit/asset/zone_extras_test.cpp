// Zones in the extras of a file are read as they stand, or refused by their place.
#include "lib/asset/zone_extras.h"

#include <gtest/gtest.h>

#include "lib/asset/json_view.h"
#include "maker.h"

namespace claque::testing
{
namespace
{

std::vector<model::Zone> zones_in(const std::string &text)
{
    const asset::JsonDocument document(reinterpret_cast<const uint8_t *>(text.data()), text.size(), 1 << 20);
    return asset::read_zone_extras(document.root());
}

// A zone with these members.
std::string one_zone(const std::string &members) { return R"({"claque": {"zones": [{)" + members + "}]}}"; }

void zones_refused(const std::string &text, const std::string &sentence)
{
    const Outcome found = outcome_of([&] { zones_in(text); });
    EXPECT_EQ(found.status, CLQ_FORMAT) << text;
    EXPECT_NE(found.text.find(sentence), std::string::npos) << found.text << "\nand not: " << sentence;
}

TEST(ZoneExtras, OfOtherProgramsAreNone)
{
    for (const char *text : {"{}", "[]", "3", "\"claque\"", "null", R"({"zones": 3})", R"({"claque": {}})",
                             R"({"claque": {"markers": []}})"})
        EXPECT_TRUE(zones_in(text).empty()) << text;
}

TEST(ZoneExtras, KeepTheirNumbers)
{
    const std::vector<model::Zone> zones = zones_in(
        one_zone(R"("name": "cap", "key": 7, "colour": [0, 0.5, 1], "hue_deg": [350, 10], "saturation": [0.25, 0.5],
                       "brightness": [0, 1])"));
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_EQ(zones[0].name, "cap");
    EXPECT_EQ(zones[0].key, 7);
    EXPECT_EQ(zones[0].colour[1], 0.5f);
    EXPECT_EQ(zones[0].range.hue_min_deg, 350);
    EXPECT_EQ(zones[0].range.hue_max_deg, 10) << "a hue may wrap";
    EXPECT_EQ(zones[0].range.saturation_min, 0.25f);
    EXPECT_EQ(zones[0].range.saturation_max, 0.5f);
    EXPECT_EQ(zones[0].range.brightness_max, 1);
}

TEST(ZoneExtras, ThatBreakARuleAreRefusedByTheirPlace)
{
    const std::string cap = R"("name": "cap", "key": 7)", all = R"(, "hue_deg": [0, 9], "saturation": [0, 1])";
    zones_refused(R"({"claque": {"zones": 3}})", "zones is number instead of an array");
    zones_refused(R"({"claque": {"zones": []}})", "zones is empty");
    zones_refused(one_zone(R"("name": "", "key": 7)"), "zones[0].name is empty");
    zones_refused(one_zone(R"("key": 7)"), "zones[0]");
    zones_refused(one_zone(R"("name": "cap", "key": 256)"), "zones[0].key");
    for (const char *colour : {"[0, 1.5, 0]", "[-0.1, 0, 0]", "[0, 0, 2]"})
        zones_refused(one_zone(cap + R"(, "colour": )" + colour), "zones[0].colour has a number outside 0 to 1");
    for (const char *hue : {"[-1, 9]", "[0, 361]", "[361, 0]", "[0, -1]"})
        zones_refused(one_zone(cap + R"(, "saturation": [0, 1], "brightness": [0, 1], "hue_deg": )" + hue),
                      "both must be from 0 to 360");
    for (const char *pair : {"[0, 1.5]", "[-0.5, 1]"})
        zones_refused(one_zone(cap + all + R"(, "brightness": )" + pair), "both must be from 0 to 1");
    zones_refused(one_zone(cap + all + R"(, "brightness": [1, 0.5])"), "zones[0].brightness goes down");
    zones_refused(one_zone(cap + R"(, "hue_deg": [0, 9])"), "zones[0]");
    zones_refused(one_zone(cap + R"(, "brightness": [0, 1])"), "zones[0]");
    std::string many = R"({"claque": {"zones": [{"name": "cap", "key": 7})";
    for (int i = 0; i < 256; ++i) many += R"(, {"name": "cap", "key": 7})";
    zones_refused(many + "]}}", "zones has 257 zones: 256 keys exist");
    zones_refused(R"({"claque": {"zones": [{"name": "cap", "key": 7}, {"name": "coat", "key": 7}]}})",
                  "key 7 means 'cap' and 'coat'");
    EXPECT_EQ(zones_in(R"({"claque": {"zones": [{"name": "cap", "key": 7}, {"name": "cap", "key": 7}]}})").size(), 1u);
}

}  // namespace
}  // namespace claque::testing

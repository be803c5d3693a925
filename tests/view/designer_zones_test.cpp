// Zones that are painted over a texture, or proposed, and what the crowd shows of them.
#include <algorithm>
#include <cmath>
#include <set>

#include "samples/view/designer/files.h"
#include "samples/view/designer/zone_picture.h"
#include "tests/view/staged.h"

namespace
{

using view::ZoneMap;
using view_test::Stage;
using view_test::Staged;

size_t texels_with(const ZoneMap &map, uint8_t zone)
{
    size_t count = 0;
    for (uint32_t y = 0; y < map.height(); ++y)
        for (uint32_t x = 0; x < map.width(); ++x) count += map.at(x, y) == zone;
    return count;
}

TEST(ZoneMaps, OfCopiesKeepWhatTheyHad)
{
    ZoneMap map(200, 130);
    map.set(150, 120, 3);
    ZoneMap copy = map;
    copy.set(150, 120, 4);
    copy.set(1, 1, 5);
    EXPECT_EQ(map.at(150, 120), 3);
    EXPECT_EQ(map.at(1, 1), ZoneMap::none);
    EXPECT_EQ(copy.at(150, 120), 4);
    EXPECT_FALSE(map == copy);
    copy.set(150, 120, 3);
    copy.set(1, 1, ZoneMap::none);
    EXPECT_TRUE(map == copy);
}

TEST(ZoneMaps, AreStrokedWithARoundBrushThatStaysInside)
{
    ZoneMap dot(100, 100);
    const float middle[2] = {0.5f, 0.5f}, right[2] = {0.9f, 0.5f}, corner[2] = {1, 1};
    stroke(dot, 1, middle, middle, 20);
    EXPECT_NEAR(static_cast<double>(texels_with(dot, 1)), 314, 10);
    stroke(dot, 2, middle, right, 10);
    EXPECT_NEAR(static_cast<double>(texels_with(dot, 2)), 400 + 78, 12);
    stroke(dot, 3, corner, corner, 20);
    EXPECT_NEAR(static_cast<double>(texels_with(dot, 3)), 314 / 4, 8);
    ZoneMap fine(100, 100);
    stroke(fine, 1, middle, right, 1);
    for (uint32_t x = 50; x < 90; ++x) EXPECT_TRUE(fine.at(x, 49) == 1 || fine.at(x, 50) == 1) << x;
}

class DesignerZones : public Staged
{
protected:
    void open_citizens()
    {
        Stage stage;
        stage.line_up = {"citizen"};
        stage.count = 3;
        stage.width = 640, stage.height = 700;
        open(stage);
        play({"click \"pause\"", "click \"Camera\"", "click \"Person\"", "click \"Designer\""});
    }
    view::Designer &designer() { return session().model().designer; }
    uint32_t zone(const char *name) { return clq_template_find_zone(session().world().templates().at(0), name); }
    uint32_t zone_count()
    {
        clq_template_info info = clq_template_info_init();
        EXPECT_EQ(clq_template_get_info(session().world().templates().at(0), &info), CLQ_OK);
        return info.zone_count;
    }
};

TEST_F(DesignerZones, ThatArePaintedAreTheTemplatesWhenTheStrokeEndsAndAreUndone)
{
    open_citizens();
    const std::vector<uint8_t> before = picture();
    const uint32_t zones = zone_count();
    play({"click \"tool: brush\"", "type \"brush size\" \"40\"", "type \"new zone\" \"sash\"", "click \"add zone\"",
          "drag \"texels\" 0.05 0.7 0.95 0.7"});
    ASSERT_NE(zone("sash"), CLQ_NONE);
    EXPECT_EQ(zone_count(), zones + 1);
    EXPECT_EQ(designer().history.done(), 1u);
    EXPECT_EQ(designer().picture->at(0.5f, 0.7f), "sash");
    EXPECT_NE(designer().picture->at(0.5f, 0.3f), "sash");
    play({"click \"zone: sash\"", "type \"one colour\" \"#00ff00\"", "wait 0.1"});
    const auto greens = [this] {
        const std::vector<uint8_t> rgb = picture();
        size_t count = 0;
        for (size_t k = 0; k + 2 < rgb.size(); k += 3)
            count += rgb[k + 1] > 60 && rgb[k + 1] > 2 * rgb[k] && rgb[k + 1] > 2 * rgb[k + 2];
        return count;
    };
    EXPECT_GT(greens(), 100u);
    play({"click \"undo\"", "click \"undo\"", "wait 0.1"});
    EXPECT_EQ(zone("sash"), CLQ_NONE);
    EXPECT_EQ(picture(), before);
    play({"click \"redo\"", "click \"redo\"", "wait 0.1"});
    EXPECT_GT(greens(), 100u);
}

TEST_F(DesignerZones, FillTheIslandOfThePlaceAndNothingElse)
{
    open_citizens();
    play({"click \"tool: fill\"", "type \"new zone\" \"cloak\"", "click \"add zone\""});
    const std::shared_ptr<ZoneMap> unpainted = designer().picture->painted();
    play({"drag \"texels\" 0.3 0.7 0.3 0.7"});
    const view::SharedMap map = view::painted_map(designer());
    ASSERT_TRUE(map);
    const auto cloak =
        static_cast<uint8_t>(std::find(map->names.begin(), map->names.end(), "cloak") - map->names.begin());
    const size_t filled = texels_with(*map, cloak), all = static_cast<size_t>(map->width()) * map->height();
    EXPECT_GT(filled, all / 100);
    EXPECT_LT(filled, all * 3 / 4);
    for (uint32_t y = 0; y < map->height(); ++y)
        for (uint32_t x = 0; x < map->width(); ++x) {
            const uint8_t now = map->at(x, y);
            ASSERT_TRUE(now == cloak || now == unpainted->at(x, y)) << x << ", " << y;
        }
    // The same by itself.
    ZoneMap again = *unpainted;
    const uint8_t zone = again.zone("cloak");
    ASSERT_TRUE(fill_island(again, zone, session().world().templates().at(0), 0.3f, 0.7f));
    EXPECT_EQ(texels_with(again, zone), filled);
    ZoneMap outside = *unpainted;
    EXPECT_FALSE(fill_island(outside, zone, session().world().templates().at(0), 7.5f, 7.5f));
}

TEST_F(DesignerZones, AreProposedByTheLibraryAndCanBeColoured)
{
    open_citizens();
    play({"click \"tool: brush\"", "type \"zones at most\" \"3\"", "click \"propose zones\"", "wait 0.1"});
    const view::SharedMap map = view::painted_map(designer());
    ASSERT_TRUE(map);
    EXPECT_GE(map->names.size(), 2u);
    EXPECT_LE(map->names.size(), 3u);
    EXPECT_NE(zone("zone 1"), CLQ_NONE);
    EXPECT_NE(zone("zone 2"), CLQ_NONE);
    play({"click \"zone: zone 1\"", "drag \"hue arc\" 0.3 0.6"});
    EXPECT_TRUE(view::chosen_zone(designer()));
    EXPECT_EQ(designer().paint_failure + designer().why_not, "");
    // A zone that was painted away is said, and can be taken out of the class.
    play({"type \"zones at most\" \"1\"", "click \"propose zones\"", "click \"zone: zone 1\""});
    designer().zone = "zone 2";
    view::set_weight(designer(), clq_hsb_range_init(), 1, "");
    play({"wait 0.1", "see \"zone 2\"", "click \"zone: zone 2\"", "click \"leave to template\"", "wait 0.1"});
    EXPECT_EQ(designer().why_not, "");
}

TEST_F(DesignerZones, AreSavedAsAPictureWithAColourForEach)
{
    open_citizens();
    play({"click \"tool: brush\"", "type \"new zone\" \"sash\"", "click \"add zone\"",
          "drag \"texels\" 0.05 0.7 0.95 0.7"});
    const view::SharedMap map = view::painted_map(designer());
    ASSERT_TRUE(map);
    std::vector<uint8_t> rgb;
    std::string text, to, message;
    designer().wishes.save_zones = true;
    view::keep_zones(
        designer(), view::Folder("made"),
        [&](const std::string &path, const std::vector<uint8_t> &bytes, int width, int height) {
            to = path, rgb = bytes;
            EXPECT_EQ(width, static_cast<int>(map->width()));
            EXPECT_EQ(height, static_cast<int>(map->height()));
        },
        [&](const std::string &, const std::string &options) { text = options; }, message);
    EXPECT_EQ(to, "made/citizen-zones.png");
    ASSERT_EQ(rgb.size(), 3 * static_cast<size_t>(map->width()) * map->height());
    std::map<std::string, std::set<uint32_t>> inks;
    for (uint32_t y = 0; y < map->height(); ++y)
        for (uint32_t x = 0; x < map->width(); ++x) {
            const uint8_t *at = rgb.data() + 3 * (static_cast<size_t>(y) * map->width() + x);
            if (map->at(x, y) == ZoneMap::none) continue;
            inks[map->names[map->at(x, y)]].insert(static_cast<uint32_t>(at[0] << 16 | at[1] << 8 | at[2]));
        }
    std::set<uint32_t> all;
    for (const auto &[name, of_zone] : inks) {
        EXPECT_EQ(of_zone.size(), 1u) << name;
        all.insert(of_zone.begin(), of_zone.end());
        char option[64];
        std::snprintf(option, sizeof option, "--zone '#%06x=", *of_zone.begin());
        EXPECT_NE(text.find(option + name + "'"), std::string::npos) << text;
    }
    EXPECT_EQ(all.size(), inks.size());
    EXPECT_GT(inks.count("sash"), 0u);
}

TEST_F(DesignerZones, ThatAreTooSmallToBeReadAgainAreNotNamedAndSaid)
{
    open_citizens();
    play({"click \"tool: brush\"", "type \"new zone\" \"sash\"", "click \"add zone\"",
          "drag \"texels\" 0.05 0.7 0.95 0.7"});
    view::ZoneMap map = *view::painted_map(designer());
    for (uint32_t y = 0; y < map.height(); ++y)
        for (uint32_t x = 0; x < map.width(); ++x) map.set(x, y, map.zone("sash"));
    map.set(0, 0, map.zone("bead"));
    std::vector<std::string> colours;
    const std::vector<uint8_t> rgb = view::picture_of(map, colours);
    ASSERT_EQ(colours.size(), map.names.size());
    EXPECT_EQ(colours[map.zone("bead")], "");
    EXPECT_EQ(colours[map.zone("sash")].size(), 7u);
    view::set_zone_map(designer(), std::make_shared<const view::ZoneMap>(map), "");
    std::string text, message;
    designer().wishes.save_zones = true;
    view::keep_zones(
        designer(), view::Folder("made"), [](const std::string &, const std::vector<uint8_t> &, int, int) {},
        [&](const std::string &, const std::string &options) { text = options; }, message);
    EXPECT_NE(text.find("=sash'"), std::string::npos) << text;
    EXPECT_EQ(text.find("bead"), std::string::npos) << text;
    EXPECT_NE(message.find("too small to be read again: "), std::string::npos) << message;
    EXPECT_NE(message.find("bead"), std::string::npos) << message;
}

}  // namespace

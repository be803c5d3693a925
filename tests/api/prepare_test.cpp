// Prepared templates: their bytes on disk and in memory.
#include "prepare_fixture.h"

namespace prepare_test
{
namespace
{

TEST_F(Prepare, MakesOnceAndThenTakesTheSameBytesFromDisk)
{
    clq_prepare_report first = clq_prepare_report_init(), second = first;
    const Bytes fresh = made(owl(), first), kept = made(owl(), second);
    EXPECT_FALSE(first.from_disk);
    EXPECT_TRUE(first.stored) << first.text;
    EXPECT_TRUE(second.from_disk);
    EXPECT_EQ(fresh, kept);
    ASSERT_EQ(files().size(), 1u);
    EXPECT_EQ(read(files()[0]), fresh);
}

TEST_F(Prepare, ReplacesAFileThatWasCutOrChanged)
{
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    Bytes cut(fresh.begin(), fresh.begin() + std::ptrdiff_t(fresh.size() / 2)), changed = fresh, other = fresh;
    changed[fresh.size() / 2] ^= 1;
    other[8] ^= 1;  // its version
    for (const Bytes &bytes : {cut, changed, other, Bytes()}) {
        write(files()[0], bytes);
        EXPECT_EQ(made(owl(), report), fresh);
        EXPECT_FALSE(report.from_disk);
        EXPECT_EQ(read(files()[0]), fresh);
    }
}

TEST_F(Prepare, KeepsOtherOptionsInOtherFiles)
{
    clq_prepare_report report = clq_prepare_report_init();
    clq_prepare_def def = owl();
    made(def, report);
    def.max_texture_px = 64;
    made(def, report);
    EXPECT_FALSE(report.from_disk);
    def.builtin = "citizen";
    made(def, report);
    clq_levels_def levels = clq_levels_def_init();
    const uint32_t targets[] = {500, 400};
    levels.targets = targets, levels.target_count = 1;
    def.levels = &levels;
    made(def, report);
    EXPECT_FALSE(report.from_disk);
    levels.target_count = 2;
    made(def, report);
    EXPECT_FALSE(report.from_disk);
    EXPECT_EQ(files().size(), 5u);
}

// A map of the citizen's image: its left half is one zone, its right half another one.
struct HalfMap {
    HalfMap()
    {
        def.width_px = def.height_px = 4;
        def.texels = texels.data();
        def.zones = zones.data(), def.zone_count = 2;
    }
    std::vector<uint16_t> texels = {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
    std::vector<clq_zone_map_zone> zones = {{"left", false, nullptr}, {"right", false, nullptr}};
    clq_hsb_range range = clq_hsb_range_init();
    clq_zone_map_def def = clq_zone_map_def_init();
};

TEST_F(Prepare, KeepsTheZonesOfAMapInAFileOfItsOwn)
{
    HalfMap map;
    const clq_zone_map_def *const maps[] = {&map.def};
    clq_prepare_def def = owl();
    def.builtin = "citizen";
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes plain = made(def, report);
    def.zone_maps = maps, def.zone_map_count = 1;
    const Bytes zoned = made(def, report);
    EXPECT_FALSE(report.from_disk);
    EXPECT_NE(zoned, plain);
    const std::string all(zoned.begin(), zoned.end());
    EXPECT_NE(all.find("left"), std::string::npos);
    EXPECT_EQ(made(def, report), zoned);
    EXPECT_TRUE(report.from_disk) << report.text;
    clq_asset *asset = nullptr;
    clq_template *by_hand = nullptr;
    ASSERT_EQ(clq_asset_builtin(context_, "citizen", &asset), CLQ_OK);
    ASSERT_EQ(clq_asset_set_zone_map(context_, asset, &map.def), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_asset_build(context_, asset, 0, &by_hand), CLQ_OK);
    EXPECT_EQ(saved(by_hand), zoned);
    clq_asset_destroy(asset);
}

TEST_F(Prepare, TellsZoneMapsApartByAllThatTheySay)
{
    HalfMap map;
    const clq_zone_map_def *const maps[] = {&map.def};
    clq_prepare_def def = owl();
    def.builtin = "citizen";
    def.zone_maps = maps, def.zone_map_count = 1;
    clq_prepare_report report = clq_prepare_report_init();
    made(def, report);
    const std::function<void()> changes[] = {[&] { map.texels.back() = 0; },
                                             [&] { map.def.width_px = 2, map.def.height_px = 8; },
                                             [&] { map.zones[1].name = "other"; },
                                             [&] { map.zones[1].reduced = true; },
                                             [&] { map.zones[1].range = &map.range; },
                                             [&] { map.range.hue_max_deg = 20; },
                                             [&] { map.def.image = 1; },
                                             [&] {
                                                 map.zones.push_back({"more", false, nullptr});
                                             }};
    for (size_t i = 0; i < std::size(changes); ++i) {
        changes[i]();
        map.def.zones = map.zones.data(), map.def.zone_count = static_cast<uint32_t>(map.zones.size());
        made(def, report);
        EXPECT_FALSE(report.from_disk) << "change " << i;
    }
    EXPECT_EQ(files().size(), 1 + std::size(changes));
}

TEST_F(Prepare, RefusesAZoneMapWithoutTexelsOrZones)
{
    HalfMap map;
    const clq_zone_map_def *maps[] = {&map.def};
    clq_prepare_def def = owl();
    def.zone_maps = maps, def.zone_map_count = 1;
    const auto refused = [&](clq_status status, const char *why) {
        clq_template *tmpl = nullptr;
        EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), status) << why;
        EXPECT_NE(std::string(clq_last_error()).find(why), std::string::npos) << clq_last_error();
    };
    map.def.texels = nullptr;
    refused(CLQ_ARGUMENT, "texels of a zone map are NULL");
    map.def.texels = map.texels.data(), map.def.zones = nullptr;
    refused(CLQ_ARGUMENT, "zones of a zone map is NULL with a count of 2");
    maps[0] = nullptr;
    refused(CLQ_ARGUMENT, "a zone map is NULL");
    def.zone_maps = nullptr;
    refused(CLQ_ARGUMENT, "zone_maps is NULL with a count of 1");
    HalfMap other;
    other.def.struct_bytes -= 1;
    maps[0] = &other.def, def.zone_maps = maps;
    refused(CLQ_STRUCT_SIZE, "clq_zone_map_def_init");
}

TEST_F(Prepare, SeesThatAFileBesideTheCharacterChanged)
{
    clq_prepare_def def = owl();
    const std::string path = triangle().string(), kept = (folder_ / "kept").string();
    def.builtin = nullptr, def.path = path.c_str(), def.folder = kept.c_str();
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes before = made(def, report);
    made(def, report);
    EXPECT_TRUE(report.from_disk);
    Bytes numbers = read(folder_ / "in" / "numbers.bin");
    numbers[15] = 0x40;  // x of the second corner: 1 becomes another number
    write(folder_ / "in" / "numbers.bin", numbers);
    EXPECT_NE(made(def, report), before);
    EXPECT_FALSE(report.from_disk);
}

TEST_F(Prepare, WorksWithoutAWritableStoreAndSaysWhy)
{
    fs::create_directories(folder_);
    clq_prepare_def def = owl();
    const std::string file = (folder_ / "file").string();
    write(file, {'x'});
    def.folder = file.c_str();
    clq_prepare_report report = clq_prepare_report_init();
    EXPECT_FALSE(made(def, report).empty());
    EXPECT_FALSE(report.stored);
    EXPECT_NE(std::string(report.text).find(file), std::string::npos) << report.text;
    EXPECT_NE(std::string(report.text).find("repair that, or name another folder"), std::string::npos) << report.text;
    def.folder = "";
    EXPECT_FALSE(made(def, report).empty());
    EXPECT_FALSE(report.stored);
}

TEST_F(Prepare, RefusesNamesThatMatchNotExactlyOneCharacter)
{
    clq_prepare_def def = owl();
    clq_template *tmpl = nullptr;
    def.path = "also.glb";
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_ARGUMENT);
    def.builtin = def.path = nullptr;
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_ARGUMENT);
    def.path = "there is no such file.glb";
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_IO);
    def = owl();
    def.builtin = "nobody";
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("citizen"), std::string::npos) << clq_last_error();
    def.struct_bytes -= 1;
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_STRUCT_SIZE);
    EXPECT_EQ(tmpl, nullptr);
    EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace prepare_test

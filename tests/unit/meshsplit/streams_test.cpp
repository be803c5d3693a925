// Clean bins, dirty ranges and the fused stream of one template, as laws (S1 3).
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "models.h"

namespace claque::test
{

using model::Level;
using model::Surface;

namespace
{

// A triangle as its source vertices.
std::array<uint32_t, 3> source_of(const Level &level, uint32_t first_index)
{
    std::array<uint32_t, 3> out;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t v = level.indices[first_index + k];
        out[k] = v < level.source_count ? v : level.copies[v - level.source_count];
    }
    return out;
}

using Touched = std::map<std::array<uint32_t, 3>, std::vector<uint32_t>>;

template <class Body>
void each_triangle(const model::IndexRange &range, const Body &body)
{
    for (uint32_t i = range.first; i < range.first + range.count; i += 3) body(i);
}

Touched zones_by_bins(const Level &level, const Surface &surface)
{
    Touched out;
    for (const auto *bins : {&surface.clean, &surface.dirty_by_zone})
        for (const model::Bin &bin : *bins)
            each_triangle(bin.range, [&](uint32_t i) { out[source_of(level, i)].push_back(bin.zone_index); });
    return out;
}

// The triangles of ranges in the order in which they are drawn.
using Order = std::vector<std::array<uint32_t, 3>>;
Order order_of(const Level &level, const std::vector<model::IndexRange> &ranges)
{
    Order out;
    for (const model::IndexRange &range : ranges)
        each_triangle(range, [&](uint32_t i) { out.push_back(source_of(level, i)); });
    return out;
}

void expect_laws(const model::Template &tmpl)
{
    const Level &level = tmpl.levels[0];
    uint32_t triangles = 0, dirty = 0, zone_sum = 0, fused = 0;
    for (const Surface &surface : level.surfaces) {
        const Touched by_bins = zones_by_bins(level, surface);
        std::set<std::array<uint32_t, 3>> dirty_once;
        each_triangle(surface.dirty, [&](uint32_t i) {
            EXPECT_TRUE(dirty_once.insert(source_of(level, i)).second) << "a dirty triangle occurs twice";
            EXPECT_GE(by_bins.at(source_of(level, i)).size(), 2u);
        });
        for (const model::Bin &bin : surface.clean)
            each_triangle(bin.range, [&](uint32_t i) { EXPECT_EQ(by_bins.at(source_of(level, i)).size(), 1u); });

        Touched by_fused;
        each_triangle(surface.fused, [&](uint32_t i) {
            const uint16_t slot = level.slots[level.indices[i]];
            for (uint32_t k = 1; k < 3; ++k) EXPECT_EQ(level.slots[level.indices[i + k]], slot);
            auto &zones = by_fused[source_of(level, i)];
            EXPECT_EQ(slot % 2, zones.empty() ? 0 : 1) << "the lowest copy is never raised, all others are";
            EXPECT_TRUE(zones.empty() || slot / 2u > zones.back()) << "copies ascend";
            zones.push_back(slot / 2u);
            ++fused;
        });
        EXPECT_EQ(by_fused, by_bins) << "both strategies show the same zones of every triangle";
        std::vector<model::IndexRange> bins;
        for (const auto *some : {&surface.clean, &surface.dirty_by_zone})
            for (const model::Bin &bin : *some) bins.push_back(bin.range);
        ASSERT_TRUE(surface.part_offsets.empty());
        EXPECT_EQ(order_of(level, {surface.fused}), order_of(level, bins)) << "so that depths tie in one way";
        triangles += uint32_t(by_bins.size());
        dirty += uint32_t(dirty_once.size());
        for (const auto &entry : by_bins)
            if (entry.second.size() > 1) zone_sum += uint32_t(entry.second.size());
    }
    EXPECT_EQ(tmpl.report.triangles, triangles);
    EXPECT_EQ(tmpl.report.dirty, dirty);
    EXPECT_EQ(tmpl.report.dirty_zone_sum, zone_sum);
    EXPECT_EQ(tmpl.report.fused_triangles, fused);
    EXPECT_EQ(tmpl.report.copies, level.copies.size());
    uint32_t clean = 0;
    for (const uint32_t count : tmpl.zone_clean) clean += count;
    EXPECT_EQ(clean + dirty, triangles);
}

// A source vertex has one copy less than slots, and all copies differ.
void expect_fewest_copies(const Level &level)
{
    std::set<std::pair<uint32_t, uint16_t>> pairs;
    for (uint32_t v = 0; v < level.vertex_count; ++v) {
        const uint32_t source = v < level.source_count ? v : level.copies[v - level.source_count];
        EXPECT_TRUE(pairs.insert({source, level.slots[v]}).second) << "two vertices for one slot";
        for (uint32_t k = 0; k < 2; ++k) EXPECT_EQ(level.uvs[2 * v + k], level.uvs[2 * source + k]);
    }
}

}  // namespace

TEST(Streams, TortureOf2To48ZonesKeepsEveryLawAndLosesNothing)
{
    for (const uint32_t zones : {2u, 8u, 10u, 16u, 48u}) {
        const auto tmpl = built(torture(zones, 10, 5));
        EXPECT_EQ(tmpl->report.triangles, 32u);
        EXPECT_EQ(tmpl->report.dirty, 32u);
        EXPECT_EQ(tmpl->report.dirty_zone_sum, 32 * zones);
        expect_laws(*tmpl);
        expect_fewest_copies(tmpl->levels[0]);
        EXPECT_EQ(tmpl->levels[0].source_count, 25u);
        EXPECT_EQ(tmpl->levels[0].vertex_count, 25 * zones);
    }
}

namespace
{

// A sheet of `side` squares each way, all of whose triangles show most of 20 zones, and 19 levels of two triangles.
model::Model speckled(uint32_t side)
{
    model::Model m = torture(20, 10, 5);
    m.source_bytes = 1;  // the allowance is what every model has
    m.parts[0] = sheet_part(side, side);
    for (uint32_t level = 0; level < 20; ++level) {
        if (level > 0) m.parts.push_back(sheet_part(1, 1));
        m.parts.back().lod_min_m = float(level);
        m.parts.back().lod_max_m = level < 19 ? float(level + 1) : std::numeric_limits<float>::infinity();
    }
    return m;
}

}  // namespace

// The finest level alone needs more than a twentieth of what there is for all.
TEST(Streams, OfAllLevelsShareOneLimit)
{
    const auto tmpl = built(speckled(16));
    EXPECT_EQ(tmpl->levels.size(), 20u);
    EXPECT_EQ(tmpl->report.dirty, 512u);
    expect_laws(*tmpl);
    try {
        built(speckled(64));
        ADD_FAILURE() << "is not refused";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_LIMIT);
        const std::string said = error.what();
        EXPECT_NE(
            said.find("for the 1 bytes read; 20 zones are too many: fewer come from materials joined in the file"),
            std::string::npos)
            << said;
        EXPECT_NE(said.find("--propose N or --zones PNG of claque prepare"), std::string::npos) << said;
    }
}

// What no level needs alone may still be more than there is for all of them together.
TEST(Streams, OfAllLevelsTogetherAreLimited)
{
    model::Model m = speckled(16);
    for (model::Part &part : m.parts) {
        const float first = part.lod_min_m, last = part.lod_max_m;
        part = sheet_part(12, 12);
        part.lod_min_m = first, part.lod_max_m = last;
    }
    try {
        built(m);
        ADD_FAILURE() << "is not refused";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_LIMIT);
        EXPECT_NE(std::string(error.what()).find("5760 triangles in all levels of detail show"), std::string::npos)
            << error.what();
    }
}

TEST(Streams, KeysMayStartAt0AndBe1Apart)
{
    for (const uint32_t zones : {2u, 16u, 200u}) {
        const auto tmpl = built(torture(zones, 0, 1));
        expect_laws(*tmpl);
        ASSERT_EQ(tmpl->textures[0].keys.size(), zones);
        for (uint32_t i = 0; i < zones; ++i) EXPECT_EQ(tmpl->textures[0].keys[i].zone, i) << "order of the file's keys";
        EXPECT_GT(tmpl->textures[0].keys[0].key, 0);
    }
}

TEST(Streams, CleanTrianglesLieInTheBinOfTheirZone)
{
    // Left half zone 7, right half zone 3; eight columns of triangles, none across.
    const auto image = key_image(64, 64, [](uint32_t x, uint32_t) { return x < 30 ? 7 : 3; });
    model::Model m = keyed_sheet(8, 2, image, {7, 3});
    m.materials[0].wrap_s = m.materials[0].wrap_t = model::Wrap::clamp;
    const auto tmpl = built(m);
    expect_laws(*tmpl);
    const Level &level = tmpl->levels[0];
    const Surface &surface = level.surfaces[0];
    EXPECT_EQ(tmpl->report.dirty, 4u) << "one column of two squares holds the border";
    ASSERT_EQ(surface.clean.size(), 2u);
    for (const model::Bin &bin : surface.clean) {
        const uint32_t zone = tmpl->textures[0].keys[bin.zone_index].zone;
        EXPECT_EQ(std::string_view(tmpl->zone_names[zone]), bin.zone_index == 0 ? "zone 3" : "zone 7");
        each_triangle(bin.range, [&](uint32_t i) {
            for (const uint32_t v : source_of(level, i)) EXPECT_EQ(level.uvs[2 * v] < 0.45f, bin.zone_index == 1);
        });
    }
    EXPECT_EQ(tmpl->zone_clean[0], 12u);
    EXPECT_EQ(tmpl->zone_clean[1], 16u);
}

TEST(Streams, HolesMakeNoTriangleDirtyAndATriangleOfHolesIsKept)
{
    model::Model m = empty_model();
    model::Image image =
        key_image(32, 32, [](uint32_t x, uint32_t y) { return (x / 2 + y / 2) % 2 || x < 16 ? 0 : 200; });
    image.alpha = model::AlphaMeaning::opacity;
    m.images.push_back(image);
    m.materials.emplace_back();
    m.materials[0].image = 0;
    m.materials[0].alpha_mode = model::AlphaMode::mask;
    m.parts.push_back(sheet_part(4, 4));
    const auto tmpl = built(m);
    expect_laws(*tmpl);
    EXPECT_EQ(tmpl->report.triangles, 32u);
    EXPECT_EQ(tmpl->report.dirty, 0u);
    const model::Texture &texture = tmpl->textures[0];
    EXPECT_TRUE(texture.has_holes);
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 32; ++x)
            EXPECT_EQ(texture.rgba[4 * (y * 32 + x) + 3], (x / 2 + y / 2) % 2 || x < 16 ? 0 : 255);
}

TEST(Streams, EveryKeyThatATriangleSamplesIsInItsZoneSet)
{
    const auto tmpl = built(torture(10, 0, 25));
    const Level &level = tmpl->levels[0];
    const model::Texture &texture = tmpl->textures[0];
    const Touched touched = zones_by_bins(level, level.surfaces[0]);
    for (const auto &[corners, zones] : touched)
        for (int k = 0; k < 400; ++k) {
            float a = float(k % 20) / 19, b = float(k / 20) / 19;
            if (a + b > 1) a = 1 - a, b = 1 - b;
            float uv[2];
            for (uint32_t c = 0; c < 2; ++c)
                uv[c] = level.uvs[2 * corners[0] + c] * (1 - a - b) + level.uvs[2 * corners[1] + c] * a +
                        level.uvs[2 * corners[2] + c] * b;
            const uint32_t x = uint32_t(uv[0] * 64) % 64, y = uint32_t(uv[1] * 64) % 64;
            const uint8_t key = texture.rgba[4 * (y * 64 + x) + 3];
            const bool found =
                std::any_of(zones.begin(), zones.end(), [&](uint32_t z) { return texture.keys[z].key == key; });
            ASSERT_TRUE(found);
        }
}

}  // namespace claque::test

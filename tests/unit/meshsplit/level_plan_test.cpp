// Levels of detail by distance (S0 5.1): each holds exactly the geometry that is drawn from its distance on.
#include <map>

#include <gtest/gtest.h>

#include "articulated.h"
#include "lib/model/template_check.h"
#include "lib/model/template_file.h"

namespace claque::test
{

namespace
{

// The triangles, by the bind positions of their corners, lowest first.
using Triangles = std::multiset<std::array<float, 9>>;

void add(Triangles &to, std::array<glm::vec3, 3> t)
{
    const auto before = [](glm::vec3 a, glm::vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::rotate(t.begin(), std::min_element(t.begin(), t.end(), before), t.end());
    to.insert({t[0].x, t[0].y, t[0].z, t[1].x, t[1].y, t[1].z, t[2].x, t[2].y, t[2].z});
}

Triangles triangles_of(const model::Level &level)
{
    Triangles out;
    const std::vector<uint32_t> corners = corners_of(level);
    const auto at = [&](size_t i) {
        const float *p = level.positions.data() + 3 * size_t(corners[i]);
        return glm::vec3(p[0], p[1], p[2]);
    };
    for (size_t i = 0; i < corners.size(); i += 3) add(out, {at(i), at(i + 1), at(i + 2)});
    return out;
}

Triangles triangles_at(const model::Model &m, float distance)
{
    Triangles out;
    for (const model::Part &part : m.parts)
        if (part.lod_min_m <= distance && distance < part.lod_max_m)
            for (const auto &t : model::triangles_of(part))
                add(out, {part.positions[t[0]], part.positions[t[1]], part.positions[t[2]]});
    return out;
}

std::vector<float> distances_of(const model::Template &tmpl)
{
    std::vector<float> out;
    for (const model::Level &level : tmpl.levels) out.push_back(level.switch_distance_m);
    return out;
}

// Three levels of a body, a hat in distance bands of its own, and a sign that exists only at a distance.
Puppet in_levels()
{
    Puppet m;
    m.hang(m.root, "body", 0, 20, 4);
    m.hang(m.root, "body, coarse", 20, 60, 2);
    m.hang(m.root, "body, block", 60, for_ever, 1);
    m.hang(m.spine, "hat", 5, 35, 3);
    m.hang(m.leg, "sign", 90, 120, 1);
    for (size_t p = 0; p < m.parts.size(); ++p)
        for (glm::vec3 &v : m.parts[p].positions) v.z = float(p);
    return m;
}

}  // namespace

TEST(Levels, AModelInWhichNothingChangesWithDistanceHasOneThatEvaluatesEverything)
{
    Puppet m;
    m.hang(m.root, "body");
    m.hang(m.hand, "hand");
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels.size(), 1u);
    const model::Level &level = tmpl->levels[0];
    EXPECT_EQ(level.switch_distance_m, 0);
    EXPECT_EQ(level.skeletal_level, 0u);
    EXPECT_TRUE(level.active.empty() && level.nodes.empty() && level.entries.empty());
    EXPECT_EQ(tmpl->rig.palette.size(), 2u);
}

TEST(Levels, BeginWhereverAPartBeginsOrEndsOrANodeStops)
{
    Puppet m = in_levels();
    m.stop(m.finger, 45);
    m.stop(m.arm, 60);
    const auto tmpl = built(m);
    EXPECT_EQ(distances_of(*tmpl), (std::vector<float>{0, 5, 20, 35, 45, 60, 90, 120}));
    model::check(*tmpl);
}

TEST(Levels, HoldExactlyTheTrianglesOfThePartsWhoseRangeHoldsTheirDistance)
{
    const Puppet m = in_levels();
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels.size(), 7u);
    for (const model::Level &level : tmpl->levels) {
        EXPECT_EQ(triangles_of(level), triangles_at(m, level.switch_distance_m)) << level.switch_distance_m;
        EXPECT_EQ(triangles_of(level).size(), corners_of(level).size() / 3);
    }
    EXPECT_EQ(tmpl->report.triangles, 32u) << "the report is of the first";
}

TEST(Levels, AreNotMadeForHiddenParts)
{
    Puppet m = in_levels();
    m.parts.back().hidden = true;
    EXPECT_EQ(distances_of(*built(m)), (std::vector<float>{0, 5, 20, 35, 60}));
}

TEST(Levels, ShareTexturesAndZones)
{
    model::Model m =
        keyed_sheet(2, 2, key_image(16, 16, [](uint32_t x, uint32_t) { return uint8_t(x < 8 ? 1 : 2); }), {1, 2});
    m.images.push_back(key_image(8, 8, [](uint32_t, uint32_t) { return uint8_t(2); }));
    m.materials.emplace_back();
    m.materials[1].image = 1;
    m.parts[0].lod_max_m = 10;
    m.parts.push_back(sheet_part(1, 1));
    m.parts[1].material = 1;
    m.parts[1].lod_min_m = 10, m.parts[1].lod_max_m = 50;
    m.parts.push_back(sheet_part(3, 1));
    m.parts[2].lod_min_m = 50;
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels.size(), 3u);
    EXPECT_EQ(tmpl->textures.size(), 2u);
    EXPECT_EQ(tmpl->levels[0].surfaces[0].texture, 0u);
    EXPECT_EQ(tmpl->levels[1].surfaces[0].texture, 1u);
    EXPECT_EQ(tmpl->levels[2].surfaces[0].texture, 0u);
    EXPECT_EQ(tmpl->zone_count(), 2u);
    model::check(*tmpl);
}

TEST(Levels, PartsOfCoarseLevelsKeepTheirTexelsWhenGuttersAreFilled)
{
    // The near part covers the image's left half, the distant one its right half: neither may overwrite the other.
    const auto image = key_image(64, 64, [](uint32_t x, uint32_t) { return uint8_t(x < 32 ? 5 : 9); });
    model::Model m = keyed_sheet(1, 1, image, {5, 9});
    m.parts[0] = sheet_part(1, 1, {0.1f, 0.1f}, {0.4f, 0.9f});
    m.parts[0].lod_max_m = 30;
    m.parts.push_back(sheet_part(1, 1, {0.6f, 0.1f}, {0.9f, 0.9f}));
    m.parts[1].lod_min_m = 30;
    const auto tmpl = built(m);
    EXPECT_EQ(tmpl->textures[0].keys.size(), 2u);
    const model::Surface &far = tmpl->levels[1].surfaces[0];
    ASSERT_EQ(far.clean.size(), 1u);
    EXPECT_EQ(tmpl->zone_names[tmpl->textures[0].keys[far.clean[0].zone_index].zone], "zone 9");
}

TEST(Levels, WhereNothingIsDrawnAreEmptyAndCanBeSaved)
{
    Puppet m;
    m.hang(m.root, "body", 0, 50);
    m.hang(m.root, "sign", 80, 90);
    const auto tmpl = built(m);
    ASSERT_EQ(distances_of(*tmpl), (std::vector<float>{0, 50, 80, 90}));
    for (const size_t k : {1, 3}) {
        EXPECT_TRUE(tmpl->levels[k].surfaces.empty() && tmpl->levels[k].parts.empty());
        EXPECT_EQ(tmpl->levels[k].vertex_count, 0u);
    }
    model::check(*tmpl);
    std::pmr::vector<uint8_t> bytes, again;
    model::save(*tmpl, bytes);
    model::Template loaded(std::pmr::get_default_resource());
    model::load(bytes.data(), bytes.size(), loaded);
    model::save(loaded, again);
    EXPECT_EQ(bytes, again);
}

TEST(Levels, NothingToDrawNearTheEyeIsRefused)
{
    Puppet m;
    m.hang(m.root, "sign", 80, 90);
    EXPECT_TRUE(says(refused(m), {"puppet", "no triangle to draw near the eye"}));
}

TEST(Levels, BeyondTheMaximumAreRefusedWithTheirNumber)
{
    Puppet m;
    m.hang(m.root, "body");
    for (int i = 0; i < 64; ++i) m.hang(m.root, "flag", float(i), float(i + 1));
    EXPECT_TRUE(says(refused(m, CLQ_LIMIT), {"puppet", "64 distances", "64 levels"}));
    m.parts.pop_back();
    EXPECT_EQ(built(m)->levels.size(), 64u);
}

TEST(Levels, ARigidPartOnANodeThatHasStoppedIsRefusedWithBothNames)
{
    Puppet m;
    m.hang(m.root, "body");
    m.hang(m.hand, "glove", 0, 60);
    m.stop(m.hand, 30);
    EXPECT_TRUE(says(refused(m), {"puppet", "'glove'", "'hand'", "stops at 30 m", "from 0 m to 60 m"}));
    m.stop(m.hand, 70);
    m.stop(m.arm, 40);
    EXPECT_TRUE(says(refused(m), {"'glove'", "'hand'", "stops at 40 m with 'arm' above it"}));
    m.stop(m.arm, 60);
    m.hang(m.spine, "stump", 60);
    EXPECT_EQ(refused(m), "");
}

TEST(Levels, ARigidPartThatEndsWithItsNodeNeedsAReplacementThere)
{
    Puppet m;
    m.hang(m.root, "body");
    m.hang(m.hand, "glove", 0, 30);
    m.stop(m.arm, 30);
    const std::string text = refused(m);
    EXPECT_TRUE(says(text, {"'glove'", "'hand'", "'arm'", "30 m", "takes over"}));
    m.hang(m.spine, "arm in one piece", 31);
    EXPECT_NE(refused(m), "") << "it begins too late";
    m.parts.back().lod_min_m = 30;
    EXPECT_EQ(refused(m), "");
}

TEST(Levels, AReplacementMustHangOnARemainingNode)
{
    Puppet m;
    m.hang(m.root, "body");
    m.hang(m.hand, "glove", 0, 30);
    m.hang(m.hand, "coarse glove", 30, 40);
    m.stop(m.hand, 30);
    EXPECT_NE(refused(m), "");
    m.parts.pop_back();
    m.skin({m.root, m.spine}, "coarse arm", 30, 40);
    EXPECT_EQ(refused(m), "") << "a skinned part may be the replacement too";
}

TEST(Levels, NoReplacementIsNeededWhereNothingIsDrawn)
{
    Puppet m;
    m.hang(m.root, "body", 0, 30);
    m.hang(m.hand, "glove", 0, 30);
    m.stop(m.hand, 30);
    EXPECT_EQ(refused(m), "");
    m.parts[0].lod_max_m = 31;
    EXPECT_NE(refused(m), "");
}

TEST(Levels, APartThatEndsBeforeItsNodeStopsNeedsNothing)
{
    Puppet m;
    m.hang(m.root, "body");
    m.hang(m.hand, "glove", 0, 20);
    m.stop(m.hand, 30);
    EXPECT_EQ(refused(m), "");
}

TEST(Levels, SkinnedVerticesOnARootThatStopsAreRefused)
{
    Puppet m;
    m.skin({m.spine, m.arm}, "body", 0, 50);
    m.stop(m.root, 40);
    EXPECT_TRUE(says(refused(m), {"puppet", "'body'", "'root'", "40 m", "50 m"}));
    m.stop(m.root, 50);
    EXPECT_EQ(refused(m), "");
}

TEST(Levels, SkinnedVerticesMayNameAStoppedRootWithoutWeight)
{
    Puppet m;
    const uint32_t prop = add_node(m, model::none, "prop", {0, 0, 0});
    model::Part &part = m.skin({m.spine, m.arm}, "body");
    ASSERT_EQ(part.weights[1], 0);
    part.joints[1] = add_entry(m, prop);
    m.stop(prop, 40);
    EXPECT_EQ(refused(m), "");
    part.weights[0] = 0.75f, part.weights[1] = 0.25f;
    EXPECT_TRUE(says(refused(m), {"'body' is drawn to inf m and follows node 'prop'", "stops at 40 m"}));
}

}  // namespace claque::test

// Parts that are culled separately (S0 4.1, 4.2 phase 3): their index ranges and their spheres.
#include <set>

#include <gtest/gtest.h>

#include "lib/model/template_check.h"
#include "meshsplit/enclosing.h"
#include "meshsplit/morph_limits.h"
#include "posed.h"

namespace claque::test
{

namespace
{

// Parts over a checkerboard of zones, part p at z = p.
model::Model striped(uint32_t parts)
{
    const auto key = [](uint32_t x, uint32_t y) { return uint8_t((x / 5 + y / 7) % 3); };
    model::Model m = keyed_sheet(1, 1, key_image(32, 32, key), {0, 1, 2});
    m.materials.push_back(m.materials[0]);
    m.materials[1].double_sided = true;
    m.parts.clear();
    for (uint32_t p = 0; p < parts; ++p) {
        model::Part part = sheet_part(5 + p % 3, 9);
        part.material = p % 4 == 3;
        for (glm::vec3 &v : part.positions) v.z = float(p);
        m.parts.push_back(part);
    }
    return m;
}

std::vector<model::IndexRange> ranges_of(const model::Surface &surface)
{
    std::vector<model::IndexRange> out;
    for (const model::Bin &bin : surface.clean) out.push_back(bin.range);
    out.push_back(surface.dirty);
    for (const model::Bin &bin : surface.dirty_by_zone) out.push_back(bin.range);
    out.push_back(surface.fused);
    return out;
}

float z_of(const model::Level &level, uint32_t index)
{
    const uint32_t v = level.indices[index];
    return level.positions[3 * (v < level.source_count ? v : level.copies[v - level.source_count]) + 2];
}

}  // namespace

TEST(Parts, AreConsecutiveInEveryRange)
{
    const auto tmpl = built(striped(9));
    const model::Level &level = tmpl->levels[0];
    ASSERT_EQ(level.parts.size(), 9u);
    ASSERT_EQ(level.surfaces.size(), 2u);
    for (const model::Surface &surface : level.surfaces) {
        EXPECT_GT(surface.dirty_by_zone.size(), 1u);
        const uint32_t *firsts = surface.part_offsets.data();
        for (const model::IndexRange &range : ranges_of(surface)) {
            for (uint32_t p = 0; p < 9; ++p)
                for (uint32_t i = firsts[p]; i < firsts[p + 1]; ++i) ASSERT_EQ(z_of(level, range.first + i), float(p));
            EXPECT_EQ(firsts[9], range.count);
            firsts += 10;
        }
        EXPECT_EQ(firsts, surface.part_offsets.data() + surface.part_offsets.size());
    }
    model::check(*tmpl);
}

TEST(Parts, WithinTheFusedRangeHaveTheirTrianglesInTheOrderOfTheBins)
{
    const auto tmpl = built(striped(6));
    const model::Level &level = tmpl->levels[0];
    for (const model::Surface &surface : level.surfaces) {
        const std::vector<model::IndexRange> ranges = ranges_of(surface);
        const size_t dirty = surface.clean.size(), fused = ranges.size() - 1;
        size_t shown = 0;
        for (uint32_t part = 0; part < 6; ++part) {
            const auto add = [&](size_t range, std::vector<uint32_t> &out) {
                const uint32_t *firsts = surface.part_offsets.data() + 7 * range + part;
                for (uint32_t i = firsts[0]; i < firsts[1]; ++i) {
                    const uint32_t v = level.indices[ranges[range].first + i];
                    out.push_back(v < level.source_count ? v : level.copies[v - level.source_count]);
                }
            };
            std::vector<uint32_t> of_bins, of_fused;
            for (size_t range = 0; range < fused; ++range)
                if (range != dirty) add(range, of_bins);
            add(fused, of_fused);
            EXPECT_EQ(of_fused, of_bins) << "part " << part;
            shown += of_fused.size();
        }
        EXPECT_EQ(shown, surface.fused.count);
    }
}

TEST(Parts, ThatAreAloneLeaveTheRangesAsTheyAre)
{
    const auto tmpl = built(striped(1));
    ASSERT_EQ(tmpl->levels[0].parts.size(), 1u);
    EXPECT_EQ(tmpl->levels[0].parts[0].triangles, 90u);
    EXPECT_TRUE(tmpl->levels[0].surfaces[0].part_offsets.empty());
}

TEST(Parts, WithoutTrianglesAreNone)
{
    Puppet m;
    m.hang(m.root, "body");
    m.hang(m.spine, "points").topology = model::Topology::points;
    m.hang(m.arm, "later", 20);
    m.hang(m.leg, "shoe");
    const auto tmpl = built(m);
    EXPECT_EQ(tmpl->levels[0].parts.size(), 2u);
    EXPECT_EQ(tmpl->levels[0].parts[1].node, m.leg);
    EXPECT_EQ(tmpl->levels[1].parts.size(), 3u);
}

TEST(Parts, BeyondSixtyFourAreDrawnWithTheirNeighbours)
{
    const auto tmpl = built(striped(150));
    const model::Level &level = tmpl->levels[0];
    ASSERT_EQ(level.parts.size(), 64u);
    float last = -1;
    for (const model::LevelPart &part : level.parts) {
        const model::Sphere &sphere = level.part_spheres[part.first_sphere].bind;
        EXPECT_GT(sphere.centre.z, last) << "in their order";
        last = sphere.centre.z;
        EXPECT_LE(part.triangles, 3u * 2 * 7 * 9);
        EXPECT_GE(part.triangles, 2u * 2 * 5 * 9);
    }
    model::check(*tmpl);
}

TEST(Parts, HangOnTheLowestNodeAboveAllThatMovesThem)
{
    Puppet m;
    m.hang(m.hand, "glove");
    m.skin({m.arm, m.hand, m.finger}, "sleeve");
    m.skin({m.finger, m.leg}, "rope");
    const uint32_t other = add_node(m, model::none, "other root", {9, 0, 0});
    m.skin({m.finger, other}, "bridge");
    const auto tmpl = built(m);
    ASSERT_EQ(tmpl->levels[0].parts.size(), 4u);
    EXPECT_EQ(tmpl->levels[0].parts[0].node, m.hand);
    EXPECT_EQ(tmpl->levels[0].parts[1].node, m.arm);
    EXPECT_EQ(tmpl->levels[0].parts[2].node, m.root);
    EXPECT_EQ(tmpl->levels[0].parts[3].node, m.root) << "two trees have no common ancestor: the first root";
    model::check(*tmpl);
}

TEST(Parts, HangOnRemainingNodesWhereNodesStop)
{
    Puppet m;
    m.skin({m.hand, m.finger}, "glove");
    m.stop(m.hand, 20);
    EXPECT_EQ(built(m)->levels[1].parts[0].node, m.arm);
}

TEST(PartSpheres, HoldTheirPartInEveryPoseOfAClip)
{
    Puppet m;
    m.skin({m.root, m.spine, m.arm, m.hand, m.finger}, "body");
    m.swing({m.spine, m.arm, m.hand, m.finger});
    m.stop(m.finger, 20);
    const auto tmpl = built(m);
    pose::Workspace workspace(tmpl->rig);
    for (int i = 0; i <= 200; ++i) {
        const auto palette = workspace.pose(0, 0.01 * i);
        for (const model::Level &level : tmpl->levels)
            expect_held(*tmpl, level, palette.data, workspace.weights().data);
    }
    EXPECT_EQ(tmpl->levels[0].part_spheres.size(), 5u);
    EXPECT_EQ(tmpl->levels[1].part_spheres.size(), 4u);
}

TEST(PartSpheres, HoldWhatMorphTargetsMoveWithDegreesOfFreedomAtTheirEnds)
{
    Puppet m;
    model::Part &part = m.hang(m.root, "face", 0, for_ever, 3);
    m.rig.morph_sets.push_back({m.root, 0, 2});
    m.rig.rest_weights = {0.5f, 0};
    part.morph_set = 0;
    part.morphs.resize(2);
    for (size_t v = 0; v < part.positions.size(); ++v) {
        part.morphs[0].positions.emplace_back(0, 0, float(v));
        part.morphs[1].positions.emplace_back(float(v % 3), 0, 0);
    }
    // A spline that swings far beyond its keys.
    m.rig.clips.push_back({0, 1, 0, 1});
    m.rig.clip_names.emplace_back("smile");
    m.rig.times = {0, 1};
    m.rig.values = {0, 0, 0.2f, 0.1f, 30, -20, 0, 0, 0.4f, 0.3f, 0, 0};
    m.rig.channels.push_back({0, model::ChannelTarget::morph_weights, model::Interpolation::cubic_spline, 2, 0, 2, 0});
    m.rig.dofs.push_back({0, model::DofKind::morph, 1, glm::vec3(0, 1, 0), -2, 3, 0});
    m.rig.dof_names.resize(1);
    const auto tmpl = built(m);
    const model::Level &level = tmpl->levels[0];
    pose::Workspace workspace(tmpl->rig);
    float most = 0;
    for (int i = 0; i <= 100; ++i)
        for (const float freedom : {-2.0f, 0.0f, 3.0f}) {
            const auto palette = workspace.pose(0, 0.01 * i);
            std::vector<float> weights(workspace.weights().begin(), workspace.weights().end());
            weights[1] += freedom;
            most = std::max(most, weights[0]);
            expect_held(*tmpl, level, palette.data, weights.data());
        }
    EXPECT_GT(most, 4) << "the spline must swing";
    const auto limits = meshsplit::morph_limits(tmpl->rig);
    EXPECT_GE(limits[0].high, most);
    EXPECT_LT(limits[0].high, most * 1.2f);
    EXPECT_LE(limits[1].low, -2);
}

TEST(PartSpheres, OfAMorphTargetHoldBothEndsOfItsWeightAndLittleMore)
{
    Puppet m;
    model::Part &part = m.hang(m.root, "face");
    m.rig.morph_sets.push_back({m.root, 0, 1});
    m.rig.rest_weights = {0.5f};
    part.morph_set = 0;
    part.morphs.resize(1);
    part.morphs[0].positions.assign(4, glm::vec3(0, 0, 10));
    m.rig.dofs.push_back({0, model::DofKind::morph, 0, glm::vec3(0, 1, 0), -1, 2, 0});
    m.rig.dof_names.resize(1);
    const model::Sphere sphere = built(m)->levels[0].part_spheres[0].bind;
    EXPECT_NEAR(sphere.centre.z, 10, 0.1) << "weights are from -0.5 to 2.5";
    EXPECT_GE(sphere.radius, 15 + 0.7f);
    EXPECT_LT(sphere.radius, 16);
}

TEST(PartSpheres, AreNearTheSmallest)
{
    Puppet m;
    m.hang(m.root, "sheet", 0, for_ever, 8);
    const auto tmpl = built(m);
    const model::Sphere &sphere = tmpl->levels[0].part_spheres[0].bind;
    EXPECT_LT(sphere.radius, 0.5f * std::sqrt(2.0f) * 1.01f);
    EXPECT_LT(glm::distance(sphere.centre, glm::vec3(0.5f, 0.5f, 0)), 0.01f);
    // The centre of its box is not the centre of an equilateral triangle.
    const model::Sphere even = meshsplit::enclosing({{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0.5, 0.8660254, 0}, 0}});
    EXPECT_LT(even.radius, 0.5773503f * 1.03f);
    const model::Sphere two = meshsplit::enclosing({{{0, 0, 0}, 1}, {{10, 0, 0}, 3}});
    EXPECT_NEAR(two.radius, 7, 0.1);
    EXPECT_NEAR(two.centre.x, 6, 0.1);
}

}  // namespace claque::test

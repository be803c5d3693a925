// Prepared files are refused if their levels, skeletons or parts would make drawing unsafe.
#include <limits>

#include "prepared_files.h"

namespace claque::test
{

TEST(TemplateLevels, ThatWouldMakeDrawingUnsafeAreRefused)
{
    using Levels = model::Array<model::Level>;
    const std::vector<void (*)(Levels &)> breaks = {
        [](Levels &l) { l[0].switch_distance_m = 1; },
        [](Levels &l) { l[2].switch_distance_m = l[1].switch_distance_m; },
        [](Levels &l) { l[1].switch_distance_m = std::numeric_limits<float>::infinity(); },
        [](Levels &l) { l[4].surfaces.emplace_back(l.get_allocator().resource()); },
        [](Levels &l) { l[4].indices.push_back(0); },
        [](Levels &l) {
            l[4].parts.push_back({0, 0, 1, 0});
        },
        // skeletons
        [](Levels &l) { l[3].skeletal_level = 4; },
        [](Levels &l) { l[3].skeletal_level = 3; },
        [](Levels &l) { l[2].skeletal_level = 1; },
        [](Levels &l) { l[1].skeletal_level = 0; },
        [](Levels &l) { l[1].active.clear(); },
        [](Levels &l) { l[1].active.clear(), l[1].nodes.clear(); },
        [](Levels &l) { l[1].active.pop_back(); },
        [](Levels &l) { l[1].active[4] = 2; },
        [](Levels &l) { l[1].active[5] = 0; },
        [](Levels &l) { l[1].active[4] = 1; },
        [](Levels &l) { l[1].nodes.push_back(4); },
        [](Levels &l) { l[1].nodes.pop_back(); },
        [](Levels &l) { std::swap(l[1].nodes[0], l[1].nodes[1]); },
        [](Levels &l) { l[0].active[0] = 0, l[0].nodes.erase(l[0].nodes.begin()); },
        [](Levels &l) { l[1].entries.push_back(99); },
        [](Levels &l) { l[1].entries.push_back(l[1].entries.back()); },
        [](Levels &l) { l[1].entries.push_back(4), std::sort(l[1].entries.begin(), l[1].entries.end()); },
        [](Levels &l) { l[1].entries.erase(l[1].entries.begin()); },
        [](Levels &l) { l[3].entries.pop_back(); },
        [](Levels &l) { l[1].joints[0] = 4; },
        // parts
        [](Levels &l) { l[0].parts.clear(); },
        [](Levels &l) { l[0].parts.pop_back(); },
        [](Levels &l) { l[0].parts.resize(65); },
        [](Levels &l) { l[0].parts[0].node = 6; },
        [](Levels &l) { l[0].parts[0].node = model::none; },
        [](Levels &l) { l[2].parts[0].node = 3; },
        [](Levels &l) { l[0].parts[0].triangles += 1; },
        [](Levels &l) { l[0].parts[0].triangles += 1, l[0].parts[1].triangles -= 1; },
        [](Levels &l) { l[0].parts[2].first_sphere += 1; },
        [](Levels &l) { l[0].parts[2].first_sphere = 0xffffffff; },
        [](Levels &l) { l[0].parts[2].sphere_count = 0; },
        [](Levels &l) { l[0].parts[0].sphere_count += 1; },
        [](Levels &l) { l[0].part_spheres[1].entry = 0; },
        [](Levels &l) { l[0].part_spheres.back().entry = 99; },
        [](Levels &l) { l[1].part_spheres[0].entry = 4; },
        [](Levels &l) { l[0].part_spheres[0].bind.radius = -1; },
        [](Levels &l) { l[0].part_spheres[0].bind.radius = std::numeric_limits<float>::quiet_NaN(); },
        [](Levels &l) { l[0].part_spheres[0].bind.centre.y = std::numeric_limits<float>::infinity(); },
        // their positions in the ranges
        [](Levels &l) { l[0].surfaces[0].part_offsets.clear(); },
        [](Levels &l) { l[0].surfaces[0].part_offsets.push_back(0); },
        [](Levels &l) { l[0].surfaces[0].part_offsets[0] = 3; },
        [](Levels &l) { l[0].surfaces[0].part_offsets[1] += 1; },
        [](Levels &l) { l[0].surfaces[0].part_offsets[1] += 3; },
        [](Levels &l) { l[0].surfaces[0].part_offsets[1] = 0x7fffffff / 3 * 3; },
        [](Levels &l) { l[0].surfaces[0].part_offsets[3] -= 3; },
        [](Levels &l) { l[0].surfaces[1].part_offsets.back() += 3; },
        [](Levels &l) { l[0].surfaces[1].part_offsets[l[0].surfaces[1].part_offsets.size() - 4] = 3; },
    };
    const auto whole = built(puppet_in_levels());
    model::check(*whole);
    ASSERT_EQ(whole->levels.size(), 5u);
    for (size_t i = 0; i < breaks.size(); ++i) {
        const auto tmpl = built(puppet_in_levels());
        breaks[i](tmpl->levels);
        EXPECT_THROW(model::check(*tmpl), base::Error) << i;
        EXPECT_EQ(outcome(saved(*tmpl)), CLQ_FORMAT) << i;
    }
}

TEST(TemplateLevels, OfOnePartAreIndependentOfPartCulling)
{
    const auto tmpl = built(torture(3, 0, 40));
    tmpl->levels[0].surfaces[0].part_offsets.assign(8, 0);
    EXPECT_THROW(model::check(*tmpl), base::Error);
}

TEST(TemplateReach, OfEveryNodeIsADistanceAndAFactor)
{
    const auto tmpl = built(torture(3, 0, 40));
    tmpl->node_reach.assign(1, {1, 1});
    model::check(*tmpl);
    tmpl->node_reach[0].distance = -1;
    EXPECT_THROW(model::check(*tmpl), base::Error);
    tmpl->node_reach[0] = {1, std::numeric_limits<float>::quiet_NaN()};
    EXPECT_THROW(model::check(*tmpl), base::Error);
    tmpl->node_reach.assign(2, {1, 1});
    EXPECT_THROW(model::check(*tmpl), base::Error);
}

}  // namespace claque::test

#include "samples/cli/levels_table.h"

#include <algorithm>
#include <cstdio>

#include "samples/scenes/check.h"

namespace cli
{

namespace
{

double mm(float metres) { return 1000 * double(metres); }
double percent(float share) { return 100 * double(share); }

// A distance in the middle of those that a level serves; any of them would do.
float served(const Levels &levels, size_t k)
{
    return k + 1 < levels.size() ? 0.5f * (levels[k].lod_min_m + levels[k + 1].lod_min_m) : levels[k].lod_min_m + 1;
}

// Visits the levels that both have, from the finest on.
template <class Row>
void for_each_pair(const LevelsComparison &comparison, const Row &row)
{
    for (size_t k = 1; k < std::min(comparison.ours.size(), comparison.quadric_only.size()); ++k)
        row(comparison.ours[k], comparison.quadric_only[k]);
}

}  // namespace

nlohmann::ordered_json json_of(const Levels &levels)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const clq_level_report &level : levels)
        list.push_back({{"min_m", level.lod_min_m},
                        {"triangles", level.triangle_count},
                        {"vertices", level.vertex_count},
                        {"error_mm", mm(level.error_m)},
                        {"rest_rms_mm", mm(level.rest_rms_m)},
                        {"rest_max_mm", mm(level.rest_max_m)},
                        {"posed_rms_mm", mm(level.posed_rms_m)},
                        {"posed_max_mm", mm(level.posed_max_m)},
                        {"wrong_zone_percent", percent(level.wrong_zone)},
                        {"zone_drift_percent", percent(level.zone_area_error)},
                        {"open_edges", level.open_edges},
                        {"flipped_uvs", level.flipped_uvs}});
    return list;
}

void print(const Levels &levels)
{
    std::printf(
        "triangles vertices   from m   at rest mm: rms     max   in motion mm: rms     max   wrong zone %%   zone area "
        "%%  open edges  flipped uvs\n");
    for (const clq_level_report &l : levels)
        std::printf("%9u %8u %8.1f %17.2f %7.1f %19.2f %7.1f %14.2f %14.2f %11u %12u\n", l.triangle_count,
                    l.vertex_count, double(l.lod_min_m), mm(l.rest_rms_m), mm(l.rest_max_m), mm(l.posed_rms_m),
                    mm(l.posed_max_m), percent(l.wrong_zone), percent(l.zone_area_error), l.open_edges, l.flipped_uvs);
}

ZoneAreas zone_areas(const clq_asset *asset, const Levels &levels)
{
    ZoneAreas out;
    uint32_t count = 0;
    scenes::check(clq_asset_get_zone_areas(asset, 0, nullptr, 0, &count), "zones");
    for (uint32_t zone = 0; zone + 1 < count; ++zone) out.zones.push_back(clq_asset_get_zone_name(asset, zone));
    out.zones.push_back("none");
    for (size_t k = 0; k < levels.size(); ++k) {
        out.area_fractions.emplace_back(count);
        scenes::check(
            clq_asset_get_zone_areas(asset, served(levels, k), out.area_fractions.back().data(), count, nullptr),
            "zones");
    }
    return out;
}

void print(const Levels &levels, const ZoneAreas &area_fractions)
{
    std::printf("\nshare of the surface %%");
    for (const clq_level_report &l : levels) std::printf("%7u", l.triangle_count);
    std::printf("\n");
    for (size_t zone = 0; zone < area_fractions.zones.size(); ++zone) {
        const bool shown = std::any_of(area_fractions.area_fractions.begin(), area_fractions.area_fractions.end(),
                                       [zone](const std::vector<float> &level) { return level[zone] > 0; });
        if (!shown) continue;
        std::printf("%-22.22s", area_fractions.zones[zone].c_str());
        for (const std::vector<float> &level : area_fractions.area_fractions)
            std::printf("%7.2f", percent(level[zone]));
        std::printf("\n");
    }
}

void print(const LevelsComparison &comparison)
{
    std::printf(
        "           in motion mm: rms   |              max   |   wrong zone %%    |   zone area %%     |  open edges   "
        "|  flipped uvs\ntriangles    claque  quadric   |  claque  quadric   |  claque  quadric   |  claque  quadric   "
        "| claque quadr. | claque quadr.\n");
    for_each_pair(comparison, [](const clq_level_report &a, const clq_level_report &b) {
        std::printf("%9u %9.2f %8.2f   |%8.1f %8.1f   |%8.2f %8.2f   |%8.2f %8.2f   | %6u %6u | %6u %6u\n",
                    a.triangle_count, mm(a.posed_rms_m), mm(b.posed_rms_m), mm(a.posed_max_m), mm(b.posed_max_m),
                    percent(a.wrong_zone), percent(b.wrong_zone), percent(a.zone_area_error),
                    percent(b.zone_area_error), a.open_edges, b.open_edges, a.flipped_uvs, b.flipped_uvs);
        if (a.triangle_count != b.triangle_count) std::printf("%9s (quadric: %u)\n", "", b.triangle_count);
    });
    std::printf("s, with measuring: claque %.2f, quadric alone %.2f\n", comparison.ours_s, comparison.quadric_only_s);
}

nlohmann::ordered_json json_of(const LevelsComparison &comparison)
{
    return {{"claque", json_of(comparison.ours)},
            {"quadric_only", json_of(comparison.quadric_only)},
            {"claque_s", comparison.ours_s},
            {"quadric_only_s", comparison.quadric_only_s}};
}

}  // namespace cli

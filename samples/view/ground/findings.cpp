#include "samples/view/ground/findings.h"

#include <claque/levels.h>
#include <claque/mesh.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace view
{
namespace
{

using scenes::check;

// Edges that one triangle alone has.
uint32_t count_open_edges(const clq_template *tmpl)
{
    clq_mesh mesh = clq_mesh_init();
    check(clq_template_get_mesh(tmpl, 0, &mesh));
    using Place = std::tuple<float, float, float>;
    std::map<Place, uint32_t> places;
    std::vector<uint32_t> welded(mesh.vertex_count);
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
        const float *p = mesh.positions + 3 * static_cast<size_t>(v);
        welded[v] = places.emplace(Place(p[0], p[1], p[2]), v).first->second;
    }
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        check(clq_template_get_triangles(tmpl, 0, bin, &triangles));
        for (uint32_t i = 0; i + 2 < triangles.index_count; i += 3)
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t a = welded[triangles.indices[i + k]], b = welded[triangles.indices[i + (k + 1) % 3]];
                if (a != b) ++edges[{std::min(a, b), std::max(a, b)}];
            }
    }
    return static_cast<uint32_t>(
        std::count_if(edges.begin(), edges.end(), [](const auto &edge) { return edge.second == 1; }));
}

void count_influences(const clq_template *tmpl, Findings &out)
{
    clq_mesh mesh = clq_mesh_init();
    check(clq_template_get_mesh(tmpl, 0, &mesh));
    const size_t wide = std::max(1u, mesh.influence_count);
    std::vector<uint16_t> joints(wide * mesh.vertex_count);
    std::vector<float> weights(joints.size());
    clq_influences influences = clq_influences_init();
    influences.per_vertex = static_cast<uint32_t>(wide), influences.joints = joints.data();
    influences.weights = weights.data(), influences.capacity = joints.size();
    check(clq_template_get_influences(tmpl, 0, &influences));
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
        const auto first = weights.begin() + static_cast<std::ptrdiff_t>(v * wide);
        const auto used = static_cast<uint32_t>(
            std::count_if(first, first + static_cast<std::ptrdiff_t>(wide), [](float weight) { return weight > 0; }));
        out.most_influences = std::max(out.most_influences, used);
        if (used > 4) ++out.many_influences;
    }
}

std::vector<float> zone_areas(const clq_asset *asset, float distance_m)
{
    uint32_t count = 0;
    check(clq_asset_get_zone_areas(asset, distance_m, nullptr, 0, &count));
    std::vector<float> areas(count);
    check(clq_asset_get_zone_areas(asset, distance_m, areas.data(), count, &count));
    return areas;
}

void measure_zones(const clq_asset *asset, Findings &out)
{
    const std::vector<float> finest = zone_areas(asset, 0);
    for (uint32_t zone = 0; zone + 1 < finest.size(); ++zone)
        out.zones.push_back({clq_asset_get_zone_name(asset, zone), static_cast<double>(finest[zone]), -1});
    for (const Findings::Level &level : out.levels) {
        const std::vector<float> areas = zone_areas(asset, level.from_m + 0.01f);
        for (size_t zone = 0; zone < out.zones.size() && zone < areas.size(); ++zone) {
            Findings::Zone &one = out.zones[zone];
            if (areas[zone] > 0) one.gone_from_m = -1;
            else if (one.share > 0 && one.gone_from_m < 0) one.gone_from_m = static_cast<double>(level.from_m);
        }
    }
}

// Those of rigid parts, which have distances of their own.
void take_own_levels(const clq_template *tmpl, Findings &out)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    for (uint32_t i = 0; i < info.level_count; ++i) {
        clq_level_info level = clq_level_info_init();
        check(clq_template_get_level(tmpl, i, &level));
        out.levels.push_back({level.lod_min_m, level.triangle_count, -1, 0, 0});
    }
}

}  // namespace

Findings examine(scenes::Library &library, const clq_template *tmpl, const scenes::Own<clq_asset> &asset)
{
    Findings out;
    for (uint32_t i = 0; *clq_asset_get_warning(asset.get(), i) != 0; ++i)
        out.warnings.emplace_back(clq_asset_get_warning(asset.get(), i));
    out.open_edges = count_open_edges(tmpl);
    count_influences(tmpl, out);
    uint32_t count = 0;
    if (clq_asset_make_levels(library.context(), asset.get(), nullptr, &count) != CLQ_OK) {
        out.no_levels = clq_last_error();
        take_own_levels(tmpl, out);
        measure_zones(asset.get(), out);
        return out;
    }
    for (uint32_t i = 0; i < count; ++i) {
        clq_level_report report = clq_level_report_init();
        check(clq_asset_get_level_report(asset.get(), i, &report));
        out.levels.push_back({report.lod_min_m, report.triangle_count, 1000 * static_cast<double>(report.error_m),
                              static_cast<double>(report.zone_area_error), report.open_edges});
    }
    measure_zones(asset.get(), out);
    clq_template *made = nullptr;
    check(clq_asset_build(library.context(), asset.get(), 0, &made));
    out.levelled.reset(made);
    return out;
}

}  // namespace view

// clq_area_...: where people can walk, from files.
#include "lib/asset/areas/area.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lib/api/boundary.h"
#include "lib/asset/file.h"

using namespace claque;

struct clq_area {
    explicit clq_area(asset::Area &&read) : all(std::move(read)) {}
    asset::Area all;
};

namespace
{

constexpr uint64_t most_area_bytes = uint64_t(256) << 20;

clq_area *read(clq_context *context, const uint8_t *bytes, size_t size, const std::string &name)
{
    try {
        if (size > most_area_bytes)
            base::fail(CLQ_LIMIT, "%zu bytes: %llu are allowed", size, base::big(most_area_bytes));
        auto made = std::make_unique<clq_area>(asset::read_area(bytes, size));
        for (const std::string &warning : made->all.warnings)
            clq_context_log(context, CLQ_LOG_WARNING, warning.c_str());
        return made.release();
    } catch (const base::Error &error) {
        if (name.empty()) throw;
        base::fail(error.status(), "%s: %s", name.c_str(), error.what());
    }
}

void grow_box(const std::vector<double> &points, clq_area_info &info)
{
    if (points.empty()) return;
    std::copy_n(points.begin(), 3, info.box_min_m);
    std::copy_n(points.begin(), 3, info.box_max_m);
    for (size_t i = 0; i < points.size(); ++i) {
        info.box_min_m[i % 3] = std::min(info.box_min_m[i % 3], points[i]);
        info.box_max_m[i % 3] = std::max(info.box_max_m[i % 3], points[i]);
    }
}

}  // namespace

extern "C" {

clq_status clq_area_load(clq_context *context, const char *path, clq_area **out)
{
    return api::boundary("clq_area_load", [&] {
        api::require(context && path && out, "context, path or out is NULL");
        const std::vector<uint8_t> bytes = asset::read_file(path, most_area_bytes);
        *out = read(context, bytes.data(), bytes.size(), path);
    });
}

clq_status clq_area_load_memory(clq_context *context, const void *bytes, size_t size_bytes, const char *name,
                                clq_area **out)
{
    return api::boundary("clq_area_load_memory", [&] {
        api::require(context && out && (bytes || size_bytes == 0), "context, bytes or out is NULL");
        *out = read(context, static_cast<const uint8_t *>(bytes), size_bytes, api::name_of(name));
    });
}

void clq_area_destroy(clq_area *area) { delete area; }

clq_status clq_area_get_info(const clq_area *area, clq_area_info *out)
{
    return api::boundary("clq_area_get_info", [&] {
        api::require(area && out, "area or out is NULL");
        api::require_size(*out, "clq_area_info_init");
        const asset::Area &all = area->all;
        clq_area_info info = clq_area_info_init();
        info.polygon_count = all.polygons;
        info.ring_count = static_cast<uint32_t>(all.rings.size());
        info.point_count = static_cast<uint32_t>(all.points.size() / 3);
        info.triangle_count = static_cast<uint32_t>(all.triangles.size() / 3);
        info.wall_count = static_cast<uint32_t>(all.walls.size() / 2);
        info.warning_count = static_cast<uint32_t>(all.warnings.size());
        info.rings = all.rings.data(), info.points_m = all.points.data();
        info.triangles = all.triangles.data(), info.walls = all.walls.data();
        info.area_m2 = all.area_m2;
        grow_box(all.points, info);
        api::write_out(out, info);
    });
}

const char *clq_area_get_warning(const clq_area *area, uint32_t warning)
{
    return area && warning < area->all.warnings.size() ? area->all.warnings[warning].c_str() : "";
}

}  // extern "C"

#include "lib/asset/zone_map.h"

#include <claque/zones.h>

#include <algorithm>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/boundary.h"
#include "lib/asset/file.h"
#include "lib/asset/image.h"
#include "lib/asset/zone_clusters.h"

using namespace claque;

namespace
{

constexpr uint64_t most_image_bytes = uint64_t(1) << 30;

void check_range(const clq_hsb_range &r, const char *zone)
{
    const auto within = [](float x, float last) { return x >= 0 && x <= last; };
    if (!within(r.hue_min_deg, 360) || !within(r.hue_max_deg, 360) || !within(r.saturation_min, 1) ||
        !within(r.saturation_max, 1) || !within(r.brightness_min, 1) || !within(r.brightness_max, 1))
        base::fail(CLQ_ARGUMENT, "zone '%s' has a range that leaves [0, 360] degrees or [0, 1]", zone);
}

model::HsbRange range_of(const clq_hsb_range &r)
{
    return {r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.brightness_min, r.brightness_max};
}

const model::Image &image_of(const clq_asset *asset, uint32_t image)
{
    if (image >= asset->model.images.size())
        base::fail(CLQ_ARGUMENT, "image %u of '%s', which has %zu", image, asset->model.name.c_str(),
                   asset->model.images.size());
    return asset->model.images[image];
}

}  // namespace

extern "C" {

clq_status clq_asset_get_image(const clq_asset *asset, uint32_t image, clq_asset_image *out)
{
    return api::boundary("clq_asset_get_image", [&] {
        api::require(asset && out, "asset or out is NULL");
        const model::Image &from = image_of(asset, image);
        *out = {from.name.c_str(), from.width, from.height, from.rgba.data(),
                from.alpha == model::AlphaMeaning::zone_keys ? CLQ_ALPHA_ZONE_KEYS : CLQ_ALPHA_OPACITY};
    });
}

clq_status clq_asset_set_zone_map(clq_context *context, clq_asset *asset, const clq_zone_map_def *def)
{
    return api::boundary("clq_asset_set_zone_map", [&] {
        api::require(context && asset && def, "context, asset or def is NULL");
        api::require_size(def, "clq_zone_map_def_init");
        api::require(def->texels != nullptr, "texels is NULL");
        api::require_array(def->zones, def->zone_count, "zones");
        std::vector<asset::ZoneMapZone> zones;
        std::vector<model::HsbRange> ranges(def->zone_count);
        for (uint32_t i = 0; i < def->zone_count; ++i) {
            const clq_zone_map_zone &from = def->zones[i];
            asset::ZoneMapZone zone;
            zone.name = api::name_of(from.name);
            if (zone.name.empty()) base::fail(CLQ_ARGUMENT, "zone %u has no name", i);
            zone.reduced = from.reduced != 0;
            if (from.range) {
                check_range(*from.range, zone.name.c_str());
                ranges[i] = range_of(*from.range);
                zone.range = &ranges[i];
            }
            zones.push_back(std::move(zone));
        }
        asset::set_zone_map(asset->model, def->image, {def->width_px, def->height_px, def->texels}, zones);
    });
}

clq_status clq_asset_propose_zones(const clq_asset *asset, uint32_t image, uint32_t max_zones, uint16_t *out_texels,
                                   size_t capacity, uint8_t *out_rgb, uint32_t *out_count)
{
    return api::boundary("clq_asset_propose_zones", [&] {
        api::require(asset && out_texels && out_rgb && out_count, "asset, out_texels, out_rgb or out_count is NULL");
        const model::Image &from = image_of(asset, image);
        const size_t texels = size_t(from.width) * from.height;
        if (capacity < texels)
            base::fail(CLQ_ARGUMENT, "room for %zu texels of an image of %u x %u, which has %zu", capacity, from.width,
                       from.height, texels);
        const asset::ZoneProposal made = asset::propose_zones(asset->model, image, max_zones);
        std::copy(made.zones.begin(), made.zones.end(), out_texels);
        for (size_t i = 0; i < made.means.size(); ++i) std::copy_n(made.means[i].begin(), 3, out_rgb + 3 * i);
        *out_count = static_cast<uint32_t>(made.means.size());
    });
}

clq_status clq_image_read(clq_context *context, const char *path, uint8_t *out_rgba, size_t capacity_bytes,
                          uint32_t *out_width_px, uint32_t *out_height_px)
{
    return api::boundary("clq_image_read", [&] {
        api::require(context && path && out_width_px && out_height_px, "context, path or a size is NULL");
        const std::vector<uint8_t> bytes = asset::read_file(path, most_image_bytes);
        const model::Image image = asset::decode_image(bytes.data(), bytes.size(), path, asset::ImageLimits());
        if (out_rgba) {
            if (capacity_bytes < image.rgba.size())
                base::fail(CLQ_ARGUMENT, "%zu bytes for '%s' of %u x %u, which takes %zu", capacity_bytes, path,
                           image.width, image.height, image.rgba.size());
            std::copy(image.rgba.begin(), image.rgba.end(), out_rgba);
        }
        *out_width_px = image.width;
        *out_height_px = image.height;
    });
}

}  // extern "C"

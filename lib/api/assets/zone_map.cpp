// Zones for the images of an asset: given as a map, or proposed.
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
        base::fail(CLQ_ARGUMENT, "image %u does not exist: '%s' has %zu", image, asset->model.name.c_str(),
                   asset->model.images.size());
    return asset->model.images[image];
}

}  // namespace

extern "C" {

clq_status clq_asset_get_image(const clq_asset *asset, uint32_t image, clq_asset_image *out)
{
    return api::boundary("clq_asset_get_image", [&] {
        api::require(asset && out, "asset or out is NULL");
        api::require_size(*out, "clq_asset_image_init");
        const model::Image &from = image_of(asset, image);
        clq_asset_image found = clq_asset_image_init();
        found.name = from.name.c_str();
        found.width_px = from.width, found.height_px = from.height;
        found.rgba = from.rgba.data();
        found.alpha = from.alpha == model::AlphaMeaning::zone_keys ? CLQ_ALPHA_ZONE_KEYS : CLQ_ALPHA_OPACITY;
        api::write_out(out, found);
    });
}

clq_status clq_asset_set_zone_map(clq_context *context, clq_asset *asset, const clq_zone_map_def *def)
{
    return api::boundary("clq_asset_set_zone_map", [&] {
        api::require(context && asset && def, "context, asset or def is NULL");
        const clq_zone_map_def wanted = api::read_def(def, clq_zone_map_def_init, "clq_zone_map_def_init");
        api::require(wanted.texels != nullptr, "texels is NULL");
        api::require_array(wanted.zones, wanted.zone_count, "zones");
        std::vector<asset::ZoneMapZone> zones;
        std::vector<model::HsbRange> ranges(wanted.zone_count);
        for (uint32_t i = 0; i < wanted.zone_count; ++i) {
            const clq_zone_map_zone &from = wanted.zones[i];
            asset::ZoneMapZone zone;
            zone.name = api::name_of(from.name);
            if (zone.name.empty()) base::fail(CLQ_ARGUMENT, "zone %u has no name", i);
            zone.reduced = from.reduced;
            if (from.range) {
                check_range(*from.range, zone.name.c_str());
                ranges[i] = range_of(*from.range);
                zone.range = &ranges[i];
            }
            zones.push_back(std::move(zone));
        }
        asset::set_zone_map(asset->model, wanted.image, {wanted.width_px, wanted.height_px, wanted.texels}, zones,
                            asset->colours);
    });
}

clq_status clq_asset_propose_zones(const clq_asset *asset, uint32_t image, clq_zone_proposal *out)
{
    return api::boundary("clq_asset_propose_zones", [&] {
        api::require(asset && out, "asset or out is NULL");
        clq_zone_proposal wanted = api::read_def(out, clq_zone_proposal_init, "clq_zone_proposal_init");
        api::require(wanted.texels && wanted.rgb, "texels or rgb is NULL");
        const model::Image &from = image_of(asset, image);
        const size_t texels = size_t(from.width) * from.height;
        if (wanted.capacity_texels < texels)
            base::fail(CLQ_ARGUMENT, "room for %zu texels of an image of %u x %u, which has %zu",
                       wanted.capacity_texels, from.width, from.height, texels);
        const asset::ZoneProposal made = asset::propose_zones(asset->model, image, wanted.max_zones);
        std::copy(made.zones.begin(), made.zones.end(), wanted.texels);
        for (size_t i = 0; i < made.means.size(); ++i) std::copy_n(made.means[i].begin(), 3, wanted.rgb + 3 * i);
        wanted.zone_count = static_cast<uint32_t>(made.means.size());
        api::write_out(out, wanted);
    });
}

clq_status clq_image_read(clq_context *context, const char *path, clq_picture *out)
{
    return api::boundary("clq_image_read", [&] {
        api::require(context && path && out, "context, path or out is NULL");
        clq_picture picture = api::read_def(out, clq_picture_init, "clq_picture_init");
        const std::vector<uint8_t> bytes = asset::read_file(path, most_image_bytes);
        const model::Image image = asset::decode_image(bytes.data(), bytes.size(), path, asset::ImageLimits());
        if (picture.pixels) {
            if (picture.capacity_bytes < image.rgba.size())
                base::fail(CLQ_ARGUMENT, "%zu bytes for '%s' of %u x %u, which takes %zu", picture.capacity_bytes, path,
                           image.width, image.height, image.rgba.size());
            std::copy(image.rgba.begin(), image.rgba.end(), picture.pixels);
        }
        picture.width_px = image.width, picture.height_px = image.height;
        api::write_out(out, picture);
    });
}

}  // extern "C"

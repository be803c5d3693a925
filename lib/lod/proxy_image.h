// Bakes the images of proxies. Internal to lib/lod.
#pragma once

#include "lib/lod/proxy.h"
#include "lib/lod/surface_samples.h"

namespace claque::lod
{

// The character that proxies are baked from.
struct ProxySource {
    ProxySource(const model::Model &model, const std::vector<const model::Part *> &parts, const base::Jobs &jobs = {});
    // The same where the visibility is known.
    ProxySource(const model::Model &model, PosedParts at_rest, std::vector<double> visibility, const base::Jobs &jobs);

    size_t set_count() const { return model.texture_sets.size() + 1; }
    const model::TextureSet *set(size_t i) const { return i ? &model.texture_sets[i - 1] : nullptr; }
    PosedParts at_rest(const model::Part &part) const;

    const model::Model &model;
    PosedParts fine;                                  // at rest
    std::vector<double> visibility;                   // [triangles of fine] visibility (visibility.h)
    std::vector<std::vector<double>> area_fractions;  // [sets] per zone (area_fractions.h)
    std::vector<uint8_t> keys;                        // [zones] all different
};

model::Image empty_image(uint32_t width, uint32_t height);
void set_texel(const ProxySource &source, size_t at, uint32_t zone, glm::dvec3 rgb, model::Image &image);

// Splits the vertices of a part, one for each different texture coordinate, in [0, 1], of their corners.
void split_by_uv(model::Part &part, const std::vector<glm::vec2> &corners);

// Gives each triangle of each part one zone in one brightness, from the source surface that is nearest to it, and sets
// texture coordinates. Returns one image per texture set for all parts.
std::vector<model::Image> bake_swatches(const ProxySource &source, std::vector<model::Part> &parts);

// Makes the images of `meshes`, which proxy_meshes() returned, as make_proxies() does. The result does not depend on
// `jobs`.
ProxyLevels bake_proxies(const ProxySource &source, std::vector<model::Part> meshes, const base::Jobs &jobs = {});

// Bakes one part whose texels show the nearest points of the source.
std::vector<model::Image> bake_charts(const ProxySource &source, model::Part &part);

}  // namespace claque::lod

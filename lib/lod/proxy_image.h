// What triangles of far levels show. Between the files of this room only.
#pragma once

#include "lib/lod/proxy.h"
#include "lib/lod/surface_samples.h"

namespace claque::lod
{

// What they are painted from.
struct ProxySource {
    ProxySource(const model::Model &model, const std::vector<const model::Part *> &parts, const base::Jobs &jobs = {});

    size_t set_count() const { return model.texture_sets.size() + 1; }
    const model::TextureSet *set(size_t i) const { return i ? &model.texture_sets[i - 1] : nullptr; }
    PosedParts at_rest(const model::Part &part) const;

    const model::Model &model;
    PosedParts fine;                                  // at rest
    std::vector<double> visibility;                   // [triangles of fine] how much of it can be (seen.h)
    std::vector<std::vector<double>> area_fractions;  // [sets] of zones (shares.h)
    std::vector<uint8_t> keys;                        // [zones], which tell all of them apart
};

model::Image empty_image(uint32_t width, uint32_t height);
void set_texel(const ProxySource &source, size_t at, uint32_t zone, glm::dvec3 rgb, model::Image &image);

// The vertices of a part once for each place in the texture, [0, 1], that their corners have.
void split_by_uv(model::Part &part, const std::vector<glm::vec2> &corners);

// Each triangle of each part shows one zone in one brightness, from all of the source that lies nearest to it; parts get
// their texture coordinates. One image for each texture set, for all parts.
std::vector<model::Image> bake_swatches(const ProxySource &source, std::vector<model::Part> &parts,
                                        const base::Jobs &jobs = {});

// One part whose triangles show, texel by texel, what lies nearest on the source.
std::vector<model::Image> bake_charts(const ProxySource &source, model::Part &part, const base::Jobs &jobs = {});

}  // namespace claque::lod

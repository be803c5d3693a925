// Proxies: levels of detail for characters that are a few dozen pixels tall. One closed surface replaces all parts
// (proxy_mesh.h). In levels of few triangles each triangle shows one zone, from a shared image with a few texels for
// each zone and brightness: every triangle is clean, and individuals share draw calls. Finer levels have an image of
// their own, laid out in charts (atlas.h), whose texels show the nearest point of the source.
#pragma once

#include <vector>

#include "lib/base/services.h"
#include "lib/model/model.h"

namespace claque::lod
{

// Levels of at most this many triangles show one zone per triangle: the value of
// passes::RendererOptions::batch_triangles.
constexpr size_t max_clean_triangles = 128;

struct ProxyOptions {
    std::vector<size_t> targets;          // triangles, strictly descending
    double influence = 0.1, zone = 0.05;  // as in ProxyMeshOptions
};

struct ProxyLevels {
    // One for each target, finest first; material indices are valid after add_to_model()
    std::vector<model::Part> parts;
    std::vector<model::Material> materials;         // image indices likewise
    std::vector<model::Image> images;               // with the zone keys below
    std::vector<std::vector<uint32_t>> set_images;  // [texture sets of the model][materials]

    // [zones] keys that the images use: the model's own, or new ones if the model's do not tell zones apart.
    std::vector<uint8_t> zone_keys;
};

// `source` are triangle parts of `model`, which must have passed model::check. Throws base::Error (CLQ_LIMIT) if there
// are more zones than keys. The result does not depend on `jobs`. Deterministic.
ProxyLevels make_proxies(const model::Model &model, const std::vector<const model::Part *> &source,
                         const ProxyOptions &options, const base::Jobs &jobs = {});

// Adds materials, images, texture-set entries and keys to the same `model`. The caller adds the parts.
void add_to_model(const ProxyLevels &proxies, model::Model &model);

}  // namespace claque::lod

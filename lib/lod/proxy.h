// Levels of detail for characters that are a few dozen pixels tall: one closed surface in place of all parts (shell.h).
// Levels of few triangles show one zone on each, from an image of a few texels, one for each zone and brightness: every
// triangle is clean, and individuals share calls. Levels of more have an image of their own each, laid out in charts
// (atlas.h), whose texels show what lies nearest on the source.
#pragma once

#include <vector>

#include "lib/base/services.h"
#include "lib/model/model.h"

namespace claque::lod
{

// Levels of so many triangles and fewer show one zone on each: passes::RendererOptions::batch_triangles has as many.
constexpr size_t max_clean_triangles = 128;

struct ProxyOptions {
    std::vector<size_t> targets;          // triangles, descending strictly
    double influence = 0.1, zone = 0.05;  // as in ShellWish
};

struct ProxyLevels {
    std::vector<model::Part> parts;  // one for each target, finest first; materials as they are numbered once entered
    std::vector<model::Material> materials;         // images likewise
    std::vector<model::Image> images;               // with keys of the model's zones
    std::vector<std::vector<uint32_t>> set_images;  // [texture sets of the model][materials]
    // [zones] that images use: the model's own, or new ones where those do not tell zones apart.
    std::vector<uint8_t> zone_keys;
};

// `source` are triangle parts of `model`, which has passed model::check. Throws base::Error (CLQ_LIMIT) where zones are
// more than keys. Deterministic, whatever the jobs.
ProxyLevels make_proxies(const model::Model &model, const std::vector<const model::Part *> &source,
                         const ProxyOptions &options, const base::Jobs &jobs = {});

// Gives the same `model` materials, images, what its texture sets show of them, and keys; parts are left to the caller.
void add_to_model(const ProxyLevels &proxies, model::Model &model);

}  // namespace claque::lod

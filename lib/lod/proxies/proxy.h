// Proxies: levels of detail for characters that are a few dozen pixels tall. One closed surface round all parts at rest
// replaces them: clothes, hair and separate limbs fuse, and hidden interior surface disappears. In levels of few
// triangles each triangle shows one zone, from a shared image with a few texels for each zone and brightness: every
// triangle is clean, and individuals share draw calls. Finer levels have an image of their own, laid out in charts
// (atlas.h), whose texels show the nearest point of the source.
#pragma once

#include <optional>
#include <vector>

#include "lib/base/services.h"
#include "lib/lod/proxies/zone_points.h"
#include "lib/lod/proxies/zone_views.h"
#include "lib/lod/surface/nearest.h"
#include "lib/lod/surface/surface_samples.h"
#include "lib/model/model.h"

namespace claque::lod
{

// Levels of at most this many triangles show one zone per triangle: the value of
// passes::RendererOptions::batch_triangles.
constexpr size_t max_clean_triangles = 128;

struct ProxyMeshOptions {
    std::vector<size_t> targets;  // triangles, strictly descending

    // The cost of a vertex that represents surface of other joints, or of another zone, as fractions of the character's
    // size.
    double influence = 0.1, zone = 0.05;
    base::Jobs jobs = {};
    uint32_t cells = 48;  // along the character's longest side; details below one cell are lost
};

// Returns one skinned part per target, without texture coordinates. A vertex follows the joints of the surface that it
// represents, at most the four heaviest.
std::vector<model::Part> proxy_meshes(const model::Model &model, const std::vector<const model::Part *> &source,
                                      const ProxyMeshOptions &options);

// The character that proxies are baked from.
struct ProxySource {
    ProxySource(const model::Model &model, const std::vector<const model::Part *> &parts, const base::Jobs &jobs = {});
    // The same where the visibility is known.
    ProxySource(const model::Model &model, PosedParts at_rest, std::vector<double> visibility, const base::Jobs &jobs);

    size_t set_count() const { return model.texture_sets.size() + 1; }
    const model::TextureSet *set(size_t i) const { return i ? &model.texture_sets[i - 1] : nullptr; }
    PosedParts at_rest(const model::Part &part) const;
    // The point of `fine`, or where that is a hole, the nearest to `at` of a surface without holes.
    SurfacePoint through_holes(const SurfacePoint &point, glm::dvec3 at) const;

    const model::Model &model;
    PosedParts fine;                                  // at rest
    PartTrees trees;                                  // of `fine`, for levels of one part
    std::vector<double> visibility;                   // [triangles of fine] visibility (visibility.h)
    std::vector<std::vector<double>> area_fractions;  // [sets] per zone (area_fractions.h)
    std::vector<uint8_t> keys;                        // [zones] all different
    ZoneViews views;                                  // of `fine`, in all poses
    std::vector<uint32_t> visible_triangles;          // of `fine`
    std::optional<NearestPoint> nearest_visible;      // of these
    std::vector<uint32_t> whole_triangles;            // the visible ones in which no holes are
    std::optional<NearestPoint> nearest_whole;        // of these, where some others have holes
    // [sets] by zone, for as many sets as memory has room for; the others have none.
    std::vector<std::vector<ZonePoints>> zone_points;
};

struct ProxyLevels {
    // One for each target, finest first; material indices are valid after add_to_model()
    std::vector<model::Part> parts;
    std::vector<std::vector<double>> visibility;    // [parts][triangles] at rest (visibility.h)
    std::vector<model::Material> materials;         // image indices likewise
    std::vector<model::Image> images;               // with the zone keys below
    std::vector<std::vector<uint32_t>> set_images;  // [texture sets of the model][materials]

    // [zones] keys that the images use: the model's own, or new ones if the model's do not tell zones apart.
    std::vector<uint8_t> zone_keys;
};

// Makes the images of `meshes`, which proxy_meshes() returned, and sets their texture coordinates. `tolerances`:
// [meshes] of zones' area fractions, for those with one zone a triangle; empty: max_zone_area_error each. Throws
// base::Error (CLQ_LIMIT) if there are more zones than keys. The result does not depend on `jobs`. Deterministic.
ProxyLevels bake_proxies(const ProxySource &source, std::vector<model::Part> meshes,
                         const std::vector<double> &tolerances = {}, const base::Jobs &jobs = {});

// Both steps in one. `source` are triangle parts of `model`, which must have passed model::check.
ProxyLevels make_proxies(const model::Model &model, const std::vector<const model::Part *> &source,
                         const ProxyMeshOptions &options);

// Adds materials, images, texture-set entries and keys to the same `model`. The caller adds the parts.
void add_to_model(const ProxyLevels &proxies, model::Model &model);

// Splits a proxy, whose material is in source.model, into one part for each lighting that its triangles show: a
// triangle has the lighting of the zones that most of it shows, a zone that of most of its surface. `model` is
// source.model, and gets the materials.
std::vector<model::Part> split_by_lighting(const ProxySource &source, model::Part part, model::Model &model);

}  // namespace claque::lod

#include "lib/model/model.h"

#include <cmath>

#include "lib/base/error.h"

namespace claque::model
{

using base::fail;

namespace
{

void check_lengths(const Part &part, size_t index)
{
    const size_t n = part.positions.size();
    const auto must = [&](size_t have, const char *what) {
        if (have != 0 && have != n)
            fail(CLQ_ARGUMENT, "part %zu '%s' has %zu positions and %zu %s", index, part.name.c_str(), n, have, what);
    };
    must(part.normals.size(), "normals");
    must(part.uvs.size(), "texture coordinates");
    must(part.colours.size(), "colours");
    for (const MorphTarget &target : part.morphs) {
        must(target.positions.size(), "morphed positions");
        must(target.normals.size(), "morphed normals");
    }
    if (part.influence_count == 0 || part.joints.size() != n * part.influence_count ||
        part.weights.size() != n * part.influence_count)
        fail(CLQ_ARGUMENT, "part %zu '%s' has %zu joints and %zu weights for %zu vertices of %u influences", index,
             part.name.c_str(), part.joints.size(), part.weights.size(), n, part.influence_count);
}

void check_influences(const Model &model, const Part &part, size_t index)
{
    for (size_t v = 0; v < part.positions.size(); ++v) {
        float sum = 0;
        for (uint32_t k = 0; k < part.influence_count; ++k) {
            const size_t at = v * part.influence_count + k;
            if (part.joints[at] >= model.rig.palette.size())
                fail(CLQ_ARGUMENT, "vertex %zu of part %zu '%s' names joint %u, which does not exist: there are %zu", v,
                     index, part.name.c_str(), part.joints[at], model.rig.palette.size());
            if (!(part.weights[at] >= 0))
                fail(CLQ_ARGUMENT, "vertex %zu of part %zu '%s' has a negative weight", v, index, part.name.c_str());
            sum += part.weights[at];
        }
        if (!(std::fabs(sum - 1) <= 1e-3f))
            fail(CLQ_ARGUMENT, "weights of vertex %zu of part %zu '%s' sum to %g instead of 1", v, index,
                 part.name.c_str(), static_cast<double>(sum));
    }
}

template <class V>
bool finite(const std::vector<V> &values)
{
    const float *p = values.empty() ? nullptr : &values[0].x;
    for (size_t i = 0; i < values.size() * (sizeof(V) / sizeof(float)); ++i)
        if (!std::isfinite(p[i])) return false;
    return true;
}

void check_part(const Model &model, const Part &part, size_t index)
{
    check_lengths(part, index);
    check_influences(model, part, index);
    const char *name = part.name.c_str();
    if (!finite(part.positions) || !finite(part.normals) || !finite(part.uvs))
        fail(CLQ_ARGUMENT, "part %zu '%s' has a position, normal or texture coordinate that is not finite", index,
             name);
    for (const uint32_t i : part.indices)
        if (i >= part.positions.size())
            fail(CLQ_ARGUMENT, "part %zu '%s' has an index of vertex %u, which does not exist: there are %zu", index,
                 name, i, part.positions.size());
    if (part.material != none && part.material >= model.materials.size())
        fail(CLQ_ARGUMENT, "part %zu '%s' has material %u, which does not exist: there are %zu", index, name,
             part.material, model.materials.size());
    if (!(part.lod_min_m >= 0) || !std::isfinite(part.lod_min_m) || !(part.lod_max_m > part.lod_min_m))
        fail(CLQ_ARGUMENT, "part %zu '%s' is drawn from %g m to %g m: 0 <= lod_min_m < lod_max_m is wanted", index,
             name, static_cast<double>(part.lod_min_m), static_cast<double>(part.lod_max_m));
    if (!part.morphs.empty()) {
        if (part.morph_set >= model.rig.morph_sets.size())
            fail(CLQ_ARGUMENT, "part %zu '%s' has morph targets without a morph set", index, name);
        if (part.morphs.size() != model.rig.morph_sets[part.morph_set].target_count)
            fail(CLQ_ARGUMENT, "part %zu '%s' has %zu morph targets, and its morph set %u", index, name,
                 part.morphs.size(), model.rig.morph_sets[part.morph_set].target_count);
        for (const MorphTarget &target : part.morphs)
            if (!finite(target.positions) || !finite(target.normals))
                fail(CLQ_ARGUMENT, "part %zu '%s' has a morph target that is not finite", index, name);
    }
}

void check_zone(const Zone &zone, size_t index)
{
    const auto within = [](float x, float max) { return x >= 0 && x <= max; };
    for (const float c : zone.colour)
        if (!within(c, 1))
            fail(CLQ_ARGUMENT, "zone %zu '%s' has a colour with a channel of %g: 0 to 1 is wanted", index,
                 zone.name.c_str(), static_cast<double>(c));
    const HsbRange &r = zone.range;
    if (!within(r.hue_min_deg, 360) || !within(r.hue_max_deg, 360) || !within(r.saturation_min, 1) ||
        !within(r.saturation_max, 1) || !within(r.brightness_min, 1) || !within(r.brightness_max, 1))
        fail(CLQ_ARGUMENT, "zone %zu '%s' has a range that leaves [0, 360] degrees or [0, 1]", index,
             zone.name.c_str());
}

void check_looks(const Model &model)
{
    for (size_t i = 0; i < model.zones.size(); ++i) check_zone(model.zones[i], i);
    for (size_t i = 0; i < model.images.size(); ++i) {
        const Image &image = model.images[i];
        if (!is_image_size(image.width, image.height) || image.rgba.size() != 4ull * image.width * image.height)
            fail(CLQ_ARGUMENT, "image %zu '%s' of %u x %u has %zu bytes", i, image.name.c_str(), image.width,
                 image.height, image.rgba.size());
    }
    for (size_t i = 0; i < model.materials.size(); ++i) {
        const Material &material = model.materials[i];
        const std::array<float, 4> &c = material.base_colour;
        for (const float x : {c[0], c[1], c[2], c[3], material.alpha_cutoff})
            if (!std::isfinite(x))
                fail(CLQ_ARGUMENT, "material %zu '%s' has a colour or an alpha_cutoff that is not finite", i,
                     material.name.c_str());
        for (const float e : material.lighting.emission)
            if (!(e >= 0 && e <= 1))
                fail(CLQ_ARGUMENT, "material %zu '%s' emits %g: [0, 1] is wanted", i, material.name.c_str(), double(e));
        if (material.image != none && material.image >= model.images.size())
            fail(CLQ_ARGUMENT, "material %zu '%s' has image %u, which does not exist: there are %zu", i,
                 material.name.c_str(), material.image, model.images.size());
        if (material.zone != none && material.zone >= model.zones.size())
            fail(CLQ_ARGUMENT, "material %zu '%s' has zone %u, which does not exist: there are %zu", i,
                 material.name.c_str(), material.zone, model.zones.size());
    }
}

}  // namespace

void check_influence_count(uint32_t influence_count, size_t part, const char *part_name)
{
    if (influence_count > max_influences)
        fail(CLQ_ARGUMENT, "part %zu '%s' has %u influences a vertex: at most %u", part, part_name, influence_count,
             max_influences);
}

void check_texture_sets(const Model &model)
{
    if (model.texture_sets.size() >= max_texture_sets)
        fail(CLQ_LIMIT, "model '%s' has %zu texture sets: %u are the most", model.name.c_str(),
             model.texture_sets.size() + 1, max_texture_sets);
    for (const TextureSet &set : model.texture_sets) {
        const char *name = set.name.c_str();
        if (set.images.size() != model.materials.size())
            fail(CLQ_ARGUMENT, "texture set '%s' names %zu images for %zu materials", name, set.images.size(),
                 model.materials.size());
        for (size_t i = 0; i < set.images.size(); ++i) {
            if (set.images[i] == none) continue;
            const Material &material = model.materials[i];
            if (set.images[i] >= model.images.size())
                fail(CLQ_ARGUMENT,
                     "texture set '%s' has image %u, which does not exist (there are %zu), for material %zu '%s'", name,
                     set.images[i], model.images.size(), i, material.name.c_str());
            if (material.image == none)
                fail(CLQ_ARGUMENT, "texture set '%s' has an image for material %zu '%s', which has none of its own",
                     name, i, material.name.c_str());
            if (model.images[set.images[i]].alpha != model.images[material.image].alpha)
                fail(CLQ_ARGUMENT,
                     "texture set '%s': image '%s' and material %zu's own, '%s', mean different things by alpha", name,
                     model.images[set.images[i]].name.c_str(), i, model.images[material.image].name.c_str());
        }
    }
}

void check(const Model &model)
{
    check(model.rig);
    check_looks(model);
    check_texture_sets(model);
    for (size_t i = 0; i < model.parts.size(); ++i) check_part(model, model.parts[i], i);
}

std::vector<std::array<uint32_t, 3>> triangles_of(const Part &part)
{
    const size_t n = part.indices.empty() ? part.positions.size() : part.indices.size();
    const auto at = [&](size_t i) { return part.indices.empty() ? static_cast<uint32_t>(i) : part.indices[i]; };
    std::vector<std::array<uint32_t, 3>> out;
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        if (a != b && b != c && c != a) out.push_back({a, b, c});
    };
    if (part.topology == Topology::triangles)
        for (size_t i = 0; i + 2 < n; i += 3) add(at(i), at(i + 1), at(i + 2));
    if (part.topology == Topology::triangle_strip)
        for (size_t i = 0; i + 2 < n; ++i)
            i % 2 == 0 ? add(at(i), at(i + 1), at(i + 2)) : add(at(i + 1), at(i), at(i + 2));
    if (part.topology == Topology::triangle_fan)
        for (size_t i = 1; i + 1 < n; ++i) add(at(0), at(i), at(i + 1));
    return out;
}

bool is_drawn(const Part &part) { return !part.hidden && !triangles_of(part).empty(); }

}  // namespace claque::model

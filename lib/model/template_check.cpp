#include "lib/model/template_check.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/model/level_check.h"

namespace claque::model
{

using base::fail;

namespace
{

void check_motion(const Rig &rig)
{
    check(rig);
    for (const Channel &channel : rig.channels)
        if (channel.target > ChannelTarget::morph_weights || channel.interpolation > Interpolation::cubic_spline)
            fail(CLQ_ARGUMENT, "a channel of target %u and interpolation %u", unsigned(channel.target),
                 unsigned(channel.interpolation));
}

void check_zones(const Template &tmpl)
{
    require_count(tmpl.zone_colours.size(), tmpl.zone_names.size(), "zone colours");
    require_count(tmpl.zone_ranges.size(), tmpl.zone_names.size(), "zone ranges");
    require_count(tmpl.zone_clean.size(), tmpl.zone_names.size(), "clean counts of zones");
    for (const auto &colour : tmpl.zone_colours) require_finite(colour.data(), 3, "zone colour");
    for (const HsbRange &range : tmpl.zone_ranges) require_finite(&range.hue_min_deg, 6, "zone range");
}

// For Texture and TextureImage.
template <class Image>
void check_image(const Image &image, const bool (&known)[256], size_t index)
{
    const auto good_side = [](uint32_t side) { return side > 0 && side <= 32768 && (side & (side - 1)) == 0; };
    if (!good_side(image.width) || !good_side(image.height))
        fail(CLQ_ARGUMENT, "texture %zu is %u x %u", index, image.width, image.height);
    require_count(image.rgba.size(), size_t(4) * image.width * image.height, "bytes of a texture");
    for (size_t i = 3; i < image.rgba.size(); i += 4)
        if (!known[image.rgba[i]])
            fail(CLQ_ARGUMENT, "texture %zu has key %u, which is none of its zones'", index, image.rgba[i]);
}

void check_texture(const Template &tmpl, const Texture &texture, size_t index)
{
    if (texture.wrap_s > Wrap::clamp || texture.wrap_t > Wrap::clamp)
        fail(CLQ_ARGUMENT, "texture %zu neither repeats nor clamps", index);
    if (texture.keys.empty()) fail(CLQ_ARGUMENT, "texture %zu has no zones", index);
    bool known[256] = {};
    known[0] = texture.has_holes;
    for (size_t i = 0; i < texture.keys.size(); ++i) {
        if (texture.keys[i].zone >= tmpl.zone_count())
            fail(CLQ_ARGUMENT, "texture %zu has zone %u, which does not exist: there are %u", index,
                 texture.keys[i].zone, tmpl.zone_count());
        if (i > 0 && texture.keys[i].key <= texture.keys[i - 1].key)
            fail(CLQ_ARGUMENT, "texture %zu has keys that do not ascend", index);
        known[texture.keys[i].key] = true;
    }
    check_image(texture, known, index);
    if (!texture.set_images.empty())
        require_count(texture.set_images.size(), tmpl.texture_sets.size(), "images of a texture");
    for (const TextureImage &other : texture.set_images) check_image(other, known, index);
}

bool good_reach(float a, float b) { return std::isfinite(a) && std::isfinite(b) && a >= 0 && b >= 0; }

void check_reach(const Rig &rig, size_t node, float a, float b)
{
    if (!good_reach(a, b))
        fail(CLQ_ARGUMENT, "node %zu '%s' reaches %g m and %g: both have to be finite and at least 0", node,
             node < rig.node_names.size() ? rig.node_names[node].c_str() : "", double(a), double(b));
}

}  // namespace

void check_spheres(const Template &tmpl)
{
    const Sphere &sklsroot = tmpl.sklsroot;
    require_finite(&sklsroot.centre.x, 3, "centre of the Sklsroot Bsphere");
    if (!good_reach(sklsroot.radius, 0))
        fail(CLQ_ARGUMENT, "the Sklsroot Bsphere has a radius of %g m: it has to be finite and at least 0",
             double(sklsroot.radius));
    if (!tmpl.node_reach.empty()) require_count(tmpl.node_reach.size(), tmpl.rig.node_count(), "reaches of nodes");
    for (size_t i = 0; i < tmpl.node_reach.size(); ++i)
        check_reach(tmpl.rig, i, tmpl.node_reach[i].distance, tmpl.node_reach[i].scale);
    if (!good_reach(tmpl.blend_radius.base, tmpl.blend_radius.per_weight))
        fail(CLQ_ARGUMENT,
             "blended poses have a radius of %g m and %g m per weight: both have to be finite and at least 0",
             double(tmpl.blend_radius.base), double(tmpl.blend_radius.per_weight));
    if (!tmpl.blend_reach.empty())
        require_count(tmpl.blend_reach.size(), tmpl.rig.node_count(), "reaches of blended nodes");
    for (size_t i = 0; i < tmpl.blend_reach.size(); ++i)
        for (const AdditiveBound &bound : {tmpl.blend_reach[i].distance, tmpl.blend_reach[i].scale})
            check_reach(tmpl.rig, i, bound.base, bound.per_weight);
}

void check(const Template &tmpl)
{
    check_motion(tmpl.rig);
    check(tmpl.motion, tmpl.rig);
    check_zones(tmpl);
    if (tmpl.texture_sets.size() >= max_texture_sets)
        fail(CLQ_ARGUMENT, "%u texture sets: %u are the most", tmpl.texture_set_count(), max_texture_sets);
    for (size_t i = 0; i < tmpl.textures.size(); ++i) check_texture(tmpl, tmpl.textures[i], i);
    check_levels(tmpl);
    check_spheres(tmpl);
}

}  // namespace claque::model

#include "lib/model/template_check.h"

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

void check_spheres(const Template &tmpl)
{
    require_finite(&tmpl.sklsroot.centre.x, 3, "centre of the Sklsroot Bsphere");
    require_finite(&tmpl.sklsroot.radius, 1, "radius of the Sklsroot Bsphere");
    if (tmpl.sklsroot.radius < 0) fail(CLQ_ARGUMENT, "a Sklsroot Bsphere of negative radius");
    if (!tmpl.node_reach.empty()) require_count(tmpl.node_reach.size(), tmpl.rig.node_count(), "reaches of nodes");
    for (const NodeReach &reach : tmpl.node_reach) {
        require_finite(&reach.distance, 2, "reach of a node");
        if (reach.distance < 0 || reach.scale < 0) fail(CLQ_ARGUMENT, "a node with a negative reach");
    }
    if (!tmpl.blend_reach.empty())
        require_count(tmpl.blend_reach.size(), tmpl.rig.node_count(), "reaches of blended nodes");
    const auto check_bound = [](const AdditiveBound &bound) {
        require_finite(&bound.base, 2, "reach of blended poses");
        if (bound.base < 0 || bound.per_weight < 0) fail(CLQ_ARGUMENT, "a negative reach of blended poses");
    };
    check_bound(tmpl.blend_radius);
    for (const BlendReach &reach : tmpl.blend_reach) check_bound(reach.distance), check_bound(reach.scale);
}

}  // namespace

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

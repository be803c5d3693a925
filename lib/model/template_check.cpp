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
        if (channel.path > Path::morph_weights || channel.interpolation > Interpolation::cubic_spline)
            fail(CLQ_ARGUMENT, "a channel of path %u and interpolation %u", unsigned(channel.path),
                 unsigned(channel.interpolation));
}

void check_zones(const Template &tmpl)
{
    must_count(tmpl.zone_colours.size(), tmpl.zone_names.size(), "zone colours");
    must_count(tmpl.zone_ranges.size(), tmpl.zone_names.size(), "zone ranges");
    must_count(tmpl.zone_clean.size(), tmpl.zone_names.size(), "clean counts of zones");
    for (const auto &colour : tmpl.zone_colours) must_be_finite(colour.data(), 3, "zone colour");
    for (const HsbRange &range : tmpl.zone_ranges) must_be_finite(&range.hue_first_deg, 6, "zone range");
}

// Of Texture or TextureImage.
template <class Image>
void check_image(const Image &image, const bool (&known)[256], size_t index)
{
    const auto good_side = [](uint32_t side) { return side > 0 && side <= 32768 && (side & (side - 1)) == 0; };
    if (!good_side(image.width) || !good_side(image.height))
        fail(CLQ_ARGUMENT, "texture %zu is %u x %u", index, image.width, image.height);
    must_count(image.rgba.size(), size_t(4) * image.width * image.height, "bytes of a texture");
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
            fail(CLQ_ARGUMENT, "texture %zu has zone %u of %u", index, texture.keys[i].zone, tmpl.zone_count());
        if (i > 0 && texture.keys[i].key <= texture.keys[i - 1].key)
            fail(CLQ_ARGUMENT, "texture %zu has keys that do not ascend", index);
        known[texture.keys[i].key] = true;
    }
    check_image(texture, known, index);
    if (!texture.others.empty()) must_count(texture.others.size(), tmpl.texture_sets.size(), "images of a texture");
    for (const TextureImage &other : texture.others) check_image(other, known, index);
}

void check_spheres(const Template &tmpl)
{
    must_be_finite(&tmpl.sklsroot.centre.x, 3, "centre of the Sklsroot Bsphere");
    must_be_finite(&tmpl.sklsroot.radius, 1, "radius of the Sklsroot Bsphere");
    if (tmpl.sklsroot.radius < 0) fail(CLQ_ARGUMENT, "a Sklsroot Bsphere of negative radius");
    if (!tmpl.node_reach.empty()) must_count(tmpl.node_reach.size(), tmpl.rig.node_count(), "reaches of nodes");
    for (const NodeReach &reach : tmpl.node_reach) {
        must_be_finite(&reach.distance, 2, "reach of a node");
        if (reach.distance < 0 || reach.stretch < 0) fail(CLQ_ARGUMENT, "a node with a negative reach");
    }
    if (!tmpl.blend_reach.empty())
        must_count(tmpl.blend_reach.size(), tmpl.rig.node_count(), "reaches of blended nodes");
    const auto check_bound = [](const ByAdded &bound) {
        must_be_finite(&bound.none, 2, "reach of blended poses");
        if (bound.none < 0 || bound.each < 0) fail(CLQ_ARGUMENT, "a negative reach of blended poses");
    };
    check_bound(tmpl.blend_radius);
    for (const BlendReach &reach : tmpl.blend_reach) check_bound(reach.distance), check_bound(reach.stretch);
}

}  // namespace

void check(const Template &tmpl)
{
    check_motion(tmpl.rig);
    check(tmpl.motion, tmpl.rig);
    check_zones(tmpl);
    if (tmpl.texture_sets.size() >= most_texture_sets)
        fail(CLQ_ARGUMENT, "%u texture sets: %u are the most", tmpl.texture_set_count(), most_texture_sets);
    for (size_t i = 0; i < tmpl.textures.size(); ++i) check_texture(tmpl, tmpl.textures[i], i);
    check_levels(tmpl);
    check_spheres(tmpl);
}

}  // namespace claque::model

#include "tests/gl/support/source_picture.h"

#include <algorithm>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

namespace gltest
{
namespace
{

constexpr gl::Enum mirrored_repeat = 0x8370, clamp_to_edge = 0x812F;  // of later GL: Mesa's own wrapping is the judge

struct Colour {
    uint8_t r, g, b, a;
};

// By name, so that the order of zones in the template does not matter.
Colour colour_of(const model::Zone &zone, const model::Template &tmpl, const uint8_t *zone_rgb)
{
    for (uint32_t i = 0; i < tmpl.zone_count(); ++i)
        if (std::string(tmpl.zone_names[i].begin(), tmpl.zone_names[i].end()) == zone.name)
            return {zone_rgb[3 * i], zone_rgb[3 * i + 1], zone_rgb[3 * i + 2], 255};
    ADD_FAILURE() << "the template has no zone " << zone.name;
    return {0, 0, 0, 255};
}

// The image that a material shows in the set, each texel in the colour of its zone.
struct Painted {
    uint32_t width = 1, height = 1;
    std::vector<Colour> texels;
};

Painted painted(const model::Model &source, uint32_t material_index, const PosedModel &posed, const uint8_t *zone_rgb)
{
    const model::Material &material = source.materials[material_index];
    uint32_t index = material.image;
    if (posed.texture_set > 0) {
        const uint32_t other = source.texture_sets[posed.texture_set - 1].images[material_index];
        if (other != model::none) index = other;
    }
    Painted out;
    if (index == model::none) {
        out.texels = {colour_of(source.zones[material.zone], *posed.tmpl, zone_rgb)};
        return out;
    }
    const model::Image &image = source.images[index];
    out.width = image.width, out.height = image.height;
    for (size_t i = 0; i < image.rgba.size(); i += 4) {
        const uint8_t alpha = image.rgba[i + 3];
        if (material.zone != model::none) {
            const bool hole =
                material.alpha_mode == model::AlphaMode::mask && float(alpha) / 255.0f < material.alpha_cutoff;
            Colour colour = colour_of(source.zones[material.zone], *posed.tmpl, zone_rgb);
            colour.a = hole ? 0 : 255;
            out.texels.push_back(colour);
            continue;
        }
        const auto zone = std::find_if(source.zones.begin(), source.zones.end(),
                                       [&](const model::Zone &one) { return one.key == alpha; });
        if (zone == source.zones.end()) {
            ADD_FAILURE() << "no zone has key " << int(alpha);
            return out;
        }
        out.texels.push_back(colour_of(*zone, *posed.tmpl, zone_rgb));
    }
    return out;
}

int32_t wrap_of(model::Wrap wrap)
{
    return int32_t(wrap == model::Wrap::clamp    ? clamp_to_edge
                   : wrap == model::Wrap::mirror ? mirrored_repeat
                                                 : gl::repeat);
}

// Left bound and enabled.
uint32_t upload(const HostGl &host, const Painted &image, const model::Material &material)
{
    uint32_t name = 0;
    host.GenTextures(1, &name);
    host.BindTexture(gl::texture_2d, name);
    host.TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::wrap_s, wrap_of(material.wrap_s));
    host.TexParameteri(gl::texture_2d, gl::wrap_t, wrap_of(material.wrap_t));
    host.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(image.width), int32_t(image.height), 0, gl::rgba,
                    gl::unsigned_byte, image.texels.data());
    host.Enable(gl::texture_2d);
    host.TexEnvi(gl::texture_env, gl::texture_env_mode, int32_t(gl::modulate));
    material.alpha_mode == model::AlphaMode::mask ? host.Enable(gl::alpha_test) : host.Disable(gl::alpha_test);
    host.AlphaFunc(gl::gequal, 0.5f);
    return name;
}

using Place = std::array<uint32_t, 3>;  // the bits of a position, so that equal means equal

Place place_of(const float *p)
{
    Place place;
    const float numbers[3] = {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};  // no negative zero
    std::memcpy(place.data(), numbers, sizeof numbers);
    return place;
}

std::map<Place, uint32_t> vertices_of(const model::Template &tmpl)
{
    std::map<Place, uint32_t> vertices;
    for (uint32_t v = 0; v < tmpl.levels[0].source_count; ++v)
        vertices.emplace(place_of(tmpl.levels[0].positions.data() + 3 * size_t(v)), v);
    return vertices;
}

// Where the pose has the vertices of a part; without those that the template does not have.
std::vector<float> places_of(const model::Part &part, const PosedModel &posed,
                             const std::map<Place, uint32_t> &vertices)
{
    std::vector<float> places;
    for (const glm::vec3 &p : part.positions) {
        const auto found = vertices.find(place_of(&p.x));
        EXPECT_NE(found, vertices.end()) << "a vertex of part " << part.name << " is not in the template";
        if (found == vertices.end()) return {};
        const float *at = posed.positions.data() + 3 * size_t(found->second);
        places.insert(places.end(), at, at + 3);
    }
    return places;
}

}  // namespace

Picture draw_source(contexts::Offscreen &context, const model::Model &source, const PosedModel &posed,
                    const Camera &camera, const uint8_t *zone_rgb)
{
    const HostGl host(context);
    Picture picture = begin_picture(context, host, background);
    plain_state(host, camera.projection);
    host.LoadMatrixf(camera.model_view);
    const std::map<Place, uint32_t> vertices = vertices_of(*posed.tmpl);
    for (const model::Part &part : source.parts) {
        if (!model::is_drawn(part) || part.lod_min_m > 0) continue;
        const model::Material &material = source.materials[part.material];
        const std::vector<float> places = places_of(part, posed, vertices);
        if (places.empty()) break;
        const uint32_t name = upload(host, painted(source, part.material, posed, zone_rgb), material);
        std::vector<glm::vec2> uvs = part.uvs;
        uvs.resize(part.positions.size(), glm::vec2(0));
        host.EnableClientState(gl::texture_coord_array);
        host.TexCoordPointer(2, gl::real, 0, uvs.data());
        host.VertexPointer(3, gl::real, 0, places.data());
        host.FrontFace(gl::ccw);
        host.CullFace(gl::back);
        material.double_sided ? host.Disable(gl::cull_face) : host.Enable(gl::cull_face);
        host.Color4ub(255, 255, 255, 255);
        const std::vector<std::array<uint32_t, 3>> triangles = model::triangles_of(part);
        host.DrawElements(gl::triangles, int32_t(3 * triangles.size()), gl::unsigned_int, triangles.data());
        host.DeleteTextures(1, &name);
    }
    context.read_rgb(picture);
    end_plain_state(host);
    return picture;
}

}  // namespace gltest

#include "tests/gl/support/pictures.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gltest
{
namespace
{

using claque::draw::DrawList;
using claque::draw::Item;

// GL as a plain program would have it: nothing on but depth, matrices and arrays of the figure.
constexpr gl::Enum lighting = 0x0B50, dither = 0x0BD0;

void plain_state(const HostGl &host, const Figure &figure, const Camera &camera)
{
    for (const gl::Enum what : {gl::blend, gl::alpha_test, gl::texture_2d, lighting, dither}) host.Disable(what);
    host.Enable(gl::depth_test);
    host.DepthFunc(gl::lequal);
    host.MatrixMode(gl::projection);
    host.LoadMatrixf(camera.projection);
    host.MatrixMode(gl::modelview);
    host.LoadMatrixf(camera.model_view);
    host.EnableClientState(gl::vertex_array);
    host.VertexPointer(3, gl::real, 0, figure.positions.data());
}

void end_plain_state(const HostGl &host)
{
    host.DisableClientState(gl::vertex_array);
    host.DisableClientState(gl::texture_coord_array);
    for (const gl::Enum what : {gl::alpha_test, gl::texture_2d, gl::cull_face, gl::depth_test}) host.Disable(what);
}

void set_culling(const HostGl &host, const model::Surface &surface)
{
    host.FrontFace(gl::ccw);
    host.CullFace(gl::back);
    surface.double_sided ? host.Disable(gl::cull_face) : host.Enable(gl::cull_face);
}

// Source triangles of a surface, each once.
std::vector<uint32_t> triangles_of(const model::Level &level, const model::Surface &surface)
{
    std::vector<uint32_t> indices;
    const auto add = [&](model::IndexRange range) {
        indices.insert(indices.end(), level.indices.begin() + range.first,
                       level.indices.begin() + range.first + range.count);
    };
    for (const model::Bin &bin : surface.clean) add(bin.range);
    add(surface.dirty);
    return indices;
}

// The texture with each texel's own zone colour; alpha 0 in holes.
std::vector<uint8_t> coloured_texels(const model::Texture &texture, const uint8_t *zone_rgb)
{
    std::vector<uint8_t> out(texture.rgba.begin(), texture.rgba.end());
    for (size_t i = 0; i < out.size(); i += 4) {
        const uint8_t key = out[i + 3];
        const auto zone = std::find_if(texture.keys.begin(), texture.keys.end(),
                                       [&](const model::ZoneKey &k) { return k.key == key; });
        const bool is_hole = texture.has_holes && zone == texture.keys.end();
        if (!is_hole && zone == texture.keys.end()) {
            ADD_FAILURE() << "a texel's alpha " << int(key) << " is no key of its texture";
            return out;
        }
        if (!is_hole) std::copy_n(zone_rgb + 3 * zone->zone, 3, &out[i]);
        out[i + 3] = is_hole ? 0 : 255;
    }
    return out;
}

// Left bound; deleted by the caller.
uint32_t upload(const HostGl &host, const model::Texture &texture, const std::vector<uint8_t> &rgba)
{
    uint32_t name = 0;
    host.GenTextures(1, &name);
    host.BindTexture(gl::texture_2d, name);
    const auto wrap = [](model::Wrap w) { return int32_t(w == model::Wrap::clamp ? gl::clamp : gl::repeat); };
    host.TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::wrap_s, wrap(texture.wrap_s));
    host.TexParameteri(gl::texture_2d, gl::wrap_t, wrap(texture.wrap_t));
    host.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(texture.width), int32_t(texture.height), 0, gl::rgba,
                    gl::unsigned_byte, rgba.data());
    return name;
}

void use_texture(const HostGl &host, const model::Level &level, const model::Texture &texture)
{
    host.Enable(gl::texture_2d);
    host.TexEnvi(gl::texture_env, gl::texture_env_mode, int32_t(gl::modulate));
    host.EnableClientState(gl::texture_coord_array);
    host.TexCoordPointer(2, gl::real, 0, level.uvs.data());
    texture.has_holes ? host.Enable(gl::alpha_test) : host.Disable(gl::alpha_test);
    host.AlphaFunc(gl::gequal, 0.5f);
}

Picture begin(contexts::Offscreen &context, const HostGl &host, const uint8_t *rgb)
{
    host.Viewport(0, 0, context.width(), context.height());
    host.clear(rgb[0] / 255.0f, rgb[1] / 255.0f, rgb[2] / 255.0f);
    return Picture();
}

}  // namespace

Camera camera_on(const Figure &figure, float distance_radii, float turn_rad, float tilt_rad, float aspect)
{
    const float r = figure.radius, distance = distance_radii * r;
    const float z_near = std::max(distance - 1.5f * r, 0.02f * r);
    glm::mat4 view = glm::translate(glm::mat4(1), glm::vec3(0, 0, -distance));
    view = glm::rotate(view, tilt_rad, glm::vec3(1, 0, 0));
    view = glm::rotate(view, turn_rad, glm::vec3(0, 1, 0));
    view = glm::translate(view, -figure.centre);
    const glm::mat4 projection = glm::perspective(0.8f, aspect, z_near, distance + 1.5f * r);
    Camera camera;
    std::copy_n(glm::value_ptr(projection), 16, camera.projection);
    std::copy_n(glm::value_ptr(view), 16, camera.model_view);
    return camera;
}

DrawList list_of(const Figure &figure, const Camera &camera, const uint8_t *zone_rgb)
{
    DrawList list(std::pmr::get_default_resource());
    Item item;
    item.tmpl = figure.tmpl.get();
    item.vertices = {figure.positions.data(), figure.normals.data()};
    item.zone_rgb = zone_rgb;
    std::copy_n(camera.model_view, 16, item.model_view);
    std::copy_n(camera.projection, 16, list.projection);
    list.items.push_back(item);
    return list;
}

Picture draw(contexts::Offscreen &context, passes::Renderer &renderer, const DrawList &list)
{
    const HostGl host(context);
    Picture picture = begin(context, host, background);
    const claque::base::Status status = renderer.draw(list, nullptr);
    EXPECT_TRUE(status.ok()) << status.text;
    context.read_rgb(picture);
    return picture;
}

Picture draw_plain(contexts::Offscreen &context, const Figure &figure, const Camera &camera, const uint8_t *zone_rgb)
{
    const HostGl host(context);
    Picture picture = begin(context, host, background);
    plain_state(host, figure, camera);
    const model::Level &level = figure.tmpl->levels[0];
    for (const model::Surface &surface : level.surfaces) {
        const model::Texture &texture = figure.tmpl->textures[surface.texture];
        const uint32_t name = upload(host, texture, coloured_texels(texture, zone_rgb));
        use_texture(host, level, texture);
        set_culling(host, surface);
        host.Color4ub(255, 255, 255, 255);
        const std::vector<uint32_t> indices = triangles_of(level, surface);
        host.DrawElements(gl::triangles, int32_t(indices.size()), gl::unsigned_int, indices.data());
        host.DeleteTextures(1, &name);
    }
    context.read_rgb(picture);
    end_plain_state(host);
    return picture;
}

Picture draw_ids(contexts::Offscreen &context, const Figure &figure, const Camera &camera, Order order)
{
    const HostGl host(context);
    constexpr uint8_t black[3] = {0, 0, 0};
    Picture picture = begin(context, host, black);
    plain_state(host, figure, camera);
    const model::Level &level = figure.tmpl->levels[0];
    struct Triangle {
        const model::Surface *surface;
        std::array<uint32_t, 3> corners;
    };
    std::vector<Triangle> all;
    std::vector<uint32_t> names;
    for (const model::Surface &surface : level.surfaces) {
        const std::vector<uint32_t> indices = triangles_of(level, surface);
        for (size_t i = 0; i < indices.size(); i += 3)
            all.push_back({&surface, {indices[i], indices[i + 1], indices[i + 2]}});
        const model::Texture &texture = figure.tmpl->textures[surface.texture];
        const std::vector<uint8_t> white(3 * figure.tmpl->zone_count(), 255);
        names.push_back(upload(host, texture, coloured_texels(texture, white.data())));
    }
    for (size_t k = 0; k < all.size(); ++k) {
        const size_t i = order == Order::forwards ? k : all.size() - 1 - k;
        const Triangle &t = all[i];
        use_texture(host, level, figure.tmpl->textures[t.surface->texture]);
        host.BindTexture(gl::texture_2d, names[size_t(t.surface - level.surfaces.data())]);
        set_culling(host, *t.surface);
        const uint32_t id = static_cast<uint32_t>(i + 1);  // 16 bits, as RGB565 keeps them
        host.Color4ub(uint8_t(id >> 11 << 3), uint8_t((id >> 5 & 63) << 2), uint8_t((id & 31) << 3), 255);
        host.DrawElements(gl::triangles, 3, gl::unsigned_int, t.corners.data());
    }
    context.read_rgb(picture);
    host.DeleteTextures(int32_t(names.size()), names.data());
    end_plain_state(host);
    return picture;
}

Comparison compare(const Picture &plain, const Picture &variety, const Picture &forwards, const Picture &backwards)
{
    Comparison result;
    for (size_t i = 0; i < plain.size(); i += 3) {
        const auto same = [i](const uint8_t *a, const Picture &b) { return std::memcmp(a, &b[i], 3) == 0; };
        const bool covered = !same(background, plain), tie = !same(&forwards[i], backwards);
        result.covered += covered;
        result.holes += covered && same(background, variety);
        result.ties += covered && tie;
        result.wrong += !tie && !same(&plain[i], variety);
    }
    return result;
}

Comparison zone_law(contexts::Offscreen &context, passes::Renderer &renderer, const Figure &figure,
                    const Camera &camera)
{
    const std::vector<uint8_t> colours = zone_colours(figure.tmpl->zone_count());
    const DrawList list = list_of(figure, camera, colours.data());
    return compare(draw_plain(context, figure, camera, colours.data()), draw(context, renderer, list),
                   draw_ids(context, figure, camera, Order::forwards),
                   draw_ids(context, figure, camera, Order::backwards));
}

}  // namespace gltest

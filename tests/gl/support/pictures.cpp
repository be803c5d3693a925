#include "tests/gl/support/pictures.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include "tests/gl/support/uploads.h"

namespace gltest
{
namespace
{

using claque::draw::DrawList;
using claque::draw::Item;

void place(const HostGl &host, const Individual &individual)
{
    host.LoadMatrixf(individual.model_view);
    host.VertexPointer(3, gl::real, 0, individual.positions);
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

void use_texture(const HostGl &host, const model::Level &level, const model::Texture &texture)
{
    host.Enable(gl::texture_2d);
    host.TexEnvi(gl::texture_env, gl::texture_env_mode, int32_t(gl::modulate));
    host.EnableClientState(gl::texture_coord_array);
    host.TexCoordPointer(2, gl::real, 0, level.uvs.data());
    texture.has_holes ? host.Enable(gl::alpha_test) : host.Disable(gl::alpha_test);
    host.AlphaFunc(gl::gequal, 0.5f);
}

}  // namespace

uint32_t covered(const Picture &picture)
{
    uint32_t count = 0;
    for (size_t i = 0; i + 2 < picture.size(); i += 3)
        count += !std::equal(background, background + 3, picture.begin() + std::ptrdiff_t(i));
    return count;
}

Picture begin_picture(contexts::Offscreen &context, const HostGl &host, const uint8_t *rgb)
{
    host.Viewport(0, 0, context.width(), context.height());
    host.clear(rgb[0] / 255.0f, rgb[1] / 255.0f, rgb[2] / 255.0f);
    return Picture();
}

constexpr gl::Enum lighting = 0x0B50, dither = 0x0BD0;

void plain_state(const HostGl &host, const float (&projection)[16])
{
    for (const gl::Enum what : {gl::blend, gl::alpha_test, gl::texture_2d, lighting, dither}) host.Disable(what);
    host.Enable(gl::depth_test);
    host.DepthFunc(gl::lequal);
    host.MatrixMode(gl::projection);
    host.LoadMatrixf(projection);
    host.MatrixMode(gl::modelview);
    host.EnableClientState(gl::vertex_array);
}

void end_plain_state(const HostGl &host)
{
    host.DisableClientState(gl::vertex_array);
    host.DisableClientState(gl::texture_coord_array);
    for (const gl::Enum what : {gl::alpha_test, gl::texture_2d, gl::cull_face, gl::depth_test}) host.Disable(what);
}

Camera camera_on(const PosedModel &posed, float distance_radii, float turn_rad, float tilt_rad, float aspect)
{
    const float r = posed.radius, distance = distance_radii * r;
    const float z_near = std::max(distance - 1.5f * r, 0.02f * r);
    glm::mat4 view = glm::translate(glm::mat4(1), glm::vec3(0, 0, -distance));
    view = glm::rotate(view, tilt_rad, glm::vec3(1, 0, 0));
    view = glm::rotate(view, turn_rad, glm::vec3(0, 1, 0));
    view = glm::translate(view, -posed.centre);
    const glm::mat4 projection = glm::perspective(0.8f, aspect, z_near, distance + 1.5f * r);
    Camera camera;
    std::copy_n(glm::value_ptr(projection), 16, camera.projection);
    std::copy_n(glm::value_ptr(view), 16, camera.model_view);
    return camera;
}

Individual individual_of(const PosedModel &posed, const Camera &camera, const uint8_t *zone_rgb)
{
    Individual individual = {posed.tmpl.get(), posed.positions.data(), posed.normals.data(), zone_rgb, {}, 0};
    individual.texture_set = posed.texture_set;
    std::copy_n(camera.model_view, 16, individual.model_view);
    return individual;
}

DrawList list_of(const std::vector<Individual> &individuals, const float (&projection)[16])
{
    DrawList list(std::pmr::get_default_resource());
    for (const Individual &individual : individuals) {
        Item item;
        item.tmpl = individual.tmpl;
        item.vertices = {individual.positions, individual.normals};
        item.zone_rgb = individual.zone_rgb;
        item.texture_set = individual.texture_set;
        std::copy_n(individual.model_view, 16, item.model_view);
        list.items.push_back(item);
    }
    std::copy_n(projection, 16, list.projection);
    return list;
}

DrawList list_of(const PosedModel &posed, const Camera &camera, const uint8_t *zone_rgb)
{
    return list_of({individual_of(posed, camera, zone_rgb)}, camera.projection);
}

Picture draw(contexts::Offscreen &context, passes::Renderer &renderer, const DrawList &list, double least_share)
{
    const HostGl host(context);
    Picture picture = begin_picture(context, host, background);
    const claque::base::Status status = renderer.draw(list, nullptr);
    EXPECT_TRUE(status.ok()) << status.text;
    context.read_rgb(picture);
    if (!list.items.empty()) {
        EXPECT_GE(covered(picture), least_share * double(picture.size() / 3)) << "the picture shows next to nothing";
    }
    return picture;
}

Picture draw_plain(contexts::Offscreen &context, const std::vector<Individual> &individuals,
                   const float (&projection)[16])
{
    const HostGl host(context);
    Picture picture = begin_picture(context, host, background);
    plain_state(host, projection);
    Uploads uploads(host);
    for (const Individual &individual : individuals) {
        place(host, individual);
        const model::Level &level = individual.tmpl->levels[0];
        for (const model::Surface &surface : level.surfaces) {
            const model::Texture &texture = individual.tmpl->textures[surface.texture];
            const uint32_t name = uploads.of(texture, individual.texture_set, individual.zone_rgb);
            use_texture(host, level, texture);
            host.BindTexture(gl::texture_2d, name);
            set_culling(host, surface);
            host.Color4ub(255, 255, 255, 255);
            const std::vector<uint32_t> indices = triangles_of(level, surface);
            host.DrawElements(gl::triangles, int32_t(indices.size()), gl::unsigned_int, indices.data());
        }
    }
    context.read_rgb(picture);
    end_plain_state(host);
    return picture;
}

Picture draw_plain(contexts::Offscreen &context, const PosedModel &posed, const Camera &camera, const uint8_t *zone_rgb)
{
    return draw_plain(context, {individual_of(posed, camera, zone_rgb)}, camera.projection);
}

namespace
{

struct Triangle {
    const Individual *individual;
    const model::Surface *surface;
    std::array<uint32_t, 3> corners;
};

std::vector<Triangle> all_triangles(const std::vector<Individual> &individuals)
{
    std::vector<Triangle> all;
    for (const Individual &individual : individuals)
        for (const model::Surface &surface : individual.tmpl->levels[0].surfaces) {
            const std::vector<uint32_t> indices = triangles_of(individual.tmpl->levels[0], surface);
            for (size_t i = 0; i < indices.size(); i += 3)
                all.push_back({&individual, &surface, {indices[i], indices[i + 1], indices[i + 2]}});
        }
    return all;
}

// The bits that RGB565 keeps; bits above them need RGBA8888.
void colour_by(const HostGl &host, uint32_t id)
{
    const uint32_t more = id >> 16;
    host.Color4ub(uint8_t((id >> 11 & 31) << 3 | (more & 7)), uint8_t((id >> 5 & 63) << 2 | (more >> 3 & 3)),
                  uint8_t((id & 31) << 3 | (more >> 5 & 7)), 255);
}

}  // namespace

Picture draw_ids(contexts::Offscreen &context, const std::vector<Individual> &individuals,
                 const float (&projection)[16], Order order)
{
    const HostGl host(context);
    constexpr uint8_t black[3] = {0, 0, 0};
    Picture picture = begin_picture(context, host, black);
    plain_state(host, projection);
    const std::vector<Triangle> all = all_triangles(individuals);
    Uploads uploads(host);
    const Individual *last = nullptr;
    static const std::vector<uint8_t> white(3 * 256, 255);
    for (size_t k = 0; k < all.size(); ++k) {
        const size_t i = order == Order::forwards ? k : all.size() - 1 - k;
        const Triangle &t = all[i];
        if (t.individual != last) place(host, *t.individual);
        last = t.individual;
        const model::Texture &texture = t.individual->tmpl->textures[t.surface->texture];
        const uint32_t name = uploads.of(texture, t.individual->texture_set, white.data());
        use_texture(host, t.individual->tmpl->levels[0], texture);
        host.BindTexture(gl::texture_2d, name);
        set_culling(host, *t.surface);
        colour_by(host, static_cast<uint32_t>(i + 1));
        host.DrawElements(gl::triangles, 3, gl::unsigned_int, t.corners.data());
    }
    context.read_rgb(picture);
    end_plain_state(host);
    return picture;
}

Picture draw_ids(contexts::Offscreen &context, const PosedModel &posed, const Camera &camera, Order order)
{
    return draw_ids(context, {individual_of(posed, camera, nullptr)}, camera.projection, order);
}

}  // namespace gltest

#include "tests/gl/support/ground.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gltest
{
namespace
{

constexpr double near_m = 0.5, far_m = 60;

struct GroundTriangle {
    glm::dvec3 a, b, c;
};

// Moeller and Trumbore 1997, either side, any t > 0 up to `most`.
bool meets(const GroundTriangle &t, const glm::dvec3 &from, const glm::dvec3 &way, double most)
{
    const glm::dvec3 u = t.b - t.a, v = t.c - t.a, p = glm::cross(way, v);
    const double det = glm::dot(u, p);
    if (std::fabs(det) < 1e-14) return false;
    const glm::dvec3 s = from - t.a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / det, y = glm::dot(way, q) / det, at = glm::dot(v, q) / det;
    return x >= 0 && y >= 0 && x + y <= 1 && at > 0 && at < most;
}

// The triangles of one individual, and a sphere round it.
struct Body {
    explicit Body(std::vector<GroundTriangle> of) : triangles(std::move(of)), middle(0)
    {
        for (const GroundTriangle &t : triangles) middle += (t.a + t.b + t.c) / (3.0 * double(triangles.size()));
        for (const GroundTriangle &t : triangles)
            for (const glm::dvec3 &p : {t.a, t.b, t.c}) radius = std::max(radius, glm::length(p - middle));
    }
    bool meets(const glm::dvec3 &from, const glm::dvec3 &way, double most) const
    {
        if (glm::length(glm::cross(middle - from, way)) > 1.001 * radius * glm::length(way)) return false;
        return std::any_of(triangles.begin(), triangles.end(),
                           [&](const GroundTriangle &t) { return gltest::meets(t, from, way, most); });
    }
    std::vector<GroundTriangle> triangles;
    glm::dvec3 middle;
    double radius = 0;
};

std::vector<GroundTriangle> triangles_of(const Item &item, const glm::dmat3 &world_to_eye, const glm::dvec3 &eye)
{
    const glm::dmat4 model_view(glm::make_mat4(item.model_view));
    const model::Level &level = item.tmpl->levels[item.level];
    const auto point = [&](uint32_t v) {
        const float *p = item.vertices.positions + 3 * size_t(v);
        return glm::transpose(world_to_eye) * glm::dvec3(model_view * glm::dvec4(p[0], p[1], p[2], 1)) + eye;
    };
    std::vector<GroundTriangle> out;
    const auto add = [&](model::IndexRange range) {
        for (uint32_t i = range.first; i < range.first + range.count; i += 3)
            out.push_back({point(level.indices[i]), point(level.indices[i + 1]), point(level.indices[i + 2])});
    };
    for (const model::Surface &surface : level.surfaces) {
        for (const model::Bin &bin : surface.clean) add(bin.range);
        add(surface.dirty);
    }
    return out;
}

}  // namespace

Ground::Ground(glm::dvec3 eye, glm::dvec3 target, float aspect) : eye_(eye)
{
    world_to_eye_ = glm::dmat3(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
    const glm::mat4 projection = glm::perspective(0.8f, aspect, float(near_m), float(far_m));
    std::copy_n(glm::value_ptr(projection), 16, projection_);
}

Item Ground::stand(const PosedModel &posed, glm::dvec3 at, float turn_rad, float scale) const
{
    Item item;
    item.tmpl = posed.tmpl.get();
    item.vertices.positions = posed.positions.data();
    item.vertices.normals = posed.normals.data();
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), double(turn_rad), glm::dvec3(0, 1, 0));
    glm::dmat4 place = glm::dmat4(world_to_eye_) * turn * glm::scale(glm::dmat4(1), glm::dvec3(scale));
    place[3] = glm::dvec4(world_to_eye_ * (at - eye_), 1);
    std::copy_n(glm::value_ptr(glm::mat4(place)), 16, item.model_view);
    for (int k = 0; k < 3; ++k) item.ground[k] = at[k];
    item.eye_distance_m = float(glm::length(at - eye_));
    return item;
}

DrawList Ground::list_of(const std::vector<Item> &items) const
{
    DrawList list(std::pmr::get_default_resource());
    list.items.assign(items.begin(), items.end());
    std::copy_n(projection_, 16, list.projection);
    for (int k = 0; k < 3; ++k) list.eye[k] = eye_[k];
    for (int k = 0; k < 9; ++k) list.world_to_eye[k] = world_to_eye_[k / 3][k % 3];
    return list;
}

void Ground::quad(const HostGl &host, const std::array<glm::dvec3, 4> &corners) const
{
    glm::vec3 eye_space[4];
    for (size_t k = 0; k < 4; ++k) eye_space[k] = glm::vec3(world_to_eye_ * (corners[k] - eye_));
    const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    host.PushAttrib(gl::all_attrib_bits);
    host.PushClientAttrib(gl::all_client_attrib_bits);
    host.MatrixMode(gl::projection);
    host.LoadMatrixf(projection_);
    host.MatrixMode(gl::modelview);
    host.LoadMatrixf(identity);
    host.Enable(gl::depth_test);
    host.Color4f(1, 1, 1, 1);
    host.EnableClientState(gl::vertex_array);
    host.VertexPointer(3, gl::real, 0, eye_space);
    host.DrawElements(gl::triangles, 6, gl::unsigned_int, indices);
    host.PopClientAttrib();
    host.PopAttrib();
}

void Ground::draw(const HostGl &host, int width, int height) const
{
    host.Viewport(0, 0, width, height);
    host.clear(0, 0, 1);
    host.ask<void (*)(int32_t)>("glClearStencil")(0xff);
    host.Clear(0x400);
    constexpr double r = 200;
    quad(host, {glm::dvec3(-r, 0, r), glm::dvec3(r, 0, r), glm::dvec3(r, 0, -r), glm::dvec3(-r, 0, -r)});
}

void Ground::draw_wall(const HostGl &host) const
{
    const glm::dmat3 axes = glm::transpose(world_to_eye_);
    const auto at = [&](double x, double y) { return eye_ + axes * glm::dvec3(x, y, -1); };
    quad(host, {at(-5, -5), at(0, -5), at(0, 5), at(-5, 5)});
}

glm::dvec3 Ground::seen_ground(double x, double y) const
{
    const glm::dvec3 ray(x / double(projection_[0]), y / double(projection_[5]), -1);
    const glm::dvec3 way = glm::transpose(world_to_eye_) * ray;
    return eye_ - way * (eye_.y / way.y);
}

std::vector<bool> Ground::shaded(const std::vector<Item> &items, glm::dvec4 light, int width, int height) const
{
    std::vector<Body> bodies;
    for (const Item &item : items) bodies.emplace_back(triangles_of(item, world_to_eye_, eye_));
    std::vector<bool> out;
    for (int row = height - 1; row >= 0; --row)
        for (int column = 0; column < width; ++column) {
            const glm::dvec3 from = seen_ground(2 * (column + 0.5) / width - 1, 2 * (row + 0.5) / height - 1);
            const glm::dvec3 way = light.w == 0 ? glm::dvec3(light) : glm::dvec3(light) - from;
            out.push_back(std::any_of(bodies.begin(), bodies.end(), [&](const Body &body) {
                return body.meets(from, way, light.w == 0 ? 1e9 : 1.0);
            }));
        }
    return out;
}

}  // namespace gltest

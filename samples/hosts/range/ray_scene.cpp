#include "samples/hosts/range/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "samples/scenes/check.h"

namespace range
{

using scenes::check;

namespace
{

// The zones of a texture's texels, the row at v = 0 first.
struct Zones {
    uint32_t width = 0, height = 0;
    std::vector<uint32_t> of;
    bool has_holes = false;
    clq_wrap wrap_s = CLQ_WRAP_REPEAT, wrap_t = CLQ_WRAP_REPEAT;

    uint32_t at(double u, double v) const
    {
        return of[size_t(texel(v, height, wrap_t)) * width + texel(u, width, wrap_s)];
    }

private:
    static uint32_t texel(double at, uint32_t size, clq_wrap wrap)
    {
        const double within = wrap == CLQ_WRAP_REPEAT ? at - std::floor(at) : std::fmin(std::fmax(at, 0), 1);
        return std::min(size - 1, static_cast<uint32_t>(within * size));
    }
};

// One individual's triangles. Positions are relative to the sensor, so that floats do at any place of the world.
struct Body {
    uint32_t actor = 0;
    std::vector<float> positions;
    std::vector<uint32_t> corners;          // three a triangle
    std::vector<uint32_t> zones, textures;  // by triangle; zone CLQ_NONE: several
    std::vector<uint8_t> double_sided;      // by triangle
    bool mirrored = false;                  // front faces wind clockwise
    const float *uvs = nullptr;
    std::vector<const Zones *> texels;  // by texture

    uint32_t zone_at(uint32_t triangle, float u, float v) const
    {
        const Zones &map = *texels[textures[triangle]];
        if (zones[triangle] != CLQ_NONE && !map.has_holes) return zones[triangle];
        const double weights[3] = {1 - static_cast<double>(u + v), static_cast<double>(u), static_cast<double>(v)};
        double uv[2] = {0, 0};
        for (size_t k = 0; k < 3; ++k)
            for (size_t j = 0; j < 2; ++j)
                uv[j] += weights[k] * static_cast<double>(uvs[2 * size_t(corners[3 * size_t(triangle) + k]) + j]);
        return map.at(uv[0], uv[1]);
    }
    // As drawing shows it: not the backs of single-sided triangles, and no holes.
    bool shows(uint32_t triangle, float u, float v, bool from_behind) const
    {
        if (from_behind != mirrored && double_sided[triangle] == 0) return false;
        return !texels[textures[triangle]]->has_holes || zone_at(triangle, u, v) != CLQ_NONE;
    }
};

// From eye space to the world's axes.
std::array<float, 3> turned_back(const clq_camera &camera, const std::array<double, 3> &v)
{
    const float *q = camera.rotation_xyzw;
    const double a = -static_cast<double>(q[0]), b = -static_cast<double>(q[1]), c = -static_cast<double>(q[2]),
                 w = static_cast<double>(q[3]);
    const double t[3] = {2 * (b * v[2] - c * v[1]), 2 * (c * v[0] - a * v[2]), 2 * (a * v[1] - b * v[0])};
    return {static_cast<float>(v[0] + w * t[0] + b * t[2] - c * t[1]),
            static_cast<float>(v[1] + w * t[1] + c * t[0] - a * t[2]),
            static_cast<float>(v[2] + w * t[2] + a * t[1] - b * t[0])};
}

}  // namespace

struct RayScene::Parts {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<Body> bodies;
    std::map<std::tuple<const clq_template *, uint32_t, uint32_t>, Zones> zones;
    std::vector<float> ground;
    std::vector<uint32_t> ground_corners;
    unsigned ground_geometry = RTC_INVALID_GEOMETRY_ID;
    size_t triangles = 0;

    ~Parts()
    {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    const Zones *zones_of(const clq_template *tmpl, uint32_t set, uint32_t texture)
    {
        Zones &made = zones[{tmpl, set, texture}];
        if (!made.of.empty()) return &made;
        clq_texels texels = clq_texels_init();
        check(clq_template_get_texture(tmpl, set, texture, &texels));
        made.width = texels.width_px, made.height = texels.height_px;
        made.of.resize(size_t(made.width) * made.height);
        texels.zones = made.of.data(), texels.capacity = made.of.size();
        check(clq_template_get_texture(tmpl, set, texture, &texels));
        made.has_holes = std::find(made.of.begin(), made.of.end(), CLQ_NONE) != made.of.end();
        check(clq_template_get_wrap(tmpl, texture, &made.wrap_s, &made.wrap_t));
        return &made;
    }

    // `camera`: of the view.
    void take(const clq_view *view, uint32_t index, const clq_drawn_actor &drawn, const clq_camera &camera)
    {
        Body &body = bodies.emplace_back();
        body.actor = drawn.actor.index1, body.mirrored = drawn.mirrored;
        std::vector<float> xyz(3 * size_t(drawn.vertex_count));
        check(clq_view_get_vertices(view, index, xyz.data(), nullptr, drawn.vertex_count));
        const float *m = drawn.model_view;
        for (size_t v = 0; v < drawn.vertex_count; ++v) {
            std::array<double, 3> eye;
            for (size_t r = 0; r < 3; ++r) {
                eye[r] = static_cast<double>(m[12 + r]);
                for (size_t k = 0; k < 3; ++k)
                    eye[r] += static_cast<double>(m[4 * k + r]) * static_cast<double>(xyz[3 * v + k]);
            }
            const std::array<float, 3> at = turned_back(camera, eye);
            body.positions.insert(body.positions.end(), at.begin(), at.end());
        }
        clq_mesh mesh = clq_mesh_init();
        check(clq_template_get_mesh(drawn.tmpl, drawn.level, &mesh));
        body.uvs = mesh.uvs;
        for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
            clq_triangles found = clq_triangles_init();
            check(clq_template_get_triangles(drawn.tmpl, drawn.level, bin, &found));
            body.corners.insert(body.corners.end(), found.indices, found.indices + found.index_count);
            body.zones.insert(body.zones.end(), found.index_count / 3, found.zone);
            body.double_sided.insert(body.double_sided.end(), found.index_count / 3, found.double_sided);
            body.textures.insert(body.textures.end(), found.index_count / 3, found.texture);
            if (body.texels.size() <= found.texture) body.texels.resize(found.texture + 1, nullptr);
            body.texels[found.texture] = zones_of(drawn.tmpl, drawn.texture_set, found.texture);
        }
        triangles += body.corners.size() / 3;
    }

    // Embree asks it for each triangle that a ray meets.
    static void filter(const RTCFilterFunctionNArguments *asked)
    {
        const Body &body = *static_cast<const Body *>(asked->geometryUserPtr);
        const RTCRay *ray = reinterpret_cast<const RTCRay *>(asked->ray);
        const RTCHit *hit = reinterpret_cast<const RTCHit *>(asked->hit);
        const bool from_behind = hit->Ng_x * ray->dir_x + hit->Ng_y * ray->dir_y + hit->Ng_z * ray->dir_z > 0;
        if (!body.shows(hit->primID, hit->u, hit->v, from_behind)) asked->valid[0] = 0;
    }

    unsigned add(const std::vector<float> &positions, const std::vector<uint32_t> &corners, Body *body) const
    {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        void *to = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                           positions.size() / 3);
        void *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                3 * sizeof(uint32_t), corners.size() / 3);
        if (!to || !indices) throw scenes::Failure("Embree has no memory for an individual's triangles");
        std::copy(positions.begin(), positions.end(), static_cast<float *>(to));
        std::copy(corners.begin(), corners.end(), static_cast<uint32_t *>(indices));
        if (body) {
            rtcSetGeometryUserData(geometry, body);
            rtcSetGeometryIntersectFilterFunction(geometry, filter);
        }
        rtcCommitGeometry(geometry);
        const unsigned id = rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        return id;
    }

    Return returned(const RTCRayHit &hit) const
    {
        Return out;
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return out;
        out.distance = hit.ray.tfar;
        const float length =
            std::sqrt(hit.hit.Ng_x * hit.hit.Ng_x + hit.hit.Ng_y * hit.hit.Ng_y + hit.hit.Ng_z * hit.hit.Ng_z);
        out.normal = {hit.hit.Ng_x / length, hit.hit.Ng_y / length, hit.hit.Ng_z / length};
        if (hit.hit.geomID == ground_geometry) return out;
        const Body &body = bodies[hit.hit.geomID];
        out.actor = body.actor;
        out.zone = body.zone_at(hit.hit.primID, hit.hit.u, hit.hit.v);
        return out;
    }
};

RayScene::RayScene(const std::vector<Look> &looks, double ground_y) : parts_(std::make_unique<Parts>())
{
    parts_->device = rtcNewDevice(nullptr);
    if (!parts_->device) throw scenes::Failure("Embree could not be started");
    parts_->scene = rtcNewScene(parts_->device);
    rtcSetSceneFlags(parts_->scene, RTC_SCENE_FLAG_ROBUST);
    std::set<uint32_t> taken;  // views overlap at their borders
    for (const Look &look : looks) {
        clq_view_stats stats = clq_view_stats_init();
        check(clq_view_get_stats(look.view, &stats));
        for (uint32_t i = 0; i < stats.visible; ++i) {
            clq_drawn_actor drawn = clq_drawn_actor_init();
            check(clq_view_get_drawn_actor(look.view, i, &drawn));
            if (!drawn.shadow_only && taken.insert(drawn.actor.index1).second)
                parts_->take(look.view, i, drawn, look.camera);
        }
    }
    for (Body &body : parts_->bodies) parts_->add(body.positions, body.corners, &body);
    if (!std::isnan(ground_y) && !looks.empty()) {
        constexpr float far = 1000;
        const float y = static_cast<float>(ground_y - looks[0].camera.eye[1]);
        parts_->ground = {-far, y, -far, far, y, -far, far, y, far, -far, y, far};
        parts_->ground_corners = {0, 2, 1, 0, 3, 2};
        parts_->ground_geometry = parts_->add(parts_->ground, parts_->ground_corners, nullptr);
    }
    rtcCommitScene(parts_->scene);
}

RayScene::~RayScene() = default;

size_t RayScene::triangle_count() const { return parts_->triangles; }

std::vector<Return> RayScene::cast(const std::vector<Ray> &rays) const
{
    std::vector<Return> out;
    out.reserve(rays.size());
#if RTC_VERSION_MAJOR < 4
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
#endif
    for (const Ray &ray : rays) {
        RTCRayHit hit = {};
        hit.ray.dir_x = ray.direction[0], hit.ray.dir_y = ray.direction[1], hit.ray.dir_z = ray.direction[2];
        hit.ray.tfar = ray.max_distance, hit.ray.mask = ~0u;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID, hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR < 4
        rtcIntersect1(parts_->scene, &context, &hit);
#else
        rtcIntersect1(parts_->scene, &hit);
#endif
        out.push_back(parts_->returned(hit));
    }
    return out;
}

}  // namespace range

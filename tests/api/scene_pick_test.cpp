// The triangle that a ray meets first, against every triangle that a view's draw list draws.
#include <cmath>
#include <vector>

#include "tests/api/scene_people.h"

namespace
{

using scene_people::Crowd;

struct Vec {
    double x = 0, y = 0, z = 0;
};
Vec operator-(const Vec &a, const Vec &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator+(const Vec &a, const Vec &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator*(const Vec &a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(const Vec &a, const Vec &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(const Vec &a, const Vec &b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

// The nearest triangle of the whole list, and the distance of the nearest one of anybody else.
struct Nearest {
    clq_actor actor = {0, 0};
    double distance = HUGE_VAL, next = HUGE_VAL;
    uint32_t zone = CLQ_NONE;
    bool dirty = false;
};

class Picture
{
public:
    Picture(const clq_view *view, const clq_camera &camera) : view_(view), camera_(camera) {}

    // By planes and areas in eye space: another way than the library's.
    Nearest meet(const clq_ray &ray) const
    {
        const Vec origin = eye_of(Vec{ray.origin[0], ray.origin[1], ray.origin[2]} -
                                  Vec{camera_.eye[0], camera_.eye[1], camera_.eye[2]}),
                  along = eye_of({ray.direction[0], ray.direction[1], ray.direction[2]});
        clq_view_stats stats = clq_view_stats_init();
        EXPECT_EQ(clq_view_get_stats(view_, &stats), CLQ_OK);
        Nearest out;
        for (uint32_t i = 0; i < stats.visible; ++i) meet_one(i, origin, along, out);
        return out;
    }

private:
    Vec eye_of(const Vec &v) const
    {
        const float *q = camera_.rotation_xyzw;
        const Vec axis{q[0], q[1], q[2]};
        const Vec t = cross(axis, v) * 2;
        return v + t * q[3] + cross(axis, t);
    }

    void meet_one(uint32_t index, const Vec &origin, const Vec &along, Nearest &out) const
    {
        clq_drawn_actor drawn = clq_drawn_actor_init();
        ASSERT_EQ(clq_view_get_drawn_actor(view_, index, &drawn), CLQ_OK);
        if (drawn.shadow_only) return;
        std::vector<float> xyz(3 * drawn.vertex_count);
        ASSERT_EQ(clq_view_get_vertices(view_, index, xyz.data(), nullptr, drawn.vertex_count), CLQ_OK);
        const float *m = drawn.model_view;
        const auto at = [&](uint32_t v) {
            const double x = xyz[3 * v], y = xyz[3 * v + 1], z = xyz[3 * v + 2];
            return Vec{m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13],
                       m[2] * x + m[6] * y + m[10] * z + m[14]};
        };
        clq_mesh mesh = clq_mesh_init();
        ASSERT_EQ(clq_template_get_mesh(drawn.tmpl, drawn.level, &mesh), CLQ_OK);
        double mine = HUGE_VAL;
        for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
            clq_triangles triangles = clq_triangles_init();
            ASSERT_EQ(clq_template_get_triangles(drawn.tmpl, drawn.level, bin, &triangles), CLQ_OK);
            for (uint32_t i = 0; i < triangles.index_count; i += 3) {
                const Vec a = at(triangles.indices[i]), b = at(triangles.indices[i + 1]),
                          c = at(triangles.indices[i + 2]);
                const Vec normal = cross(b - a, c - a);
                const double facing = dot(normal, along);
                if (facing == 0 || (!triangles.double_sided && (facing > 0) != drawn.mirrored)) continue;
                const double distance = dot(normal, a - origin) / facing;
                const Vec p = origin + along * distance;
                if (distance < 0 || dot(cross(b - a, p - a), normal) < 0 || dot(cross(c - b, p - b), normal) < 0 ||
                    dot(cross(a - c, p - c), normal) < 0)
                    continue;
                if (distance < out.distance) {
                    if (out.actor.index1 != drawn.actor.index1) out.next = out.distance;
                    out.actor = drawn.actor, out.distance = distance;
                    out.zone = triangles.zone, out.dirty = triangles.zone == CLQ_NONE;
                }
                mine = std::fmin(mine, distance);
            }
        }
        if (out.actor.index1 != drawn.actor.index1) out.next = std::fmin(out.next, mine);
    }

    const clq_view *view_;
    const clq_camera &camera_;
};

struct Form {
    const char *name;
    clq_vertex_format vertices;
    clq_rigid_mode rigid;
};

class Pick : public testing::TestWithParam<Form>
{
protected:
    void SetUp() override
    {
        rigid_def_.def.name = "rigid";
        rigid_def_.parts[0].influence_count = 0, rigid_def_.parts[0].node = 1;
        rigid_def_.def.joint_count = 0;
        for (size_t v = 0; v < 10; ++v)  // skin alone
            skin_uvs_[2 * v] = 0.5f + 0.5f * rigid_def_.parts[0].uvs[2 * v],
                          skin_uvs_[2 * v + 1] = rigid_def_.parts[0].uvs[2 * v + 1];
        rigid_def_.parts[0].uvs = skin_uvs_;
        ASSERT_EQ(clq_template_build(world_.context, &rigid_def_.def, &rigid_), CLQ_OK) << clq_last_error();
        clq_crowd_def def = clq_crowd_def_init();
        def.vertex_format = GetParam().vertices, def.rigid_mode = GetParam().rigid;
        crowd_ = world_.new_crowd(&def);
        for (uint32_t i = 0; i < 120; ++i) {
            clq_actor_def actor = clq_actor_def_init();
            actor.tmpl = i % 3 == 2 ? rigid_ : world_.templates[i % 3];
            actor.transform.position[0] = double(mixed(1, i) % 1000) / 125 - 4;
            actor.transform.position[1] = double(mixed(2, i) % 1000) / 500 - 1;
            actor.transform.position[2] = -double(mixed(3, i) % 1000) / 100 - 1;
            actor.transform.orientation_xyzw[1] = 0.6f, actor.transform.orientation_xyzw[3] = 0.8f;
            if (i % 2) actor.transform.orientation_xyzw[1] = 0, actor.transform.orientation_xyzw[3] = 1;
            actor.transform.scale = i % 5 == 4 ? -1.0f : 1.0f;
            actor.play.clip = 0, actor.play.phase_s = 0.01f * float(i);
            clq_actor made;
            ASSERT_EQ(clq_actor_create(crowd_, &actor, &made), CLQ_OK) << clq_last_error();
            actors_.push_back(made);
        }
        const double eye[3] = {0.3, 1.2, 4}, target[3] = {0, 0.6, -4};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera_, eye, target, up, 0.9f, 1.3f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera_), CLQ_OK);
        ASSERT_EQ(clq_scene_create(crowd_, &scene_), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_update(crowd_, 0.4, &view_, 1), CLQ_OK) << clq_last_error();
    }
    void TearDown() override { clq_template_destroy(rigid_); }

    clq_scene_pick pick(const clq_ray &ray, const clq_scene_filter *filter = nullptr)
    {
        clq_scene_pick out = clq_scene_pick_init();
        EXPECT_EQ(clq_scene_pick_triangle(scene_, view_, &ray, filter, &out), CLQ_OK) << clq_last_error();
        return out;
    }

    clq_ray ray_through(uint32_t i)
    {
        clq_ray ray;
        const float x = float(mixed(7, i) % 1000) / 500 - 1, y = float(mixed(8, i) % 1000) / 500 - 1;
        EXPECT_EQ(clq_camera_get_ray(&camera_, 0.9f * x, 0.9f * y, &ray), CLQ_OK) << clq_last_error();
        return ray;
    }

    // How many of a hundred rays met somebody.
    uint32_t compare(uint32_t first)
    {
        const Picture picture(view_, camera_);
        uint32_t met = 0;
        for (uint32_t i = first; i < first + 100; ++i) {
            const clq_ray ray = ray_through(i);
            const Nearest wanted = picture.meet(ray);
            const clq_scene_pick got = pick(ray);
            if (wanted.next - wanted.distance < 1e-5) continue;  // two at one place
            EXPECT_EQ(got.actor.index1, wanted.actor.index1) << "ray " << i;
            if (got.actor.index1 == 0 || wanted.actor.index1 == 0) continue;
            EXPECT_NEAR(got.distance, wanted.distance, 1e-4) << "ray " << i;
            if (!wanted.dirty) {
                EXPECT_EQ(got.zone, wanted.zone) << "ray " << i;
            }
            ++met;
        }
        return met;
    }

    TestWorld world_;
    SmallTemplate rigid_def_;
    float skin_uvs_[2 * 10];
    clq_template *rigid_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    clq_scene *scene_ = nullptr;
    clq_camera camera_;
    std::vector<clq_actor> actors_;
};

TEST_P(Pick, FindsTheTriangleThatIsDrawnFirstAlongTheRay) { EXPECT_GT(compare(0), 20u); }

TEST_P(Pick, FindsWhatIsDrawnWhateverHasChangedSince)
{
    const clq_transform away = {{900, 0, 0}, {0, 0, 0, 1}, 1};
    std::vector<clq_transform> places(actors_.size(), away);
    ASSERT_EQ(clq_crowd_set_transforms(crowd_, actors_.data(), places.data(), uint32_t(places.size())), CLQ_OK);
    EXPECT_GT(compare(100), 20u);
    ASSERT_EQ(clq_scene_update(scene_, 9), CLQ_OK);
    EXPECT_GT(compare(200), 20u);
}

TEST_P(Pick, LeavesOutActorsThatAreGoneOrNotAskedFor)
{
    uint32_t met = 0, met_again = 0;
    for (uint32_t i = 0; i < 300 && met < 20; ++i) {
        const clq_ray ray = ray_through(i);
        const clq_scene_pick first = pick(ray);
        if (first.actor.index1 == 0) continue;
        ++met;
        const uint64_t behind = 2;
        ASSERT_EQ(clq_scene_set_categories(scene_, &first.actor, 1, behind), CLQ_OK);
        clq_scene_filter filter = clq_scene_filter_init();
        filter.none_of = behind;
        const clq_scene_pick second = pick(ray, &filter);
        EXPECT_NE(second.actor.index1, first.actor.index1);
        ASSERT_EQ(clq_actor_destroy(crowd_, first.actor), CLQ_OK);
        const clq_scene_pick next = pick(ray);
        EXPECT_EQ(next.actor.index1, second.actor.index1);
        if (next.actor.index1 == 0) continue;
        ++met_again;
        EXPECT_GE(next.distance, first.distance);
    }
    EXPECT_EQ(met, 20u);
    EXPECT_GT(met_again, 2u);
}

TEST_P(Pick, SaysWhereInTheTriangleThePointIs)
{
    uint32_t met = 0, of_one_zone = 0;
    for (uint32_t i = 0; i < 100; ++i) {
        const clq_scene_pick got = pick(ray_through(i));
        if (got.actor.index1 == 0) continue;
        ++met;
        clq_drawn_actor drawn = clq_drawn_actor_init();
        ASSERT_EQ(clq_view_get_drawn_actor(view_, got.index, &drawn), CLQ_OK);
        EXPECT_EQ(drawn.actor.index1, got.actor.index1);
        EXPECT_TRUE(drawn.parts >> got.part & 1);
        of_one_zone += drawn.tmpl == rigid_;
        std::vector<float> xyz(3 * drawn.vertex_count);
        ASSERT_EQ(clq_view_get_vertices(view_, got.index, xyz.data(), nullptr, drawn.vertex_count), CLQ_OK);
        double eye[3] = {0, 0, 0}, away = 0, weights = 0;
        for (int c = 0; c < 3; ++c) {
            weights += double(got.barycentric[c]);
            for (int r = 0; r < 3; ++r) {
                double at = drawn.model_view[12 + r];
                for (int k = 0; k < 3; ++k)
                    at += double(drawn.model_view[4 * k + r]) * double(xyz[3 * got.vertices[c] + uint32_t(k)]);
                eye[r] += double(got.barycentric[c]) * at;
            }
        }
        for (int k = 0; k < 3; ++k) away += (got.position[k] - camera_.eye[k]) * (got.position[k] - camera_.eye[k]);
        EXPECT_NEAR(std::sqrt(away), std::sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]), 1e-4);
        EXPECT_NEAR(weights, 1, 1e-6);
        // The left half of the strip's texture is cloth, the right half skin; triangles with joints have both.
        clq_mesh mesh = clq_mesh_init();
        ASSERT_EQ(clq_template_get_mesh(drawn.tmpl, drawn.level, &mesh), CLQ_OK);
        float u = 0;
        for (int c = 0; c < 3; ++c) u += got.barycentric[c] * mesh.uvs[2 * got.vertices[c]];
        const char *wanted = u < 0.5f ? "cloth" : "skin";
        EXPECT_EQ(got.zone, clq_template_find_zone(drawn.tmpl, wanted)) << "u is " << u;
    }
    EXPECT_GT(met, 20u);
    EXPECT_GT(of_one_zone, 5u);
}

INSTANTIATE_TEST_SUITE_P(Forms, Pick,
                         testing::Values(Form{"Floats", CLQ_VERTEX_FLOAT, CLQ_RIGID_VERTICES},
                                         Form{"Packed", CLQ_VERTEX_PACKED, CLQ_RIGID_VERTICES},
                                         Form{"Tracked", CLQ_VERTEX_FLOAT, CLQ_RIGID_MATRICES}),
                         [](const auto &info) { return info.param.name; });

}  // namespace

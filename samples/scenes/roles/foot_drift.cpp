// How far feet slide, from the skinned soles of one person on a track.
#include <algorithm>
#include <array>
#include <cmath>

#include "samples/scenes/roles/treadmill.h"

namespace scenes::roles
{
namespace
{

constexpr double contact_m = 0.012, step_s = 0.04;
constexpr float sole_share = 0.6f;  // of a vertex's weights that follow the foot

using Matrix = std::array<double, 12>;  // three axes and a translation

Matrix product(const Matrix &a, const Matrix &b)
{
    Matrix out = {};
    for (size_t column = 0; column < 4; ++column)
        for (size_t row = 0; row < 3; ++row) {
            for (size_t k = 0; k < 3; ++k) out[3 * column + row] += a[3 * k + row] * b[3 * column + k];
            if (column == 3) out[3 * column + row] += a[9 + row];
        }
    return out;
}

// Of a rotation with one scale.
Matrix inverse(const Matrix &m)
{
    const double square = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
    Matrix out = {};
    for (size_t column = 0; column < 3; ++column)
        for (size_t row = 0; row < 3; ++row) out[3 * column + row] = m[3 * row + column] / square;
    for (size_t row = 0; row < 3; ++row)
        for (size_t k = 0; k < 3; ++k) out[9 + row] -= out[3 * k + row] * m[9 + k];
    return out;
}

Matrix of_columns(const double (&m)[16])
{
    return {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10], m[12], m[13], m[14]};
}

double apart(const Matrix &a, const Matrix &b)
{
    double most = 0;
    for (size_t k = 0; k < 12; ++k) most = std::max(most, std::fabs(a[k] - b[k]));
    return most;
}

using Sole = std::vector<std::array<double, 3>>;  // metres in the world

// One person on a track in a crowd of its own, which poses it at the very times.
class Walker
{
public:
    Walker(Library &library, clq_template *tmpl, clq_track *track, float scale) : tmpl_(tmpl), track_(track)
    {
        clq_crowd_def def = clq_crowd_def_init();
        def.period_near_s = def.period_far_s = 0, def.lod_scale = 0, def.cache = CLQ_CACHE_NONE;
        clq_crowd *crowd = nullptr;
        check(clq_crowd_create(library.context(), &def, &crowd));
        crowd_.reset(crowd);
        clq_actor_def actor_def = clq_actor_def_init();
        actor_def.tmpl = tmpl, actor_def.transform.scale = scale;
        check(clq_actor_create(crowd, &actor_def, &actor_));
        check(clq_actor_follow_track(crowd, actor_, track, 0));
        check(clq_view_create(crowd, &view_));
        scale_ = static_cast<double>(scale);
    }

    void find_soles(const clq_locomotion *walk, double from_s)
    {
        clq_locomotion_info info = clq_locomotion_info_init();
        check(clq_locomotion_get_info(walk, &info));
        for (size_t foot = 0; foot < 2; ++foot) {
            std::vector<bool> follows;
            for (const uint32_t node : {info.legs[foot].foot, info.legs[foot].toes})
                if (node != CLQ_NONE) join(follows, node, from_s);
            take_vertices(follows, soles_[foot]);
        }
    }

    const Sole &at(size_t foot, double time_s)
    {
        show(time_s);
        std::vector<float> xyz(3 * static_cast<size_t>(shown_.vertex_count));
        check(clq_view_get_vertices(view_, 0, xyz.data(), nullptr, shown_.vertex_count));
        const double s = std::sin(state_.heading_rad), c = std::cos(state_.heading_rad);
        posed_.clear();
        for (const uint32_t v : soles_[foot]) {
            const double x = scale_ * static_cast<double>(xyz[3 * v]), z = scale_ * static_cast<double>(xyz[3 * v + 2]);
            posed_.push_back({state_.position[0] + x * c + z * s, scale_ * static_cast<double>(xyz[3 * v + 1]),
                              state_.position[2] - x * s + z * c});
        }
        return posed_;
    }

private:
    void show(double time_s)
    {
        check(clq_track_evaluate(track_, time_s, &state_));
        clq_look_at_def look = clq_look_at_def_init();
        for (int k = 0; k < 3; ++k) look.eye[k] = look.target[k] = state_.position[k];
        look.target[1] += scale_, look.eye[1] += scale_, look.eye[2] += 8 * scale_;
        clq_camera camera = {};
        check(clq_camera_look_at(&look, &camera));
        check(clq_view_set_camera(view_, &camera));
        check(clq_crowd_update(crowd_.get(), time_s, &view_, 1));
        check(clq_view_get_drawn_actor(view_, 0, &shown_));
    }

    // The joint's matrix as seen from the node: the same in all poses if the joint follows the node.
    Matrix beside(uint32_t node, size_t joint, double time_s)
    {
        double world[16];
        check(clq_actor_get_node(crowd_.get(), actor_, node, time_s, world));
        const double s = scale_ * std::sin(state_.heading_rad), c = scale_ * std::cos(state_.heading_rad);
        const Matrix placed = {
            c, 0, -s, 0, scale_, 0, s, 0, c, state_.position[0], state_.position[1], state_.position[2]};
        Matrix own = {};
        for (size_t k = 0; k < 12; ++k) own[k] = static_cast<double>(palette_[12 * joint + k]);
        return product(inverse(product(inverse(placed), of_columns(world))), own);
    }

    void join(std::vector<bool> &follows, uint32_t node, double from_s)
    {
        std::vector<Matrix> first, still;
        for (const double t : {from_s, from_s + 0.31, from_s + 0.57}) {
            show(t);
            palette_.resize(12 * static_cast<size_t>(shown_.joint_count));
            check(clq_view_get_palette(view_, 0, palette_.data(), shown_.joint_count));
            if (follows.empty()) follows.assign(shown_.joint_count, false);
            std::vector<Matrix> now;
            for (size_t joint = 0; joint < shown_.joint_count; ++joint) now.push_back(beside(node, joint, t));
            if (first.empty()) first = still = now;
            for (size_t joint = 0; joint < now.size(); ++joint)
                if (apart(first[joint], now[joint]) > 1e-3) still[joint][0] = NAN;
        }
        for (size_t joint = 0; joint < first.size(); ++joint)
            if (!std::isnan(still[joint][0])) follows[joint] = true;
    }

    void take_vertices(const std::vector<bool> &follows, std::vector<uint32_t> &out) const
    {
        clq_mesh mesh = clq_mesh_init();
        check(clq_template_get_mesh(tmpl_, 0, &mesh));
        const uint32_t wide = std::max(1u, mesh.influence_count);
        std::vector<uint16_t> joints(static_cast<size_t>(wide) * mesh.vertex_count);
        std::vector<float> weights(joints.size());
        clq_influences influences = clq_influences_init();
        influences.per_vertex = wide, influences.joints = joints.data(), influences.weights = weights.data();
        influences.capacity = joints.size();
        check(clq_template_get_influences(tmpl_, 0, &influences));
        for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
            float sum = 0;
            for (size_t k = 0; k < wide; ++k)
                if (joints[v * wide + k] < follows.size() && follows[joints[v * wide + k]])
                    sum += weights[v * wide + k];
            if (sum > sole_share) out.push_back(v);
        }
    }

    clq_template *tmpl_;
    clq_track *track_;
    Own<clq_crowd> crowd_;
    clq_view *view_ = nullptr;  // ends with its crowd
    clq_actor actor_ = {};
    double scale_ = 1;
    clq_track_state state_ = {};
    clq_drawn_actor shown_ = clq_drawn_actor_init();
    std::vector<float> palette_;
    std::vector<uint32_t> soles_[2];
    Sole posed_;
};

// The way of the part of a sole that touches the ground, at height 0, in both.
std::array<double, 2> way(const Sole &before, const Sole &now, double contact)
{
    std::array<double, 2> moved = {0, 0};
    int touching = 0;
    for (size_t i = 0; i < before.size(); ++i) {
        if (!(before[i][1] < contact && now[i][1] < contact)) continue;
        moved[0] += now[i][0] - before[i][0], moved[1] += now[i][2] - before[i][2];
        ++touching;
    }
    return {moved[0] / std::max(1, touching), moved[1] / std::max(1, touching)};
}

}  // namespace

FootDrift drift_of(Library &library, clq_template *tmpl, const clq_locomotion *walk, clq_track *track, float scale,
                   double from_s, double to_s)
{
    Walker walker(library, tmpl, track, scale);
    walker.find_soles(walk, from_s);
    FootDrift out;
    for (uint32_t foot = 0; foot < 2; ++foot) {
        size_t count = 0;
        check(clq_track_get_plants(track, foot, from_s, to_s, nullptr, 0, &count));
        std::vector<clq_track_plant> plants(count);
        check(clq_track_get_plants(track, foot, from_s, to_s, plants.data(), count, &count));
        for (const clq_track_plant &plant : plants) {
            double sum[2] = {0, 0}, most = 0;
            Sole before;
            // A person that stands has its feet down all the time.
            const double end_s = std::min(plant.end_s, to_s);
            for (double t = std::max(plant.begin_s, from_s); t <= end_s; t += step_s) {
                const Sole now = walker.at(foot, t);
                const std::array<double, 2> moved = way(before, now, contact_m * static_cast<double>(scale));
                sum[0] += moved[0], sum[1] += moved[1];
                most = std::max(most, std::hypot(sum[0], sum[1]));
                before = now;
            }
            out.mean_mm += 1000 * most;
            out.most_mm = std::max(out.most_mm, 1000 * most);
            ++out.steps;
        }
    }
    if (out.steps > 0) out.mean_mm /= static_cast<double>(out.steps);
    return out;
}

}  // namespace scenes::roles

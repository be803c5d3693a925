#include "figure.h"

#include <cmath>
#include <random>

#include "lib/math/slerp.h"
#include "lib/pose/pose.h"
#include "lib/skin/skin.h"

namespace claque::testing_support
{

namespace
{

class Maker
{
public:
    Maker(const FigureDef &def, model::Template &out) : def_(def), out_(out), random_(def.seed) {}

    void make()
    {
        out_.name = "figure";
        out_.similar_only = def_.shape == Shape::similar;
        nodes();
        clip("walk", keys(34, 1.0f / 30), model::Interpolation::linear);
        clip("sway", {0.1f, 0.15f, 0.6f, 0.7f, 1.9f}, model::Interpolation::cubic_spline);
        clip("pose", {2.0f}, model::Interpolation::linear);
        clip("steps", {0.0f, 0.3f, 0.4f, 1.0f}, model::Interpolation::step);
        zones();
        level(def_.vertices, 0);
        level(def_.vertices / 2 + 1, 20);
        sphere();
    }

private:
    float real(float first, float last) { return std::uniform_real_distribution<float>(first, last)(random_); }
    // Braces fix the order of evaluation: compilers differ in that of a call's arguments.
    glm::vec3 vector(float size) { return glm::vec3{real(-size, size), real(-size, size), real(-size, size)}; }
    glm::quat turn()
    {
        const glm::vec3 v = vector(1);
        return math::unit_quat(1, v.x, v.y, v.z);
    }

    std::vector<float> keys(int count, float step)
    {
        std::vector<float> out;
        for (int i = 0; i < count; ++i) out.push_back(float(i) * step);
        return out;
    }

    void nodes()
    {
        for (uint32_t i = 0; i < def_.nodes; ++i) {
            out_.rig.parents.push_back(i == 0 ? model::none : (i - 1) / 2);
            math::Trs trs;
            trs.translation = vector(0.3f);
            trs.rotation = turn();
            trs.scale = def_.shape == Shape::similar ? glm::vec3(real(0.8f, 1.1f))
                                                     : glm::vec3{real(0.7f, 1.2f), 1, real(0.7f, 1.2f)};
            out_.rig.rest.push_back(trs);
            out_.rig.node_names.emplace_back("node");
            math::Trs bind;
            bind.rotation = turn();
            bind.translation = vector(1);
            out_.rig.palette.push_back({i, math::affine_of(bind)});
        }
        if (!def_.morphs) return;
        out_.rig.morph_sets.push_back({0, 0, 2});
        out_.rig.rest_weights = {0, 0};
    }

    void channel(uint32_t node, model::ChannelTarget path, model::Interpolation how, const std::vector<float> &times)
    {
        const uint16_t n = path == model::ChannelTarget::rotation        ? 4
                           : path == model::ChannelTarget::morph_weights ? 2
                                                                         : 3;
        model::Channel c{node,
                         path,
                         how,
                         n,
                         uint32_t(out_.rig.times.size()),
                         uint32_t(times.size()),
                         uint32_t(out_.rig.values.size())};
        out_.rig.times.insert(out_.rig.times.end(), times.begin(), times.end());
        const float like = path == model::ChannelTarget::scale && def_.shape == Shape::similar ? 0 : 1;
        for (size_t k = 0; k < times.size(); ++k) {
            const glm::quat q = turn();
            const float value[4] = {q.x, q.y, q.z, q.w};
            for (int part = how == model::Interpolation::cubic_spline ? 0 : 1;
                 part < (how == model::Interpolation::cubic_spline ? 3 : 2); ++part)
                for (uint32_t i = 0; i < n; ++i) {
                    const float size = part == 1 ? 1 : 0.5f;
                    float v = size * (path == model::ChannelTarget::rotation && part == 1 ? value[i]
                                                                                          : like * real(-0.4f, 0.4f));
                    if (path == model::ChannelTarget::scale && part == 1) v += 1;
                    out_.rig.values.push_back(v);
                }
        }
        out_.rig.channels.push_back(c);
    }

    void clip(const char *name, const std::vector<float> &times, model::Interpolation how)
    {
        model::Clip clip;
        clip.first_channel = uint32_t(out_.rig.channels.size());
        clip.start_s = times.front();
        clip.duration_s = times.back() - times.front();
        channel(0, model::ChannelTarget::translation, how, times);
        for (uint32_t i = 0; i + 1 < def_.nodes; ++i) channel(i, model::ChannelTarget::rotation, how, times);
        channel(1, model::ChannelTarget::scale, how, times);
        // This channel starts later and ends earlier than its clip.
        if (times.size() > 3)
            channel(2, model::ChannelTarget::translation, how, std::vector<float>(times.begin() + 1, times.end() - 1));
        if (def_.morphs) channel(0, model::ChannelTarget::morph_weights, how, times);
        clip.channel_count = uint32_t(out_.rig.channels.size()) - clip.first_channel;
        out_.rig.clips.push_back(clip);
        out_.rig.clip_names.emplace_back(name);
    }

    void zones()
    {
        for (int i = 0; i < 3; ++i) {
            out_.zone_names.emplace_back("zone");
            out_.zone_colours.push_back({1, 1, 1});
            out_.zone_ranges.push_back({float(120 * i), float(120 * i + 40), 0.5f, 0.9f, 0.5f, 1.0f});
        }
    }

    void level(uint32_t per_run, float switch_distance_m)
    {
        out_.levels.emplace_back(def_.memory);
        model::Level &level = out_.levels.back();
        level.switch_distance_m = switch_distance_m;
        for (uint32_t influences = 1; influences <= 6; ++influences) {
            level.runs.push_back({level.source_count, per_run, influences, uint32_t(level.joints.size())});
            level.source_count += per_run;
            for (uint32_t v = 0; v < per_run; ++v) vertex(level, influences);
        }
        for (uint32_t i = 0; i < 7; ++i) level.copies.push_back((i * 13) % level.source_count);
        level.vertex_count = level.source_count + 7;
        if (def_.morphs)
            for (uint32_t weight = 0; weight < 2; ++weight) morph(level, weight);
    }

    void vertex(model::Level &level, uint32_t influences)
    {
        for (int i = 0; i < 3; ++i) level.positions.push_back(real(-1, 1));
        const glm::vec3 n = turn() * glm::vec3(0, 0, 1);
        level.normals.insert(level.normals.end(), {n.x, n.y, n.z});
        std::vector<float> w;
        float sum = 0;
        for (uint32_t i = 0; i < influences; ++i) sum += (w.push_back(real(0.1f, 1)), w.back());
        for (uint32_t i = 0; i < influences; ++i) {
            level.weights.push_back(w[i] / sum);
            level.joints.push_back(uint16_t(random_() % def_.nodes));
        }
    }

    void morph(model::Level &level, uint32_t weight)
    {
        model::MorphRange range{weight, uint32_t(level.morph_deltas.size()), 0};
        for (uint32_t v = weight; v < level.source_count; v += 3, ++range.count)
            level.morph_deltas.push_back({v, {real(-1, 1), 0, 0.1f}, {0, real(-1, 1), 0}});
        level.morph_ranges.push_back(range);
    }

    // Bounds every vertex of many poses, with a margin for the poses between them.
    void sphere()
    {
        pose::Workspace workspace(out_.rig);
        float square = 0;
        for (const model::Level &level : out_.levels) {
            square = std::max(square, farthest(level, workspace, model::none, 0));
            for (uint32_t c = 0; c < out_.rig.clips.size(); ++c)
                for (int k = 0; k <= 100; ++k) {
                    const model::Clip &clip = out_.rig.clips[c];
                    square = std::max(square, farthest(level, workspace, c, clip.start_s + clip.duration_s * k / 100));
                }
        }
        out_.sklsroot = {glm::vec3(0), 1.1f * std::sqrt(square)};
    }

    static float farthest(const model::Level &level, pose::Workspace &workspace, uint32_t clip, double time_s)
    {
        std::vector<float> positions(3 * level.vertex_count), normals(positions.size());
        skin::SkinJob job;
        job.level = &level;
        job.palette = workspace.pose(clip, time_s);
        job.morph_weights = workspace.weights();
        std::vector<float> scratch(skin::scratch_floats(level, job.palette.count, job.normals));
        job.scratch = base::Span<float>(scratch);
        job.out_positions = base::Span<float>(positions);
        job.out_normals = base::Span<float>(normals);
        job.run();
        float square = 0;
        for (uint32_t v = 0; v < level.vertex_count; ++v) {
            const float *p = positions.data() + 3 * v;
            square = std::max(square, p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        }
        return square;
    }

    const FigureDef &def_;
    model::Template &out_;
    std::mt19937 random_;
};

}  // namespace

std::unique_ptr<model::Template> make_figure(const FigureDef &def)
{
    auto out = std::make_unique<model::Template>(def.memory);
    Maker(def, *out).make();
    model::check(out->rig);
    return out;
}

}  // namespace claque::testing_support

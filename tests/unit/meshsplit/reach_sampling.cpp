#include "reach_sampling.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "lib/base/hash.h"
#include "lib/pose/pose.h"

namespace claque::test
{

namespace
{

float sampling_random(uint64_t seed, uint64_t i) { return base::unit(base::hash(seed, i, base::Purpose::pick, 77)); }

class Sampler
{
public:
    Sampler(const model::Template &tmpl, const glm::dvec3 &centre)
        : tmpl_(tmpl),
          centre_(centre),
          dofs_(tmpl.rig.dofs.size()),
          locals_(tmpl.rig.node_count()),
          globals_(tmpl.rig.node_count()),
          palette_(tmpl.rig.palette.size() + 1),
          weights_(tmpl.rig.rest_weights.size()),
          scratch_(pose::scratch_floats(tmpl.rig)),
          masks_(pose::max_layers, std::vector<float>(tmpl.rig.node_count()))
    {
        out_.node.resize(tmpl.rig.node_count());
        out_.stretch.resize(tmpl.rig.node_count());
        for (const model::Level &level : tmpl.levels) balls_.push_back(balls_of(level, palette_.size()));
    }

    void take(uint64_t sample)
    {
        const model::Rig &rig = tmpl_.rig;
        pose::PoseJob job = job_of(sample);
        const uint32_t which = uint32_t(sampling_random(sample, 1000) * float(rig.clips.size() + 1));
        if (which < rig.clips.size()) {
            job.clip = which;
            job.time_s =
                double(rig.clips[which].start_s) + double(rig.clips[which].duration_s * sampling_random(sample, 1001));
        }
        look(job);
    }

    void take_blend(uint64_t sample, float added)
    {
        std::vector<pose::Layer> layers(1 + uint32_t(sampling_random(sample, 2000) * float(pose::max_layers)));
        float left = added;
        for (uint32_t i = 0; i < layers.size(); ++i) {
            const uint64_t first = 2100 + 100 * i;
            pose::Layer &layer = layers[i];
            any_moment(sample, first, layer.clip, layer.time_s);
            // 0, 1 and values between, each often.
            layer.weight = i == 0 ? 1 : std::clamp(2 * sampling_random(sample, first + 2) - 0.5f, 0.0f, 1.0f);
            if (i > 0 && sampling_random(sample, first + 3) < 0.6f && left > 0) {
                layer.kind = pose::LayerKind::add;
                const float weight =
                    std::min(left, added * std::clamp(2 * sampling_random(sample, first + 4), 0.0f, 1.0f));
                left -= weight;
                layer.weight = sampling_random(sample, first + 5) < 0.5f ? weight : -weight;
                any_moment(sample, first + 6, layer.reference_clip, layer.reference_time_s);
            }
            if (i == 0 || sampling_random(sample, first + 8) < 0.3f) continue;
            for (size_t n = 0; n < masks_[i].size(); ++n)
                masks_[i][n] = std::clamp(3 * sampling_random(sample, first + 20 + n % 80) - 1, 0.0f, 1.0f);
            layer.mask = masks_[i].data();
        }
        pose::PoseJob job = job_of(sample);
        job.layers = {layers.data(), uint32_t(layers.size())};
        job.scratch = base::Span<float>(scratch_);
        look(job);
    }

    void take_layers(base::Span<const pose::Layer> layers)
    {
        pose::PoseJob job = job_of(0);
        job.dofs = nullptr;
        job.layers = layers;
        job.scratch = base::Span<float>(scratch_);
        look(job);
    }

    Sampled out_;

private:
    // Often its start, its end, and the middle.
    void any_moment(uint64_t sample, uint64_t first, uint32_t &clip, double &time_s) const
    {
        const model::Rig &rig = tmpl_.rig;
        const uint32_t which = uint32_t(sampling_random(sample, first) * float(rig.clips.size() + 1));
        clip = which < rig.clips.size() ? which : model::none;
        if (clip == model::none) return;
        const float share = std::clamp(1.2f * sampling_random(sample, first + 1) - 0.1f, 0.0f, 1.0f);
        time_s = double(rig.clips[clip].start_s) + double(rig.clips[clip].duration_s * share);
    }

    pose::PoseJob job_of(uint64_t sample)
    {
        const model::Rig &rig = tmpl_.rig;
        for (size_t d = 0; d < dofs_.size(); ++d) {
            const float f = std::clamp(2 * sampling_random(sample, d) - 0.5f, 0.0f, 1.0f);
            dofs_[d] = f < 1 ? rig.dofs[d].min + f * (rig.dofs[d].max - rig.dofs[d].min) : rig.dofs[d].max;
        }
        pose::PoseJob job;
        job.rig = &rig;
        job.dofs = dofs_.data();
        job.locals = base::Span<math::Trs>(locals_);
        job.globals = base::Span<math::Columns>(globals_);
        job.palette = base::Span<math::Affine>(palette_);
        job.weights = base::Span<float>(weights_);
        return job;
    }

    void look(const pose::PoseJob &job)
    {
        job.run();
        for (const model::Level &level : tmpl_.levels) look_at(level);
        look_at_nodes();
    }

    // Round the vertices in each octant of those that an entry of the palette moves, without morph targets.
    struct Ball {
        glm::dvec3 centre = glm::dvec3(0);
        double radius = -1;
    };
    struct Balls {
        std::vector<Ball> balls;          // eight an entry
        std::vector<uint32_t> influence;  // the ball of each
    };
    static Balls balls_of(const model::Level &level, size_t entries)
    {
        Balls out;
        out.balls.resize(8 * entries);
        out.influence.resize(level.joints.size());
        const auto each = [&level](const auto &visit) {
            for (const model::InfluenceRun &run : level.runs)
                for (uint32_t i = 0; i < run.count * run.influences; ++i) {
                    const float *p = &level.positions[3 * size_t(run.first + i / run.influences)];
                    visit(run.first_influence + i, glm::dvec3(p[0], p[1], p[2]));
                }
        };
        std::vector<glm::dvec3> sums(8 * entries);
        std::vector<double> counts(8 * entries);
        const auto average = [&](size_t k) { return sums[k] / std::max(counts[k], 1.0); };
        each([&](uint32_t i, glm::dvec3 p) { sums[level.joints[i]] += p, ++counts[level.joints[i]]; });
        std::vector<glm::dvec3> middles;
        for (size_t j = 0; j < entries; ++j) middles.push_back(average(j));
        std::fill(sums.begin(), sums.end(), glm::dvec3(0)), std::fill(counts.begin(), counts.end(), 0);
        each([&](uint32_t i, glm::dvec3 p) {
            const glm::dvec3 d = p - middles[level.joints[i]];
            const uint32_t k = 8u * level.joints[i] + (d.x > 0) + 2u * (d.y > 0) + 4u * (d.z > 0);
            out.influence[i] = k;
            sums[k] += p, ++counts[k];
        });
        for (size_t k = 0; k < 8 * entries; ++k) out.balls[k].centre = average(k);
        each([&](uint32_t i, glm::dvec3 p) {
            Ball &ball = out.balls[out.influence[i]];
            ball.radius = std::max(ball.radius, glm::distance(p, ball.centre));
        });
        return out;
    }

    // Per ball: whether its entry may take a vertex farther than any was. Blended vertices lie between where their
    // entries take them.
    bool may_be_farther(const std::vector<Ball> &balls)
    {
        far_.assign(balls.size(), 0);
        bool any = false;
        for (size_t k = 0; k < balls.size(); ++k) {
            if (balls[k].radius < 0) continue;
            const math::Affine &m = palette_[k / 8];
            double stretch = 0;
            for (int c = 0; c < 3; ++c) stretch += double(glm::dot(m.column(c), m.column(c)));
            const glm::dvec3 at(math::transform_point(m, glm::vec3(balls[k].centre)));
            const double reach = glm::distance(at, centre_) + std::sqrt(stretch) * balls[k].radius;
            far_[k] = reach * (1 + 1e-5) > out_.vertex;
            any = any || far_[k];
        }
        return any;
    }

    void look_at(const model::Level &level)
    {
        const size_t index = size_t(&level - tmpl_.levels.data());
        const bool morphs = !level.morph_ranges.empty();
        if (!morphs && !may_be_farther(balls_[index].balls)) return;
        bind_.assign(level.positions.begin(), level.positions.end());
        for (const model::MorphRange &range : level.morph_ranges)
            for (uint32_t i = range.first; i < range.first + range.count; ++i)
                for (uint32_t k = 0; k < 3; ++k)
                    bind_[3 * level.morph_deltas[i].vertex + k] +=
                        weights_[range.weight] * level.morph_deltas[i].position[k];
        for (const model::InfluenceRun &run : level.runs)
            for (uint32_t v = 0; v < run.count; ++v) {
                const uint32_t *ball = &balls_[index].influence[run.first_influence + v * run.influences];
                if (!morphs && std::none_of(ball, ball + run.influences, [this](uint32_t k) { return far_[k]; }))
                    continue;
                const float *p = &bind_[3 * (run.first + v)];
                glm::dvec3 at(0);
                for (uint32_t i = 0; i < run.influences; ++i) {
                    const uint32_t k = run.first_influence + v * run.influences + i;
                    at += double(level.weights[k]) *
                          glm::dvec3(math::transform_point(palette_[level.joints[k]], {p[0], p[1], p[2]}));
                }
                out_.vertex = std::max(out_.vertex, glm::distance(at, centre_));
            }
    }

    void look_at_nodes()
    {
        for (size_t n = 0; n < globals_.size(); ++n) {
            float c[4][4];
            for (int k = 0; k < 4; ++k) math::store4(c[k], globals_[n].c[k]);
            const auto column = [&](int k) { return glm::dvec3(c[k][0], c[k][1], c[k][2]); };
            out_.node[n] = std::max(out_.node[n], glm::distance(column(3), centre_));
            for (int k = 0; k < 3; ++k) out_.stretch[n] = std::max(out_.stretch[n], glm::length(column(k)));
        }
    }

    const model::Template &tmpl_;
    const glm::dvec3 centre_;
    std::vector<float> dofs_, bind_;
    std::vector<math::Trs> locals_;
    std::vector<math::Columns> globals_;
    std::vector<math::Affine> palette_;
    std::vector<float> weights_, scratch_;
    std::vector<std::vector<float>> masks_;
    std::vector<Balls> balls_;  // per level
    std::vector<uint8_t> far_;
};

}  // namespace

Sampled sample_reach(const model::Template &tmpl, const glm::dvec3 &centre, uint32_t count)
{
    Sampler sampler(tmpl, centre);
    for (uint64_t sample = 0; sample < count; ++sample) sampler.take(sample);
    return sampler.out_;
}

Sampled sample_blends(const model::Template &tmpl, const glm::dvec3 &centre, uint32_t count, float added)
{
    Sampler sampler(tmpl, centre);
    for (uint64_t sample = 0; sample < count; ++sample) sampler.take_blend(sample, added);
    return sampler.out_;
}

Sampled sample_layers(const model::Template &tmpl, const glm::dvec3 &centre, base::Span<const pose::Layer> layers)
{
    Sampler sampler(tmpl, centre);
    sampler.take_layers(layers);
    return sampler.out_;
}

}  // namespace claque::test

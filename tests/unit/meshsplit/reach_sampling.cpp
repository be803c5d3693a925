#include "reach_sampling.h"

#include "lib/base/hash.h"
#include "lib/pose/pose.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace claque::test
{

namespace
{

float lot(uint64_t seed, uint64_t i) { return base::unit(base::hash(seed, i, base::Purpose::pick, 77)); }

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
          weights_(tmpl.rig.rest_weights.size())
    {
        out_.node.resize(tmpl.rig.node_count());
        out_.stretch.resize(tmpl.rig.node_count());
    }

    void take(uint64_t sample)
    {
        const model::Rig &rig = tmpl_.rig;
        for (size_t d = 0; d < dofs_.size(); ++d) {
            const float f = std::clamp(2 * lot(sample, d) - 0.5f, 0.0f, 1.0f);
            dofs_[d] = f < 1 ? rig.dofs[d].first + f * (rig.dofs[d].last - rig.dofs[d].first) : rig.dofs[d].last;
        }
        pose::PoseJob job;
        job.rig = &rig;
        job.dofs = dofs_.data();
        job.locals = base::Span<math::Trs>(locals_);
        job.globals = base::Span<math::Columns>(globals_);
        job.palette = base::Span<math::Affine>(palette_);
        job.weights = base::Span<float>(weights_);
        const uint32_t which = uint32_t(lot(sample, 1000) * float(rig.clips.size() + 1));
        if (which < rig.clips.size()) {
            job.clip = which;
            job.time_s = double(rig.clips[which].start_s) + double(rig.clips[which].duration_s * lot(sample, 1001));
        }
        job.run();
        for (const model::Level &level : tmpl_.levels) look_at(level);
        look_at_nodes();
    }

    Sampled out_;

private:
    void look_at(const model::Level &level)
    {
        bind_.assign(level.positions.begin(), level.positions.end());
        for (const model::MorphRange &range : level.morph_ranges)
            for (uint32_t i = range.first; i < range.first + range.count; ++i)
                for (uint32_t k = 0; k < 3; ++k)
                    bind_[3 * level.morph_deltas[i].vertex + k] +=
                        weights_[range.weight] * level.morph_deltas[i].position[k];
        for (const model::InfluenceRun &run : level.runs)
            for (uint32_t v = 0; v < run.count; ++v) {
                const float *p = &bind_[3 * (run.first + v)];
                glm::dvec3 at(0);
                for (uint32_t i = 0; i < run.influences; ++i) {
                    const uint32_t k = run.first_influence + v * run.influences + i;
                    at += double(level.weights[k]) *
                          glm::dvec3(math::point(palette_[level.joints[k]], {p[0], p[1], p[2]}));
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
    std::vector<float> weights_;
};

}  // namespace

Sampled sample_reach(const model::Template &tmpl, const glm::dvec3 &centre, uint32_t count)
{
    Sampler sampler(tmpl, centre);
    for (uint64_t sample = 0; sample < count; ++sample) sampler.take(sample);
    return sampler.out_;
}

}  // namespace claque::test

#include "meshsplit/vertex_cloud.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace claque::meshsplit
{

VertexCloud::VertexCloud(const model::Level &level, const model::Rig &rig, const uint8_t *left_out) : level_(&level)
{
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t v = 0; v < run.count; ++v) first_.push_back(run.first_influence + v * run.influences);
    first_.push_back(static_cast<uint32_t>(level.joints.size()));
    sort_by_joint(rig.palette.size(), left_out);
    sort_morphs();
    bound(rig.palette.size());
}

void VertexCloud::sort_by_joint(size_t joint_count, const uint8_t *left_out)
{
    const auto each = [&](const auto &body) {
        for (uint32_t v = 0; v < level_->source_count; ++v)
            if (!left_out || !left_out[v])
                for (const uint16_t joint : joints(v)) body(v, joint);
    };
    starts_.assign(joint_count + 1, 0);
    each([&](uint32_t, uint16_t joint) { ++starts_[size_t(joint) + 1]; });
    for (size_t j = 0; j < joint_count; ++j) starts_[j + 1] += starts_[j];
    std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
    by_joint_.resize(starts_.back());
    each([&](uint32_t v, uint16_t joint) { by_joint_[next[joint]++] = v; });
}

void VertexCloud::sort_morphs()
{
    if (level_->morph_deltas.empty()) return;
    first_delta_.assign(size_t(level_->source_count) + 1, 0);
    for (const model::MorphDelta &delta : level_->morph_deltas) ++first_delta_[delta.vertex + 1];
    for (size_t v = 0; v < level_->source_count; ++v) first_delta_[v + 1] += first_delta_[v];
    std::vector<uint32_t> next(first_delta_.begin(), first_delta_.end() - 1);
    deltas_.resize(level_->morph_deltas.size());
    for (const model::MorphRange &range : level_->morph_ranges) {
        double longest = 0;
        for (uint32_t i = range.first; i < range.first + range.count; ++i) {
            const model::MorphDelta &delta = level_->morph_deltas[i];
            const glm::vec3 p(delta.position[0], delta.position[1], delta.position[2]);
            deltas_[next[delta.vertex]++] = {range.weight, p};
            longest = std::max(longest, double(glm::length(p)));
        }
        longest_delta_.push_back(longest);
    }
}

glm::vec3 VertexCloud::position(uint32_t vertex) const
{
    const float *p = level_->positions.data() + 3 * size_t(vertex);
    return glm::vec3(p[0], p[1], p[2]);
}

void VertexCloud::bound(size_t joint_count)
{
    spheres_.resize(joint_count);
    std::vector<uint8_t> stands_out(level_->source_count);
    for (uint32_t j = 0; j < joint_count; ++j) {
        if (!has(j)) continue;
        glm::vec3 low = position(vertices(j)[0]), high = low;
        for (const uint32_t v : vertices(j)) low = glm::min(low, position(v)), high = glm::max(high, position(v));
        spheres_[j].centre = 0.5f * (low + high);
        float radius = 0;
        for (const uint32_t v : vertices(j)) radius = std::max(radius, glm::distance(position(v), spheres_[j].centre));
        spheres_[j].radius = radius * 1.00001f;
        for (int d = 0; d < 27; ++d) {
            const glm::vec3 axis(float(d % 3 - 1), float(d / 3 % 3 - 1), float(d / 9 - 1));
            uint32_t best = vertices(j)[0];
            for (const uint32_t v : vertices(j))
                if (glm::dot(position(v), axis) > glm::dot(position(best), axis)) best = v;
            stands_out[best] = 1;
        }
    }
    for (uint32_t v = 0; v < level_->source_count; ++v)
        if (stands_out[v]) outer_.push_back(v);
}

glm::vec3 VertexCloud::skinned(uint32_t vertex, const math::Affine *palette, const float *morph_weights) const
{
    glm::vec3 bind = position(vertex), out(0);
    if (!first_delta_.empty())
        for (uint32_t d = first_delta_[vertex]; d < first_delta_[vertex + 1]; ++d)
            bind += morph_weights[deltas_[d].weight] * deltas_[d].position;
    for (uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i)
        out += level_->weights[i] * math::transform_point(palette[level_->joints[i]], bind);
    return out;
}

double VertexCloud::max_morph_offset(const float *morph_weights) const
{
    double sum = 0;
    for (size_t r = 0; r < longest_delta_.size(); ++r)
        sum += std::fabs(double(morph_weights[level_->morph_ranges[r].weight])) * longest_delta_[r];
    return sum;
}

}  // namespace claque::meshsplit

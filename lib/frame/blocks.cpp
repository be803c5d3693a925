#include "lib/frame/blocks.h"

#include <algorithm>
#include <cmath>

namespace claque::frame
{

model::Sphere sphere_of(const crowd::Crowd &crowd, const uint32_t *rows, uint32_t count)
{
    if (count == 0) return model::Sphere();
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 &p = crowd.transform_of(rows[i]).position;
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    model::Sphere sphere;
    sphere.centre = glm::vec3((low + high) * 0.5);
    const glm::dvec3 centre(sphere.centre);
    double radius = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const crowd::Transform &transform = crowd.transform_of(rows[i]);
        const glm::dvec3 d = transform.position - centre;
        const double own = std::fabs(static_cast<double>(transform.scale)) * double(crowd.extent_of(rows[i]).refpoint);
        radius = std::max(radius, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) + own);
    }
    sphere.radius = static_cast<float>(radius * (1 + 1e-6));
    return sphere;
}

void Blocks::arrange(const crowd::Crowd &crowd)
{
    structure_ = 0;
    rows_.resize(crowd.row_capacity());
    at_.assign(crowd.group_count() + 1, 0);
    blocks_.reserve(crowd.group_count() + 1);
    blocks_.clear();
    // at_[0] counts actors without a group, at_[g + 1] those of group g; the prefix sum turns counts into start
    // indices.
    const auto slot = [&](uint32_t row) { return crowd.group_of(row) == model::none ? 0 : crowd.group_of(row) + 1; };
    for (uint32_t row = 0; row < crowd.row_count(); ++row)
        if (crowd.alive(row)) ++at_[slot(row)];
    uint32_t first = 0;
    for (uint32_t g = 0; g < at_.size(); ++g) {
        Block block;
        block.group = g == 0 ? model::none : g - 1;
        block.first = first;
        block.count = at_[g];
        if (block.count) blocks_.push_back(block);
        at_[g] = first;
        first += block.count;
    }
    for (uint32_t row = 0; row < crowd.row_count(); ++row)
        if (crowd.alive(row)) rows_[at_[slot(row)]++] = row;
    structure_ = crowd.structure_version();
}

void Blocks::follow(const crowd::Crowd &crowd)
{
    if (structure_ != crowd.structure_version()) arrange(crowd);
    for (Block &block : blocks_) {
        if (block.group == model::none || block.version == crowd.group(block.group).version) continue;
        block.sphere = sphere_of(crowd, rows_.data() + block.first, block.count);
        block.version = crowd.group(block.group).version;
    }
}

}  // namespace claque::frame

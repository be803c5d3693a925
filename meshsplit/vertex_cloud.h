// The vertices of a level sorted by the palette entries that move them, for the search of the Sklsroot Bsphere.
#pragma once

#include "lib/base/span.h"
#include "lib/model/template.h"

namespace claque::meshsplit
{

class VertexCloud
{
public:
    // `left_out`: per source vertex, 1 for those to exclude from entries; or null.
    VertexCloud(const model::Level &level, const model::Rig &rig, const uint8_t *left_out = nullptr);

    bool has(uint32_t joint) const { return starts_[joint + 1] > starts_[joint]; }
    // All vertices with an influence of this entry.
    base::Span<const uint32_t> vertices(uint32_t joint) const
    {
        return {by_joint_.data() + starts_[joint], starts_[joint + 1] - starts_[joint]};
    }
    // A sphere round the bind positions of those vertices.
    const model::Sphere &sphere(uint32_t joint) const { return spheres_[joint]; }
    // The vertices of each entry that are extreme in some direction.
    const std::vector<uint32_t> &outer() const { return outer_; }

    base::Span<const uint16_t> joints(uint32_t vertex) const
    {
        return {level_->joints.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
    }
    glm::vec3 skinned(uint32_t vertex, const math::Affine *palette, const float *morph_weights) const;
    // Returns a bound of the displacement of vertices by morph targets with these weights.
    double max_morph_offset(const float *morph_weights) const;

private:
    struct Delta {
        uint32_t weight;
        glm::vec3 position;
    };
    void sort_by_joint(size_t joint_count, const uint8_t *left_out);
    void sort_morphs();
    void bound(size_t joint_count);
    glm::vec3 position(uint32_t vertex) const;

    const model::Level *level_;
    std::vector<uint32_t> first_;  // [vertices + 1] offsets into level.joints
    std::vector<uint32_t> starts_, by_joint_;
    std::vector<model::Sphere> spheres_;
    std::vector<uint32_t> outer_;
    std::vector<uint32_t> first_delta_;  // [vertices + 1], or empty without morph targets
    std::vector<Delta> deltas_;
    std::vector<double> longest_delta_;  // per morph range
};

}  // namespace claque::meshsplit

// Places on a character's surface, and where they are in a pose. Between the files of this room only.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "lib/base/span.h"
#include "lib/model/model.h"

namespace claque::lod
{

// Vertices of several parts in one pose of the rig, numbered through all parts.
class PosedParts
{
public:
    explicit PosedParts(std::vector<const model::Part *> parts);
    // palette and weights as pose::Workspace gives them.
    void pose(const model::Rig &rig, base::Span<const math::Affine> palette, base::Span<const float> weights);

    struct Triangle {
        uint32_t part = 0;
        std::array<uint32_t, 3> vertices{};  // of the part
    };
    const std::vector<Triangle> &triangles() const { return triangles_; }
    const model::Part &part(uint32_t index) const { return *parts_[index]; }
    uint32_t part_count() const { return static_cast<uint32_t>(parts_.size()); }
    glm::dvec3 corner(const Triangle &t, size_t k) const { return positions_[first_[t.part] + t.vertices[k]]; }
    std::array<glm::dvec3, 3> corners(const Triangle &t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }

private:
    std::vector<const model::Part *> parts_;
    std::vector<uint32_t> first_;
    std::vector<Triangle> triangles_;
    std::vector<glm::dvec3> positions_;
};

// A place: so much of each corner of a triangle.
struct Place {
    uint32_t triangle = 0;
    glm::dvec3 weights = glm::dvec3(0);
};

glm::dvec3 where(const PosedParts &parts, const Place &place);

// The zone that a place shows: its material's, or that of the texel's key; model::none where there is none.
uint32_t zone_at(const model::Model &model, const PosedParts &parts, const Place &place);

}  // namespace claque::lod

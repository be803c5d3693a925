// The filled cells of a grid round a character: those that its triangles pass through and those that they enclose.
// Internal to lib/lod/proxies.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace claque::lod
{

class Voxels
{
public:
    using Triangle = std::array<glm::dvec3, 3>;

    // `cells` along the longest side of the triangles' box, with an empty border. At least one triangle.
    Voxels(const std::vector<Triangle> &triangles, uint32_t cells);

    // Fills enclosed cells: those from which five of the six axis directions meet a triangle, so that an open hem or
    // sleeve counts as closed.
    void fill();

    bool filled(uint32_t x, uint32_t y, uint32_t z) const { return cells_[index(x, y, z)] != 0; }
    glm::uvec3 size() const { return size_; }
    double cell() const { return cell_; }
    glm::dvec3 middle(uint32_t x, uint32_t y, uint32_t z) const
    {
        return origin_ + cell_ * (glm::dvec3(x, y, z) + 0.5);
    }

private:
    size_t index(uint32_t x, uint32_t y, uint32_t z) const { return (size_t(z) * size_.y + y) * size_.x + x; }
    void add(const Triangle &t);

    glm::dvec3 origin_ = glm::dvec3(0);
    glm::uvec3 size_ = glm::uvec3(0);
    double cell_ = 0;
    std::vector<uint8_t> cells_;
};

}  // namespace claque::lod

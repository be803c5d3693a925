// Directions spread evenly over the sphere, for support functions of convex sets: h(u) = how far the set extends along
// u. Values of h at these directions bound it in any other: h(v) <= sum of weight * h(u) for every v = sum of weight *
// u with non-negative weights, because h is subadditive and positively homogeneous.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace claque::meshsplit
{

// Three neighbouring directions and the non-negative weights that combine them into a vector.
struct DirectionBlend {
    std::array<uint16_t, 3> at;
    std::array<float, 3> weight;

    double of(const double *h) const
    {
        return double(weight[0]) * h[at[0]] + double(weight[1]) * h[at[1]] + double(weight[2]) * h[at[2]];
    }
};

// The corners of an icosahedron whose triangles were split in four `splits` times: 10 * 4^splits + 2.
class Directions
{
public:
    explicit Directions(int splits);

    size_t count() const { return units_.size(); }
    const glm::dvec3 &operator[](size_t i) const { return units_[i]; }
    DirectionBlend find(const glm::dvec3 &v) const;

    // The largest sum of the weights of a unit vector. A unit vector e between three directions lies on the plane n.x =
    // d through them after division by the sum of its weights; so the sum is n.e / d <= 1 / d.
    double max_weight() const { return max_weight_; }

private:
    struct Face {
        std::array<uint16_t, 3> corners;
        std::array<uint16_t, 3> across;  // the face across the edge opposite to each corner
        glm::dmat3 weights;              // times v: the weights of v
    };
    using Corners = std::vector<std::array<uint16_t, 3>>;

    Corners icosahedron();
    Corners split(const Corners &faces);
    void connect(const Corners &faces);
    void fill_cells();
    uint16_t walk(uint16_t face, const glm::dvec3 &v) const;

    std::vector<glm::dvec3> units_;
    std::vector<Face> faces_;
    std::vector<uint16_t> cells_;  // cube map: a face near each cell
    double max_weight_ = 1;
};

}  // namespace claque::meshsplit

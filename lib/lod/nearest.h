// The nearest point of a set of triangles, and what is in the way of a ray, by a tree of boxes.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace claque::lod
{

class NearestPoint
{
public:
    using Triangle = std::array<glm::dvec3, 3>;
    explicit NearestPoint(std::vector<Triangle> triangles);  // at least one

    struct Found {
        uint32_t triangle = 0;
        glm::dvec3 weights = glm::dvec3(0);  // of its corners: not below 0, their sum 1
        double distance_squared = 0;
    };
    // Of several that are as near, any; always the same.
    Found to(glm::dvec3 p) const;

    // Whether something lies further than `after` along a unit direction.
    bool meets(glm::dvec3 from, glm::dvec3 along, double after) const;

private:
    struct Box {
        glm::dvec3 first, last;
        uint32_t begin = 0, end = 0;  // of order_
        uint32_t left = 0;            // children left and left + 1; 0: a leaf
    };
    void divide(uint32_t box);

    std::vector<Triangle> triangles_;
    std::vector<uint32_t> order_;
    std::vector<Box> boxes_;
};

// Weights of the corners of t at its point nearest to p.
glm::dvec3 nearest_on(const NearestPoint::Triangle &t, glm::dvec3 p);

inline glm::dvec3 point_on(const NearestPoint::Triangle &t, glm::dvec3 weights)
{
    return weights.x * t[0] + weights.y * t[1] + weights.z * t[2];
}

}  // namespace claque::lod

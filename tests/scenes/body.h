// A built-in character as a body in the world: its vertices, and capsules in its limbs.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lib/figures/figure.h"
#include "lib/pose/pose.h"
#include "samples/scenes/check.h"

namespace bodies
{

struct Capsule {
    glm::dvec3 from, to;
    double radius;
    const char *name;
};

// How deep the vertex `p` lies inside; negative outside.
double depth(const Capsule &capsule, const glm::dvec3 &p);

class Body
{
public:
    explicit Body(const std::string &figure);

    uint32_t clip(const std::string &name) const;
    double duration_s(uint32_t clip) const;
    void pose(uint32_t clip, double time_s);

    // In model space, of the last pose.
    const std::vector<glm::dvec3> &vertices() const { return vertices_; }
    std::vector<Capsule> capsules() const;
    glm::dvec3 hips() const;  // between the joints of the thighs

private:
    glm::dvec3 joint(const char *name) const;

    claque::model::Model model_;
    claque::pose::Workspace workspace_;
    scenes::Own<clq_context> context_;
    scenes::Own<clq_asset> asset_;
    std::vector<float> xyz_;
    std::vector<glm::dvec3> vertices_;
};

// From model space to the world.
glm::dvec3 placed(const clq_transform &place, const glm::dvec3 &p);

}  // namespace bodies

// Ambient occlusion of a figure: short rays against the figure itself in a uniform grid.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "lib/figures/mesh.h"

namespace claque::figures
{

class AmbientOcclusion
{
public:
    explicit AmbientOcclusion(const Mesh &mesh);

    // 1 if nothing is near in the hemisphere of the normal, towards 0 if everything is.
    float ambient_visibility(glm::vec3 position, glm::vec3 normal) const;

private:
    struct Triangle {
        glm::vec3 a, ab, ac;
    };
    bool blocked(glm::vec3 from, glm::vec3 direction, float reach) const;
    glm::ivec3 cell_of(glm::vec3 p) const;
    const std::vector<uint32_t> &cell(glm::ivec3 c) const;

    std::vector<Triangle> triangles_;
    glm::vec3 low_ = glm::vec3(0);
    glm::ivec3 cells_ = glm::ivec3(1);
    std::vector<std::vector<uint32_t>> grid_;
};

}  // namespace claque::figures

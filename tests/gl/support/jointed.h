// A character of rigid boxes on a tree of nodes, in a pose: made by hand, independently of meshsplit and lib/pose.
#pragma once

#include "tests/gl/support/pictures.h"

namespace gltest
{

struct Joint {
    uint32_t parent = model::none;
    glm::vec3 offset = glm::vec3(0);  // of the node from its parent
    float turn_rad = 0;               // in the pose, about `axis`
    glm::vec3 axis = glm::vec3(0, 0, 1);
    glm::vec3 box = glm::vec3(0);  // half edges; zero: the node has no part
};

struct Jointed {
    PosedModel posed;                           // vertices in the pose, as the processor transforms them
    std::vector<claque::math::Affine> locals;   // in the pose, one per node
    std::vector<claque::math::Affine> globals;  // likewise, to model space
    std::vector<claque::math::Affine> palette;  // likewise, one per part
    std::vector<uint32_t> parts;                // the node of each
};

// `map` covers each of a box's six sides. Boxes alternate between two surfaces. If `bind_offset` is not 0, the
// template's vertices lie that far from their nodes, and the inverse bind matrices move them back.
Jointed make_jointed(const std::vector<Joint> &joints, const ZoneMap &map, float bind_offset = 0);

// Thirteen nodes, two of them without a box; all boxes are visible from the front.
std::vector<Joint> puppet();

// One box on each of `count` nodes in a chain.
std::vector<Joint> rope(uint32_t count);

// Draws all parts by GL's matrix stack.
claque::draw::DrawList by_matrices(const Jointed &jointed, const Camera &camera, const uint8_t *zone_rgb = nullptr);

// Near and far cameras from all sides, some looking past the character.
Camera hashed_camera(const PosedModel &posed, uint32_t index, float aspect);

}  // namespace gltest

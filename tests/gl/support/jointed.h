// A figure of rigid boxes on a tree of nodes, in a pose: made by hand, apart from meshsplit and lib/pose.
#pragma once

#include "tests/gl/support/pictures.h"

namespace gltest
{

struct Joint {
    uint32_t parent = model::none;
    glm::vec3 offset = glm::vec3(0);  // of the node from its parent's
    float turn_rad = 0;               // in the pose, about `axis`
    glm::vec3 axis = glm::vec3(0, 0, 1);
    glm::vec3 box = glm::vec3(0);  // half edges; none: no part hangs on the node
};

struct Jointed {
    PosedModel posed;                               // vertices in the pose, as the processor places them
    std::vector<claque::math::Affine> locals;       // in the pose, one a node
    std::vector<claque::math::Affine> globals;      // likewise, to the figure's own space
    std::vector<uint32_t> parts;                    // the node of each
    std::vector<claque::model::Sphere> part_balls;  // of the vertices in the pose
};

// `map` is laid over each box's six sides. Boxes are of two surfaces by turns. Where `bind_offset` is not 0, the
// template's vertices lie that far from where their nodes want them, and its inverse bind matrices bring them back.
Jointed make_jointed(const std::vector<Joint> &joints, const ZoneMap &map, float bind_offset = 0);

// Thirteen nodes, two of them without a box, all of whose boxes can be seen from the front.
std::vector<Joint> puppet();

// One box on each of `count` nodes, each hanging on the one before.
std::vector<Joint> rope(uint32_t count);

// Draws all parts by GL's matrix stack.
claque::draw::DrawList by_matrices(const Jointed &jointed, const Camera &camera, const uint8_t *zone_rgb = nullptr);

// Parts whose balls are not wholly outside what a camera shows.
uint64_t parts_in(const Jointed &jointed, const Camera &camera);

// Near and far, from all sides, looking past the figure too.
Camera hashed_camera(const PosedModel &posed, uint32_t index, float aspect);

}  // namespace gltest

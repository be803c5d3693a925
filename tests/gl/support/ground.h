// A white ground, people on it and an eye above, for shadows; and an answer of its own to what is in shadow: rays.
#pragma once

#include "tests/gl/support/fixture.h"

#include <functional>

namespace gltest
{

using claque::draw::DrawList;
using claque::draw::Item;

class Ground
{
public:
    Ground(glm::dvec3 eye, glm::dvec3 target, float aspect);

    // Somebody at a place in the world, turned about the upright axis; positions of level 0.
    Item stand(const PosedModel &posed, glm::dvec3 at, float turn_rad, float scale = 1) const;
    DrawList list_of(const std::vector<Item> &items) const;

    // Draws the ground, white and unlit at height 0, with depth; clears first, stencil to all ones.
    void draw(const HostGl &host, int width, int height) const;
    // An upright white wall over the picture's left half, nearer than anybody.
    void draw_wall(const HostGl &host) const;

    // Which pixels' middles show ground that no light reaches, as rays find it in double; rows from the top.
    std::vector<bool> shaded(const std::vector<Item> &items, glm::dvec4 light, int width, int height) const;

    const float *projection() const { return projection_; }

private:
    void quad(const HostGl &host, const std::array<glm::dvec3, 4> &corners) const;
    glm::dvec3 seen_ground(double x, double y) const;  // of normalised coordinates

    glm::dvec3 eye_;
    glm::dmat3 world_to_eye_;
    float projection_[16];
};

}  // namespace gltest

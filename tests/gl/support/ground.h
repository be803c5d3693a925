// A white ground, individuals on it and an eye above, for shadows; shadows are found independently, by rays.
#pragma once

#include <functional>

#include "tests/gl/support/fixture.h"

namespace gltest
{

using claque::draw::DrawList;
using claque::draw::Item;

class Ground
{
public:
    Ground(glm::dvec3 eye, glm::dvec3 target, float aspect);

    // An individual in the world, rotated about the upright axis; positions of level 0.
    Item stand(const PosedModel &posed, glm::dvec3 at, float turn_rad, float scale = 1) const;
    DrawList list_of(const std::vector<Item> &items) const;

    // Clears colour and depth, sets the stencil to all ones, and draws the ground at height 0, white and unlit, with
    // depth.
    void draw(const HostGl &host, int width, int height) const;
    // An upright white wall over the picture's left half, nearer than any individual.
    void draw_wall(const HostGl &host) const;

    // Pixels whose centres show ground that no light reaches, found by rays in double; rows from the top.
    std::vector<bool> shaded(const std::vector<Item> &items, glm::dvec4 light, int width, int height) const;

    const float *projection() const { return projection_; }

private:
    void quad(const HostGl &host, const std::array<glm::dvec3, 4> &corners) const;
    glm::dvec3 seen_ground(double x, double y) const;  // at normalised coordinates

    glm::dvec3 eye_;
    glm::dmat3 world_to_eye_;
    float projection_[16];
};

}  // namespace gltest

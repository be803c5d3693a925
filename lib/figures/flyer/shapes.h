// Builds flyers' pieces from sheets over meridians and tubes of rings. Points at equal positions are one point, so that
// sheets join where they meet; the same shape with fewer points is the next level of detail.
#pragma once

#include <functional>
#include <map>
#include <tuple>

#include "lib/figures/flyer/flyer.h"

namespace claque::figures::flyer
{

class MeshBuilder
{
public:
    explicit MeshBuilder(Mesh &mesh) : mesh_(mesh) {}

    uint32_t point(glm::vec3 p);

    // Meridians run upwards; the next one is to the right as seen from outside. Their `st.y` ascend.
    using SheetVertex = std::pair<glm::vec3, glm::vec2>;  // position and st
    void sheet(Chart chart, Winding winding, const std::vector<std::vector<SheetVertex>> &meridians);

    void triangle(Chart chart, Winding winding, const SheetVertex &a, const SheetVertex &b, const SheetVertex &c);

    // A tetrahedron with sharp edges, as seen from outside; the last corner is the tip, at st.y 1.
    void spike(Chart chart, const std::array<glm::vec3, 4> &corners);

private:
    Corner corner(const SheetVertex &stop) { return {point(stop.first), stop.second}; }

    Mesh &mesh_;
    std::map<std::tuple<float, float, float>, uint32_t> points_;
};

// An elliptic ring with half widths along ex to both sides and along ez to the front and to the back. `t` is its height
// in the chart. A ring of width 0 is a tip.
struct Ring {
    glm::vec3 centre;
    float side, front, back;
    float t;
    glm::vec3 ex = glm::vec3(1, 0, 0), ez = glm::vec3(0, 0, 1);
};

// Halfway between the inscribed and the circumscribed polygon of the ellipse, so that coarse rings are no thinner than
// fine ones. Pleats push every other point of a ring in and out by a fraction of the radius at t = 0 that fades towards
// t = 1.
struct Tube {
    Chart chart;
    Side side = Side::left;
    int around = 8;
    float pleat = 0;
};
void add_tube(MeshBuilder &to, const Tube &tube, const std::vector<Ring> &rings);

// Rings along a path, each in the plane across it, with `ez` as near to `forward` as possible.
struct PathRing {
    glm::vec3 centre;
    float side, front, back;
};
std::vector<Ring> rings_along(const std::vector<PathRing> &beads, glm::vec3 forward);

// The part of a ball that faces ahead, up to these angles sideways and upwards; st are the angles.
struct Ball {
    glm::vec3 centre;
    float radius, aside, up;
};
void add_ball(MeshBuilder &to, Chart chart, const Ball &ball, int columns, int rows);

// An eyelid between half circles through the two sides of the ball, at these angles upwards.
void add_lid(MeshBuilder &to, Chart chart, const Ball &ball, int columns, const std::vector<float> &pitches);

// The elements with these indices.
template <class T>
std::vector<T> pick(const std::vector<T> &from, std::initializer_list<size_t> numbers)
{
    std::vector<T> picked;
    for (const size_t i : numbers) picked.push_back(from[i]);
    return picked;
}

}  // namespace claque::figures::flyer

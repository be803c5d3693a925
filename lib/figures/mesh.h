// A surface while it is being modelled: points that are shared across seams, and faces whose corners know their place
// in a chart. Chains of corners are sewn to each other like strips of cloth; that is the only modelling verb needed.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "lib/figures/charts.h"

namespace claque::figures
{

// Which bones may move a point.
// A gown is a skirt that reaches below the knees; `own` and what follows it a figure explains by its weigher.
enum class Region : uint8_t { head, torso, skirt, gown, sleeve, arm, palm, fingers, index, thumb, leg, foot, own };
constexpr Region own_region(int number) { return static_cast<Region>(static_cast<int>(Region::own) + number); }

struct Point {
    glm::vec3 position;
    Region region = Region::torso;
    Side side = Side::left;  // of regions that exist twice
};

// `st` is in the chart's own units; unwrap() makes `uv` of them, the place in the texture.
struct Corner {
    uint32_t point = 0;
    glm::vec2 st = glm::vec2(0);
    glm::vec2 uv = glm::vec2(0);
};
using Chain = std::vector<Corner>;

struct Face {
    std::array<Corner, 3> corners;
    Chart chart = Chart::head;
};

enum class Along : uint8_t { s, t };
enum class Winding : uint8_t { as_given, reversed };

constexpr Winding winding_of(Side side) { return side == Side::left ? Winding::as_given : Winding::reversed; }

// Mirrors what is modelled on the left; its own inverse.
inline glm::vec3 mirrored(glm::vec3 p, Side side) { return glm::vec3(side == Side::left ? p.x : -p.x, p.y, p.z); }

class Mesh
{
public:
    std::vector<Point> points;
    std::vector<Face> faces;

    uint32_t add(glm::vec3 position, Region region, Side side = Side::left);

    // Counter-clockwise from outside as given.
    void face(Chart chart, Winding winding, Corner a, Corner b, Corner c);

    // Sews two chains that run the same way: to the right of whoever looks from outside with `upper` above `lower`.
    // Chains of unequal count are zipped by the named coordinate; corners that share a point make no face there.
    void sew(Chart chart, Winding winding, const Chain &lower, const Chain &upper, Along along);

    // A fan from every edge of the chain to one corner, which stands where an upper chain would.
    void fan(Chart chart, Winding winding, const Chain &lower, Corner top);

    // Closes a convex loop (its first point not repeated) without a new point.
    void cap(Chart chart, Winding winding, const Chain &loop);

    std::vector<glm::vec3> smooth_normals() const;  // one a point, angle-weighted
};

// The points of a ring as a chain whose s runs from 0 to 1, the first repeated at the end (the chart's seam).
Chain ring_chain(const std::vector<uint32_t> &ring, float t);

// Fits each chart's corners into its rectangle. Throws base::Error where a chart with faces has none.
void unwrap(Mesh &mesh, const Layout &layout);

}  // namespace claque::figures

// A surface under construction: points that are shared across seams, and faces whose corners have positions in a chart.
// Strips between chains of corners (sew) make up nearly all of a figure.
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lib/figures/charts.h"

namespace claque::figures
{

// The region of a point decides which bones may move it. A gown is a skirt that reaches below the knees. A figure's
// weigher defines `own` and the regions after it.
enum class Region : uint8_t { head, torso, skirt, gown, sleeve, arm, palm, fingers, index, thumb, leg, foot, own };
constexpr Region own_region(int number) { return static_cast<Region>(static_cast<int>(Region::own) + number); }

struct Point {
    glm::vec3 position;
    Region region = Region::torso;
    Side side = Side::left;  // for regions that exist twice
};

// `st` is in the chart's own units; unwrap() turns it into `uv`, the position in the texture.
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

// Mirrors points of the left side; its own inverse.
inline glm::vec3 mirrored(glm::vec3 p, Side side) { return glm::vec3(side == Side::left ? p.x : -p.x, p.y, p.z); }

class Mesh
{
public:
    std::vector<Point> points;
    std::vector<Face> faces;

    uint32_t add(glm::vec3 position, Region region, Side side = Side::left);

    // Corners are counter-clockwise as seen from outside.
    void face(Chart chart, Winding winding, Corner a, Corner b, Corner c);

    // Joins two chains of the same direction: to the right as seen from outside, with `upper` above `lower`. Chains of
    // unequal count are matched by the named coordinate; corners that share a point give no face there.
    void sew(Chart chart, Winding winding, const Chain &lower, const Chain &upper, Along along);

    // A fan from every edge of the chain to one corner, which is in the place of an upper chain.
    void fan(Chart chart, Winding winding, const Chain &lower, Corner top);

    // Closes a convex loop without a new point. The first point is not repeated.
    void cap(Chart chart, Winding winding, const Chain &loop);

    std::vector<glm::vec3> smooth_normals() const;  // one per point, weighted by angle
};

// The points of a ring as a chain with s from 0 to 1. The first point is repeated at the end, the seam of the chart.
Chain ring_chain(const std::vector<uint32_t> &ring, float t);

// Fits each chart's corners into its rectangle. Throws base::Error if a chart with faces has no rectangle.
void unwrap(Mesh &mesh, const Layout &layout);

}  // namespace claque::figures

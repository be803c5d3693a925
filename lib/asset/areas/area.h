// Reads walkable areas from bytes that may be anything.
#pragma once

#include <claque/trajectories.h>

#include <cstdint>
#include <string>
#include <vector>

namespace claque::asset
{

struct Point {
    double x = 0, y = 0;
};
using Ring = std::vector<Point>;

struct Area {
    std::vector<double> points;  // x, y, z
    std::vector<clq_area_ring> rings;
    std::vector<uint32_t> triangles, walls;
    std::vector<std::string> warnings;
    uint32_t polygons = 0;
    double area_m2 = 0;
};

// A plane over which a polygon lies: z = a x + b y + c.
struct Plane {
    double a = 0, b = 0, c = 0;
    double height(const Point &at) const { return a * at.x + b * at.y + c; }
};

// Puts polygons into an area.
class AreaBuilder
{
public:
    // Of a polygon: edges at one place, or long slanting ones close together, are compared with each other.
    static constexpr size_t most_points = 10000;

    // Rings in any direction, with or without their first point repeated at the end. Rings that enclose nothing are
    // left out with a warning. Throws base::Error: CLQ_FORMAT if rings cross or a hole is not in the polygon,
    // CLQ_LIMIT.
    void add_polygon(const std::vector<Ring> &rings, const Plane &plane = {}, bool walled = true);
    // A piece of wall. Its points may be those of polygons.
    void add_wall(uint32_t from, uint32_t to);
    uint32_t add_point(const Point &at, const Plane &plane = {});
    void warn(const std::string &text) { area_.warnings.push_back(text); }
    Area take() { return std::move(area_); }

private:
    void keep_ring(const Ring &ring, bool hole, const Plane &plane, bool walled);
    Area area_;
};

// Throws base::Error and std::bad_alloc. The name is for messages.
Area read_area(const uint8_t *bytes, size_t size);

}  // namespace claque::asset

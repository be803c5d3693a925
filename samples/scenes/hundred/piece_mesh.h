// The geometry of the dragon: flat triangles in model space with texture coordinates in the atlas of zones (paint.h).
#pragma once

#include <cstdint>
#include <vector>

namespace scenes::hundred
{

struct Point {
    double x, y, z;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator*(Point a, double k) { return {a.x * k, a.y * k, a.z * k}; }
Point unit(Point a);
Point cross(Point a, Point b);

// Cells of the atlas, each a zone of its own.
enum Cell : uint32_t { lacquer, belly, mane, horn, eye, gold, mouth, cell_count };

struct PieceMesh {
    std::vector<float> positions, uvs;  // three corners a triangle, nothing shared: faces are flat

    void triangle(Cell cell, Point a, Point b, Point c, const double (&uv)[6]);
    // Corners counter-clockwise seen from outside; u along a to b, v along a to d.
    void quad(Cell cell, Point a, Point b, Point c, Point d);

    struct Ring {
        Point centre;
        double wide, high;  // half axes, across and upright
    };
    // A surface through the rings in their order, closed at both ends. Rings stand upright and square to the line
    // between their neighbours. The lower `under` sides are of cell `below`.
    void loft(const std::vector<Ring> &rings, int sides, Cell cell, Cell below, int under);
    // A round limb or a horn.
    void limb(Cell cell, const std::vector<Point> &way, const std::vector<double> &radius, int sides);
    // A thin blade, visible from both sides: `root` to `heel` along its foot, and its tip.
    void blade(Cell cell, Point root, Point heel, Point tip, double thick);
    // An octahedron with these half axes.
    void bead(Cell cell, Point centre, double x, double y, double z);
};

}  // namespace scenes::hundred

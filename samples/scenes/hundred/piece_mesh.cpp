#include "samples/scenes/hundred/piece_mesh.h"

#include <cmath>

#include "samples/scenes/hundred/paint.h"

namespace scenes::hundred
{

Point unit(Point a)
{
    const double l = std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
    return l > 0 ? a * (1 / l) : Point{0, 0, 1};
}

Point cross(Point a, Point b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

void PieceMesh::triangle(Cell cell, Point a, Point b, Point c, const double (&uv)[6])
{
    const Point corners[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
        const Point &p = corners[k];
        positions.insert(positions.end(), {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        float at[2];
        in_cell(cell, uv[2 * k], uv[2 * k + 1], at);
        uvs.insert(uvs.end(), {at[0], at[1]});
    }
}

void PieceMesh::quad(Cell cell, Point a, Point b, Point c, Point d)
{
    triangle(cell, a, b, c, {0, 0, 1, 0, 1, 1});
    triangle(cell, a, c, d, {0, 0, 1, 1, 0, 1});
}

void PieceMesh::loft(const std::vector<Ring> &rings, int sides, Cell cell, Cell below, int under)
{
    std::vector<std::vector<Point>> skin;
    for (size_t i = 0; i < rings.size(); ++i) {
        const Point along = unit(rings[i + 1 < rings.size() ? i + 1 : i].centre - rings[i > 0 ? i - 1 : 0].centre);
        const Point right = unit(cross({0, 1, 0}, along)), up = cross(along, right);
        std::vector<Point> ring;
        for (int k = 0; k < sides; ++k) {
            // Side 0 begins beside the lowest line, so that the sides are symmetric about it.
            const double turn = 6.283185307179586 * (k - under * 0.5) / sides;
            ring.push_back(rings[i].centre + right * (rings[i].wide * std::sin(turn)) +
                           up * (-rings[i].high * std::cos(turn)));
        }
        skin.push_back(ring);
    }
    const auto at = [&](size_t i, int k) { return skin[i][static_cast<size_t>(k % sides)]; };
    for (size_t i = 0; i + 1 < skin.size(); ++i)
        for (int k = 0; k < sides; ++k)
            quad(k < under ? below : cell, at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    for (int k = 1; k + 1 < sides; ++k) {
        const size_t last = skin.size() - 1;
        triangle(cell, at(0, 0), at(0, k + 1), at(0, k), {0.5, 0.5, 1, 1, 0, 1});
        triangle(cell, at(last, 0), at(last, k), at(last, k + 1), {0.5, 0.5, 0, 1, 1, 1});
    }
}

void PieceMesh::limb(Cell cell, const std::vector<Point> &way, const std::vector<double> &radius, int sides)
{
    std::vector<std::vector<Point>> skin;
    for (size_t i = 0; i < way.size(); ++i) {
        const Point along = unit(way[i + 1 < way.size() ? i + 1 : i] - way[i > 0 ? i - 1 : 0]);
        const Point aside = std::fabs(along.y) < 0.8 ? Point{0, 1, 0} : Point{0, 0, 1};
        const Point right = unit(cross(aside, along)), up = cross(along, right);
        std::vector<Point> ring;
        for (int k = 0; k < sides; ++k) {
            const double turn = 6.283185307179586 * k / sides;
            ring.push_back(way[i] + right * (radius[i] * std::sin(turn)) + up * (-radius[i] * std::cos(turn)));
        }
        skin.push_back(ring);
    }
    const auto at = [&](size_t i, int k) { return skin[i][static_cast<size_t>(k % sides)]; };
    for (size_t i = 0; i + 1 < skin.size(); ++i)
        for (int k = 0; k < sides; ++k) quad(cell, at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    for (int k = 1; k + 1 < sides; ++k) triangle(cell, at(0, 0), at(0, k + 1), at(0, k), {0.5, 0.5, 1, 1, 0, 1});
}

void PieceMesh::blade(Cell cell, Point root, Point heel, Point tip, double thick)
{
    const Point out = unit(cross(heel - root, tip - root)) * (thick * 0.5);
    triangle(cell, root + out, heel + out, tip, {0, 0, 1, 0, 0.5, 1});
    triangle(cell, heel - out, root - out, tip, {1, 0, 0, 0, 0.5, 1});
    triangle(cell, root - out, root + out, tip, {0, 0, 0.1, 0, 0.5, 1});
    triangle(cell, heel + out, heel - out, tip, {0.9, 0, 1, 0, 0.5, 1});
}

void PieceMesh::bead(Cell cell, Point centre, double x, double y, double z)
{
    const Point ring[4] = {{0, 0, z}, {0, y, 0}, {0, 0, -z}, {0, -y, 0}};
    const double uv[4][2] = {{1, 0.5}, {0.5, 1}, {0, 0.5}, {0.5, 0}};
    for (const double side : {1.0, -1.0})
        for (int k = 0; k < 4; ++k) {
            const int from = side > 0 ? (k + 1) % 4 : k, to = side > 0 ? k : (k + 1) % 4;
            triangle(cell, centre + Point{x * side, 0, 0}, centre + ring[from], centre + ring[to],
                     {0.5, 0.5, uv[from][0], uv[from][1], uv[to][0], uv[to][1]});
        }
}

}  // namespace scenes::hundred

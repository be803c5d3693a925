#include "samples/scenes/everything/shapes.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::everything
{
namespace
{

void add(Shape &shape, double x, double y, double z, double nx, double ny, double nz, double u, double v)
{
    const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
    for (const double p : {x, y, z}) shape.positions.push_back(static_cast<float>(p));
    for (const double n : {nx, ny, nz}) shape.normals.push_back(static_cast<float>(n / length));
    for (const double t : {u, v}) shape.uvs.push_back(static_cast<float>(t));
}

// Triangles between rows of vertices, each row from the left to the right seen from the front, and the next above it.
void join(Shape &shape, int rows, int columns)
{
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const uint32_t a = static_cast<uint32_t>(row * columns + column), b = a + 1;
            const uint32_t c = a + static_cast<uint32_t>(columns), d = c + 1;
            shape.indices.insert(shape.indices.end(), {a, b, d, a, d, c});
        }
}

}  // namespace

Shape turned(const Profile &radius, double low, double high, int rings, int sides)
{
    Shape out;
    for (int ring = 0; ring <= rings; ++ring) {
        const double v = static_cast<double>(ring) / rings, y = low + (high - low) * v, r = radius(y);
        constexpr double near_m = 1e-4;
        const double slope = (radius(y + near_m) - radius(y - near_m)) / (2 * near_m);
        for (int side = 0; side <= sides; ++side) {
            const double u = static_cast<double>(side) / sides, s = std::sin(two_pi * u), c = std::cos(two_pi * u);
            add(out, r * s, y, r * c, s, -slope, c, u, v);
        }
    }
    join(out, rings + 1, sides + 1);
    return out;
}

Shape cape(double low, double high, int rows, int columns)
{
    Shape out;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
            const double y = low + (high - low) * v, half = 0.34 - 0.16 * v;
            const double x = half * (1 - 2 * u), wave = 0.05 * (1 - v), turn = 3 * two_pi * u;
            const double z = -(0.17 + 0.30 * (1 - v) + wave * std::sin(turn)) + 0.35 * x * x;
            const double along = -wave * std::cos(turn) * 3 * two_pi / (-2 * half) + 0.70 * x;  // dz/dx
            add(out, x, y, z, along, 0.30 / (high - low), -1, u, v);
        }
    join(out, rows + 1, columns + 1);
    return out;
}

Shape box(const double (&low)[3], const double (&high)[3])
{
    Shape out;
    for (size_t axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const size_t across = (axis + 1) % 3, up = (axis + 2) % 3;
            const uint32_t first = out.vertices();
            for (int corner = 0; corner < 4; ++corner) {
                const int u = corner == 1 || corner == 2, v = corner >= 2;
                double p[3], n[3] = {0, 0, 0};
                p[axis] = sign < 0 ? low[axis] : high[axis];
                p[across] = (u == 1) == (sign > 0) ? high[across] : low[across];
                p[up] = v ? high[up] : low[up];
                n[axis] = sign;
                add(out, p[0], p[1], p[2], n[0], n[1], n[2], u, v);
            }
            out.indices.insert(out.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    return out;
}

void follow_spine(Shape &shape)
{
    constexpr double reach_m = 0.3;
    for (uint32_t vertex = 0; vertex < shape.vertices(); ++vertex) {
        double weights[spine_joints], sum = 0;
        for (uint32_t joint = 0; joint < spine_joints; ++joint) {
            const double apart =
                (static_cast<double>(shape.positions[3 * vertex + 1]) - spine_foot_m - spine_step_m * joint) / reach_m;
            weights[joint] = 1 / (1 + apart * apart * apart * apart);
            sum += weights[joint];
        }
        for (uint32_t joint = 0; joint < spine_joints; ++joint) {
            shape.joints.push_back(joint);
            shape.weights.push_back(static_cast<float>(weights[joint] / sum));
        }
    }
}

void tint(Shape &shape, double low, double high)
{
    for (uint32_t vertex = 0; vertex < shape.vertices(); ++vertex) {
        const double y = static_cast<double>(shape.positions[3 * vertex + 1]);
        const double t = std::clamp((y - low) / (high - low), 0.0, 1.0);
        for (const double top : {255.0, 244.0, 225.0})
            shape.colours.push_back(static_cast<uint8_t>(std::lround(130 + (top - 130) * t)));
        shape.colours.push_back(255);
    }
}

}  // namespace scenes::everything

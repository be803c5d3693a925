// Meshes of the figure of `everything`, in its model space or in a node's own frame.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace scenes::everything
{

constexpr uint32_t spine_joints = 8;
constexpr double spine_foot_m = 0.08, spine_step_m = 0.17;  // height of the lowest joint, and between two

struct Shape {
    std::vector<float> positions, normals, uvs, weights;  // weights: of each spine joint, eight a vertex; may be empty
    std::vector<uint8_t> colours;                         // four a vertex; may be empty
    std::vector<uint32_t> joints, indices;

    uint32_t vertices() const { return static_cast<uint32_t>(positions.size() / 3); }
};

// The radius of a body of revolution at a height.
using Profile = std::function<double(double y)>;

// A body about the vertical axis from y `low` to `high`: u goes round, v up.
Shape turned(const Profile &radius, double low, double high, int rings, int sides);

// A sheet that hangs behind the body, with waves; one-sided triangles that face away from the body.
Shape cape(double low, double high, int rows, int columns);

// A box from `low` to `high`, each face with the whole texture.
Shape box(const double (&low)[3], const double (&high)[3]);

// Every vertex follows all joints of the spine, those at its height most.
void follow_spine(Shape &shape);

// Darker towards the ground, with a warm tint above.
void tint(Shape &shape, double low, double high);

}  // namespace scenes::everything

// A second opinion on every character: glTF 2.0 evaluated in double precision, written from the specification and apart
// from the library.
//
// What is independent: everything between the file's bytes and the positions. Base64, GLB chunks, accessors, node
// transforms, key interpolation (a true slerp with acos), morphing, skinning and normals are this folder's own; no
// header of lib/asset, lib/pose, lib/math or GLM is seen by it, and it blends whole 4x4 matrices where the library
// works on 3x4 floats. What is shared: nlohmann-json's parser, the C++ compiler, and the reader of the specification.
//
// What is not done: hostile files (anything may be thrown), compression, images, materials.
//
// The order of vertices is that of `claque dump`: the default scene (scene 0 if none is named, all root nodes if there
// are no scenes), nodes depth first with children in listed order, primitives in order, vertices as in the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/reference/matrix.h"

namespace claque::reference
{

struct Node {
    std::string name;
    int parent = -1;
    std::vector<size_t> children;
    bool has_matrix = false;
    Mat4 matrix;
    Vec3 translation;
    Quat rotation;
    Vec3 scale{1, 1, 1};
    std::vector<double> morph_weights;  // the node's own, else its mesh's, else zeros
    int mesh = -1, skin = -1;
};

struct Skin {
    std::vector<size_t> joints;  // nodes
    std::vector<Mat4> inverse_binds;
};

struct MorphTarget {
    std::vector<Vec3> positions, normals;  // deltas, either may be empty
};

// One primitive of one node.
struct Part {
    size_t node = 0;
    int skin = -1;  // -1: moves rigidly with its node
    int mode = 4;
    std::vector<Vec3> positions, normals;  // normals may be empty
    std::vector<MorphTarget> targets;
    size_t influences = 0;  // per vertex, over all JOINTS_n
    std::vector<size_t> joints;
    std::vector<double> weights;    // each vertex's sum to 1
    std::vector<uint32_t> indices;  // 0, 1, 2 ... where the file has none
};

enum class Path { Translation, Rotation, Scale, Weights };
enum class Interpolation { Step, Linear, CubicSpline };

struct Channel {
    size_t node = 0;
    Path path = Path::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::vector<double> times;
    size_t width = 0;  // numbers in one value
    std::vector<double> values;
};

struct Clip {
    std::string name;
    std::vector<Channel> channels;
    double first_s = 0, last_s = 0;
};

// Plain data, so that tests can damage it and see that the comparison notices.
struct Character {
    std::vector<Node> nodes;
    std::vector<Skin> skins;
    std::vector<Part> parts;
    std::vector<Clip> clips;
    size_t vertex_count() const;
};

Character load_character(const std::string &path);

// The channel's value at a time, clamped to its own keys; rotations come back with unit length.
std::vector<double> sample(const Channel &channel, double time_s);

struct Shape {
    std::vector<Vec3> positions;
    std::vector<double> stretches;  // condition number of the matrix that each vertex follows, 1 if nothing is bent
    std::vector<bool> mirrored;     // whether that matrix mirrors
    std::vector<Vec3> normals;      // unit, or zero where the file has none or the transform is singular
};

constexpr size_t rest = static_cast<size_t>(-1);

// All parts in world space; clip `rest` is the rest pose.
Shape evaluate(const Character &character, size_t clip, double time_s);

}  // namespace claque::reference

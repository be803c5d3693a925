// Reads meshes: each primitive of a file is decoded once and then attached to the nodes that show it.
#pragma once

#include "lib/asset/gltf_file.h"
#include "lib/asset/gltf_material.h"

namespace claque::asset
{

struct Primitive {
    model::Part part;         // without node and matrix palette entries
    bool has_joints = false;  // part.joints are indices of a skin's list of joints
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;  // only those with positions
    uint32_t target_count = 0;
    std::vector<float> morph_weights;  // target_count of them
};

// Reads and checks all meshes of the file. Meshes that are not `shown` may lack their data.
std::vector<Mesh> read_meshes(File &file, Materials &materials, const std::vector<bool> &shown);

// The memory of a part's arrays.
uint64_t bytes_of(const model::Part &part);

}  // namespace claque::asset

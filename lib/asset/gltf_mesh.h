// Meshes: each primitive of a file decoded once, to be hung on the nodes that show it.
#pragma once

#include "lib/asset/gltf_file.h"
#include "lib/asset/gltf_material.h"

namespace claque::asset
{

struct Primitive {
    model::Part part;         // without node and palette entries
    bool has_joints = false;  // part.joints are places in a skin's list of joints
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;  // those with positions
    uint32_t target_count = 0;
    std::vector<float> morph_weights;  // target_count of them
};

// All meshes of the file, shown or not, and so all of them checked; those that are not shown may lack their data.
std::vector<Mesh> read_meshes(File &file, Materials &materials, const std::vector<bool> &shown);

// What a part's arrays take.
uint64_t bytes_of(const model::Part &part);

}  // namespace claque::asset

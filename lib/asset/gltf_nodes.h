// The checked node tree of a file, and the order of its nodes in the rig.
#pragma once

#include <string>
#include <vector>

#include "lib/asset/gltf_file.h"
#include "lib/asset/node_extras.h"
#include "lib/math/affine.h"

namespace claque::asset
{

struct FileNode {
    std::string name;
    uint32_t parent = none;
    std::vector<uint32_t> children;
    math::Trs rest;
    bool has_matrix = false;
    uint32_t mesh = none, skin = none;
    bool is_instanced = false;           // its mesh is shown by nodes of its own below it
    std::vector<float> morph_weights;    // the node's own weights; empty: those of its mesh
    std::unique_ptr<NodeExtras> extras;  // null: none
};

// Node indices are those of the file; after its own come nodes for instances (gltf_instances.h). Every node has at most
// one parent and there are no cycles, inside the scene or outside.
struct NodeTree {
    std::vector<FileNode> nodes;
    size_t file_count = 0;        // of the file's own
    std::vector<uint32_t> scene;  // root nodes of the shown scene, in file order

    // The nodes of the scene, depth first, children in file order.
    std::vector<uint32_t> shown() const;
    // The nodes below these roots, depth first.
    std::vector<uint32_t> below(const std::vector<uint32_t> &roots) const;
    uint32_t root_of(uint32_t node) const;
};

NodeTree read_nodes(File &file);

}  // namespace claque::asset

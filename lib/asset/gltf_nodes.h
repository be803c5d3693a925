// The node tree of a file, checked, and the order in which its nodes become the rig's.
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
    std::vector<float> morph_weights;    // the node's own; empty: its mesh's
    std::unique_ptr<NodeExtras> extras;  // null: none
};

// Indices of nodes are the file's. Every node has one parent at most and there are no loops, wherever it stands.
struct NodeTree {
    std::vector<FileNode> nodes;
    std::vector<uint32_t> scene;  // root nodes of the scene that is shown, as listed

    // The scene depth first, children as listed.
    std::vector<uint32_t> shown() const;
    // Depth first from these roots.
    std::vector<uint32_t> below(const std::vector<uint32_t> &roots) const;
    uint32_t root_of(uint32_t node) const;
};

NodeTree read_nodes(File &file);

}  // namespace claque::asset

#include "lib/asset/gltf_nodes.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/gltf_instances.h"
#include "lib/asset/node_matrix.h"

namespace claque::asset
{

using base::fail;

namespace
{

// A matrix that differs by more from every translation, rotation and scale has shear, which nodes do not support.
constexpr double shear_refused = 1e-3, shear_noted = 1e-5;

void read_matrix(const JsonView &view, FileNode &node, File &file)
{
    float m[16];
    view.numbers(m, 16);
    if (std::fabs(m[3]) + std::fabs(m[7]) + std::fabs(m[11]) + std::fabs(m[15] - 1) > 1e-5f)
        fail(CLQ_FORMAT, "%s: the last row of the matrix is %g %g %g %g instead of 0 0 0 1", view.path().c_str(),
             static_cast<double>(m[3]), static_cast<double>(m[7]), static_cast<double>(m[11]),
             static_cast<double>(m[15]));
    const DecomposedMatrix parts = decompose(m);
    if (parts.error > shear_refused)
        fail(CLQ_FORMAT, "%s: the matrix has shear: it is not a translation, rotation and scale", view.path().c_str());
    if (parts.error > shear_noted)
        file.warn(base::text_of("%s has a little shear: shown without", view.path().c_str()));
    node.rest = parts.trs;
    node.has_matrix = true;
}

void read_transform(const JsonView &view, FileNode &node, File &file)
{
    const JsonView t = view["translation"], r = view["rotation"], s = view["scale"];
    if (view["matrix"].exists()) {
        if (t.exists() || r.exists() || s.exists())
            fail(CLQ_FORMAT, "%s has a matrix and a translation, rotation or scale", view.path().c_str());
        return read_matrix(view["matrix"], node, file);
    }
    if (t.exists()) t.numbers(&node.rest.translation.x, 3);
    if (s.exists()) s.numbers(&node.rest.scale.x, 3);
    if (!r.exists()) return;
    float q[4];
    r.numbers(q, 4);
    const double length =
        std::sqrt(double(q[0]) * q[0] + double(q[1]) * q[1] + double(q[2]) * q[2] + double(q[3]) * q[3]);
    if (!(std::fabs(length - 1) < 0.1)) fail(CLQ_FORMAT, "%s has length %g instead of 1", r.path().c_str(), length);
    for (float &x : q) x = static_cast<float>(x / length);
    node.rest.rotation = glm::quat(q[3], q[0], q[1], q[2]);
}

FileNode read_node(const JsonView &view, File &file, size_t node_count)
{
    FileNode node;
    view.object();
    node.name = view["name"].text_or("");
    const JsonView children = view["children"];
    node.children.reserve(children.count());
    for (size_t i = 0; i < children.count(); ++i) node.children.push_back(children.at(i).index(node_count, "node"));
    read_transform(view, node, file);
    node.mesh = view["mesh"].index_or_none(file.root["meshes"].count(), "mesh");
    node.skin = view["skin"].index_or_none(file.root["skins"].count(), "skin");
    if (node.skin != none && node.mesh == none) fail(CLQ_FORMAT, "%s has a skin but no mesh", view.path().c_str());
    const JsonView weights = view["weights"];
    if (weights.exists()) {
        node.morph_weights.resize(weights.count());
        weights.numbers(node.morph_weights.data(), node.morph_weights.size());
    }
    node.extras = read_node_extras(view["extras"], file.budget);
    if (node.extras && node.extras->has_lod && node.mesh == none)
        fail(CLQ_FORMAT, "%s.extras.claque.lod_m says when a mesh is drawn: the node has none", view.path().c_str());
    return node;
}

void link_parents(NodeTree &tree)
{
    for (size_t i = 0; i < tree.nodes.size(); ++i)
        for (const uint32_t child : tree.nodes[i].children) {
            uint32_t &parent = tree.nodes[child].parent;
            if (parent != none)
                fail(CLQ_FORMAT, "nodes[%u] is a child of nodes[%u] and of nodes[%zu]", child, parent, i);
            parent = static_cast<uint32_t>(i);
        }
    // Each node has at most one parent, so nodes that no root reaches form a cycle.
    std::vector<uint32_t> roots;
    for (size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].parent == none) roots.push_back(static_cast<uint32_t>(i));
    const std::vector<uint32_t> reached = tree.below(roots);
    if (reached.size() == tree.nodes.size()) return;
    std::vector<bool> is_reached(tree.nodes.size(), false);
    for (const uint32_t node : reached) is_reached[node] = true;
    // So many steps up from any other node end on a cycle.
    uint32_t node = static_cast<uint32_t>(std::find(is_reached.begin(), is_reached.end(), false) - is_reached.begin());
    for (size_t i = 0; i < tree.nodes.size(); ++i) node = tree.nodes[node].parent;
    fail(CLQ_FORMAT, "nodes[%u] is its own ancestor", node);
}

void choose_scene(NodeTree &tree, const File &file)
{
    const JsonView scenes = file.root["scenes"];
    const uint32_t by_default = file.root["scene"].index_or_none(scenes.count(), "scene");
    if (file.options.scene >= 0 && static_cast<size_t>(file.options.scene) >= scenes.count())
        fail(CLQ_ARGUMENT, "scene %d is asked for: the file has %zu", file.options.scene, scenes.count());
    if (scenes.count() == 0) {
        for (size_t i = 0; i < tree.nodes.size(); ++i)
            if (tree.nodes[i].parent == none) tree.scene.push_back(static_cast<uint32_t>(i));
        return;
    }
    const size_t wanted = file.options.scene >= 0 ? static_cast<size_t>(file.options.scene)
                          : by_default != none    ? by_default
                                                  : 0;
    std::vector<bool> listed(tree.nodes.size(), false);
    for (size_t s = 0; s < scenes.count(); ++s) {
        scenes.at(s).object();
        const JsonView nodes = scenes.at(s)["nodes"];
        for (size_t i = 0; i < nodes.count(); ++i) {
            const uint32_t node = nodes.at(i).index(tree.nodes.size(), "node");
            if (tree.nodes[node].parent != none)
                fail(CLQ_FORMAT, "%s names nodes[%u], which is no root node", nodes.at(i).path().c_str(), node);
            if (s != wanted) continue;
            if (listed[node]) fail(CLQ_FORMAT, "%s names nodes[%u] twice", nodes.path().c_str(), node);
            listed[node] = true;
            tree.scene.push_back(node);
        }
    }
}

}  // namespace

std::vector<uint32_t> NodeTree::below(const std::vector<uint32_t> &roots) const
{
    std::vector<uint32_t> out, waiting(roots.rbegin(), roots.rend());
    while (!waiting.empty()) {
        const uint32_t node = waiting.back();
        waiting.pop_back();
        out.push_back(node);
        waiting.insert(waiting.end(), nodes[node].children.rbegin(), nodes[node].children.rend());
    }
    return out;
}

std::vector<uint32_t> NodeTree::shown() const { return below(scene); }

uint32_t NodeTree::root_of(uint32_t node) const
{
    while (nodes[node].parent != none) node = nodes[node].parent;
    return node;
}

NodeTree read_nodes(File &file)
{
    NodeTree tree;
    const JsonView list = file.root["nodes"];
    file.budget.charge(list.count() * sizeof(FileNode), "the list of nodes");
    tree.nodes.reserve(list.count());
    for (size_t i = 0; i < list.count(); ++i) tree.nodes.push_back(read_node(list.at(i), file, list.count()));
    tree.file_count = tree.nodes.size();
    link_parents(tree);
    choose_scene(tree, file);
    add_instances(file, tree);
    return tree;
}

}  // namespace claque::asset

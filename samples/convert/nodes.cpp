// Assimp's tree of nodes as nodes of glTF, in metres and with y up.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "samples/convert/scene.h"

namespace convert
{
namespace
{

constexpr unsigned deepest = 500;

std::vector<double> numbers_of(const aiVector3D &v) { return {double(v.x), double(v.y), double(v.z)}; }

// Nodes are written as translation, rotation and scale, because clips move those.
Json node_json(const aiNode &node)
{
    Json out = {{"name", node.mName.C_Str()}};
    aiVector3D scale, move;
    aiQuaternion turn;
    node.mTransformation.Decompose(scale, turn, move);
    turn.Normalize();
    if (move != aiVector3D(0, 0, 0)) out["translation"] = numbers_of(move);
    if (turn != aiQuaternion(1, 0, 0, 0)) out["rotation"] = {turn.x, turn.y, turn.z, turn.w};
    if (scale != aiVector3D(1, 1, 1)) out["scale"] = numbers_of(scale);
    return out;
}

float largest(const aiMatrix4x4 &m)
{
    float most = 0;
    for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 3; ++c) most = std::fmax(most, std::fabs(m[r][c]));
    return most;
}

// How far the matrix is from what its translation, rotation and scale make of it, relative to its largest number.
float shear_of(const aiMatrix4x4 &matrix)
{
    aiVector3D scale, move;
    aiQuaternion turn;
    matrix.Decompose(scale, turn, move);
    turn.Normalize();
    const aiMatrix4x4 again(scale, turn, move);
    float worst = 0;
    for (unsigned r = 0; r < 3; ++r)
        for (unsigned c = 0; c < 3; ++c) worst = std::fmax(worst, std::fabs(again[r][c] - matrix[r][c]));
    return worst / std::fmax(largest(matrix), 1e-30f);
}

void add_node(Scene &scene, const aiNode &node, unsigned depth)
{
    if (depth > deepest) throw std::runtime_error("its nodes are nested too deep");
    const float shear = shear_of(node.mTransformation);
    if (!(shear < 1e-4f)) scene.sheared.emplace_back(node.mName.C_Str());
    const size_t index = scene.glb.add("nodes", node_json(node));
    scene.nodes[&node] = index;
    scene.named.emplace(node.mName.C_Str(), &node);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], depth + 1);
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        scene.glb.json["nodes"][index]["children"].push_back(scene.nodes.at(node.mChildren[i]));
}

struct Listed {
    aiNode *node, *by;
};

void find_misplaced(aiNode &node, unsigned depth, std::vector<Listed> &out)
{
    if (depth == deepest) return;  // add_node refuses it
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
        aiNode &child = *node.mChildren[i];
        if (child.mParent && child.mParent != &node) out.push_back({&child, &node});
        find_misplaced(child, depth + 1, out);
    }
}

bool lists(const aiNode &root, const aiNode *node)
{
    if (&root == node) return true;
    return std::any_of(root.mChildren, root.mChildren + root.mNumChildren,
                       [&](const aiNode *child) { return lists(*child, node); });
}

}  // namespace

void hang_below_parents(aiNode &root)
{
    std::vector<Listed> misplaced;
    find_misplaced(root, 0, misplaced);
    for (const auto &[node, by] : misplaced) {
        aiNode *parent = node->mParent;
        if (!lists(root, parent) || lists(*node, parent)) continue;
        aiNode **end = by->mChildren + by->mNumChildren, **at = std::find(by->mChildren, end, node);
        std::copy(at + 1, end, at);
        --by->mNumChildren;
        aiNode *moved = node;
        parent->addChildren(1, &moved);
    }
}

std::string listed(const std::vector<std::string> &names)
{
    constexpr size_t most = 4;
    std::string out;
    for (size_t i = 0; i < std::min(most, names.size()); ++i) out += (i ? ", '" : "'") + names[i] + "'";
    return names.size() <= most ? out : out + " and " + std::to_string(names.size() - most) + " more";
}

void add_nodes(Scene &scene)
{
    add_node(scene, *scene.from.mRootNode, 0);
    if (!scene.sheared.empty())
        scene.warn((scene.sheared.size() == 1 ? "node " : "nodes ") + listed(scene.sheared) +
                   (scene.sheared.size() == 1 ? " is" : " are") +
                   " sheared, which nodes of glTF cannot be: written without, so what hangs there may look bent");
}

aiMatrix4x4 global_of(const aiNode &node)
{
    aiMatrix4x4 out = node.mTransformation;
    for (const aiNode *above = node.mParent; above; above = above->mParent) out = above->mTransformation * out;
    return out;
}

}  // namespace convert

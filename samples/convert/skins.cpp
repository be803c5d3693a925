// Assimp's bones as a skin of glTF, with all weights of each vertex, four a set.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "samples/convert/scene.h"

namespace convert
{
namespace
{

constexpr size_t most_joints = 65535;

void add_weights(Skin &skin, const aiBone &bone, uint16_t joint)
{
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        const aiVertexWeight &weight = bone.mWeights[w];
        if (weight.mVertexId >= skin.of_vertex.size() || !(weight.mWeight > 0)) continue;
        skin.of_vertex[weight.mVertexId].push_back({joint, weight.mWeight});
    }
}

float difference(const aiMatrix4x4 &a, const aiMatrix4x4 &b)
{
    float sum = 0;
    for (unsigned i = 0; i < 16; ++i) sum += std::fabs(a[i / 4][i % 4] - b[i / 4][i % 4]);
    return sum;
}

// Assimp names the node of a bone, and a file may have several armatures with a 'Bone' each. The bone is the node that
// leaves the mesh at its place at rest. Null: there is no node of that name.
const aiNode *node_of(const Scene &scene, const aiNode &mesh_node, const aiBone &bone)
{
    constexpr int most_compared = 64;
    auto [at, end] = scene.named.equal_range(bone.mName.C_Str());
    if (at == end || std::next(at) == end) return at == end ? nullptr : at->second;
    const aiMatrix4x4 place = global_of(mesh_node);
    const aiNode *nearest = at->second;
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; at != end && i < most_compared; ++at, ++i) {
        const float off = difference(global_of(*at->second) * bone.mOffsetMatrix, place);
        if (off < least) least = off, nearest = at->second;
    }
    return nearest;
}

}  // namespace

Skin skin_of(const Scene &scene, const aiNode &node, const aiMesh &mesh)
{
    Skin skin;
    skin.of_vertex.resize(mesh.mNumVertices);
    if (mesh.mNumBones + 1 > most_joints) throw std::runtime_error("a mesh of it has more bones than 65534");
    std::vector<const aiBone *> lost;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone &bone = *mesh.mBones[b];
        const aiNode *joint = node_of(scene, node, bone);
        if (!joint) {
            lost.push_back(&bone);
            continue;
        }
        skin.joints.push_back(joint);
        skin.inverse_binds.push_back(bone.mOffsetMatrix);
        add_weights(skin, bone, static_cast<uint16_t>(skin.joints.size() - 1));
    }
    // The joint that stands for the node itself. The node may be a bone, too: with another inverse bind matrix.
    const uint16_t own = static_cast<uint16_t>(skin.joints.size());
    bool own_is_used = !lost.empty();
    for (const aiBone *bone : lost) add_weights(skin, *bone, own);
    for (std::vector<Skin::Influence> &all : skin.of_vertex) {
        own_is_used = own_is_used || all.empty();
        if (all.empty()) all.push_back({own, 1});
        float sum = 0;
        for (const Skin::Influence &i : all) sum += i.weight;
        for (Skin::Influence &i : all) i.weight /= sum;
    }
    if (own_is_used) skin.joints.push_back(&node), skin.inverse_binds.emplace_back();
    return skin;
}

size_t add_skin(Scene &scene, const Skin &skin)
{
    Json joints = Json::array();
    std::vector<float> matrices;
    for (size_t j = 0; j < skin.joints.size(); ++j) {
        joints.push_back(scene.nodes.at(skin.joints[j]));
        for (unsigned column = 0; column < 4; ++column)
            for (unsigned row = 0; row < 4; ++row) matrices.push_back(skin.inverse_binds[j][row][column]);
    }
    return scene.glb.add("skins", {{"joints", joints}, {"inverseBindMatrices", scene.glb.floats("MAT4", matrices)}});
}

void add_influences(Scene &scene, const Skin &skin, Json &attributes)
{
    size_t most = 0;
    for (const auto &all : skin.of_vertex) most = std::max(most, all.size());
    for (size_t set = 0; 4 * set < most; ++set) {
        std::vector<uint16_t> joints;
        std::vector<float> weights;
        for (const auto &all : skin.of_vertex)
            for (size_t k = 4 * set; k < 4 * set + 4; ++k) {
                joints.push_back(k < all.size() ? all[k].joint : uint16_t(0));
                weights.push_back(k < all.size() ? all[k].weight : 0.0f);
            }
        attributes["JOINTS_" + std::to_string(set)] = scene.glb.joints(joints);
        attributes["WEIGHTS_" + std::to_string(set)] = scene.glb.floats("VEC4", weights);
    }
}

}  // namespace convert

// Assimp's meshes as primitives of glTF.
#include <cmath>

#include "samples/convert/scene.h"

namespace convert
{
namespace
{

std::vector<float> flat(const aiVector3D *from, unsigned count)
{
    std::vector<float> out;
    out.reserve(3 * size_t(count));
    for (unsigned i = 0; i < count; ++i)
        for (const float value : {from[i].x, from[i].y, from[i].z}) out.push_back(value);
    return out;
}

// Unit length, as glTF wants it; what has none points up.
std::vector<float> flat_normals(const aiMesh &mesh)
{
    std::vector<float> out = flat(mesh.mNormals, mesh.mNumVertices);
    for (size_t i = 0; i < out.size(); i += 3) {
        const float length = std::sqrt(out[i] * out[i] + out[i + 1] * out[i + 1] + out[i + 2] * out[i + 2]);
        const bool good = std::isfinite(length) && length > 0;
        for (size_t k = 0; k < 3; ++k) out[i + k] = good ? out[i + k] / length : k == 1 ? 1.0f : 0.0f;
    }
    return out;
}

// Assimp's v points up, that of glTF down.
std::vector<float> flat_uvs(const aiMesh &mesh)
{
    std::vector<float> out;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D &uv = mesh.mTextureCoords[0][i];
        const bool good = std::isfinite(uv.x) && std::isfinite(uv.y);
        out.push_back(good ? uv.x : 0);
        out.push_back(good ? 1 - uv.y : 0);
    }
    return out;
}

std::vector<uint32_t> flat_indices(const aiMesh &mesh)
{
    std::vector<uint32_t> out;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
        if (mesh.mFaces[f].mNumIndices == 3)
            out.insert(out.end(), mesh.mFaces[f].mIndices, mesh.mFaces[f].mIndices + 3);
    return out;
}

Json attributes_of(Scene &scene, const aiMesh &mesh)
{
    Json out = {{"POSITION", scene.glb.positions(flat(mesh.mVertices, mesh.mNumVertices))}};
    if (mesh.mNormals) out["NORMAL"] = scene.glb.floats("VEC3", flat_normals(mesh));
    if (mesh.mTextureCoords[0]) out["TEXCOORD_0"] = scene.glb.floats("VEC2", flat_uvs(mesh));
    return out;
}

void add_mesh(Scene &scene, const aiNode &node, const aiMesh &mesh)
{
    if (mesh.mNumAnimMeshes > 0)
        scene.warn("mesh '" + std::string(mesh.mName.C_Str()) + "' has morph targets, which are left out");
    Json primitive = {{"attributes", attributes_of(scene, mesh)},
                      {"indices", scene.glb.indices(flat_indices(mesh))},
                      {"material", mesh.mMaterialIndex}};
    const std::string name = mesh.mName.length ? mesh.mName.C_Str() : node.mName.C_Str();
    Json below = {{"name", name}};
    if (mesh.mNumBones > 0) {
        const Skin skin = skin_of(scene, node, mesh);
        add_influences(scene, skin, primitive["attributes"]);
        below["skin"] = add_skin(scene, skin);
    }
    below["mesh"] = scene.glb.add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
    const size_t index = scene.glb.add("nodes", below);
    Json &children = scene.glb.json["nodes"][scene.nodes.at(&node)]["children"];
    if (children.is_null()) children = Json::array();
    size_t meshes = 0;  // of this node, which stand before its children
    while (meshes < children.size() && scene.glb.json["nodes"][children[meshes].get<size_t>()].contains("mesh"))
        ++meshes;
    children.insert(children.begin() + static_cast<std::ptrdiff_t>(meshes), index);
}

}  // namespace

bool has_triangles(const aiMesh &mesh)
{
    return mesh.mNumVertices > 0 && mesh.mNumFaces > 0 && (mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE);
}

void add_meshes(Scene &scene)
{
    // By the order of the nodes, not of their addresses, so that one file gives one GLB.
    std::vector<const aiNode *> nodes(scene.nodes.size());
    for (const auto &[node, index] : scene.nodes) nodes[index] = node;
    for (const aiNode *node : nodes)
        for (unsigned m = 0; m < node->mNumMeshes; ++m) {
            const aiMesh &mesh = *scene.from.mMeshes[node->mMeshes[m]];
            if (has_triangles(mesh)) add_mesh(scene, *node, mesh);
        }
}

}  // namespace convert

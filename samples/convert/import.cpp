#include "samples/convert/import.h"

#include <cmath>
#include <stdexcept>

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/version.h>

#include "samples/convert/losses.h"
#include "samples/convert/scene.h"
#include "samples/io/files.h"
#include "samples/io/regular_file.h"

namespace convert
{
namespace
{

constexpr double pi = 3.14159265358979323846;

// Files may name others. Assimp 6 declares its own class final.
class RegularFiles : public Assimp::IOSystem
{
public:
    bool Exists(const char *file) const override { return files_.Exists(file); }
    char getOsSeparator() const override { return files_.getOsSeparator(); }
    void Close(Assimp::IOStream *stream) override { files_.Close(stream); }
    bool ComparePaths(const char *one, const char *second) const override { return files_.ComparePaths(one, second); }
    Assimp::IOStream *Open(const char *file, const char *mode) override
    {
        return io::RegularFile(file, io::most_file_bytes).wrong().empty() ? files_.Open(file, mode) : nullptr;
    }

private:
    Assimp::DefaultIOSystem files_;
};

void configure(Assimp::Importer &importer)
{
    // Each joint of an FBX file is one node, so that clips of other files find it by name.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
}

bool is_fbx(const aiScene &scene)
{
    aiString format;
    return scene.mMetaData && scene.mMetaData->Get("SourceAsset_Format", format) &&
           std::string(format.C_Str()).find("FBX") != std::string::npos;
}

// FBX files state their unit in centimetres. Assimp applies those of Collada, and the axes of most formats.
double unit_of(const aiScene &scene, const Options &options)
{
    if (options.unit_m > 0) return options.unit_m;
    if (!is_fbx(scene)) return 1;
    double factor = 1;
    float narrow = 1;
    if (!scene.mMetaData->Get("UnitScaleFactor", factor) && scene.mMetaData->Get("UnitScaleFactor", narrow))
        factor = double(narrow);
    return factor > 0 && std::isfinite(factor) ? 0.01 * factor : 0.01;
}

char up_of(const aiScene &scene, const Options &options)
{
    int axis = 1;
    if (options.up) return options.up;
    if (is_fbx(scene)) (void)scene.mMetaData->Get("UpAxis", axis);
    const bool turned = !scene.mRootNode->mTransformation.IsIdentity();
    return axis == 2 && !turned ? 'z' : axis == 0 && !turned ? 'x' : 'y';
}

// The lowest and the highest of the rest pose along an axis, in units of the file.
void extend(double &low, double &high, const aiVector3D &point, char up)
{
    const double value = double(up == 'z' ? point.z : up == 'x' ? point.x : point.y);
    low = std::fmin(low, value);
    high = std::fmax(high, value);
}

void extend_by_mesh(const Scene &scene, const aiNode &node, const aiMesh &mesh, char up, double &low, double &high)
{
    if (mesh.mNumBones == 0) {
        const aiMatrix4x4 matrix = global_of(node);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) extend(low, high, matrix * mesh.mVertices[v], up);
        return;
    }
    const Skin skin = skin_of(scene, node, mesh);
    std::vector<aiMatrix4x4> matrices;
    for (size_t j = 0; j < skin.joints.size(); ++j)
        matrices.push_back(global_of(*skin.joints[j]) * skin.inverse_binds[j]);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        aiVector3D at(0, 0, 0);
        for (const Skin::Influence &i : skin.of_vertex[v]) at += i.weight * (matrices[i.joint] * mesh.mVertices[v]);
        extend(low, high, at, up);
    }
}

void extend_by_node(const Scene &scene, const aiNode &node, char up, double &low, double &high)
{
    for (unsigned m = 0; m < node.mNumMeshes; ++m)
        extend_by_mesh(scene, node, *scene.from.mMeshes[node.mMeshes[m]], up, low, high);
    for (unsigned c = 0; c < node.mNumChildren; ++c) extend_by_node(scene, *node.mChildren[c], up, low, high);
}

double scale_of(const Scene &scene, char up)
{
    if (scene.options.height_m <= 0) return unit_of(scene.from, scene.options);
    double low = INFINITY, high = -INFINITY;
    extend_by_node(scene, *scene.from.mRootNode, up, low, high);
    if (!(high > low)) throw std::runtime_error("its rest pose has no height that could be scaled");
    return scene.options.height_m / (high - low);
}

// A node above all others turns and scales the scene, where that is needed.
void stand_up(Scene &scene)
{
    const char up = up_of(scene.from, scene.options);
    const double scale = scale_of(scene, up), half = std::sin(pi / 4);
    size_t root = scene.nodes.at(scene.from.mRootNode);
    if (up != 'y' || scale != 1) {
        Json above = {{"name", "claque convert"}, {"children", {root}}, {"scale", {scale, scale, scale}}};
        if (up == 'z') above["rotation"] = {-half, 0, 0, half};
        if (up == 'x') above["rotation"] = {0, 0, half, half};
        root = scene.glb.add("nodes", above);
    }
    scene.glb.add("scenes", {{"nodes", {root}}});
    scene.glb.json["scene"] = 0;
}

}  // namespace

unsigned import_steps()
{
    return aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
           aiProcess_JoinIdenticalVertices | aiProcess_FindInvalidData;
}

Converted import_file(const std::string &path, const Options &options)
{
    Assimp::Importer importer;
    configure(importer);
    importer.SetIOHandler(new RegularFiles);  // which the importer deletes
    const aiScene *read = importer.ReadFile(path, import_steps());
    if (!read || !read->mRootNode) {
        const std::string why = importer.GetErrorString();
        throw std::runtime_error(why.empty() ? "it finds no scene" : why);
    }
    Scene scene = {*read, options, path};
    if (!io::read_whole(path, scene.bytes, io::most_file_bytes).empty()) scene.bytes.clear();
    hang_below_parents(*read->mRootNode);
    for (std::string &loss : losses_in(scene.bytes)) scene.warn(std::move(loss));
    add_materials(scene);
    add_nodes(scene);
    add_meshes(scene);
    add_clips(scene);
    stand_up(scene);
    if (!scene.glb.json.contains("meshes") && !scene.glb.json.contains("animations"))
        throw std::runtime_error("it finds neither triangles nor clips");
    return {scene.glb.glb(), scene.warnings};
}

}  // namespace convert

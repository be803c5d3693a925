// A scene of Assimp on its way to GLB: what the steps share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <assimp/scene.h>

#include "samples/convert/convert.h"
#include "samples/convert/glb_writer.h"

namespace convert
{

struct Scene {
    const aiScene &from;
    const Options &options;
    std::string path;        // of the file
    std::string bytes = {};  // of the file; empty where they cannot be read
    GlbWriter glb = {};
    std::map<const aiNode *, size_t> nodes = {};            // their index in the GLB
    std::multimap<std::string, const aiNode *> named = {};  // those of one name: parents first
    std::vector<std::string> warnings = {};

    std::vector<std::string> sheared = {};  // nodes that lose their shear

    void warn(std::string text)
    {
        if (warnings.size() < 64) warnings.push_back(std::move(text));
    }
};

// The first few names in quotes, and how many more there are.
std::string listed(const std::vector<std::string> &names);

// Where the joints of one mesh on one node stand, and which vertices follow them.
struct Skin {
    std::vector<const aiNode *> joints;
    std::vector<aiMatrix4x4> inverse_binds;
    struct Influence {
        uint16_t joint;
        float weight;
    };
    std::vector<std::vector<Influence>> of_vertex;
};

// Hangs each node below the node that it names as its parent. Assimp 5.2 lists the bones of a Half-Life model side by
// side.
void hang_below_parents(aiNode &root);
// Nodes keep the order of Assimp's scene: a node's own meshes first, each as a node below it, then its children.
void add_nodes(Scene &scene);
void add_meshes(Scene &scene);
void add_clips(Scene &scene);
void add_materials(Scene &scene);

// A vertex without weights, and a bone whose node is missing, move with the mesh's node.
Skin skin_of(const Scene &scene, const aiNode &node, const aiMesh &mesh);
// A skin of the GLB, and the attributes of its vertices.
size_t add_skin(Scene &scene, const Skin &skin);
void add_influences(Scene &scene, const Skin &skin, Json &attributes);

bool has_triangles(const aiMesh &mesh);
aiMatrix4x4 global_of(const aiNode &node);

}  // namespace convert

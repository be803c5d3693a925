#include "samples/cli/reader_files.h"

#include "samples/cli/gltf_writer.h"

namespace cli
{
namespace readers
{
namespace
{

using Json = nlohmann::json;

Json channel(size_t node) { return {{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}; }
Json extras(const char *what, Json value) { return {{"claque", {{what, std::move(value)}}}}; }

std::string nodes(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i) file.node({{"name", "n" + std::to_string(i)}});
    return file.glb();
}

// Each the child of the one before.
std::string node_depth(uint32_t count)
{
    GltfFile file;
    size_t last = file.node({{"name", "top"}});
    for (uint32_t i = 0; i < count; ++i) {
        const size_t next = file.add("nodes", {{"name", "n" + std::to_string(i)}});
        file.json()["nodes"][last]["children"] = {next};
        last = next;
    }
    return file.glb();
}

std::string nodes_with_mesh(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i) file.node({{"mesh", 0}});
    return file.glb();
}

std::string meshes(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i) file.node({{"mesh", file.add("meshes", file.json()["meshes"][0])}});
    return file.glb();
}

std::string primitives(uint32_t count)
{
    GltfFile file;
    const Json one = file.primitive();
    for (uint32_t i = 0; i < count; ++i) file.json()["meshes"][0]["primitives"].push_back(one);
    return file.glb();
}

std::string vertices(uint32_t count)
{
    GltfFile file;
    std::vector<float> positions;
    for (uint32_t i = 0; i < 3 * count; ++i) positions.push_back(float(i % 977) * 0.01f + float(i % 3));
    file.primitive()["attributes"]["POSITION"] = file.floats("VEC3", positions);
    return file.glb();
}

std::string indices(uint32_t count)
{
    GltfFile file;
    std::vector<uint32_t> list;
    for (uint32_t i = 0; i < 3 * count; ++i) list.push_back(i % 3);
    file.primitive()["indices"] = file.accessor(gltf_uint, "SCALAR", list.size(), list.data(), 4 * list.size());
    return file.glb();
}

std::string accessors(uint32_t count)
{
    GltfFile file;
    const Json one = file.json()["accessors"][0];
    for (uint32_t i = 0; i < count; ++i) file.add("accessors", one);
    return file.glb();
}

std::string buffer_views(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i) file.add("bufferViews", {{"buffer", 0}, {"byteLength", 4}});
    return file.glb();
}

std::string buffers(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i)
        file.add("buffers", {{"uri", "data:application/octet-stream;base64,AAAA"}, {"byteLength", 3}});
    return file.glb();
}

std::string materials(uint32_t count)
{
    GltfFile file;
    const Json one = file.primitive();
    for (uint32_t i = 0; i < count; ++i) {
        Json with = one;
        with["material"] = file.add(
            "materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {i % 251 / 250.0, i % 7 / 6.0, 0.5, 1}}}}});
        file.json()["meshes"][0]["primitives"].push_back(with);
    }
    return file.glb();
}

std::string textures(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i) file.add("textures", {{"source", file.add("images", {{"uri", "none.png"}})}});
    return file.glb();
}

std::string skins(uint32_t count)
{
    GltfFile file;
    const size_t joint = file.node({{"name", "joint"}});
    for (uint32_t i = 0; i < count; ++i) file.add("skins", {{"joints", {joint}}});
    return file.glb();
}

void skin_primitive(GltfFile &file)
{
    const std::vector<uint8_t> joints(12);
    std::vector<float> weights(12);
    for (size_t v = 0; v < 3; ++v) weights[4 * v] = 1;
    file.primitive()["attributes"]["JOINTS_0"] = file.accessor(gltf_byte, "VEC4", 3, joints.data(), joints.size());
    file.primitive()["attributes"]["WEIGHTS_0"] = file.floats("VEC4", weights);
}

std::string joints(uint32_t count)
{
    GltfFile file;
    skin_primitive(file);
    Json list = Json::array();
    for (uint32_t i = 0; i < count; ++i) list.push_back(file.node({{"name", "j" + std::to_string(i)}}));
    file.add("skins", {{"joints", list}});
    file.json()["nodes"][0]["skin"] = 0;
    return file.glb();
}

std::string nodes_on_one_skin(uint32_t count)
{
    GltfFile file;
    skin_primitive(file);
    Json list = Json::array();
    for (uint32_t i = 0; i < count; ++i) list.push_back(file.node({{"mesh", 0}, {"skin", 0}}));
    file.add("skins", {{"joints", list}});
    return file.glb();
}

std::string animations(uint32_t count)
{
    GltfFile file;
    const size_t node = file.node({{"name", "moved"}});
    for (uint32_t i = 0; i < count; ++i) file.add("animations", file.clip(Json::array({channel(node)})));
    return file.glb();
}

std::string root_motions(uint32_t count)
{
    GltfFile file;
    const size_t node = file.node({{"name", "moved"}});
    for (uint32_t i = 0; i < count; ++i) {
        Json clip = file.clip(Json::array({channel(node)}));
        clip["extras"] = extras("root_motion", "moved");
        file.add("animations", clip);
    }
    return file.glb();
}

std::string channels(uint32_t count)
{
    GltfFile file;
    Json list = Json::array();
    for (uint32_t i = 0; i < count; ++i) list.push_back(channel(file.node({{"name", "n" + std::to_string(i)}})));
    file.add("animations", file.clip(list));
    return file.glb();
}

std::string keys(uint32_t count)
{
    GltfFile file;
    const size_t node = file.node({{"name", "moved"}});
    std::vector<float> times, places;
    for (uint32_t i = 0; i < count; ++i) {
        times.push_back(float(i) / 32);
        places.insert(places.end(), {float(i % 5), 0, float(i % 3)});
    }
    Json clip = file.clip(Json::array({channel(node)}));
    clip["samplers"][0] = {{"input", file.floats("SCALAR", times)}, {"output", file.floats("VEC3", places)}};
    file.add("animations", clip);
    return file.glb();
}

std::string morph_targets(uint32_t count)
{
    GltfFile file;
    const size_t deltas = file.floats("VEC3", GltfFile::triangle);
    Json &targets = file.primitive()["targets"] = Json::array();
    for (uint32_t i = 0; i < count; ++i) targets.push_back({{"POSITION", deltas}});
    return file.glb();
}

std::string markers(uint32_t count)
{
    GltfFile file;
    Json list = Json::array();
    for (uint32_t i = 0; i < count; ++i) list.push_back({{"time_s", 0.5}, {"name", "m" + std::to_string(i)}});
    Json clip = file.clip(Json::array({channel(file.node({{"name", "moved"}}))}));
    clip["extras"] = extras("markers", list);
    file.add("animations", clip);
    return file.glb();
}

Json dof(uint32_t i)
{
    return {{"kind", "rotation"}, {"axis", {0, 1, 0}}, {"min", -1}, {"max", 1}, {"name", "d" + std::to_string(i)}};
}

std::string degrees_of_freedom(uint32_t count)
{
    GltfFile file;
    for (uint32_t i = 0; i < count; ++i) file.node({{"extras", extras("dofs", Json::array({dof(i)}))}});
    return file.glb();
}

std::string bvh(uint32_t joints, uint32_t frames, const char *channels)
{
    std::string text = "HIERARCHY\nROOT root\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n";
    for (uint32_t i = 0; i < joints; ++i)
        text += "JOINT j" + std::to_string(i) + "\n{\nOFFSET 0 1 0\nCHANNELS " + channels +
                "\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n";
    text += "}\nMOTION\nFrames: " + std::to_string(frames) + "\nFrame Time: 0.03125\n";
    for (uint32_t f = 0; f < frames; ++f) text += "0 " + std::to_string(f % 7) + " 0\n";
    return text;
}

std::string bvh_joints(uint32_t count) { return bvh(count, 2, "0"); }
std::string bvh_frames(uint32_t count) { return bvh(1, count, "0"); }
std::string bvh_both(uint32_t count) { return bvh(count, count, "0"); }

}  // namespace

}  // namespace readers

std::vector<ReaderElement> reader_elements_of_assets()
{
    using namespace readers;
    return {
        {"glTF", "nodes", most_elements, nodes, read_asset},
        {"glTF", "nodes below one another", most_elements, node_depth, read_asset},
        {"glTF", "nodes with one mesh", most_elements, nodes_with_mesh, read_asset},
        {"glTF", "meshes", most_elements, meshes, read_asset},
        {"glTF", "primitives", most_elements, primitives, read_asset},
        {"glTF", "triangles", most_elements, vertices, read_asset},
        {"glTF", "triangles on one another", most_elements, indices, read_asset},
        {"glTF", "accessors", most_elements, accessors, read_asset},
        {"glTF", "buffer views", most_elements, buffer_views, read_asset},
        {"glTF", "buffers", most_elements, buffers, read_asset},
        {"glTF", "materials", most_elements, materials, read_asset},
        {"glTF", "textures and images", most_elements, textures, read_asset},
        {"glTF", "skins", most_elements, skins, read_asset},
        {"glTF", "joints", 65536, joints, read_asset},
        {"glTF", "nodes and joints of one skin", 65536, nodes_on_one_skin, read_asset},
        {"glTF", "animations", most_elements, animations, read_asset},
        {"glTF", "animations with root motion", most_elements, root_motions, read_asset},
        {"glTF", "channels", most_elements, channels, read_asset},
        {"glTF", "keys", most_elements, keys, read_asset},
        {"glTF", "morph targets", 65535, morph_targets, read_asset},
        {"glTF", "markers", 4096, markers, read_asset},
        {"glTF", "degrees of freedom", most_elements, degrees_of_freedom, read_asset},
        {"BVH", "joints", 4990, bvh_joints, read_clips},
        {"BVH", "frames", most_elements, bvh_frames, read_clips},
        {"BVH", "joints without channels, and frames", 4990, bvh_both, read_clips},
    };
}

std::string gltf_with_nodes(uint32_t count) { return readers::nodes(count); }
std::string gltf_with_triangles(uint32_t count) { return readers::vertices(count); }
std::string gltf_with_keys(uint32_t count) { return readers::keys(count); }
std::string gltf_with_channels(uint32_t count) { return readers::channels(count); }
std::string gltf_with_animations(uint32_t count) { return readers::animations(count); }
std::string gltf_with_markers(uint32_t count) { return readers::markers(count); }
std::string gltf_with_morph_targets(uint32_t count) { return readers::morph_targets(count); }
std::string gltf_with_degrees_of_freedom(uint32_t count) { return readers::degrees_of_freedom(count); }

}  // namespace cli

#include "attacks.h"

#include <cmath>

#include "../asset/png.h"

namespace claque::testing
{

namespace
{

Bytes bytes_of(const std::string &text) { return Bytes(text.begin(), text.end()); }

// A triangle on node 0, and `count` nodes in the scene besides.
Maker with_nodes(size_t count)
{
    Maker maker;
    maker.triangle();
    for (size_t i = 0; i < count; ++i) {
        maker.add("nodes", {{"name", "n" + std::to_string(i)}});
        maker.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    return maker;
}

Json channel(size_t sampler, size_t node, const char *path)
{
    return {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
}

Bytes data_uri_buffers(size_t count)
{
    Maker maker;
    for (size_t i = 0; i < count; ++i)
        maker.add("buffers", {{"uri", "data:application/octet-stream;base64,AAAA"}, {"byteLength", 3}});
    return maker.text();
}

Bytes root_motion_clips(size_t count)
{
    Maker maker = with_nodes(count);
    const int times = maker.floats("SCALAR", 2, {0, 1});
    const int values = maker.floats("VEC3", 2, {0, 0, 0, 1, 0, 0});
    const std::string last = "n" + std::to_string(count - 1);
    for (size_t i = 0; i < count; ++i)
        maker.add("animations", {{"channels", Json::array({channel(0, count, "translation")})},
                                 {"samplers", Json::array({{{"input", times}, {"output", values}}})},
                                 {"extras", {{"claque", {{"root_motion", last}}}}}});
    return maker.glb();
}

Bytes few_texels_on_one_view(size_t count) { return images_on_one_view(count, 64, false); }

// As many joints as nodes that the skin moves.
Bytes nodes_on_one_skin(size_t count)
{
    Maker maker = with_nodes(count);
    Json &attributes = maker.primitive()["attributes"];
    attributes["JOINTS_0"] = maker.accessor(u8, "VEC4", 3, Bytes(12, 0));
    attributes["WEIGHTS_0"] = maker.floats("VEC4", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    Json joints = Json::array();
    for (size_t i = 0; i < count; ++i) joints.push_back(i + 1);
    maker.add("skins", {{"joints", joints}});
    for (size_t i = 0; i < count; ++i) {
        maker.json["nodes"][i + 1]["mesh"] = 0;
        maker.json["nodes"][i + 1]["skin"] = 0;
    }
    return maker.glb();
}

Bytes degrees_of_freedom(size_t count)
{
    Maker maker = with_nodes(count);
    for (size_t i = 0; i < count; ++i) {
        const Json dof = {
            {"kind", "rotation"}, {"axis", {0, 1, 0}}, {"min", -1}, {"max", 1}, {"name", "d" + std::to_string(i)}};
        maker.json["nodes"][i + 1]["extras"]["claque"]["dofs"] = Json::array({dof});
    }
    return maker.glb();
}

Bytes joints_without_channels(size_t count)
{
    std::string text = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 0\n";
    for (size_t i = 0; i < count; ++i)
        text += "JOINT j" + std::to_string(i) + "\n{\nOFFSET 0 1 0\nCHANNELS 0\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n";
    return bytes_of(text + "}\nMOTION\nFrames: " + std::to_string(count) + "\nFrame Time: 0.01\n");
}

}  // namespace

Bytes shared_keys(size_t count)
{
    Maker maker = with_nodes(count);
    std::vector<float> times, values(3 * count, 0.5f);
    for (size_t i = 0; i < count; ++i) times.push_back(float(i) / 64);
    const int input = maker.floats("SCALAR", count, times), output = maker.floats("VEC3", count, values);
    Json channels = Json::array();
    for (size_t i = 0; i < count; ++i) channels.push_back(channel(0, i + 1, "translation"));
    maker.add("animations",
              {{"channels", channels}, {"samplers", Json::array({{{"input", input}, {"output", output}}})}});
    return maker.glb();
}

Bytes long_clips(size_t nodes, size_t clips, float length_s)
{
    Maker maker = with_nodes(nodes);
    const int times = maker.floats("SCALAR", 3, {0, 0.001f, length_s});
    const int places = maker.floats("VEC3", 3, {0, 0, 0, 0.1f, 0.2f, 0, 0.3f, 0, 0});
    const int turns = maker.floats("VEC4", 3, {0, 0, 0, 1, 0, 0.6f, 0, 0.8f, 0.6f, 0, 0, 0.8f});
    for (size_t c = 0; c < clips; ++c) {
        Json channels = Json::array();
        for (size_t i = 0; i < nodes; ++i)
            channels.push_back(channel(i % 2, i + 1, i % 2 ? "rotation" : "translation"));
        maker.add("animations", {{"channels", channels},
                                 {"samplers", Json::array({{{"input", times}, {"output", places}},
                                                           {{"input", times}, {"output", turns}}})}});
    }
    return maker.glb();
}

Bytes turning_wheels(size_t wheels, size_t corners, float length_s)
{
    Maker maker = with_nodes(wheels);
    std::vector<float> places;
    for (size_t i = 0; i < corners; ++i) {
        const float angle = 6.2831853f * float(i) / float(corners);
        places.insert(places.end(), {std::cos(angle), std::sin(angle), 0});
    }
    Bytes corners_of_triangles;
    for (size_t i = 2; i < corners; ++i)
        for (const size_t corner : {size_t(0), i - 1, i})
            corners_of_triangles.push_back(uint8_t(corner)), corners_of_triangles.push_back(uint8_t(corner >> 8));
    const int position = maker.floats("VEC3", corners, places);
    const int indices = maker.accessor(u16, "SCALAR", 3 * (corners - 2), corners_of_triangles);
    maker.add("meshes",
              {{"primitives", Json::array({{{"attributes", {{"POSITION", position}}}, {"indices", indices}}})}});
    const int times = maker.floats("SCALAR", 2, {0, length_s});
    const int turns = maker.floats("VEC4", 2, {0, 0, 0, 1, 0, 0, 1, 0});
    Json channels = Json::array();
    for (size_t i = 1; i <= wheels; ++i) {
        maker.json["nodes"][i]["mesh"] = 1;
        maker.json["nodes"][i]["translation"] = {3 * i, 0, 0};
        channels.push_back(channel(0, i, "rotation"));
    }
    maker.add("animations",
              {{"channels", channels}, {"samplers", Json::array({{{"input", times}, {"output", turns}}})}});
    return maker.glb();
}

Bytes tinted_images(size_t count, uint32_t side)
{
    Maker maker;
    maker.triangle();
    const int view = maker.view(make_png(side, side, 8, Bytes(side + 1, 0), side));
    const int uvs = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    maker.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    maker.add("textures", {{"source", 0}});
    maker.json["meshes"][0]["primitives"] = Json::array();
    for (size_t i = 0; i < count; ++i) {
        const double red = double(i + 1) / double(count);
        maker.add("materials", {{"pbrMetallicRoughness",
                                 {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {red, 1 - red, 0.5, 1}}}}});
        maker.json["meshes"][0]["primitives"].push_back(
            {{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", uvs}}}, {"material", i}});
    }
    return maker.glb();
}

Bytes images_on_one_view(size_t count, uint32_t side, bool extras)
{
    Maker maker;
    maker.triangle();
    const int view = maker.view(make_png(side, side, 8, Bytes(side + 1, 0), side));
    const int uvs = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    const Json primitive = {{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", uvs}}}};
    maker.json["meshes"][0]["primitives"] = Json::array();
    for (size_t i = 0; i < count; ++i) {
        maker.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
        if (extras) maker.json["images"][i]["extras"] = {{"number", i}};
        maker.add("textures", {{"source", i}});
        maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
        Json with = primitive;
        with["material"] = i;
        maker.json["meshes"][0]["primitives"].push_back(with);
    }
    return maker.glb();
}

Bytes clips_of_a_node_each(size_t count)
{
    Maker maker = with_nodes(count);
    const int times = maker.floats("SCALAR", 2, {0, 0.125f});
    const int values = maker.floats("VEC3", 2, {0, 0, 0, 1, 0, 0});
    for (size_t i = 0; i < count; ++i)
        maker.add("animations", {{"channels", Json::array({channel(0, i + 1, "translation")})},
                                 {"samplers", Json::array({{{"input", times}, {"output", values}}})}});
    return maker.glb();
}

Bytes long_root_motion(float length_s)
{
    Maker maker = with_nodes(1);
    const int times = maker.floats("SCALAR", 2, {0, length_s});
    const int values = maker.floats("VEC3", 2, {0, 0, 0, 1, 0, 0});
    maker.add("animations", {{"channels", Json::array({channel(0, 1, "translation")})},
                             {"samplers", Json::array({{{"input", times}, {"output", values}}})},
                             {"extras", {{"claque", {{"root_motion", "n0"}}}}}});
    return maker.glb();
}

const std::vector<Attack> &reader_attacks()
{
    static const std::vector<Attack> all = {{"buffers as data URIs", data_uri_buffers},
                                            {"clips with root motion", root_motion_clips},
                                            {"images on one buffer view", few_texels_on_one_view},
                                            {"nodes on one skin", nodes_on_one_skin},
                                            {"channels on the same keys", shared_keys},
                                            {"degrees of freedom", degrees_of_freedom},
                                            {"joints without channels", joints_without_channels, true}};
    return all;
}

}  // namespace claque::testing

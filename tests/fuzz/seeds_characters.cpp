// Small characters, one for each thing that files may hold.
#ifdef CLAQUE_HAS_DRACO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#pragma GCC diagnostic pop
#endif
#ifdef CLAQUE_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include <claque/assets.h>

#include <fstream>
#include <iterator>

#include "tests/api/small_template.h"
#include "tests/fuzz/seeds.h"
#include "tests/fuzz/shown.h"
#include "tests/support/written_characters.h"
#include "tests/support/written_encoding.h"
#include "tests/support/written_image.h"
#include "tests/support/written_motion.h"

namespace fuzzing
{
namespace
{

using namespace claque::testing;
using claque::testing::Bytes;

constexpr size_t max_bytes = 20000;

claque::testing::Bytes picture(uint8_t alpha)
{
    return png_of(4, 4, [&](uint32_t x, uint32_t y) {
        return Colour{uint8_t(60 * x), uint8_t(60 * y), 90, x < 2 ? alpha : uint8_t(255)};
    });
}

// A tube of two bones with a clip, markers, zones by keys, degrees of freedom and a morph target.
Maker limb()
{
    Maker maker;
    Surface surface =
        tube({{{0, 0, 0}, 0.1f, {{0, 1}}}, {{0, 0.5f, 0}, 0.2f, {{0, 0.5f}, {1, 0.5f}}}, {{0, 1, 0}, 0.1f, {{1, 1}}}},
             5, {0, 0, 1, 1});
    const int texture = add_texture(maker, picture(140));
    maker.json["images"][0]["extras"]["claque"]["zones"] = {{{"name", "tunic"},
                                                             {"key", 140},
                                                             {"colour", {0.9, 0.9, 0.8}},
                                                             {"hue_deg", {20, 50}},
                                                             {"saturation", {0.2, 0.4}},
                                                             {"brightness", {0.6, 1}}},
                                                            {{"name", "skin"}, {"key", 255}}};
    const int material = add_material(maker, "cloth", texture);
    Json primitive = primitive_of(maker, surface, material);
    const std::vector<Triple> moves(surface.positions.size(), {0, 0.1f, 0});
    primitive["targets"] = Json::array({{{"POSITION", add_triples(maker, moves)}}});
    maker.add("meshes", {{"primitives", Json::array({primitive})}, {"weights", {0.25}}});
    maker.json["nodes"] = {{{"name", "hips"},
                            {"children", {1}},
                            {"extras",
                             {{"claque",
                               {{"deactivation_m", 40},
                                {"dofs", Json::array({{{"name", "yaw"},
                                                       {"kind", "rotation"},
                                                       {"axis", {0, 1, 0}},
                                                       {"min", -0.7},
                                                       {"max", 0.7},
                                                       {"rest", 0}}})}}}}}},
                           {{"name", "tip"}, {"translation", {0, 0.5, 0}}, {"scale", {1, 1.5, 1}}},
                           {{"mesh", 0}, {"skin", 0}, {"extras", {{"claque", {{"lod_m", {0, 40}}}}}}}};
    const int binds = maker.floats("MAT4", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,     0, 1,
                                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.5f, 0, 1});
    maker.add("skins", {{"joints", {0, 1}}, {"inverseBindMatrices", binds}});
    maker.json["scenes"] = Json::array({{{"nodes", {0, 2}}}});
    ClipMaker clip(maker, "nod");
    clip.add(1, "rotation", "LINEAR", {0, 0.5f, 1}, turns({1, 0, 0}, {0, 40, 0}));
    clip.add(0, "translation", "STEP", {0, 1}, {0, 0, 0, 0, 0, 1});
    clip.add(2, "weights", "LINEAR", {0, 1}, {0, 1});
    clip.finish();
    maker.json["animations"][0]["extras"]["claque"] = {{"markers", Json::array({{{"name", "down"}, {"time_s", 0.25}}})},
                                                       {"root_motion", "hips"}};
    return maker;
}

Maker in_variants()
{
    Maker maker;
    maker.triangle();
    for (const uint8_t alpha : {255, 40})
        add_material(maker, alpha == 255 ? "day" : "night", add_texture(maker, picture(alpha)));
    maker.json["materials"][1]["alphaMode"] = "MASK";
    maker.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "night"}}, {{"name", "day"}}};
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    maker.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}}};
    return maker;
}

constexpr size_t across = 5, corners = across * across;

std::vector<float> grid_positions()
{
    std::vector<float> out;
    for (size_t i = 0; i < corners; ++i)
        for (const size_t value : {i % across, i / across, i % 3}) out.push_back(0.125f * static_cast<float>(value));
    return out;
}

std::vector<uint32_t> grid_indices()
{
    std::vector<uint32_t> out;
    for (size_t y = 0; y + 1 < across; ++y)
        for (size_t x = 0; x + 1 < across; ++x)
            for (const size_t i : {size_t(0), size_t(1), across, size_t(1), across + 1, across})
                out.push_back(static_cast<uint32_t>(y * across + x + i));
    return out;
}

#ifdef CLAQUE_HAS_DRACO
Maker in_draco(bool edgebreaker)
{
    const std::vector<float> positions = grid_positions();
    const std::vector<uint32_t> indices = grid_indices();
    draco::Mesh mesh;
    mesh.set_num_points(corners);
    for (size_t f = 0; f < indices.size(); f += 3)
        mesh.AddFace(
            {draco::PointIndex(indices[f]), draco::PointIndex(indices[f + 1]), draco::PointIndex(indices[f + 2])});
    draco::GeometryAttribute attribute;
    attribute.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int id = mesh.AddAttribute(attribute, true, corners);
    for (uint32_t v = 0; v < corners; ++v)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), &positions[3 * v]);
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
    Maker maker;
    maker.triangle();
    const int view = maker.view(Bytes(buffer.data(), buffer.data() + buffer.size()));
    maker.primitive()["attributes"]["POSITION"] =
        maker.add("accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", corners}});
    maker.primitive()["indices"] =
        maker.add("accessors", {{"componentType", u16}, {"type", "SCALAR"}, {"count", indices.size()}});
    maker.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                                     {"attributes", {{"POSITION", id}}}};
    maker.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return maker;
}
#endif

#ifdef CLAQUE_HAS_MESHOPT
int packed_view(Maker &maker, const Bytes &packed, size_t count, size_t stride, const char *mode)
{
    const int at = maker.view(packed);
    Json &view = maker.json["bufferViews"][static_cast<size_t>(at)];
    const Json place = {{"buffer", 0},
                        {"byteOffset", view["byteOffset"]},
                        {"byteLength", packed.size()},
                        {"byteStride", stride},
                        {"count", count},
                        {"mode", mode}};
    view = {{"buffer", 0}, {"byteLength", count * stride}, {"extensions", {{"EXT_meshopt_compression", place}}}};
    return at;
}

Maker in_meshopt()
{
    const std::vector<float> positions = grid_positions();
    const std::vector<uint32_t> indices = grid_indices();
    Maker maker;
    maker.triangle();
    Bytes vertices(meshopt_encodeVertexBufferBound(corners, 12));
    vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), positions.data(), corners, 12));
    Bytes triangles(meshopt_encodeIndexBufferBound(indices.size(), corners));
    triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), indices.data(), indices.size()));
    const int at = packed_view(maker, vertices, corners, 12, "ATTRIBUTES"),
              of = packed_view(maker, triangles, indices.size(), 4, "TRIANGLES");
    maker.primitive()["attributes"]["POSITION"] =
        maker.add("accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", corners}, {"bufferView", at}});
    maker.primitive()["indices"] = maker.add(
        "accessors", {{"componentType", u32}, {"type", "SCALAR"}, {"count", indices.size()}, {"bufferView", of}});
    maker.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    return maker;
}
#endif

const char bvh[] =
    "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
    "JOINT Leg\n{\nOFFSET 1 -2 0.5\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 -1 0\n}\n}\n"
    "JOINT Head\n{\nOFFSET 0 2 0\nCHANNELS 0\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: 3\nFrame Time: "
    "0.04\n0 1 0 0 0 0 0 0 0\n0.5 1 0 10 5 0 0 20 0\n1e0 1.5 -.5 0 90 0 -180 0 45.5\n";

void add_template(std::vector<Seed> &out, const char *name, clq_template *tmpl)
{
    const Bytes bytes = bytes_of(tmpl);
    if (bytes.size() <= max_bytes) out.push_back({"prepared", name, bytes});
    clq_template_destroy(tmpl);
}

}  // namespace

void add_character_seeds(std::vector<Seed> &out)
{
    for (const std::string &name : written::files()) {
        std::ifstream file(written::path_of(name, ""), std::ios::binary);
        const Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        if (bytes.size() <= max_bytes) out.push_back({"gltf", name, bytes});
    }
    const Maker moving = limb();
    Maker triangle;
    triangle.triangle();
    out.push_back({"gltf", "limb", moving.glb()});
    out.push_back({"gltf", "triangle", triangle.glb()});
    out.push_back({"gltf", "variants", in_variants().glb()});
#ifdef CLAQUE_HAS_DRACO
    out.push_back({"gltf", "draco", in_draco(false).glb()});
    out.push_back({"gltf", "edgebreaker", in_draco(true).glb()});
#endif
#ifdef CLAQUE_HAS_MESHOPT
    out.push_back({"gltf", "meshopt", in_meshopt().glb()});
#endif
    out.push_back({"bvh", "walker", Bytes(std::begin(bvh), std::end(bvh) - 1)});
    clq_context *context = new_context();
    clq_template *tmpl = nullptr;
    SmallTemplate small;
    EXPECT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_OK) << clq_last_error();
    add_template(out, "strip", tmpl);
    for (const auto &[name, maker] : {std::pair{"limb", moving}, {"variants", in_variants()}, {"triangle", triangle}}) {
        const Bytes bytes = maker.glb();
        clq_asset *asset = nullptr;
        if (done(clq_asset_load(context, bytes.data(), bytes.size(), nullptr, &asset), {}) &&
            done(clq_asset_build(context, asset, 0, &tmpl), {}))
            add_template(out, name, tmpl);
        clq_asset_destroy(asset);
    }
    end(context);
}

}  // namespace fuzzing

#include "packed.h"

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
#ifdef CLAQUE_HAS_WEBP
#include <webp/encode.h>
#endif

#include <cmath>

namespace claque::testing
{

namespace
{

struct Net {
    std::vector<float> positions;
    std::vector<uint32_t> indices;
    size_t vertices() const { return positions.size() / 3; }
    uint64_t bytes() const { return 4 * (positions.size() + indices.size()); }
};

[[maybe_unused]] Net net_of(size_t count)
{
    Net out;
    const uint32_t side = static_cast<uint32_t>(std::sqrt(double(count) / 2)) + 1;
    for (uint32_t i = 0; i < side * side; ++i) {
        const uint32_t x = i % side, y = i / side;
        out.positions.insert(out.positions.end(), {0.25f * float(x), 0.25f * float(y), float((x * x + y) % 5)});
        if (x + 1 == side || y + 1 == side) continue;
        for (const uint32_t corner : {i, i + 1, i + side, i + 1, i + side + 1, i + side}) out.indices.push_back(corner);
    }
    return out;
}

#ifdef CLAQUE_HAS_MESHOPT

// A view of the placeholder buffer 1, at its byte `at`, whose packed bytes lie in buffer 0.
int packed_view(Maker &maker, const Bytes &packed, uint64_t at, size_t count, size_t stride, const char *mode)
{
    const size_t raw = static_cast<size_t>(maker.view(packed));
    const Json extension = {{"buffer", 0},          {"byteOffset", maker.json["bufferViews"][raw]["byteOffset"]},
                            {"count", count},       {"byteLength", packed.size()},
                            {"byteStride", stride}, {"mode", mode}};
    return maker.add("bufferViews", {{"buffer", 1},
                                     {"byteOffset", at},
                                     {"byteLength", count * stride},
                                     {"extensions", {{"EXT_meshopt_compression", extension}}}});
}

#endif

}  // namespace

#ifdef CLAQUE_HAS_MESHOPT

PackedFile meshopt_sheet(size_t count)
{
    const Net net = net_of(count);
    Bytes vertices(meshopt_encodeVertexBufferBound(net.vertices(), 12)),
        indices(meshopt_encodeIndexBufferBound(net.indices.size(), net.vertices()));
    vertices.resize(
        meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), net.positions.data(), net.vertices(), 12));
    indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), net.indices.data(), net.indices.size()));
    Maker maker;
    maker.triangle();
    const int places = packed_view(maker, vertices, 0, net.vertices(), 12, "ATTRIBUTES");
    const int corners = packed_view(maker, indices, 12 * net.vertices(), net.indices.size(), 4, "TRIANGLES");
    maker.primitive()["attributes"]["POSITION"] = maker.add(
        "accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", net.vertices()}, {"bufferView", places}});
    maker.primitive()["indices"] =
        maker.add("accessors",
                  {{"componentType", u32}, {"type", "SCALAR"}, {"count", net.indices.size()}, {"bufferView", corners}});
    maker.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    maker.json["buffers"] = Json::array(
        {{{"byteLength", maker.binary.size()}},
         {{"byteLength", net.bytes()}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
    return {maker.glb(), net.bytes()};
}

#else

PackedFile meshopt_sheet(size_t) { return {}; }

#endif

#ifdef CLAQUE_HAS_DRACO

PackedFile draco_sheet(size_t count, bool edgebreaker, size_t spare)
{
    const Net net = net_of(count);
    const uint32_t vertices = static_cast<uint32_t>(net.vertices());
    draco::Mesh mesh;
    mesh.set_num_points(vertices);
    for (size_t f = 0; f < net.indices.size(); f += 3)
        mesh.AddFace({draco::PointIndex(net.indices[f]), draco::PointIndex(net.indices[f + 1]),
                      draco::PointIndex(net.indices[f + 2])});
    const auto add = [&](draco::GeometryAttribute::Type kind, draco::DataType type, size_t width, size_t bytes) {
        draco::GeometryAttribute attribute;
        attribute.Init(kind, nullptr, static_cast<int8_t>(width), type, false, static_cast<int64_t>(bytes), 0);
        return mesh.AddAttribute(attribute, true, vertices);
    };
    const int id = add(draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 3, 12);
    for (uint32_t v = 0; v < vertices; ++v)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), &net.positions[3 * size_t(v)]);
    const Bytes zeros(spare);
    const int more = spare ? add(draco::GeometryAttribute::GENERIC, draco::DT_UINT8, spare, spare) : id;
    for (uint32_t v = 0; v < vertices && spare; ++v)
        mesh.attribute(more)->SetAttributeValue(draco::AttributeValueIndex(v), zeros.data());
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
    encoder.SetAttributeQuantization(id, 12);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeToBuffer(&buffer).ok()) return {};
    Maker maker;
    maker.triangle();
    const int view = maker.view(Bytes(buffer.data(), buffer.data() + buffer.size()));
    maker.primitive()["attributes"]["POSITION"] =
        maker.add("accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", vertices}});
    maker.primitive()["indices"] =
        maker.add("accessors", {{"componentType", u32}, {"type", "SCALAR"}, {"count", net.indices.size()}});
    maker.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                                     {"attributes", {{"POSITION", id}}}};
    maker.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return {maker.glb(), net.bytes()};
}

#else

PackedFile draco_sheet(size_t, bool, size_t) { return {}; }

#endif

#ifdef CLAQUE_HAS_WEBP

PackedFile webp_square(uint32_t side)
{
    uint8_t *made = nullptr;
    Bytes texels(4 * size_t(side) * side, 255);
    for (size_t i = 0; i < texels.size(); i += 4) texels[i] = static_cast<uint8_t>(i / 4 % side / 64);
    const size_t size = WebPEncodeLosslessRGBA(texels.data(), static_cast<int>(side), static_cast<int>(side),
                                               static_cast<int>(4 * side), &made);
    Maker maker;
    maker.triangle();
    maker.add("images", {{"bufferView", maker.view(Bytes(made, made + size))}, {"mimeType", "image/webp"}});
    WebPFree(made);
    maker.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
    maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1, 0, 0, 1});
    maker.json["extensionsRequired"] = {"EXT_texture_webp"};
    return {maker.glb(), 0};
}

#else

PackedFile webp_square(uint32_t) { return {}; }

#endif

}  // namespace claque::testing

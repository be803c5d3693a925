#include "tests/support/written_encoding.h"

#include <algorithm>

namespace claque::testing
{
namespace
{

std::vector<float> flat(const std::vector<Triple> &values)
{
    std::vector<float> out;
    for (const Triple &value : values) out.insert(out.end(), value.begin(), value.end());
    return out;
}

void add_influences(Maker &maker, const Surface &surface, const InfluenceFormat &format, Json &attributes)
{
    const size_t count = surface.positions.size();
    for (size_t set = 0; set < format.sets; ++set) {
        const std::vector<uint16_t> joints = joints_of(surface, set);
        const std::vector<float> weights = weights_of(surface, set);
        const std::string number = std::to_string(set);
        attributes["JOINTS_" + number] = format.joints == u8
                                             ? maker.accessor(u8, "VEC4", count, Bytes(joints.begin(), joints.end()))
                                             : maker.accessor(u16, "VEC4", count, joints);
        const int accessor = format.weights == u8 ? maker.accessor(u8, "VEC4", count, normalized_of<uint8_t>(weights))
                             : format.weights == u16
                                 ? maker.accessor(u16, "VEC4", count, normalized_of<uint16_t>(weights))
                                 : maker.floats("VEC4", count, weights);
        if (format.weights != f32) maker.json["accessors"][static_cast<size_t>(accessor)]["normalized"] = true;
        attributes["WEIGHTS_" + number] = accessor;
    }
}

}  // namespace

int add_triples(Maker &maker, const std::vector<Triple> &values)
{
    const int index = maker.floats("VEC3", values.size(), flat(values));
    Triple low = values[0], high = values[0];
    for (const Triple &value : values)
        for (size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], value[k]), high[k] = std::max(high[k], value[k]);
    Json &accessor = maker.json["accessors"][static_cast<size_t>(index)];
    accessor["min"] = low, accessor["max"] = high;
    return index;
}

std::vector<uint16_t> joints_of(const Surface &surface, size_t set)
{
    std::vector<uint16_t> out;
    for (const std::vector<Influence> &influences : surface.influences)
        for (size_t k = 4 * set; k < 4 * set + 4; ++k)
            out.push_back(k < influences.size() ? influences[k].joint : uint16_t(0));
    return out;
}

std::vector<float> weights_of(const Surface &surface, size_t set)
{
    std::vector<float> out;
    for (const std::vector<Influence> &influences : surface.influences)
        for (size_t k = 4 * set; k < 4 * set + 4; ++k)
            out.push_back(k < influences.size() ? influences[k].weight : 0.0f);
    return out;
}

Json primitive_of(Maker &maker, const Surface &surface, int material, const InfluenceFormat &format)
{
    std::vector<float> uvs;
    for (const std::array<float, 2> &uv : surface.uvs) uvs.insert(uvs.end(), uv.begin(), uv.end());
    Json attributes = {{"POSITION", add_triples(maker, surface.positions)},
                       {"NORMAL", maker.floats("VEC3", surface.normals.size(), flat(surface.normals))},
                       {"TEXCOORD_0", maker.floats("VEC2", surface.uvs.size(), uvs)}};
    if (!surface.influences.empty()) add_influences(maker, surface, format, attributes);
    const std::vector<uint16_t> indices(surface.indices.begin(), surface.indices.end());
    return {{"attributes", attributes},
            {"indices", maker.accessor(u16, "SCALAR", indices.size(), indices)},
            {"material", material}};
}

int add_texture(Maker &maker, const Bytes &png)
{
    const int image = maker.add("images", {{"bufferView", maker.view(png)}, {"mimeType", "image/png"}});
    return maker.add("textures", {{"source", image}});
}

int add_material(Maker &maker, const char *name, int texture, std::array<float, 4> colour)
{
    Json look = {{"baseColorFactor", colour}};
    if (texture >= 0) look["baseColorTexture"] = {{"index", texture}};
    return maker.add("materials", {{"name", name}, {"pbrMetallicRoughness", look}});
}

std::string base64_of(const Bytes &bytes)
{
    const char *const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (int k = 3; k >= 0; --k) out += digits[bits >> (6 * k) & 63];
    }
    const size_t missing = (3 - bytes.size() % 3) % 3;
    return out.replace(out.size() - missing, missing, std::string(missing, '='));
}

}  // namespace claque::testing

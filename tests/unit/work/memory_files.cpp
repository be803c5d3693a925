#include "memory_files.h"

#include <cmath>

#include "../asset/png.h"

namespace claque::testing
{

Bytes sheet(size_t count, bool folded)
{
    Maker maker;
    maker.triangle();
    std::vector<float> positions, uvs;
    for (size_t i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const float step = folded ? 1e-4f : 1, x = float(i % 60) * step + float(k == 1);
            positions.insert(positions.end(), {x, float(i / 60) * step + float(k == 2), float(i % 7) * 1e-3f});
            uvs.insert(uvs.end(),
                       {float(i % 61) / 61 + 0.01f * float(k == 1), float(i % 59) / 59 + 0.01f * float(k == 2)});
        }
    Json &attributes = maker.primitive()["attributes"];
    attributes["POSITION"] = maker.floats("VEC3", 3 * count, positions);
    attributes["TEXCOORD_0"] = maker.floats("VEC2", 3 * count, uvs);
    maker.add("images", {{"bufferView", maker.view(make_png(64, 64, 8, Bytes(65, 3), 64))}, {"mimeType", "image/png"}});
    maker.add("textures", {{"source", 0}});
    maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    maker.primitive()["material"] = 0;
    return maker.glb();
}

Bytes moving_sheets(size_t count)
{
    Maker maker;
    maker.triangle();
    std::vector<float> positions;
    for (size_t i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k)
            positions.insert(positions.end(), {0.02f * (float(i % 60) + float(k == 1)),
                                               0.02f * (float(i / 60) + float(k == 2)), 0.3f * std::sin(float(i))});
    maker.primitive()["attributes"]["POSITION"] = maker.floats("VEC3", 3 * count, positions);
    maker.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 1}}});
    maker.json["scenes"][0]["nodes"].push_back(1);
    const int times = maker.floats("SCALAR", 2, {0, 1}), places = maker.floats("VEC3", 2, {0, 0, 1, 1, 0, 1});
    maker.add("animations",
              {{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}})},
               {"samplers", Json::array({{{"input", times}, {"output", places}}})}});
    return maker.glb();
}

Bytes nets(size_t count, size_t nodes)
{
    Maker maker;
    maker.triangle();
    const size_t side = static_cast<size_t>(std::sqrt(double(count) / 2)) + 1;
    std::vector<float> positions;
    std::vector<uint16_t> indices;
    for (size_t i = 0; i < side * side; ++i) {
        const float x = float(i % side), y = float(i / side);
        positions.insert(positions.end(), {x / float(side), y / float(side), 0.1f * std::sin(x) * std::cos(y)});
        if (i % side + 1 == side || i / side + 1 == side) continue;
        for (const size_t corner : {i, i + 1, i + side, i + 1, i + side + 1, i + side})
            indices.push_back(static_cast<uint16_t>(corner));
    }
    maker.primitive()["attributes"]["POSITION"] = maker.floats("VEC3", side * side, positions);
    maker.primitive()["indices"] = maker.accessor(u16, "SCALAR", indices.size(), indices);
    for (size_t i = 1; i < nodes; ++i) {
        maker.add("nodes", {{"mesh", 0}, {"translation", {i, 0, 0}}});
        maker.json["scenes"][0]["nodes"].push_back(i);
    }
    return maker.glb();
}

// Positions and texture coordinates of `count` triangles, for a file that names them and a picture beside it.
Bytes numbers_beside(size_t count)
{
    std::vector<float> numbers;
    for (size_t i = 0; i < 3 * count; ++i)
        numbers.insert(numbers.end(), {float(i / 3 % 60) + float(i % 3 == 1), float(i / 180) + float(i % 3 == 2), 0});
    for (size_t i = 0; i < 3 * count; ++i) numbers.insert(numbers.end(), {float(i % 61) / 61, float(i % 59) / 59});
    const auto *bytes = reinterpret_cast<const uint8_t *>(numbers.data());
    return Bytes(bytes, bytes + sizeof(float) * numbers.size());
}

Bytes named_files(size_t count)
{
    Maker maker;
    maker.triangle();
    maker.json.erase("accessors"), maker.json.erase("bufferViews"), maker.binary.clear();
    const size_t positions = 36 * count, uvs = 24 * count;
    maker.add("buffers", {{"uri", "numbers.bin"}, {"byteLength", positions + uvs}});
    maker.add("bufferViews", {{"buffer", 0}, {"byteLength", positions}});
    maker.add("bufferViews", {{"buffer", 0}, {"byteOffset", positions}, {"byteLength", uvs}});
    for (const int width : {3, 2})
        maker.add("accessors", {{"bufferView", 3 - width},
                                {"componentType", f32},
                                {"count", 3 * count},
                                {"type", "VEC" + std::to_string(width)}});
    maker.primitive() = {{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}, {"material", 0}};
    maker.add("images", {{"uri", "picture.png"}});
    maker.add("textures", {{"source", 0}});
    maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    return maker.text();
}

}  // namespace claque::testing

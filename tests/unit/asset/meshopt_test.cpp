// EXT_meshopt_compression, by files that libmeshoptimizer's encoder packs here.
#ifdef CLAQUE_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "decoder_test.h"
#include "lib/asset/meshopt.h"

namespace claque::testing
{
namespace
{

#ifdef CLAQUE_HAS_MESHOPT

constexpr size_t side = 20;

struct Grid {
    std::vector<float> positions, normals;  // normals: 8 bytes each once packed
    std::vector<uint32_t> indices;
};

Grid grid()
{
    Grid out;
    for (size_t y = 0; y < side; ++y)
        for (size_t x = 0; x < side; ++x) {
            const float fx = static_cast<float>(x), fy = static_cast<float>(y);
            for (const float value : {0.125f * fx, 0.25f * fy, 0.01f * fx * fy}) out.positions.push_back(value);
            const float length = std::sqrt(fx * fx + fy * fy + 100);
            for (const float value : {fx / length, fy / length, 10 / length, 0.0f}) out.normals.push_back(value);
        }
    for (size_t y = 0; y + 1 < side; ++y)
        for (size_t x = 0; x + 1 < side; ++x) {
            const uint32_t at = static_cast<uint32_t>(y * side + x), row = static_cast<uint32_t>(side);
            for (const uint32_t i : {at, at + 1, at + row, at + 1, at + row + 1, at + row}) out.indices.push_back(i);
        }
    return out;
}

// A view of the placeholder buffer 1 whose packed bytes lie in buffer 0.
int packed_view(Maker &maker, const Bytes &packed, size_t count, size_t stride, const char *mode, const char *filter)
{
    const int raw = maker.view(packed);
    Json &from = maker.json["bufferViews"][static_cast<size_t>(raw)];
    const Json extension = {{"buffer", 0},
                            {"byteOffset", from["byteOffset"]},
                            {"byteLength", packed.size()},
                            {"byteStride", stride},
                            {"count", count},
                            {"mode", mode},
                            {"filter", filter}};
    return maker.add(
        "bufferViews",
        {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{"EXT_meshopt_compression", extension}}}});
}

template <class T>
Bytes packed_vertices(const std::vector<T> &values, size_t count)
{
    const size_t stride = values.size() * sizeof(T) / count;
    Bytes out(meshopt_encodeVertexBufferBound(count, stride));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), values.data(), count, stride));
    return out;
}

struct Packed {
    Maker maker;
    Grid plain = grid();
    int position_view = 0, index_view = 0;

    Packed()
    {
        const size_t count = side * side, indices = plain.indices.size();
        maker.triangle();
        const Bytes vertices = packed_vertices(plain.positions, count);
        position_view = packed_view(maker, vertices, count, 12, "ATTRIBUTES", "NONE");
        std::vector<uint16_t> oct(4 * count);
        meshopt_encodeFilterOct(oct.data(), count, 8, 16, plain.normals.data());
        const int normal_view = packed_view(maker, packed_vertices(oct, count), count, 8, "ATTRIBUTES", "OCTAHEDRAL");
        maker.json["bufferViews"][static_cast<size_t>(normal_view)]["byteStride"] = 8;
        Bytes triangles(meshopt_encodeIndexBufferBound(indices, count));
        triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), plain.indices.data(), indices));
        index_view = packed_view(maker, triangles, indices, 4, "TRIANGLES", "NONE");
        Json &attributes = maker.primitive()["attributes"];
        attributes["POSITION"] = maker.add(
            "accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", count}, {"bufferView", position_view}});
        attributes["NORMAL"] = maker.add("accessors", {{"componentType", i16},
                                                       {"normalized", true},
                                                       {"type", "VEC3"},
                                                       {"count", count},
                                                       {"bufferView", normal_view}});
        maker.primitive()["indices"] = maker.add(
            "accessors", {{"componentType", u32}, {"type", "SCALAR"}, {"count", indices}, {"bufferView", index_view}});
        maker.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    }
    Bytes glb()
    {
        maker.json["buffers"] = Json::array(
            {{{"byteLength", maker.binary.size()}},
             {{"byteLength", 1 << 20}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
        return maker.glb();
    }
    Json &extension(int view)
    {
        return maker.json["bufferViews"][static_cast<size_t>(view)]["extensions"]["EXT_meshopt_compression"];
    }
};

// The corners of a triangle may be turned, so that its first is another.
std::vector<uint32_t> turned(std::vector<uint32_t> indices)
{
    for (size_t i = 0; i < indices.size(); i += 3)
        std::rotate(indices.begin() + static_cast<std::ptrdiff_t>(i),
                    std::min_element(&indices[i], &indices[i] + 3) - &indices[i] + indices.begin() +
                        static_cast<std::ptrdiff_t>(i),
                    indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    return indices;
}

TEST(Meshopt, UnpacksToWhatWasPacked)
{
    Packed packed;
    const model::Model model = load(packed.glb());
    ASSERT_EQ(model.parts.size(), 1u);
    const model::Part &part = model.parts[0];
    ASSERT_EQ(part.positions.size(), side * side);
    for (size_t i = 0; i < part.positions.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(part.positions[i][k], packed.plain.positions[3 * i + static_cast<size_t>(k)]) << i;
            EXPECT_NEAR(part.normals[i][k], packed.plain.normals[4 * i + static_cast<size_t>(k)], 1e-4f) << i;
        }
    const std::vector<uint32_t> indices(part.indices.begin(), part.indices.end());
    EXPECT_EQ(turned(indices), turned(packed.plain.indices));
}

TEST(Meshopt, WhatTheDecoderTakesForGrantedIsRefusedBeforeItRuns)
{
    const auto refusal = [](const std::function<void(Packed &)> &change) {
        Packed packed;
        change(packed);
        const Outcome outcome = outcome_of(packed.glb());
        EXPECT_EQ(outcome.status, CLQ_FORMAT) << outcome.text;
        return outcome.text;
    };
    const auto has = [](const std::string &text, const char *word) { return text.find(word) != std::string::npos; };
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.position_view)["byteStride"] = 10; }), "byteStride is 10"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.position_view)["count"] = 401; }), "unpacks to 4812"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.position_view)["count"] = 399; }), "unpacks to 4788"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.position_view)["filter"] = "QUATERNION"; }), "QUATERNION"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.position_view)["mode"] = "LINES"; }), "LINES"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.index_view)["byteStride"] = 12; }), "byteStride is 12"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.index_view)["count"] = 2165; }), "multiple of 3"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.index_view)["byteLength"] = 1 << 20; }), "ends at byte"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.index_view)["buffer"] = 7; }), "7"));
    EXPECT_TRUE(has(refusal([](Packed &p) { p.extension(p.index_view)["byteLength"] = 20; }), "20 packed bytes"));
}

// Each stride, count and filter of each mode: refused, or left to the decoder.
TEST(Meshopt, LayoutsAreThoseOfTheirModes)
{
    const auto fault = [](const char *mode, const char *filter, uint64_t stride, uint64_t count) -> std::string {
        const Json json = {{"buffer", 0},    {"byteLength", 8}, {"byteStride", stride},
                           {"count", count}, {"mode", mode},    {"filter", filter}};
        const Outcome found =
            outcome_of([&] { asset::read_meshopt_view(asset::JsonView(&json, "view"), 1, stride * count); });
        EXPECT_EQ(found.text.empty(), found.status == 0);
        for (const char *word : {"byteStride", "count", "filter"})
            if (found.text.find(std::string("view.") + word) == 0) return word;
        return found.text;
    };
    for (uint64_t stride = 1; stride <= 256; ++stride) {
        EXPECT_EQ(fault("ATTRIBUTES", "NONE", stride, 5), stride % 4 == 0 ? "" : "byteStride") << stride;
        for (const char *mode : {"TRIANGLES", "INDICES"})
            EXPECT_EQ(fault(mode, "NONE", stride, 6), stride == 2 || stride == 4 ? "" : "byteStride") << stride;
        if (stride % 4 != 0) continue;
        EXPECT_EQ(fault("ATTRIBUTES", "OCTAHEDRAL", stride, 5), stride == 4 || stride == 8 ? "" : "filter") << stride;
        EXPECT_EQ(fault("ATTRIBUTES", "QUATERNION", stride, 5), stride == 8 ? "" : "filter") << stride;
        EXPECT_EQ(fault("ATTRIBUTES", "EXPONENTIAL", stride, 5), "") << stride;
    }
    for (const uint64_t count : {1, 2, 3, 4, 5, 6}) {
        EXPECT_EQ(fault("TRIANGLES", "NONE", 4, count), count % 3 == 0 ? "" : "count") << count;
        EXPECT_EQ(fault("INDICES", "NONE", 4, count), "") << count;
    }
    for (const char *mode : {"TRIANGLES", "INDICES"})
        for (const char *filter : {"OCTAHEDRAL", "EXPONENTIAL"})
            EXPECT_EQ(fault(mode, filter, 4, 6), "filter") << mode << filter;
}

TEST(Meshopt, SaysHowMuchItWouldUnpackBeforeItDoes)
{
    Packed packed;
    const uint64_t count = 1u << 28;
    packed.extension(packed.position_view)["count"] = count;
    packed.maker.json["bufferViews"][static_cast<size_t>(packed.position_view)]["byteLength"] = 12 * count;
    packed.maker.json["accessors"][1]["count"] = 1;
    packed.glb();
    packed.maker.json["buffers"][1]["byteLength"] = 12 * count;
    const Outcome outcome = outcome_of(packed.maker.glb());
    EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
}

TEST(Meshopt, IndicesThatPointBeyondTheVerticesAreRefused)
{
    Packed packed;
    const size_t accessor = packed.maker.primitive()["attributes"]["POSITION"].get<size_t>();
    packed.maker.json["accessors"][accessor]["count"] = 100;
    packed.maker.primitive()["attributes"].erase("NORMAL");
    const Outcome outcome = outcome_of(packed.glb());
    EXPECT_EQ(outcome.status, CLQ_FORMAT);
    EXPECT_NE(outcome.text.find("the primitive has 100 vertices"), std::string::npos) << outcome.text;
}

TEST(Meshopt, DamagedStreamsGiveASentence)
{
    Packed packed;
    const Bytes glb = packed.glb();
    const size_t size = packed.maker.binary.size();
    expect_sentences(glb, glb.size() - (size + 3) / 4 * 4, size, 3000, 1);
}

#endif

}  // namespace
}  // namespace claque::testing

// Binary FBX written here: the colours of its materials become those that its exporter meant.
#include <array>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "samples/convert/convert.h"
#include "tests/cli/run.h"

namespace convert_test
{
namespace
{

template <class T>
std::string raw(T value)
{
    return std::string(reinterpret_cast<const char *>(&value), sizeof value);
}

struct FbxValue {
    std::string bytes;
    FbxValue(int value) : bytes("I" + raw<int32_t>(value)) {}
    FbxValue(int64_t id) : bytes("L" + raw(id)) {}
    FbxValue(double value) : bytes("D" + raw(value)) {}
    FbxValue(const char *text) : FbxValue(std::string(text)) {}
    FbxValue(const std::string &text) : bytes("S" + raw(static_cast<uint32_t>(text.size())) + text) {}
    template <class T>
    FbxValue(char type, const std::vector<T> &values)
        : bytes(type + raw(static_cast<uint32_t>(values.size())) + raw(uint32_t(0)) +
                raw(static_cast<uint32_t>(values.size() * sizeof(T))))
    {
        for (const T &value : values) bytes += raw(value);
    }
};

struct FbxNode {
    std::string name;
    std::vector<FbxValue> values;
    std::vector<FbxNode> below;
};

// A node's head says where it ends in the file.
void write(std::string &out, const FbxNode &node)
{
    const size_t head = out.size();
    std::string values;
    for (const FbxValue &value : node.values) values += value.bytes;
    out += std::string(12, '\0') + static_cast<char>(node.name.size()) + node.name + values;
    for (const FbxNode &one : node.below) write(out, one);
    if (!node.below.empty()) out += std::string(13, '\0');
    out.replace(head, 12,
                raw(static_cast<uint32_t>(out.size())) + raw(static_cast<uint32_t>(node.values.size())) +
                    raw(static_cast<uint32_t>(values.size())));
}

FbxNode material(int64_t id, const std::string &name, std::array<double, 3> colour, double factor)
{
    const FbxNode diffuse = {"P", {"DiffuseColor", "Color", "", "A", colour[0], colour[1], colour[2]}, {}},
                  dimmed = {"P", {"DiffuseFactor", "Number", "", "A", factor}, {}};
    return {"Material",
            {id, name + std::string("\0\1Material", 10), ""},
            {{"ShadingModel", {"Lambert"}, {}}, {"Properties70", {}, {diffuse, dimmed}}}};
}

// Two triangles of two materials; the name of one ends with the other's.
std::string fbx_by(const std::string &creator, const std::string &last_saved_by)
{
    const std::string geometry("square\0\1Geometry", 16), model("square\0\1Model", 13);
    const FbxNode by_triangle = {"LayerElementMaterial",
                                 {0},
                                 {{"MappingInformationType", {"ByPolygon"}, {}},
                                  {"ReferenceInformationType", {"IndexToDirect"}, {}},
                                  {"Materials", {{'i', std::vector<int32_t>{0, 1}}}, {}}}};
    const FbxNode layer = {
        "Layer", {0}, {{"LayerElement", {}, {{"Type", {"LayerElementMaterial"}, {}}, {"TypedIndex", {0}, {}}}}}};
    const auto link = [](int64_t from, int64_t to) { return FbxNode{"C", {"OO", from, to}, {}}; };
    const std::vector<FbxNode> all = {
        {"FBXHeaderExtension",
         {},
         {{"FBXVersion", {7400}, {}},
          {"Creator", {creator}, {}},
          {"SceneInfo",
           {"GlobalInfo"},
           {{"Properties70", {}, {{"P", {"LastSaved|ApplicationName", "KString", "", "", last_saved_by}, {}}}}}}}},
        {"GlobalSettings", {}, {{"Version", {1000}, {}}, {"Properties70", {}, {}}}},
        {"Definitions", {}, {{"Version", {100}, {}}}},
        {"Objects",
         {},
         {{"Geometry",
           {int64_t(1), geometry, "Mesh"},
           {{"Vertices", {{'d', std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}}}, {}},
            {"PolygonVertexIndex", {{'i', std::vector<int32_t>{0, 1, -3, 0, 2, -4}}}, {}},
            by_triangle,
            layer}},
          {"Model", {int64_t(2), model, "Mesh"}, {{"Version", {232}, {}}}},
          material(3, "DarkSkin", {0.094, 0.051, 0.024}, 0.8),
          material(4, "Skin", {0.359, 0.275, 0.141}, 0.8)}},
        {"Connections", {}, {link(1, 2), link(2, 0), link(3, 2), link(4, 2)}}};
    std::string out = std::string("Kaydara FBX Binary  \0\x1a\0", 23) + raw(uint32_t(7400));
    for (const FbxNode &node : all) write(out, node);
    return out + std::string(13, '\0');
}

struct FbxColours : cli_test::Command {
    void expect_colour(const std::string &creator, const std::string &name, std::array<double, 3> wanted,
                       const std::string &last_saved_by = "")
    {
        std::ofstream(path("square.fbx"), std::ios::binary) << fbx_by(creator, last_saved_by);
        const std::string glb = convert::convert_file(path("square.fbx"), {}, {}).glb;
        uint32_t size = 0;
        std::memcpy(&size, &glb.at(12), 4);
        const nlohmann::json json = nlohmann::json::parse(glb.substr(20, size));
        size_t seen = 0;
        for (const nlohmann::json &one : json.at("materials")) {
            if (one.at("name") != name) continue;
            const nlohmann::json &factor = one.at("pbrMetallicRoughness").at("baseColorFactor");
            for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(factor.at(k).get<double>(), wanted[k], 1e-6) << creator << k;
            ++seen;
        }
        EXPECT_EQ(seen, 1u) << name;
    }
};

TEST_F(FbxColours, OfBlenderAreLightAndIgnoreTheFactor)
{
    for (const char *version : {"2.79 (sub 0) - 3.7.17", "4.2.1 - 5.12.4"}) {
        const std::string blender = std::string("Blender (stable FBX IO) - ") + version;
        expect_colour(blender, "Skin", {0.359, 0.275, 0.141});
        expect_colour(blender, "DarkSkin", {0.094, 0.051, 0.024});
    }
}

// Mixamo writes the colours of the file that it was sent.
TEST_F(FbxColours, OfBlenderStayLightWhereAnotherProgramWritesTheFile)
{
    const std::string sdk = "FBX SDK/FBX Plugins version 2020.2";
    expect_colour(sdk, "Skin", {0.359, 0.275, 0.141}, "Blender (stable FBX IO)");
    expect_colour(sdk, "Skin", {0.0670604, 0.0396819, 0.0121254}, "Maya");
}

// 0.8 * (0.359, 0.275, 0.141), from sRGB to light.
TEST_F(FbxColours, OfOtherExportersAreDisplayedAndTakeTheFactor)
{
    expect_colour("FBX SDK/FBX Plugins version 2020.2", "Skin", {0.0670604, 0.0396819, 0.0121254});
}

}  // namespace
}  // namespace convert_test

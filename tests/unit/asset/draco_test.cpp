// KHR_draco_mesh_compression, by files that libdraco's encoder packs here.
#ifdef CLAQUE_HAS_DRACO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#pragma GCC diagnostic pop
#endif

#include <set>

#include "decoder_test.h"
#include "lib/asset/draco_decode.h"

namespace claque::testing
{
namespace
{

#ifdef CLAQUE_HAS_DRACO

constexpr uint32_t across = 15, corners = across * across;

struct Sheet {
    std::vector<float> positions;
    std::vector<uint8_t> joints;
    std::vector<uint32_t> indices;
};

Sheet sheet()
{
    Sheet out;
    for (uint32_t i = 0; i < corners; ++i) {
        const float x = static_cast<float>(i % across), y = static_cast<float>(i / across);
        for (const float value : {0.125f * x, 0.25f * y, 0.03125f * x * y}) out.positions.push_back(value);
        for (const uint32_t k : {0u, 1u, 2u, 3u}) out.joints.push_back(static_cast<uint8_t>((i + k) % 7));
    }
    for (uint32_t y = 0; y + 1 < across; ++y)
        for (uint32_t x = 0; x + 1 < across; ++x) {
            const uint32_t at = y * across + x;
            for (const uint32_t i : {at, at + 1, at + across, at + 1, at + across + 1, at + across})
                out.indices.push_back(i);
        }
    return out;
}

template <class T>
int add_attribute(draco::Mesh &mesh, draco::GeometryAttribute::Type kind, draco::DataType type,
                  const std::vector<T> &from)
{
    const int8_t width = static_cast<int8_t>(from.size() / corners);
    draco::GeometryAttribute attribute;
    attribute.Init(kind, nullptr, width, type, false, static_cast<int64_t>(sizeof(T)) * width, 0);
    const int id = mesh.AddAttribute(attribute, true, corners);
    for (uint32_t v = 0; v < corners; ++v)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), &from[v * static_cast<size_t>(width)]);
    return id;
}

Bytes packed_of(const Sheet &from, bool edgebreaker, int &positions, int &joints, int others = 0)
{
    draco::Mesh mesh;
    mesh.set_num_points(corners);
    for (size_t f = 0; f < from.indices.size() / 3; ++f)
        mesh.AddFace({draco::PointIndex(from.indices[3 * f]), draco::PointIndex(from.indices[3 * f + 1]),
                      draco::PointIndex(from.indices[3 * f + 2])});
    positions = add_attribute(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, from.positions);
    joints = add_attribute(mesh, draco::GeometryAttribute::GENERIC, draco::DT_UINT8, from.joints);
    for (int i = 0; i < others; ++i)
        add_attribute(mesh, draco::GeometryAttribute::GENERIC, draco::DT_UINT8, from.joints);
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
    return Bytes(buffer.data(), buffer.data() + buffer.size());
}

struct DracoFile {
    Maker maker;
    Sheet plain = sheet();
    size_t first = 0, size = 0;  // of the stream in the binary chunk

    explicit DracoFile(bool edgebreaker)
    {
        int positions = 0, joints = 0;
        const Bytes packed = packed_of(plain, edgebreaker, positions, joints);
        maker.triangle();
        const int view = maker.view(packed);
        first = maker.json["bufferViews"][static_cast<size_t>(view)]["byteOffset"];
        size = packed.size();
        Json &attributes = maker.primitive()["attributes"];
        attributes["POSITION"] = maker.add("accessors", {{"componentType", f32}, {"type", "VEC3"}, {"count", corners}});
        attributes["JOINTS_0"] = maker.add("accessors", {{"componentType", u8}, {"type", "VEC4"}, {"count", corners}});
        attributes["WEIGHTS_0"] = maker.floats("VEC4", corners, std::vector<float>(4 * corners, 0.25f));
        maker.primitive()["indices"] =
            maker.add("accessors", {{"componentType", u16}, {"type", "SCALAR"}, {"count", plain.indices.size()}});
        maker.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
            {"bufferView", view}, {"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}}}};
        maker.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    }
    Json &accessor(const char *name)
    {
        Json &primitive = maker.primitive();
        const Json &index = primitive["attributes"].contains(name) ? primitive["attributes"][name] : primitive[name];
        return maker.json["accessors"][index.get<size_t>()];
    }
    Json &extension() { return maker.primitive()["extensions"]["KHR_draco_mesh_compression"]; }
};

// A triangle by its positions and joints, whatever the order of its corners and of the vertices.
using Corner = std::vector<float>;
std::multiset<std::set<Corner>> corner_sets_of(const model::Part &part)
{
    std::multiset<std::set<Corner>> out;
    for (size_t i = 0; i < part.indices.size(); i += 3) {
        std::set<Corner> triangle;
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t v = part.indices[i + k];
            Corner corner = {part.positions[v].x, part.positions[v].y, part.positions[v].z};
            for (uint32_t j = 0; j < part.influence_count; ++j)
                corner.push_back(static_cast<float>(part.joints[v * part.influence_count + j]));
            triangle.insert(corner);
        }
        out.insert(triangle);
    }
    return out;
}

std::multiset<std::set<Corner>> corner_sets_of(const Sheet &from)
{
    model::Part part;
    for (uint32_t v = 0; v < corners; ++v)
        part.positions.emplace_back(from.positions[3 * v], from.positions[3 * v + 1], from.positions[3 * v + 2]);
    part.indices.assign(from.indices.begin(), from.indices.end());
    part.joints.assign(from.joints.begin(), from.joints.end());
    part.influence_count = 4;
    return corner_sets_of(part);
}

// The file with a skin of seven joints, so that joints are kept.
Bytes skinned(DracoFile &file)
{
    Json joints = Json::array();
    for (int i = 0; i < 7; ++i) joints.push_back(file.maker.add("nodes", Json::object()));
    file.maker.add("skins", {{"joints", joints}});
    file.maker.json["nodes"][0]["skin"] = 0;
    for (const Json &joint : joints) file.maker.json["scenes"][0]["nodes"].push_back(joint);
    return file.maker.glb();
}

TEST(Draco, UnpacksToWhatWasPackedByBothMethods)
{
    for (const bool edgebreaker : {false, true}) {
        DracoFile file(edgebreaker);
        const model::Model model = load(skinned(file));
        ASSERT_EQ(model.parts.size(), 1u) << edgebreaker;
        EXPECT_EQ(model.parts[0].positions.size(), corners) << edgebreaker;
        EXPECT_EQ(corner_sets_of(model.parts[0]), corner_sets_of(file.plain)) << edgebreaker;
    }
}

TEST(Draco, AStreamThatDisagreesWithTheFileIsRefusedByItsNumbers)
{
    for (const bool edgebreaker : {false, true}) {
        const auto refusal = [&](const std::function<void(DracoFile &)> &change) {
            DracoFile file(edgebreaker);
            change(file);
            const Outcome outcome = outcome_of(skinned(file));
            EXPECT_EQ(outcome.status, CLQ_FORMAT) << outcome.text;
            return outcome.text;
        };
        const auto has = [](const std::string &text, const char *word) {
            EXPECT_NE(text.find(word), std::string::npos) << text;
        };
        has(refusal([](DracoFile &f) { f.accessor("indices")["count"] = 1170; }), "says 392 triangles, the file 390");
        has(refusal([](DracoFile &f) {
                for (const char *name : {"POSITION", "JOINTS_0", "WEIGHTS_0"}) f.accessor(name)["count"] = 224;
            }),
            "it has 225 vertices, the file says 224");
        has(refusal([](DracoFile &f) { f.accessor("JOINTS_0")["count"] = 224; }), "224");
        has(refusal([](DracoFile &f) { f.accessor("JOINTS_0")["type"] = "VEC3"; }), "4 numbers a vertex");
        has(refusal([](DracoFile &f) { f.extension()["attributes"]["JOINTS_0"] = 9; }), "no attribute 9");
        has(refusal([](DracoFile &f) { f.extension()["attributes"].erase("POSITION"); }), "POSITION is missing");
        has(refusal([](DracoFile &f) { f.maker.binary[f.first] = 'X'; }), "do not begin as a Draco stream");
        has(refusal([](DracoFile &f) { f.accessor("indices")["componentType"] = f32; }), "no unsigned integers");
    }
}

// The number of vertices stands before that of triangles in one method, and behind it in the other.
TEST(Draco, MoreVerticesThanTheTrianglesHaveCornersAreRefusedBeforeTheDecoderRuns)
{
    for (const bool edgebreaker : {false, true}) {
        DracoFile file(edgebreaker);
        const size_t at = file.first + (edgebreaker ? 12 : 13);  // behind the header; two bytes hold 225 and 392
        ASSERT_EQ(file.maker.binary[at], (225 & 127) | 128) << edgebreaker;
        file.maker.binary[at] = 255, file.maker.binary[at + 1] = 127;
        const Outcome outcome = outcome_of(skinned(file));
        EXPECT_EQ(outcome.status, CLQ_FORMAT) << edgebreaker;
        EXPECT_NE(outcome.text.find("it says 16383 vertices for 392 triangles"), std::string::npos) << outcome.text;
    }
}

// Twelve bytes for each number, which eight attributes that no reader asks for have, too.
TEST(Draco, AttributesThatTakeMoreThanIsLeftAreRefusedBeforeTheyAreUnpacked)
{
    const Sheet plain = sheet();
    for (const bool edgebreaker : {false, true}) {
        int positions = 0, joints = 0;
        const Bytes packed = packed_of(plain, edgebreaker, positions, joints, 8);
        const auto outcome_with = [&](uint64_t working_bytes) {
            asset::DracoMesh mesh;
            mesh.path = "sheet", mesh.vertex_count = corners, mesh.index_count = plain.indices.size();
            mesh.working_bytes = working_bytes;
            return outcome_of([&] { asset::decode_draco({packed.data(), packed.size()}, mesh); });
        };
        const uint64_t needed = corners * (3 + 9 * 4) * 12;
        EXPECT_EQ(outcome_with(needed).status, CLQ_OK) << outcome_with(needed).text;
        const Outcome outcome = outcome_with(needed - 1);
        EXPECT_EQ(outcome.status, CLQ_FORMAT) << edgebreaker;
        EXPECT_NE(outcome.text.find("its 39 numbers for each of 225 vertices would take more"), std::string::npos)
            << outcome.text;
    }
}

TEST(Draco, OtherVersionsAndModesAreUnsupportedByName)
{
    DracoFile old(true), strip(true);
    old.maker.binary[old.first + 6] = 1;
    strip.maker.primitive()["mode"] = 5;
    const Outcome version = outcome_of(old.maker.glb()), mode = outcome_of(strip.maker.glb());
    EXPECT_EQ(version.status, CLQ_UNSUPPORTED);
    EXPECT_NE(version.text.find("version 2.1"), std::string::npos) << version.text;
    EXPECT_EQ(mode.status, CLQ_UNSUPPORTED);
    EXPECT_NE(mode.text.find("mode 5"), std::string::npos) << mode.text;
}

TEST(Draco, CountsThatTheFileCannotHoldAreRefusedBeforeTheDecoderRuns)
{
    DracoFile file(true);
    file.accessor("indices")["count"] = 3000000000u;
    const Outcome outcome = outcome_of(file.maker.glb());
    EXPECT_EQ(outcome.status, CLQ_LIMIT) << outcome.text;
    EXPECT_NE(outcome.text.find("KHR_draco_mesh_compression would take 60000"), std::string::npos) << outcome.text;
}

TEST(Draco, DamagedStreamsGiveASentence)
{
    for (const bool edgebreaker : {false, true}) {
        DracoFile file(edgebreaker);
        const Bytes glb = skinned(file);
        const size_t binary = glb.size() - (file.maker.binary.size() + 3) / 4 * 4;
        expect_sentences(glb, binary + file.first, file.size, 4000, edgebreaker);
    }
}

#endif

}  // namespace
}  // namespace claque::testing

// Each rule of the frame of a glTF file, on both sides of its bound: header, version, views, accessors, counts.
#include <gtest/gtest.h>

#include "maker.h"
#include "png.h"

namespace claque::testing
{
namespace
{

void expect_said(const Outcome &found, const std::string &sentence, int status = CLQ_FORMAT)
{
    EXPECT_EQ(found.status, status) << found.text << "\nand not: " << sentence;
    EXPECT_NE(found.text.find(sentence), std::string::npos) << found.text << "\nand not: " << sentence;
}

Maker triangle()
{
    Maker maker;
    maker.triangle();
    return maker;
}

// The refusal of a triangle with a change.
using Change = std::function<void(Maker &)>;
Outcome of(const Change &change)
{
    Maker maker = triangle();
    change(maker);
    return outcome_of(maker.glb());
}

void put_word(Bytes &bytes, size_t at, size_t value)
{
    for (size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<uint8_t>(value >> (8 * k));
}

TEST(FileRules, OfTheHeaderOfAGlb)
{
    const Bytes good = triangle().glb();
    const auto with = [&](size_t size, size_t version, size_t says) {
        Bytes bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
        if (size >= 8) put_word(bytes, 4, version);
        if (size >= 12) put_word(bytes, 8, says);
        return outcome_of(bytes);
    };
    EXPECT_EQ(with(good.size(), 2, good.size()).text, "");
    expect_said(with(11, 2, 0), "the GLB header is cut off after 11 bytes of 12");
    expect_said(with(4, 2, 0), "the GLB header is cut off after 4 bytes of 12");
    expect_said(with(12, 2, 12), "the GLB has no JSON in it");
    expect_said(with(12, 2, 11), "the GLB header says 11 bytes, the file has 12");
    expect_said(with(12, 2, 13), "the GLB header says 13 bytes, the file has 12");
    for (const size_t version : {0, 1, 3})
        expect_said(with(good.size(), version, good.size()), "only version 2 is read", CLQ_UNSUPPORTED);
}

TEST(FileRules, OfVersions)
{
    const auto version = [](const char *member, const char *value) {
        return of([=](Maker &maker) { maker.json["asset"][member] = value; });
    };
    for (const char *read : {"2.0", "2.1", "2.99"}) EXPECT_EQ(version("version", read).text, "") << read;
    for (const char *other : {"0.2", "1.9", "3.0"})
        expect_said(version("version", other), "version 2 is read", CLQ_UNSUPPORTED);
    for (const char *least : {"2.0", "1.5", "0.0"}) EXPECT_EQ(version("minVersion", least).text, "") << least;
    for (const char *later : {"2.1", "3.0"})
        expect_said(version("minVersion", later), "the file asks for glTF ", CLQ_UNSUPPORTED);
    expect_said(of([](Maker &maker) { maker.json.erase("asset"); }), "asset.version is missing");
    expect_said(of([](Maker &maker) { maker.json["asset"] = "2.0"; }), "asset is string instead of an object");
    expect_said(outcome_of(triangle().glb_of("[1]")), "the document is array instead of an object");
}

TEST(FileRules, OfExtensions)
{
    const auto extensions = [](const char *list, const Json &names) {
        return of([&](Maker &maker) { maker.json[list] = names; });
    };
    for (const char *list : {"extensionsUsed", "extensionsRequired"}) {
        EXPECT_EQ(extensions(list, Json::array({"KHR_texture_transform", "KHR_materials_of_a_new_kind"})).text, "");
        expect_said(extensions(list, Json::array({"KHR_texture_transform", 3})),
                    std::string(list) + "[1] is number instead of");
    }
    const Json unknown = Json::array({"EXT_unheard_of"});
    EXPECT_EQ(extensions("extensionsUsed", unknown).text, "");
    expect_said(extensions("extensionsRequired", unknown), "the file requires the extension EXT_unheard_of",
                CLQ_UNSUPPORTED);
}

TEST(FileRules, OfViews)
{
    const auto view = [](const char *member, size_t more) {
        return of([=](Maker &maker) {
            const int added = maker.view(Bytes(8, 0));
            Json &number = maker.json["bufferViews"][static_cast<size_t>(added)][member];
            number = number.is_null() ? more : number.get<size_t>() + more;
        });
    };
    EXPECT_EQ(view("byteLength", 0).text, "");
    expect_said(view("byteLength", 1), "bufferViews[1] ends at byte 45 of buffer 0, which has 44");
    expect_said(view("byteOffset", 1), "bufferViews[1] ends at byte 45 of buffer 0, which has 44");
    EXPECT_EQ(view("byteStride", 4).text, "");
    EXPECT_EQ(view("byteStride", 252).text, "");
    for (const size_t stride : {5, 6, 7, 250})
        expect_said(view("byteStride", stride), "byteStride is " + std::to_string(stride) + ": not a multiple of 4");
}

TEST(FileRules, OfRangesOfAccessors)
{
    // The three positions, this far apart in a view of this length.
    const auto positions = [](size_t stride, size_t length) {
        return of([=](Maker &maker) {
            maker.binary.resize(64);
            maker.json["bufferViews"][0]["byteStride"] = stride, maker.json["bufferViews"][0]["byteLength"] = length;
        });
    };
    EXPECT_EQ(positions(12, 36).text, "");
    expect_said(positions(12, 35), "ends at byte 36 of buffer view 0, which has 35");
    EXPECT_EQ(positions(16, 44).text, "");
    expect_said(positions(16, 43), "ends at byte 44 of buffer view 0, which has 43");
    expect_said(positions(8, 64), "elements of 12 bytes stand 8 apart");
    // Three indices of two bytes, this far in their view, which is this far behind a multiple of 4.
    const auto indices = [](size_t offset, size_t view_offset) {
        return of([=](Maker &maker) {
            const int accessor = maker.accessor(u16, "SCALAR", 3, std::vector<uint16_t>(6, 0));
            maker.json["accessors"][static_cast<size_t>(accessor)]["byteOffset"] = offset;
            Json &view = maker.json["bufferViews"][1];
            view["byteOffset"] = 36 + view_offset, view["byteLength"] = 12 - view_offset;
            maker.primitive()["indices"] = accessor;
        });
    };
    for (const size_t offset : {0, 2, 4, 6}) EXPECT_EQ(indices(offset, 0).text, "") << offset;
    expect_said(indices(8, 0), "values: ends at byte 14 of buffer view 1, which has 12");
    EXPECT_EQ(indices(2, 2).text, "");
    expect_said(indices(1, 0), "values: starts at byte 1 of a view at byte 36: not a multiple of 2");
    expect_said(indices(0, 1), "values: starts at byte 0 of a view at byte 37: not a multiple of 2");
    expect_said(indices(1, 1), "values: starts at byte 1 of a view at byte 37: not a multiple of 2");
}

TEST(FileRules, OfWeightsOfNodes)
{
    const auto weights = [](const Json &node) {
        return of([&](Maker &maker) {
            maker.primitive()["targets"] = Json::array({{{"POSITION", 0}}, {{"POSITION", 0}}});
            maker.json["scenes"][0]["nodes"] = {0, maker.add("nodes", node)};
        });
    };
    EXPECT_EQ(weights({{"mesh", 0}, {"weights", {0.5, 0.5}}}).text, "");
    EXPECT_EQ(weights({{"mesh", 0}}).text, "");
    EXPECT_EQ(weights({{"name", "of no mesh"}, {"weights", {1, 1, 1}}}).text, "");
    expect_said(weights({{"mesh", 0}, {"weights", Json::array({1})}}),
                "nodes[1].weights has 1 numbers, its mesh has 2");
    expect_said(weights({{"mesh", 0}, {"weights", {1, 1, 1}}}), "nodes[1].weights has 3 numbers, its mesh has 2");
}

TEST(FileRules, OfCountsOfAttributes)
{
    const auto normals = [](size_t count) {
        return of([=](Maker &maker) {
            maker.primitive()["attributes"]["NORMAL"] = maker.floats("VEC3", count, std::vector<float>(3 * count, 1));
        });
    };
    const auto moved = [](size_t count) {
        return of([=](Maker &maker) {
            const int deltas = maker.floats("VEC3", count, std::vector<float>(3 * count, 1));
            maker.primitive()["targets"] = Json::array({{{"POSITION", deltas}}});
        });
    };
    EXPECT_EQ(normals(3).text, "");
    EXPECT_EQ(moved(3).text, "");
    for (const size_t count : {2, 4}) {
        const std::string counts = std::to_string(count) + " elements, the primitive has 3 positions";
        expect_said(normals(count), counts);
        expect_said(moved(count), counts);
    }
}

// Also those of looks that no material has.
TEST(FileRules, OfTexturesThatNothingShows)
{
    const auto looks = [](const char *list, const Json &element) {
        return of([&](Maker &maker) {
            maker.add("images", {{"bufferView", 0}});
            maker.add("samplers", Json::object());
            maker.add("textures", {{"source", 0}, {"sampler", 0}});
            maker.add(list, element);
        });
    };
    EXPECT_EQ(looks("samplers", Json::object()).text, "");
    for (const char *list : {"samplers", "textures", "images"})
        expect_said(looks(list, 3), std::string(list) + "[1] is number instead of an object");
    expect_said(looks("textures", {{"source", 1}}), "names image 1, which does not exist: there are 1");
    expect_said(looks("textures", {{"sampler", 1}}), "names sampler 1, which does not exist: there are 1");
    expect_said(looks("images", {{"bufferView", 1}}), "names buffer view 1, which does not exist: there are 1");
}

// What the model's own check finds is a fault of the file, not of the caller.
TEST(FileRules, OfModelsAreRulesOfFiles)
{
    Maker maker = triangle();
    maker.add("images", {{"bufferView", maker.view(make_png(2, 2, 8, {0, 10, 200}, 2))}, {"mimeType", "image/png"}});
    maker.add("textures", {{"source", 0}});
    maker.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    maker.primitive()["material"] = 0;
    maker.primitive()["attributes"]["TEXCOORD_0"] = maker.floats("VEC2", 3, {0, 0, 1e38f, 0, 0, 1});
    EXPECT_EQ(outcome_of(maker.glb()).text, "");
    maker.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
        {"scale", {10, 1}}};
    expect_said(outcome_of(maker.glb()), "texture coordinate that is not finite");
}

}  // namespace
}  // namespace claque::testing

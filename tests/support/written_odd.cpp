// Morph targets, odd transforms, odd topologies.
#include <cmath>

#include "tests/support/written_encoding.h"
#include "tests/support/written_files.h"
#include "tests/support/written_image.h"
#include "tests/support/written_motion.h"

namespace claque::testing
{
namespace
{

constexpr UvBox all_uv = {0.05f, 0.05f, 0.95f, 0.95f};

Bytes stripes()
{
    return png_of(8, 8, [](uint32_t x, uint32_t y) {
        return (x + y) % 3 == 0 ? Colour{200, 180, 40, 255} : Colour{uint8_t(30 * x), 90, uint8_t(25 * y), 255};
    });
}

// Embeds the buffer as a data URI.
void embed(Maker &maker)
{
    maker.json["buffers"] = Json::array({{{"byteLength", maker.binary.size()},
                                          {"uri", "data:application/octet-stream;base64," + base64_of(maker.binary)}}});
}

Surface head_shape()
{
    return tube({{{0, 0, 0}, 0, {}},
                 {{0, 0.03f, 0}, 0.2f, {}},
                 {{0, 0.2f, 0}, 0.3f, {}},
                 {{0, 0.4f, 0}, 0.32f, {}},
                 {{0, 0.55f, 0}, 0.2f, {}},
                 {{0, 0.6f, 0}, 0, {}}},
                9, all_uv);
}

// A target that moves and turns normals: chins drop, brows rise.
Json target_of(Maker &maker, const Surface &surface, float from, float to, float amount)
{
    std::vector<Triple> moves, bends;
    for (size_t v = 0; v < surface.positions.size(); ++v) {
        const float y = surface.positions[v][1];
        const float part = y < from || y > to ? 0.0f : amount;
        moves.push_back({part * 0.3f * surface.normals[v][0], part, -0.2f * part});
        bends.push_back({0, 0.5f * part, part});
    }
    return {{"POSITION", add_triples(maker, moves)}, {"NORMAL", add_triples(maker, bends)}};
}

std::vector<float> matrix_of(const std::vector<float> &rotation_by_rows, const Triple &scale, const Triple &place)
{
    std::vector<float> out;
    for (size_t column = 0; column < 3; ++column) {
        for (size_t row = 0; row < 3; ++row) out.push_back(rotation_by_rows[3 * row + column] * scale[column]);
        out.push_back(0);
    }
    out.insert(out.end(), {place[0], place[1], place[2], 1});
    return out;
}

int add_mesh(Maker &maker, const char *name, const Json &primitive)
{
    return maker.add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
}

}  // namespace

// Two heads of one mesh, the second mirrored and with weights of its own, and a neck that bends and swells at once.
WrittenFiles written_morph()
{
    Maker maker;
    const int texture = maker.add(
        "textures", {{"source", maker.add("images", {{"uri", "data:image/png;base64," + base64_of(stripes())}})}});
    const int face = add_material(maker, "face", texture),
              collar = add_material(maker, "collar", -1, {0.2f, 0.2f, 0.7f, 1});
    const Surface shape = head_shape();
    Json primitive = primitive_of(maker, shape, face);
    primitive["targets"] = {target_of(maker, shape, 0, 0.1f, -0.12f), target_of(maker, shape, 0.3f, 0.6f, 0.1f)};
    maker.add("meshes", {{"name", "head"}, {"weights", {0.25f, 0}}, {"primitives", Json::array({primitive})}});

    Surface neck = tube({{{0, -0.6f, 0}, 0, {{0, 1}}},
                         {{0, -0.58f, 0}, 0.12f, {{0, 1}}},
                         {{0, -0.4f, 0}, 0.1f, {{0, 0.7f}, {1, 0.3f}}},
                         {{0, -0.2f, 0}, 0.1f, {{0, 0.2f}, {1, 0.8f}}},
                         {{0, -0.07f, 0}, 0.12f, {{1, 1}}},
                         {{0, -0.05f, 0}, 0, {{1, 1}}}},
                        7, all_uv);
    Json bent = primitive_of(maker, neck, collar);
    Json swell = target_of(maker, neck, -0.45f, -0.15f, 0.2f);
    swell.erase("NORMAL");
    bent["targets"] = Json::array({swell});
    const int neck_mesh = add_mesh(maker, "neck", bent);

    // 0: the left head on the neck's upper joint; 1: the right one; 2 and 3: joints; 4: the neck.
    maker.add("nodes", {{"name", "left head"}, {"mesh", 0}, {"translation", {0, 0.35f, 0}}});
    maker.add("nodes", {{"name", "right head"},
                        {"mesh", 0},
                        {"weights", {-0.2f, 0.8f}},
                        {"translation", {1, 0, 0.1f}},
                        {"scale", {-1, 1.2f, 1}}});
    maker.add("nodes", {{"name", "shoulders"}, {"translation", {0, -0.6f, 0}}, {"children", Json::array({3})}});
    maker.add("nodes", {{"name", "nape"},
                        {"translation", {0, 0.25f, 0}},
                        {"rotation", turn({0, 0, 1}, 8)},
                        {"children", Json::array({0})}});
    maker.add("nodes", {{"name", "neck"}, {"mesh", neck_mesh}, {"skin", 0}});
    const std::vector<float> binds = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.6f,  0, 1,
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.35f, 0, 1};
    maker.add("skins", {{"joints", {2, 3}}, {"inverseBindMatrices", maker.floats("MAT4", 2, binds)}, {"skeleton", 2}});
    maker.json["scenes"] = Json::array({{{"nodes", {2, 1, 4}}}});

    ClipMaker talk(maker, "talk");
    talk.add(0, "weights", "LINEAR", {0, 0.3f, 0.9f, 1.2f}, {0.25f, 0, 1, 0.1f, 0.4f, 0.6f, 0.25f, 0});
    talk.add(1, "weights", "CUBICSPLINE", {0.1f, 0.6f, 1.2f},
             with_tangents({-0.2f, 0.8f, 0.7f, 0.1f, -0.2f, 0.8f}, 2, 0.7f));
    talk.add(3, "rotation", "LINEAR", {0, 0.6f, 1.2f}, turns({1, 0, 0.4f}, {0, 30, -10}));
    talk.finish();
    ClipMaker gasp(maker, "gasp");
    gasp.add(4, "weights", "STEP", {0.5f, 1, 1.5f}, {0, 1, 0.3f});
    gasp.add(1, "weights", "LINEAR", {0.5f, 1.5f}, {0, 0, 1, 1});
    gasp.add(2, "scale", "LINEAR", {0.5f, 1, 1.5f}, {1, 1, 1, 1.2f, 0.9f, 1.1f, 1, 1, 1});
    gasp.finish();
    embed(maker);
    return {{"WrittenMorph.gltf", maker.text()}};
}

// Transforms that shear, mirror and flatten, above rigid parts and above joints; a strip, a fan and triangles without
// indices and without normals; vertices without weights; a second scene, which is the one that is shown.
WrittenFiles written_odd()
{
    Maker maker;
    const int texture = add_texture(maker, stripes());
    const int board = add_material(maker, "board", texture),
              plain = add_material(maker, "plain", -1, {0.5f, 0.5f, 0.4f, 1});
    maker.json["materials"][static_cast<size_t>(plain)]["doubleSided"] = true;

    Json strip =
        primitive_of(maker, sheet({Triple{-1, 0, 0}, {1, 0, 0}, {1, 0.4f, 0.1f}, {-1, 0.4f, 0}}, 1, all_uv), board);
    strip["mode"] = 5, strip["indices"] = maker.accessor(u8, "SCALAR", 4, Bytes{0, 1, 2, 3});
    Json fan = primitive_of(
        maker, sheet({Triple{-0.5f, 0, 0.6f}, {0.5f, 0, 0.6f}, {0.5f, 0.5f, 0.7f}, {-0.5f, 0.5f, 0.7f}}, 1, all_uv),
        board);
    fan["mode"] = 6, fan["indices"] = maker.accessor(u32, "SCALAR", 4, std::vector<uint32_t>{0, 1, 3, 2});
    const Surface block = box({0, 0, 0}, {0.3f, 0.2f, 0.4f}, all_uv);
    std::vector<Triple> corners;
    for (const uint32_t index : block.indices) corners.push_back(block.positions[index]);
    const Json loose = {{"attributes", {{"POSITION", add_triples(maker, corners)}}}, {"material", plain}};
    Surface post = tube({{{0, 0, 0}, 0, {{0, 1}}},
                         {{0, 0.02f, 0}, 0.15f, {{0, 1}}},
                         {{0, 0.5f, 0}, 0.12f, {{0, 0.5f}, {1, 0.5f}}},
                         {{0, 0.9f, 0}, 0.1f, {{1, 1}}},
                         {{0, 1, 0}, 0, {{1, 0}}}},  // the tip has no weight at all
                        6, all_uv);
    const int flags = add_mesh(maker, "flags", strip), fans = add_mesh(maker, "fan", fan),
              blocks = add_mesh(maker, "block", loose),
              posts = add_mesh(maker, "post", primitive_of(maker, post, board));

    // Node 0 is in the other scene alone. 1 mirrors by a matrix and enlarges; below it 2 stretches, 3 turns within the
    // stretch, which shears 4. 5 flattens what is below it. 7 and 8 are joints under 6, which stretches and mirrors.
    maker.add("nodes", {{"name", "unseen"}, {"mesh", blocks}});
    maker.add(
        "nodes",
        {{"name", "mirror"},
         {"mesh", flags},
         {"children", {2, 5}},
         {"matrix", matrix_of({0.8f, 0, 0.6f, 0, 1, 0, -0.6f, 0, 0.8f}, {-1.5f, 1.5f, 1.5f}, {0.2f, 0.1f, -0.3f})}});
    maker.add(
        "nodes",
        {{"name", "stretch"}, {"scale", {1, 2, 0.5f}}, {"translation", {0, 0.8f, 0}}, {"children", Json::array({3})}});
    maker.add(
        "nodes",
        {{"name", "lean"}, {"mesh", blocks}, {"rotation", turn({0.3f, 0.2f, 1}, 35)}, {"children", Json::array({4})}});
    maker.add("nodes", {{"name", "sheared"},
                        {"mesh", fans},
                        {"translation", {0.4f, 0.3f, 0.9f}},
                        {"rotation", turn({1, 0, 0}, 50)},
                        {"scale", {1, -1, 1}}});
    maker.add("nodes",
              {{"name", "flat"}, {"mesh", flags}, {"scale", {0.7f, 0.7f, 0}}, {"translation", {0, -0.6f, 0.9f}}});
    maker.add("nodes", {{"name", "stilts"},
                        {"scale", {1.3f, 0.8f, -1}},
                        {"rotation", turn({0, 1, 0}, -40)},
                        {"translation", {2, 0, 0}},
                        {"children", Json::array({7})}});
    maker.add("nodes", {{"name", "low"}, {"rotation", turn({1, 0, 0}, 10)}, {"children", Json::array({8})}});
    maker.add("nodes", {{"name", "high"},
                        {"translation", {0, 0.5f, 0}},
                        {"rotation", {0, 0, 0.4f, 0.9f}},
                        {"scale", {1.5f, 1, 0.7f}}});
    maker.add("nodes", {{"name", "post"}, {"mesh", posts}, {"skin", 0}});
    const std::vector<float> binds = {1, 0, 0, 0, 0,    1, 0, 0, 0, 0, 1, 0, 0, 0,     0, 1,
                                      1, 0, 0, 0, 0.2f, 1, 0, 0, 0, 0, 1, 0, 0, -0.5f, 0, 1};
    maker.add("skins", {{"joints", {7, 8}}, {"inverseBindMatrices", maker.floats("MAT4", 2, binds)}});
    maker.json["scenes"] = Json::array({{{"nodes", Json::array({0})}}, {{"nodes", {1, 6, 9}}}});
    maker.json["scene"] = 1;

    ClipMaker turn_over(maker, "turn over");
    turn_over.add(3, "rotation", "LINEAR", {0, 0.5f, 1}, turns({0.3f, 0.2f, 1}, {35, 140, 35}));
    turn_over.add(2, "scale", "LINEAR", {0, 0.4f, 1}, {1, 2, 0.5f, 1.4f, 1.1f, 0.8f, 1, 2, 0.5f});
    turn_over.add(8, "rotation", "CUBICSPLINE", {0, 0.5f, 1}, with_tangents(turns({0, 0, 1}, {48, 10, 48}), 4, 0.6f));
    turn_over.finish();
    ClipMaker hop(maker, "hop");
    hop.add(6, "translation", "STEP", {1, 1.5f, 2}, {2, 0, 0, 2, 0.3f, 0, 2.2f, 0, 0.1f});
    hop.add(4, "translation", "LINEAR", {1, 2}, {0.4f, 0.3f, 0.9f, 0.1f, 0.4f, 1.1f});
    hop.add(7, "scale", "LINEAR", {1, 1.2f, 2}, {1, 1, 1, 0.8f, 1.3f, 0.9f, 1, 1, 1});
    hop.finish();
    embed(maker);
    return {{"WrittenOdd.gltf", maker.text()}};
}

// No triangle at all: a cloud of points and a frame of lines, which move.
WrittenFiles written_lines()
{
    Maker maker;
    const std::vector<Triple> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}};
    const int positions = add_triples(maker, corners);
    Json primitives = Json::array();
    for (const int mode : {0, 1, 2}) primitives.push_back({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
    maker.add("meshes", {{"name", "frame"}, {"primitives", primitives}});
    maker.add("nodes", {{"name", "frame"}, {"mesh", 0}, {"scale", {1, 2, 1}}});
    maker.json["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
    ClipMaker spin(maker, "spin");
    spin.add(0, "rotation", "LINEAR", {0, 1, 2}, turns({0, 1, 1}, {0, 90, 170}));
    spin.finish();
    embed(maker);
    return {{"WrittenLines.gltf", maker.text()}};
}

}  // namespace claque::testing

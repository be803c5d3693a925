// A wagon: rigid parts on nodes of every kind.
#include "tests/support/written_encoding.h"
#include "tests/support/written_files.h"
#include "tests/support/written_image.h"
#include "tests/support/written_motion.h"

namespace claque::testing
{
namespace
{

constexpr UvBox wood_uv = {0.05f, 0.05f, 0.95f, 0.45f}, iron_uv = {0.05f, 0.55f, 0.95f, 0.95f};

Surface wheel()
{
    return tube(
        {{{-0.06f, 0, 0}, 0, {}}, {{-0.05f, 0, 0}, 0.3f, {}}, {{0.05f, 0, 0}, 0.3f, {}}, {{0.06f, 0, 0}, 0, {}}}, 10,
        iron_uv);
}

Bytes wood_and_iron()
{
    return png_of(16, 16, [](uint32_t x, uint32_t y) {
        const uint8_t grain = static_cast<uint8_t>(8 * ((x * 5 + y * 3) % 7));
        return y < 8 ? Colour{uint8_t(120 + grain), uint8_t(80 + grain), 40, 255} : Colour{grain, grain, 80, 255};
    });
}

// Column-major: a turn about y of 30 degrees, enlarged by 1.25 and, for `mirror` < 0, mirrored along its own x.
std::vector<float> matrix_at(float x, float y, float z, float mirror)
{
    const float c = 1.25f * 0.8660254f, s = 1.25f * 0.5f;
    return {mirror * c, 0, -mirror * s, 0, 0, 1.25f, 0, 0, s, 0, c, 0, x, y, z, 1};
}

}  // namespace

WrittenFiles written_rigid()
{
    Maker maker;
    const int texture = add_texture(maker, wood_and_iron());
    const int wood = add_material(maker, "wood", texture), iron = add_material(maker, "iron", texture),
              paint = add_material(maker, "paint", -1, {0.7f, 0.1f, 0.1f, 1});
    const auto mesh = [&](const char *name, const Surface &surface, int material) {
        return maker.add("meshes",
                         {{"name", name}, {"primitives", Json::array({primitive_of(maker, surface, material)})}});
    };
    const int bed = mesh("bed", box({0, 0.7f, 0}, {0.6f, 0.1f, 1.2f}, wood_uv), wood);
    const int round = mesh("wheel", wheel(), iron);
    const int lamp =
        mesh("lamp",
             tube({{{0, 0, 0}, 0, {}}, {{0, 0.05f, 0}, 0.1f, {}}, {{0, 0.2f, 0}, 0.06f, {}}, {{0, 0.3f, 0}, 0, {}}}, 6,
                  wood_uv),
             paint);

    // Node 0 is the wagon, 1 to 4 its wheels: those on the right are mirrored; 5 carries lamps 6 and 7 by matrices.
    maker.add("nodes",
              {{"name", "wagon"}, {"mesh", bed}, {"rotation", turn({0, 1, 0}, 15)}, {"children", {1, 2, 3, 4, 5}}});
    for (const float side : {1.0f, -1.0f})
        for (const float end : {0.8f, -0.8f})
            maker.add("nodes",
                      {{"name", std::string("wheel") + (side > 0 ? ".l" : ".r") + (end > 0 ? ".front" : ".back")},
                       {"mesh", round},
                       {"translation", {side * 0.72f, 0.35f, end}},
                       {"scale", {side, 1.1f, 1.1f}}});
    maker.add(
        "nodes",
        {{"name", "bracket"}, {"scale", {0.8f, 1.2f, 0.8f}}, {"translation", {0, 0.85f, 0}}, {"children", {6, 7}}});
    maker.add("nodes", {{"name", "lamp"}, {"mesh", lamp}, {"matrix", matrix_at(0.3f, 0.1f, 0.9f, 1)}});
    maker.add("nodes", {{"name", "lamp, mirrored"}, {"mesh", lamp}, {"matrix", matrix_at(-0.3f, 0.1f, 0.9f, -1)}});
    maker.json["scenes"] = Json::array({{{"nodes", {0}}}});

    ClipMaker roll(maker, "roll");
    const std::vector<float> five = times_from(0, 0.25f, 5);
    for (const int node : {1, 2, 3, 4})
        roll.add(node, "rotation", "LINEAR", five, turns({1, 0, 0}, {0, 80, 160, 240, 320}));
    roll.add(0, "translation", "LINEAR", five, {0, 0, 0, 0, 0.02f, 0.5f, 0, 0, 1, 0, 0.02f, 1.5f, 0, 0, 2});
    roll.finish();
    ClipMaker jolt(maker, "jolt");
    jolt.add(5, "scale", "CUBICSPLINE", {0.2f, 0.6f, 1.4f},
             with_tangents({0.8f, 1.2f, 0.8f, 1.1f, 0.7f, 0.9f, 0.8f, 1.2f, 0.8f}, 3, 0.6f));
    jolt.add(5, "translation", "STEP", {0.2f, 0.7f, 1.2f}, {0, 0.85f, 0, 0, 0.95f, 0, 0.05f, 0.85f, 0});
    jolt.add(0, "rotation", "LINEAR", {0, 1, 2}, turns({0.2f, 1, 0}, {15, 40, 15}));
    jolt.finish();
    return {{"WrittenRigid.glb", maker.glb()}};
}

}  // namespace claque::testing

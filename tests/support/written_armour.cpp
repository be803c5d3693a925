#include "tests/support/written_armour.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/written_person.h"

namespace claque::testing
{
namespace
{

// Bones of the written person from the body outwards, and a radius.
struct Limb {
    std::vector<uint16_t> bones;
    float radius;
};

const std::vector<Limb> &limbs()
{
    static const std::vector<Limb> all = {{{0, 1, 2}, 0.16f}, {{2, 3}, 0.1f},        {{4, 5, 6}, 0.06f},
                                          {{7, 8, 9}, 0.06f}, {{10, 11, 12}, 0.08f}, {{13, 14, 15}, 0.08f}};
    return all;
}

// A ring at `along` [0, 1] of a limb.
Ring ring_of(const Limb &limb, float along, float radius)
{
    const float at = along * static_cast<float>(limb.bones.size() - 1);
    const size_t from = std::min(static_cast<size_t>(at), limb.bones.size() - 2);
    const float part = at - static_cast<float>(from);
    const Triple a = place_of_bone(limb.bones[from]), b = place_of_bone(limb.bones[from + 1]);
    std::vector<Influence> influences = {{limb.bones[from], 1 - part}};
    if (part > 0) influences.push_back({limb.bones[from + 1], part});
    return {plus(times(a, 1 - part), times(b, part)), radius, influences};
}

// From `first` to `last` along a limb, round like a barrel.
Surface plate_of(const Limb &limb, float first, float last, uint32_t triangles)
{
    constexpr uint32_t sides = 24;
    const uint32_t steps = std::max(2u, triangles / (2 * sides) + 1);
    std::vector<Ring> rings;
    for (uint32_t i = 0; i <= steps; ++i) {
        const float at = static_cast<float>(i) / static_cast<float>(steps);
        const float bulge = std::sqrt(std::max(0.0f, 1 - (2 * at - 1) * (2 * at - 1)));
        rings.push_back(ring_of(limb, first + (last - first) * at, limb.radius * (0.6f + 0.4f * bulge)));
    }
    return tube(rings, sides, {0, 0, 1, 1});
}

}  // namespace

Bytes written_armour(uint32_t plates, uint32_t triangles)
{
    Maker maker;
    const int armature = add_person_nodes(maker);
    add_person_skin(maker, armature, all_bones(),
                    maker.floats("MAT4", person_bones().size(), inverse_binds(all_bones())));
    Json primitives = Json::array();
    for (uint32_t i = 0; i < plates; ++i) {
        const size_t count = limbs().size(), limb = i % count;
        const uint32_t here = (plates - static_cast<uint32_t>(limb) + 5) / static_cast<uint32_t>(count);
        const float place = static_cast<float>(i / count), wide = static_cast<float>(here);
        const float hue = static_cast<float>(i * 7 % plates) / static_cast<float>(plates);
        const int material = add_material(maker, ("plate " + std::to_string(i)).c_str(), -1,
                                          {hue, 1 - hue, 0.2f + 0.6f * static_cast<float>(i % 2), 1});
        primitives.push_back(primitive_of(
            maker, plate_of(limbs()[limb], place / wide, (place + 1) / wide, triangles / plates), material));
    }
    const int mesh = maker.add("meshes", {{"name", "armour"}, {"primitives", primitives}});
    const int body = maker.add("nodes", {{"name", "body"}, {"mesh", mesh}, {"skin", 0}});
    maker.json["scenes"] = Json::array({{{"nodes", {armature, body}}}});
    add_person_clips(maker, armature);
    return maker.glb();
}

}  // namespace claque::testing

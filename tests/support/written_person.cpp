#include "tests/support/written_person.h"

#include "tests/support/written_files.h"
#include "tests/support/written_image.h"

namespace claque::testing
{
namespace
{

enum Bones : uint16_t { hips, spine, chest, head, arm_l, forearm_l, hand_l, arm_r, forearm_r, hand_r, leg_l, shin_l };
constexpr uint16_t foot_l = 12;

constexpr UvBox skin_uv = {0.02f, 0.02f, 0.48f, 0.48f}, tunic_uv = {0.52f, 0.02f, 0.98f, 0.48f},
                trousers_uv = {0.02f, 0.52f, 0.48f, 0.98f}, cape_uv = {0.52f, 0.52f, 0.98f, 0.98f};

Surface arm(float side, uint16_t upper)
{
    const uint16_t fore = upper + 1, hand = upper + 2;
    const auto at = [&](float x) { return Triple{side * x, 1.47f, 0.0f}; };
    return tube({{at(0.19f), 0, {{upper, 1}}},
                 {at(0.2f), 0.05f, {{upper, 0.75f}, {chest, 0.25f}}},
                 {at(0.33f), 0.045f, {{upper, 1}}},
                 {at(0.44f), 0.04f, {{upper, 0.6f}, {fore, 0.4f}}},
                 {at(0.48f), 0.04f, {{upper, 0.3f}, {fore, 0.7f}}},
                 {at(0.6f), 0.035f, {{fore, 1}}},
                 {at(0.7f), 0.03f, {{fore, 0.5f}, {hand, 0.5f}}},
                 {at(0.78f), 0, {{hand, 1}}}},
                7, skin_uv);
}

Surface leg(float side, uint16_t upper)
{
    const uint16_t shin = upper + 1, foot = upper + 2;
    const auto at = [&](float y) { return Triple{side * 0.1f, y, 0.0f}; };
    return tube({{at(0.84f), 0, {{upper, 0.7f}, {hips, 0.3f}}},
                 {at(0.82f), 0.075f, {{upper, 0.7f}, {hips, 0.3f}}},
                 {at(0.66f), 0.07f, {{upper, 1}}},
                 {at(0.52f), 0.06f, {{upper, 0.5f}, {shin, 0.5f}}},
                 {at(0.46f), 0.06f, {{shin, 1}}},
                 {at(0.2f), 0.05f, {{shin, 1}}},
                 {at(0.08f), 0.045f, {{foot, 0.8f}, {shin, 0.2f}}},
                 {at(0.04f), 0, {{foot, 1}}}},
                7, trousers_uv);
}

}  // namespace

const std::vector<PersonBone> &person_bones()
{
    static const std::vector<PersonBone> bones = {{"hips", -1, {0, 0.95f, 0}},
                                                  {"spine", hips, {0, 0.2f, 0}},
                                                  {"chest", spine, {0, 0.2f, 0}},
                                                  {"head", chest, {0, 0.22f, 0}},
                                                  {"arm.l", chest, {0.2f, 0.12f, 0}},
                                                  {"forearm.l", arm_l, {0.26f, 0, 0}},
                                                  {"hand.l", forearm_l, {0.24f, 0, 0}},
                                                  {"arm.r", chest, {-0.2f, 0.12f, 0}},
                                                  {"forearm.r", arm_r, {-0.26f, 0, 0}},
                                                  {"hand.r", forearm_r, {-0.24f, 0, 0}},
                                                  {"leg.l", hips, {0.1f, -0.05f, 0}},
                                                  {"shin.l", leg_l, {0, -0.4f, 0.01f}},
                                                  {"foot.l", shin_l, {0, -0.42f, 0}},
                                                  {"leg.r", hips, {-0.1f, -0.05f, 0}},
                                                  {"shin.r", foot_l + 1, {0, -0.4f, 0.01f}},
                                                  {"foot.r", foot_l + 2, {0, -0.42f, 0}}};
    return bones;
}

Triple place_of_bone(size_t bone)
{
    const PersonBone &b = person_bones()[bone];
    return b.parent < 0 ? b.offset : plus(b.offset, place_of_bone(static_cast<size_t>(b.parent)));
}

Surface person_skin()
{
    const auto at = [](float y) { return Triple{0.0f, y, 0.02f}; };
    Surface out = tube({{at(1.6f), 0, {{head, 0.5f}, {chest, 0.5f}}},
                        {at(1.63f), 0.07f, {{head, 0.8f}, {chest, 0.2f}}},
                        {at(1.7f), 0.1f, {{head, 1}}},
                        {at(1.78f), 0.09f, {{head, 1}}},
                        {at(1.84f), 0.05f, {{head, 1}}},
                        {at(1.86f), 0, {{head, 1}}}},
                       8, skin_uv);
    append(out, arm(1, arm_l));
    append(out, arm(-1, arm_r));
    return out;
}

Surface person_tunic()
{
    const auto at = [](float y) { return Triple{0.0f, y, 0.0f}; };
    return tube({{at(0.88f), 0, {{hips, 1}}},
                 {at(0.92f), 0.14f, {{hips, 0.8f}, {leg_l, 0.1f}, {uint16_t(foot_l + 1), 0.1f}}},
                 {at(1.05f), 0.13f, {{hips, 0.5f}, {spine, 0.5f}}},
                 {at(1.2f), 0.13f, {{spine, 0.6f}, {chest, 0.4f}}},
                 {at(1.38f), 0.15f, {{chest, 0.6f}, {spine, 0.2f}, {arm_l, 0.1f}, {arm_r, 0.1f}}},
                 {at(1.5f), 0.1f, {{chest, 0.8f}, {head, 0.2f}}},
                 {at(1.55f), 0, {{chest, 0.6f}, {head, 0.4f}}}},
                10, tunic_uv);
}

Surface person_trousers()
{
    Surface out = leg(1, leg_l);
    append(out, leg(-1, foot_l + 1));
    return out;
}

int add_person_nodes(Maker &maker)
{
    const int armature = maker.add("nodes", {{"name", "armature"},
                                             {"rotation", turn({0.2f, 1, 0.1f}, 25)},
                                             {"translation", {0.05f, -0.1f, 0.3f}},
                                             {"scale", {1.1f, 1.1f, 1.1f}}});
    const auto children_of = [&](int parent) {
        Json children = Json::array();
        for (size_t i = 0; i < person_bones().size(); ++i)
            if (person_bones()[i].parent == parent) children.push_back(armature + 1 + static_cast<int>(i));
        return children;
    };
    maker.json["nodes"][static_cast<size_t>(armature)]["children"] = children_of(-1);
    for (size_t i = 0; i < person_bones().size(); ++i) {
        Json node = {{"name", person_bones()[i].name}, {"translation", person_bones()[i].offset}};
        const Json children = children_of(static_cast<int>(i));
        if (!children.empty()) node["children"] = children;
        maker.add("nodes", node);
    }
    return armature;
}

std::vector<float> inverse_binds(const std::vector<size_t> &bones, float factor, const Triple &centre)
{
    std::vector<float> out;
    for (const size_t bone : bones) {
        const Triple to = plus(centre, times(place_of_bone(bone), -1));
        out.insert(out.end(), {factor, 0, 0, 0, 0, factor, 0, 0, 0, 0, factor, 0, to[0], to[1], to[2], 1});
    }
    return out;
}

std::vector<size_t> all_bones()
{
    std::vector<size_t> out;
    for (size_t i = 0; i < person_bones().size(); ++i) out.push_back(i);
    return out;
}

int add_person_skin(Maker &maker, int armature, const std::vector<size_t> &bones, int inverse_bind_accessor)
{
    Json skin = {{"joints", Json::array()}};
    for (const size_t bone : bones) skin["joints"].push_back(armature + 1 + static_cast<int>(bone));
    if (inverse_bind_accessor >= 0) skin["inverseBindMatrices"] = inverse_bind_accessor;
    return maker.add("skins", skin);
}

void add_person_clips(Maker &maker, int armature)
{
    const auto node = [&](int bone) { return armature + 1 + bone; };
    ClipMaker walk(maker, "walk");
    const std::vector<float> nine = times_from(0.25f, 0.125f, 9);
    const std::vector<float> swing = {0, 20, 32, 20, 0, -20, -32, -20, 0};
    std::vector<float> back;
    for (const float angle : swing) back.push_back(-angle);
    walk.add(node(leg_l), "rotation", "LINEAR", nine, turns({1, 0, 0}, swing));
    walk.add(node(foot_l + 1), "rotation", "LINEAR", nine, turns({1, 0, 0}, back));
    walk.add(node(shin_l), "rotation", "LINEAR", nine, turns({1, 0, 0}, {5, 5, 25, 40, 5, 5, 25, 40, 5}));
    std::vector<float> crossing = turns({0, 0.4f, 1}, {-60, -62, -70, -62, -60, -58, -50, -58, -60});
    for (size_t i = 12; i < 24; ++i) crossing[i] = -crossing[i];  // three keys on the other side of the double cover
    walk.add(node(arm_l), "rotation", "LINEAR", nine, crossing);
    walk.add(node(arm_r), "rotation", "LINEAR", nine,
             turns({0.3f, 0, -1}, {-60, -60, -66, -60, -55, -50, -50, -55, -60}));
    walk.add(node(hips), "translation", "LINEAR", times_from(0.25f, 0.25f, 5),
             {0, 0.95f, 0, 0.02f, 0.97f, 0.1f, 0, 0.95f, 0.2f, -0.02f, 0.97f, 0.3f, 0, 0.95f, 0.4f});
    walk.finish();

    ClipMaker wave(maker, "wave");
    wave.add(node(arm_r), "rotation", "CUBICSPLINE", {0, 0.5f, 0.75f, 1.5f},
             with_tangents(turns({0, 0, -1}, {0, 70, 45, 0}), 4, 0.8f));
    wave.add(node(hips), "translation", "CUBICSPLINE", {0, 0.7f, 1.5f},
             with_tangents({0, 0.95f, 0, 0, 0.9f, 0.05f, 0, 0.95f, 0}, 3, 0.5f));
    wave.add(node(head), "rotation", "STEP", {0.1f, 0.6f, 1.1f}, turns({0, 1, 0}, {20, -20, 10}));
    wave.add(node(hand_r), "scale", "LINEAR", {0, 1, 1.5f}, {1, 1, 1, 1.6f, 1.2f, 1.4f, 1, 1, 1});
    wave.add(node(spine), "rotation", "LINEAR", {0.3f}, turns({1, 0, 0}, {8}));
    wave.finish();

    ClipMaker stand(maker, "stand");
    stand.add(node(arm_l), "rotation", "LINEAR", {0.5f}, turns({0, 0, 1}, {-75}));
    stand.add(node(arm_r), "rotation", "LINEAR", {0.5f}, turns({0, 0, 1}, {75}));
    stand.finish();
}

Bytes person_picture()
{
    return png_of(32, 32, [](uint32_t x, uint32_t y) {
        const uint8_t shade = static_cast<uint8_t>(x * 3 + y * 2);
        if (x >= 16 && y >= 16) return Colour{40, 60, 90, uint8_t((x / 4 + y / 4) % 4 == 0 ? 0 : 255)};
        if (y >= 16) return Colour{60, 50, uint8_t(40 + shade / 2), 255};
        return x < 16 ? Colour{210, uint8_t(140 + shade / 4), 110, 255} : Colour{uint8_t(120 + shade / 2), 40, 40, 255};
    });
}

// One skin of 16 joints with weights of 32 bits; a cape with holes that is seen from both sides; a hat and two
// ear-rings that hang on the head, one of them mirrored.
WrittenFiles written_person()
{
    Maker maker;
    const int armature = add_person_nodes(maker);
    const int texture = add_texture(maker, person_picture());
    const int skin = add_material(maker, "skin", texture), tunic = add_material(maker, "tunic", texture),
              trousers = add_material(maker, "trousers", texture), cape = add_material(maker, "cape", texture),
              hat = add_material(maker, "felt", -1, {0.1f, 0.3f, 0.1f, 1});
    maker.json["materials"][static_cast<size_t>(cape)].update(
        {{"alphaMode", "MASK"}, {"alphaCutoff", 0.5f}, {"doubleSided", true}});
    const int binds = maker.floats("MAT4", person_bones().size(), inverse_binds(all_bones()));
    add_person_skin(maker, armature, all_bones(), binds);

    const int body =
        maker.add("meshes", {{"name", "body"},
                             {"primitives",
                              {primitive_of(maker, person_skin(), skin), primitive_of(maker, person_tunic(), tunic),
                               primitive_of(maker, person_trousers(), trousers)}}});
    Surface cloth = sheet(
        {Triple{-0.2f, 0.7f, -0.3f}, {-0.15f, 1.4f, -0.22f}, {0.15f, 1.4f, -0.22f}, {0.2f, 0.7f, -0.3f}}, 4, cape_uv);
    for (const Triple &p : cloth.positions)
        cloth.influences.push_back({{chest, (p[1] - 0.7f) / 0.7f}, {hips, (1.4f - p[1]) / 0.7f}});
    const int cape_mesh =
        maker.add("meshes", {{"name", "cape"}, {"primitives", Json::array({primitive_of(maker, cloth, cape)})}});
    const Surface brim =
        tube({{{0, 0, 0}, 0, {}}, {{0, 0.01f, 0}, 0.14f, {}}, {{0, 0.12f, 0}, 0.06f, {}}, {{0, 0.2f, 0}, 0, {}}}, 6,
             skin_uv);
    const int hat_mesh =
        maker.add("meshes", {{"name", "hat"}, {"primitives", Json::array({primitive_of(maker, brim, hat)})}});
    const Surface drop = box({0.02f, -0.03f, 0}, {0.02f, 0.04f, 0.01f}, skin_uv);
    const int drop_mesh =
        maker.add("meshes", {{"name", "ear-ring"}, {"primitives", Json::array({primitive_of(maker, drop, hat)})}});

    const int body_node = maker.add("nodes", {{"name", "body"}, {"mesh", body}, {"skin", 0}});
    const int cape_node = maker.add("nodes", {{"name", "cape"}, {"mesh", cape_mesh}, {"skin", 0}});
    Json hung = Json::array();
    hung.push_back(maker.add("nodes", {{"name", "hat"},
                                       {"mesh", hat_mesh},
                                       {"translation", {0, 0.31f, 0.02f}},
                                       {"rotation", turn({1, 0, 0.3f}, 12)},
                                       {"scale", {1.1f, 0.7f, 0.9f}}}));
    hung.push_back(
        maker.add("nodes", {{"name", "ear-ring.l"}, {"mesh", drop_mesh}, {"translation", {0.12f, 0.14f, 0}}}));
    hung.push_back(maker.add(
        "nodes",
        {{"name", "ear-ring.r"}, {"mesh", drop_mesh}, {"translation", {-0.12f, 0.14f, 0}}, {"scale", {-1, 1, 1}}}));
    maker.json["nodes"][static_cast<size_t>(armature + 1 + head)]["children"] = hung;
    maker.json["scenes"] = Json::array({{{"nodes", {armature, body_node, cape_node}}}});
    add_person_clips(maker, armature);
    return {{"WrittenPerson.glb", maker.glb()}};
}

// The person's bones and clips, with nothing to see.
WrittenFiles written_clips()
{
    Maker maker;
    const int armature = add_person_nodes(maker);
    maker.json["scenes"] = Json::array({{{"nodes", {armature}}}});
    ClipMaker bow(maker, "bow");
    const std::vector<float> five = times_from(0, 0.2f, 5);
    bow.add(armature + 1 + hips, "translation", "LINEAR", five,
            {0, 0.95f, 0, 0, 0.95f, 0.01f, 0, 0.94f, 0.02f, 0, 0.95f, 0.01f, 0, 0.95f, 0});
    for (int bone = spine; bone < static_cast<int>(person_bones().size()); ++bone) {
        const float most = 4 * static_cast<float>(bone + 1);
        bow.add(armature + 1 + bone, "rotation", "LINEAR", five,
                turns({1, 0.2f * static_cast<float>(bone), 0.5f}, {0, most / 2, most, -most / 3, 0}));
    }
    bow.finish();
    add_person_clips(maker, armature);
    return {{"WrittenClips.glb", maker.glb()}};
}

}  // namespace claque::testing

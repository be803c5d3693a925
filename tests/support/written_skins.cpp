// The person of written_person.h, stored in other ways: several skins, sparse accessors, quantised numbers.
#include <algorithm>

#include "tests/support/written_files.h"
#include "tests/support/written_person.h"

namespace claque::testing
{
namespace
{

Json skin_material_list(Maker &maker, int texture)
{
    return {add_material(maker, "skin", texture), add_material(maker, "tunic", texture),
            add_material(maker, "trousers", texture)};
}

// Each joint of a vertex gives a quarter of its weight to its parent.
void spread(Surface &surface)
{
    for (std::vector<Influence> &influences : surface.influences) {
        const std::vector<Influence> before = influences;
        for (size_t k = 0; k < before.size(); ++k) {
            const int parent = person_bones()[before[k].joint].parent;
            if (parent < 0) continue;
            influences[k].weight -= before[k].weight / 4;
            const auto is_parent = [&](const Influence &one) { return one.joint == parent; };
            const auto at = std::find_if(influences.begin(), influences.end(), is_parent);
            if (at == influences.end()) influences.push_back({static_cast<uint16_t>(parent), before[k].weight / 4});
            else at->weight += before[k].weight / 4;
        }
    }
}

void renumber(Surface &surface, const std::vector<size_t> &bones)
{
    for (std::vector<Influence> &influences : surface.influences)
        for (Influence &influence : influences)
            influence.joint =
                static_cast<uint16_t>(std::find(bones.begin(), bones.end(), influence.joint) - bones.begin());
}

int sparse_of(Maker &maker, int base_view, const char *type, size_t count, int index_type, int indices, int values,
              size_t changed)
{
    Json accessor = {{"componentType", f32},
                     {"type", type},
                     {"count", count},
                     {"sparse",
                      {{"count", changed},
                       {"indices", {{"bufferView", indices}, {"componentType", index_type}}},
                       {"values", {{"bufferView", values}}}}}};
    if (base_view >= 0) accessor["bufferView"] = base_view;
    return maker.add("accessors", accessor);
}

}  // namespace

// Body and legs on skins of their own: the one with its joints from last to first and eight influences, the other
// stored at half the size; and a staff in the space of the one joint of a skin without inverse binds.
WrittenFiles written_skins()
{
    Maker maker;
    const int armature = add_person_nodes(maker);
    const Json materials = skin_material_list(maker, add_texture(maker, person_picture()));
    std::vector<size_t> reversed = all_bones();
    std::reverse(reversed.begin(), reversed.end());
    const std::vector<size_t> below = {0, 10, 11, 12, 13, 14, 15};
    add_person_skin(maker, armature, reversed, maker.floats("MAT4", 16, inverse_binds(reversed)));
    add_person_skin(maker, armature, below, maker.floats("MAT4", below.size(), inverse_binds(below, 2)));
    add_person_skin(maker, armature, {6}, -1);

    Surface skin = person_skin(), tunic = person_tunic(), trousers = person_trousers();
    for (Surface *surface : {&skin, &tunic}) spread(*surface), renumber(*surface, reversed);
    renumber(trousers, below);
    for (Triple &position : trousers.positions) position = times(position, 0.5f);
    Surface staff = tube({{{0.05f, -0.5f, 0}, 0, {}},
                          {{0.05f, -0.49f, 0}, 0.02f, {}},
                          {{0.05f, 0.6f, 0}, 0.02f, {}},
                          {{0.05f, 0.62f, 0}, 0, {}}},
                         5, {0.55f, 0.55f, 0.9f, 0.7f});
    staff.influences.assign(staff.positions.size(), {{0, 1}});

    const InfluenceFormat eight = {2, u16, u16}, bytes = {1, u8, u8};
    maker.add("meshes",
              {{"name", "above"},
               {"primitives",
                {primitive_of(maker, skin, materials[0], eight), primitive_of(maker, tunic, materials[1], eight)}}});
    maker.add("meshes",
              {{"name", "below"}, {"primitives", Json::array({primitive_of(maker, trousers, materials[2], bytes)})}});
    maker.add("meshes", {{"name", "staff"}, {"primitives", Json::array({primitive_of(maker, staff, materials[2])})}});
    const int first = armature + 17;
    maker.add("nodes", {{"name", "above"}, {"mesh", 0}, {"skin", 0}});
    // Skinned meshes do not follow their own node: this turn must not be seen.
    maker.add("nodes",
              {{"name", "below"}, {"mesh", 1}, {"skin", 1}, {"rotation", turn({1, 2, 3}, 70)}, {"scale", {3, 3, 3}}});
    maker.add("nodes", {{"name", "staff"}, {"mesh", 2}, {"skin", 2}, {"translation", {5, 5, 5}}});
    maker.json["scenes"] = Json::array({{{"nodes", {first, armature, first + 1, first + 2}}}});
    add_person_clips(maker, armature);
    return {{"WrittenSkins.glb", maker.glb()}};
}

// What the plain accessors say is wrong wherever a sparse one puts it right: heads lie lower, weights are another
// joint's, a clip's keys stand still. The morph target has no plain half at all.
WrittenFiles written_sparse()
{
    Maker maker;
    const int armature = add_person_nodes(maker);
    const int image = maker.add("images", {{"uri", "Written%20Sparse.png"}});
    const Json materials = skin_material_list(maker, maker.add("textures", {{"source", image}}));
    add_person_skin(maker, armature, all_bones(), maker.floats("MAT4", 16, inverse_binds(all_bones())));

    const auto view_of = [&](int accessor) {
        return maker.json["accessors"][static_cast<size_t>(accessor)]["bufferView"];
    };
    Surface skin = person_skin(), trousers = person_trousers();
    const size_t count = skin.positions.size();
    std::vector<uint16_t> high;
    std::vector<float> places, deltas;
    for (size_t v = 0; v < count; ++v) {
        if (skin.positions[v][1] < 1.65f) continue;
        high.push_back(static_cast<uint16_t>(v));
        places.insert(places.end(), skin.positions[v].begin(), skin.positions[v].end());
        deltas.insert(deltas.end(), {0.03f * skin.normals[v][0], 0.05f, 0.03f * skin.normals[v][2]});
        skin.positions[v][1] -= 0.3f;
    }
    Json above = primitive_of(maker, skin, materials[0]);
    above["attributes"]["POSITION"] = sparse_of(maker, view_of(above["attributes"]["POSITION"]), "VEC3", count, u16,
                                                maker.view(high), maker.view(places), high.size());
    const Bytes high_bytes(high.begin(), high.end());
    const std::vector<uint32_t> high_words(high.begin(), high.end());
    above["targets"] = {{{"POSITION", sparse_of(maker, -1, "VEC3", count, u8, maker.view(high_bytes),
                                                maker.view(deltas), high.size())}},
                        {{"POSITION", sparse_of(maker, -1, "VEC3", count, u32, maker.view(high_words),
                                                maker.view(places), high.size())}}};

    const std::vector<float> right = weights_of(trousers, 0);
    std::vector<uint16_t> changed;
    std::vector<float> values;
    for (size_t v = 0; v < trousers.influences.size(); ++v) {
        if (trousers.influences[v].size() < 2) continue;
        changed.push_back(static_cast<uint16_t>(v));
        values.insert(values.end(), right.begin() + static_cast<std::ptrdiff_t>(4 * v),
                      right.begin() + static_cast<std::ptrdiff_t>(4 * v + 4));
        std::swap(trousers.influences[v][0].weight, trousers.influences[v][1].weight);
    }
    Json below = primitive_of(maker, trousers, materials[2]);
    below["attributes"]["WEIGHTS_0"] =
        sparse_of(maker, view_of(below["attributes"]["WEIGHTS_0"]), "VEC4", trousers.positions.size(), u16,
                  maker.view(changed), maker.view(values), changed.size());

    maker.add("meshes", {{"name", "above"}, {"weights", {0.5f, 0}}, {"primitives", Json::array({above})}});
    maker.add("meshes",
              {{"name", "below"}, {"primitives", {primitive_of(maker, person_tunic(), materials[1]), below}}});
    maker.add("nodes", {{"name", "above"}, {"mesh", 0}, {"skin", 0}});
    maker.add("nodes", {{"name", "below"}, {"mesh", 1}, {"skin", 0}});
    maker.json["scenes"] = Json::array({{{"nodes", {armature, armature + 17, armature + 18}}}});
    add_person_clips(maker, armature);

    ClipMaker nod(maker, "nod");
    const int still = maker.floats("VEC4", 3, turns({1, 0, 0}, {0, 0, 0}));
    const int keys =
        sparse_of(maker, view_of(still), "VEC4", 3, u8, maker.view(Bytes{1}), maker.view(turns({1, 0, 0}, {30})), 1);
    nod.add(armature + 4, "rotation", "LINEAR", {0, 0.4f, 1}, keys);
    nod.add(armature + 17, "weights", "LINEAR", {0, 0.5f, 1}, {0.5f, 0, 1, 0.02f, 0.2f, 0});
    nod.finish();

    maker.json["buffers"] = Json::array({{{"byteLength", maker.binary.size()}, {"uri", "Written%20Sparse.bin"}}});
    return {{"WrittenSparse.gltf", maker.text()},
            {"Written Sparse.bin", maker.binary},
            {"Written Sparse.png", person_picture()}};
}

namespace
{

// A vertex of 24 bytes: a position and a normal padded to 4 numbers, texture coordinates, weights, joints.
Json quantised_primitive(Maker &maker, const Surface &surface, const Triple &centre, bool is_normalized, int material)
{
    const auto append_all = [](Bytes &out, const auto &values) {
        const auto *const from = reinterpret_cast<const uint8_t *>(values.data());
        out.insert(out.end(), from, from + values.size() * sizeof(values[0]));
    };
    const std::vector<uint16_t> joints = surface.influences.empty() ? std::vector<uint16_t>() : joints_of(surface, 0);
    const std::vector<uint8_t> weights =
        normalized_of<uint8_t>(surface.influences.empty() ? std::vector<float>() : weights_of(surface, 0));
    Bytes bytes;
    for (size_t v = 0; v < surface.positions.size(); ++v) {
        const Triple &n = surface.normals[v], p = plus(surface.positions[v], times(centre, -1));
        append_all(bytes, normalized_of<int16_t>({p[0], p[1], p[2], 0}));
        append_all(bytes, normalized_of<int8_t>({n[0], n[1], n[2], 0}));
        append_all(bytes, normalized_of<uint16_t>({surface.uvs[v][0], surface.uvs[v][1]}));
        for (size_t k = 4 * v; k < 4 * v + 4; ++k) bytes.push_back(weights.empty() ? uint8_t(0) : weights[k]);
        for (size_t k = 4 * v; k < 4 * v + 4; ++k)
            bytes.push_back(joints.empty() ? uint8_t(0) : static_cast<uint8_t>(joints[k]));
    }
    const int view = maker.view(bytes);
    maker.json["bufferViews"][static_cast<size_t>(view)]["byteStride"] = 24;
    const auto accessor = [&](int component, const char *type, size_t offset, bool normalized) {
        Json json = {{"bufferView", view},
                     {"byteOffset", offset},
                     {"componentType", component},
                     {"type", type},
                     {"count", surface.positions.size()}};
        if (normalized) json["normalized"] = true;
        return maker.add("accessors", json);
    };
    Json attributes = {{"POSITION", accessor(i16, "VEC3", 0, is_normalized)},
                       {"NORMAL", accessor(i8, "VEC3", 8, true)},
                       {"TEXCOORD_0", accessor(u16, "VEC2", 12, true)}};
    if (!joints.empty()) {
        attributes["WEIGHTS_0"] = accessor(u8, "VEC4", 16, true);
        attributes["JOINTS_0"] = accessor(u8, "VEC4", 20, false);
    }
    const Bytes indices(surface.indices.begin(), surface.indices.end());
    const bool small = surface.positions.size() < 255;
    const std::vector<uint16_t> wide(surface.indices.begin(), surface.indices.end());
    return {{"attributes", attributes},
            {"material", material},
            {"indices", small ? maker.accessor(u8, "SCALAR", indices.size(), indices)
                              : maker.accessor(u16, "SCALAR", wide.size(), wide)}};
}

}  // namespace

// Positions of 16 bits round the middle of the person, which the inverse binds put back; a box whose whole numbers its
// node makes small; a clip of normalized shorts.
WrittenFiles written_quantised()
{
    Maker maker;
    for (const char *list : {"extensionsUsed", "extensionsRequired"})
        maker.json[list] = Json::array({"KHR_mesh_quantization"});
    const int armature = add_person_nodes(maker);
    const Json materials = skin_material_list(maker, add_texture(maker, person_picture()));
    const Triple middle = {0, 0.95f, 0};
    add_person_skin(maker, armature, all_bones(), maker.floats("MAT4", 16, inverse_binds(all_bones(), 1, middle)));
    maker.add("meshes", {{"name", "body"},
                         {"primitives",
                          {quantised_primitive(maker, person_skin(), middle, true, materials[0]),
                           quantised_primitive(maker, person_tunic(), middle, true, materials[1]),
                           quantised_primitive(maker, person_trousers(), middle, true, materials[2])}}});
    const Surface basket = box({0, 0, 0}, {0.9f, 0.5f, 0.6f}, {0.55f, 0.1f, 0.9f, 0.4f});
    maker.add("meshes",
              {{"name", "basket"},
               {"primitives", Json::array({quantised_primitive(maker, basket, {0, 0, 0}, false, materials[1])})}});
    maker.add("nodes", {{"name", "body"}, {"mesh", 0}, {"skin", 0}});
    const float unit_of_whole = 0.2f / 32767;
    maker.json["nodes"][static_cast<size_t>(armature + 1 + 6)]["children"] =
        Json::array({maker.add("nodes", {{"name", "basket"},
                                         {"mesh", 1},
                                         {"translation", {0.2f, -0.15f, 0}},
                                         {"scale", {unit_of_whole, unit_of_whole, unit_of_whole}}})});
    maker.json["scenes"] = Json::array({{{"nodes", {armature, armature + 17}}}});
    add_person_clips(maker, armature);
    ClipMaker shrug(maker, "shrug");
    for (const int bone : {4, 7}) {
        const std::vector<int16_t> keys = normalized_of<int16_t>(turns({0, 0, 1}, {0, bone == 4 ? 25.0f : -25.0f, 0}));
        const int output = maker.accessor(i16, "VEC4", 3, keys);
        maker.json["accessors"][static_cast<size_t>(output)]["normalized"] = true;
        shrug.add(armature + 1 + bone, "rotation", "LINEAR", {0, 0.3f, 0.9f}, output);
    }
    shrug.finish();
    return {{"WrittenQuantised.glb", maker.glb()}};
}

}  // namespace claque::testing

#include "tests/fuzz/json_mutator.h"

#include "samples/io/json.h"

namespace fuzzing
{
namespace
{

const char *const keys[] = {"name",
                            "byteOffset",
                            "byteStride",
                            "byteLength",
                            "count",
                            "componentType",
                            "normalized",
                            "sparse",
                            "bufferView",
                            "POSITION",
                            "NORMAL",
                            "TEXCOORD_0",
                            "JOINTS_0",
                            "WEIGHTS_0",
                            "JOINTS_1",
                            "WEIGHTS_1",
                            "COLOR_0",
                            "targets",
                            "weights",
                            "mode",
                            "indices",
                            "material",
                            "mesh",
                            "skin",
                            "children",
                            "matrix",
                            "translation",
                            "rotation",
                            "scale",
                            "inverseBindMatrices",
                            "joints",
                            "skeleton",
                            "input",
                            "output",
                            "interpolation",
                            "path",
                            "node",
                            "scene",
                            "extras",
                            "claque",
                            "markers",
                            "root_motion",
                            "time_s",
                            "deactivation_m",
                            "lod_m",
                            "dofs",
                            "kind",
                            "axis",
                            "min",
                            "max",
                            "rest",
                            "morph_target",
                            "zones",
                            "key",
                            "colour",
                            "hue_deg",
                            "saturation",
                            "brightness",
                            "extensions",
                            "KHR_draco_mesh_compression",
                            "EXT_meshopt_compression",
                            "KHR_materials_variants",
                            "KHR_texture_transform",
                            "KHR_mesh_quantization",
                            "alphaMode",
                            "alphaCutoff",
                            "doubleSided",
                            "baseColorFactor",
                            "wrapS",
                            "wrapT",
                            "texCoord",
                            "sampler",
                            "source",
                            "uri",
                            "mimeType"};
const char *const words[] = {"SCALAR",      "VEC2",      "VEC3",       "VEC4",
                             "MAT4",        "LINEAR",    "STEP",       "CUBICSPLINE",
                             "translation", "rotation",  "scale",      "weights",
                             "BLEND",       "MASK",      "OPAQUE",     "morph",
                             "hips",        "",          "ATTRIBUTES", "TRIANGLES",
                             "INDICES",     "NONE",      "OCTAHEDRAL", "QUATERNION",
                             "EXPONENTIAL", "image/png", "image/jpeg", "data:application/octet-stream;base64,AAAAAAAA"};

Json number(Dice &dice)
{
    const Json numbers[] = {
        0,     1,    2,     3,     4,     5,     7,      16,     255,    256,        5120,       5121,       5122, 5123,
        5125,  5126, 10497, 33071, 33648, 65535, -1,     65536,  1e-40,  2147483647, 4294967295, 1ull << 62, 0.5,  1e30,
        -1e30, 1e-3, -0.5,  1e300, 0.001, 4000,  100000, 3.4e38, 1.5e-5, 16777217,   -2,         0.70710678};
    return numbers[dice.below(sizeof numbers / sizeof *numbers)];
}

void collect(Json &at, std::vector<Json *> &out)
{
    out.push_back(&at);
    if (at.is_structured())
        for (Json &child : at) collect(child, out);
}

// One of the other places that hold a value of the same kind.
const Json &like(const std::vector<Json *> &all, const Json &value, Dice &dice)
{
    for (int tries = 0; tries < 20; ++tries) {
        const Json &other = *all[dice.below(all.size())];
        if (other.type() == value.type() || (other.is_number() && value.is_number())) return other;
    }
    return value;
}

void mutate_text(Json &at, const std::vector<Json *> &all, Dice &dice)
{
    if (dice.one_in(2)) at = words[dice.below(sizeof words / sizeof *words)];
    else if (dice.one_in(2)) at = Json(like(all, at, dice));
    else {
        std::string text = at.get<std::string>();
        if (text.empty() || dice.one_in(3)) text += static_cast<char>(' ' + dice.below(95));
        else text[dice.below(text.size())] = static_cast<char>(' ' + dice.below(95));
        at = text;
    }
}

void mutate_structure(Json &at, const std::vector<Json *> &all, Dice &dice)
{
    const size_t choice = dice.below(6);
    if (at.empty() || choice == 0) {
        const Json value = dice.one_in(2) ? number(dice) : Json(*all[dice.below(all.size())]);
        if (at.is_array()) at.push_back(value);
        else at[keys[dice.below(sizeof keys / sizeof *keys)]] = value;
        return;
    }
    const auto child = [&] { return std::next(at.begin(), static_cast<std::ptrdiff_t>(dice.below(at.size()))); };
    if (choice == 1) at.erase(child());
    else if (choice == 2) child()->swap(*child());
    else if (choice == 3) *child() = Json(like(all, at, dice));
    else if (at.is_array()) {
        const Json copy = *child();
        for (size_t repeats = 1 + (dice.one_in(6) ? dice.below(40) : 0); repeats > 0; --repeats) at.push_back(copy);
    } else {
        const Json copy = *child();
        at[keys[dice.below(sizeof keys / sizeof *keys)]] = copy;
    }
}

}  // namespace

Json parsed(const uint8_t *bytes, size_t size)
{
    std::string problem;
    return io::parse_json<Json>(std::string(reinterpret_cast<const char *>(bytes), size), problem);
}

void mutate(Json &tree, Dice &dice)
{
    std::vector<Json *> all;
    collect(tree, all);
    Json &at = *all[dice.below(all.size())];
    if (dice.one_in(8)) at = Json(*all[dice.below(all.size())]);
    else if (at.is_structured()) mutate_structure(at, all, dice);
    else if (at.is_string()) mutate_text(at, all, dice);
    else if (at.is_number_integer() && dice.one_in(2)) at = at.get<int64_t>() + (dice.one_in(2) ? 1 : -1);
    else if (at.is_number() && dice.one_in(2)) at = Json(like(all, at, dice));
    else if (at.is_boolean()) at = !at.get<bool>();
    else at = number(dice);
}

}  // namespace fuzzing

#include "tests/reference/gltf_reference.h"

#include <algorithm>
#include <stdexcept>

#include "tests/reference/gltf_file.h"

namespace claque::reference
{
namespace
{

using nlohmann::json;

std::vector<Vec3> vectors(const GltfFile &file, const json &attributes, const char *name)
{
    if (!attributes.contains(name)) return {};
    const std::vector<double> numbers = file.numbers(attributes[name]);
    std::vector<Vec3> result;
    for (size_t i = 0; i + 2 < numbers.size(); i += 3) result.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return result;
}

Mat4 matrix_from(const double *numbers)
{
    Mat4 matrix;
    std::copy(numbers, numbers + 16, matrix.m.begin());
    return matrix;
}

Node read_node(const GltfFile &file, const json &j)
{
    Node node;
    node.name = j.value("name", "");
    node.children = j.value("children", std::vector<size_t>{});
    node.mesh = j.value("mesh", -1);
    node.skin = j.value("skin", -1);
    if (j.contains("matrix")) {
        node.has_matrix = true;
        node.matrix = matrix_from(j["matrix"].get<std::vector<double>>().data());
    }
    const auto t = j.value("translation", std::vector<double>{0, 0, 0});
    const auto r = j.value("rotation", std::vector<double>{0, 0, 0, 1});
    const auto s = j.value("scale", std::vector<double>{1, 1, 1});
    node.translation = {t.at(0), t.at(1), t.at(2)};
    node.rotation = {r.at(0), r.at(1), r.at(2), r.at(3)};
    node.scale = {s.at(0), s.at(1), s.at(2)};
    if (node.mesh >= 0) {
        const json &mesh = file.list("meshes").at(static_cast<size_t>(node.mesh));
        const json &primitive = mesh.at("primitives").at(0);
        const size_t targets = primitive.contains("targets") ? primitive["targets"].size() : 0;
        node.morph_weights = j.value("weights", mesh.value("weights", std::vector<double>(targets, 0.0)));
    }
    return node;
}

Skin read_skin(const GltfFile &file, const json &j)
{
    Skin skin;
    skin.joints = j.at("joints").get<std::vector<size_t>>();
    skin.inverse_binds.resize(skin.joints.size());
    if (!j.contains("inverseBindMatrices")) return skin;
    const std::vector<double> numbers = file.numbers(j["inverseBindMatrices"]);
    for (size_t i = 0; i < skin.joints.size(); ++i) skin.inverse_binds[i] = matrix_from(&numbers.at(16 * i));
    return skin;
}

// A vertex whose weights are all zero follows the first joint that it lists.
void normalize_weights(Part &part)
{
    for (size_t v = 0; v < part.positions.size(); ++v) {
        double *weights = &part.weights[v * part.influences];
        double sum = 0;
        for (size_t k = 0; k < part.influences; ++k) sum += weights[k];
        if (sum == 0) weights[0] = sum = 1;
        for (size_t k = 0; k < part.influences; ++k) weights[k] /= sum;
    }
}

void read_influences(const GltfFile &file, const json &attributes, Part &part)
{
    const size_t count = part.positions.size();
    std::vector<std::vector<double>> joints, weights;
    for (size_t set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
        joints.push_back(file.numbers(attributes["JOINTS_" + std::to_string(set)]));
        weights.push_back(file.numbers(attributes.at("WEIGHTS_" + std::to_string(set))));
    }
    part.influences = 4 * joints.size();
    part.joints.resize(count * part.influences);
    part.weights.resize(count * part.influences);
    for (size_t v = 0; v < count; ++v)
        for (size_t k = 0; k < part.influences; ++k) {
            part.joints[v * part.influences + k] = static_cast<size_t>(joints[k / 4].at(4 * v + k % 4));
            part.weights[v * part.influences + k] = weights[k / 4].at(4 * v + k % 4);
        }
    normalize_weights(part);
}

Part read_part(const GltfFile &file, const json &primitive)
{
    Part part;
    const json &attributes = primitive.at("attributes");
    part.mode = primitive.value("mode", 4);
    part.positions = vectors(file, attributes, "POSITION");
    part.normals = vectors(file, attributes, "NORMAL");
    for (const auto &target : primitive.value("targets", json::array()))
        part.targets.push_back({vectors(file, target, "POSITION"), vectors(file, target, "NORMAL")});
    if (primitive.contains("indices"))
        for (const double index : file.numbers(primitive["indices"]))
            part.indices.push_back(static_cast<uint32_t>(index));
    else
        for (size_t i = 0; i < part.positions.size(); ++i) part.indices.push_back(static_cast<uint32_t>(i));
    return part;
}

// Depth first: a node's own primitives, then its children's.
void collect_parts(const GltfFile &file, Character &character, size_t index)
{
    const Node &node = character.nodes.at(index);
    if (node.mesh >= 0)
        for (const auto &primitive : file.list("meshes").at(static_cast<size_t>(node.mesh)).at("primitives")) {
            Part part = read_part(file, primitive);
            part.node = index;
            if (node.skin >= 0 && primitive.at("attributes").contains("JOINTS_0")) {
                part.skin = node.skin;
                read_influences(file, primitive.at("attributes"), part);
            }
            character.parts.push_back(std::move(part));
        }
    for (const size_t child : node.children) collect_parts(file, character, child);
}

std::vector<size_t> root_nodes(const GltfFile &file, const Character &character)
{
    const json &scenes = file.list("scenes");
    if (!scenes.empty()) return scenes.at(file.json().value("scene", size_t{0})).value("nodes", std::vector<size_t>{});
    std::vector<size_t> roots;
    for (size_t i = 0; i < character.nodes.size(); ++i)
        if (character.nodes[i].parent < 0) roots.push_back(i);
    return roots;
}

Path path_from(const std::string &name)
{
    if (name == "translation") return Path::Translation;
    if (name == "rotation") return Path::Rotation;
    if (name == "scale") return Path::Scale;
    if (name == "weights") return Path::Weights;
    throw std::runtime_error("channel path " + name);
}

Clip read_clip(const GltfFile &file, const json &j)
{
    Clip clip;
    clip.name = j.value("name", "");
    for (const auto &source : j.at("channels")) {
        if (!source.at("target").contains("node")) continue;
        const json &sampler = j.at("samplers").at(source.at("sampler").get<size_t>());
        const std::string method = sampler.value("interpolation", "LINEAR");
        Channel channel;
        channel.node = source["target"]["node"];
        channel.path = path_from(source["target"].at("path"));
        channel.interpolation = method == "STEP"          ? Interpolation::Step
                                : method == "CUBICSPLINE" ? Interpolation::CubicSpline
                                                          : Interpolation::Linear;
        channel.times = file.numbers(sampler.at("input"));
        channel.values = file.numbers(sampler.at("output"));
        const size_t per_key = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
        channel.width = channel.values.size() / (channel.times.size() * per_key);
        const bool is_first = clip.channels.empty();
        clip.first_s = is_first ? channel.times.front() : std::min(clip.first_s, channel.times.front());
        clip.last_s = is_first ? channel.times.back() : std::max(clip.last_s, channel.times.back());
        clip.channels.push_back(std::move(channel));
    }
    return clip;
}

}  // namespace

size_t Character::vertex_count() const
{
    size_t count = 0;
    for (const Part &part : parts) count += part.positions.size();
    return count;
}

Character load_character(const std::string &path)
{
    const GltfFile file(path);
    Character character;
    for (const auto &node : file.list("nodes")) character.nodes.push_back(read_node(file, node));
    for (size_t i = 0; i < character.nodes.size(); ++i)
        for (const size_t child : character.nodes[i].children) character.nodes.at(child).parent = static_cast<int>(i);
    for (const auto &skin : file.list("skins")) character.skins.push_back(read_skin(file, skin));
    for (const size_t root : root_nodes(file, character)) collect_parts(file, character, root);
    for (const auto &clip : file.list("animations")) character.clips.push_back(read_clip(file, clip));
    return character;
}

}  // namespace claque::reference

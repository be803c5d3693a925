// scene.glb: the part of glTF 2.0 that docs/parity.md promises.
#include <cstring>

#include <png.h>

#include "tests/parity/gl20.h"
#include "tests/parity/scene_in.h"

namespace parity_test
{
namespace
{

class Glb
{
public:
    explicit Glb(const std::string &path) : file_(bytes_of(path))
    {
        if (file_.size() < 20 || file_.compare(0, 4, "glTF") != 0) throw Failure(path + " is no GLB");
        const size_t text = number(12);
        json = Json::parse(file_.substr(20, text));
        bytes_ = file_.data() + 28 + text;
    }
    std::string view(size_t index) const
    {
        const Json &view = json.at("bufferViews").at(index);
        return {bytes_ + view.at("byteOffset").get<size_t>(), view.at("byteLength").get<size_t>()};
    }
    template <class Value>
    std::vector<Value> values(size_t index) const
    {
        const std::string bytes = view(index);
        std::vector<Value> out(bytes.size() / sizeof(Value));
        if (!out.empty()) std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Value));
        return out;
    }
    template <class Value>
    std::vector<Value> accessor(size_t index) const
    {
        return values<Value>(json.at("accessors").at(index).at("bufferView").get<size_t>());
    }
    Json json;

private:
    size_t number(size_t at) const
    {
        uint32_t value = 0;
        std::memcpy(&value, file_.data() + at, 4);
        return value;
    }
    std::string file_;
    const char *bytes_ = nullptr;
};

Texture texture_of(const Glb &glb, const Json &texture)
{
    const Json &image = glb.json.at("images").at(texture.at("source").get<size_t>());
    const Json &sampler = glb.json.at("samplers").at(texture.at("sampler").get<size_t>());
    const std::string file = glb.view(image.at("bufferView").get<size_t>());
    png_image png = {};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, file.data(), file.size())) throw Failure(png.message);
    png.format = PNG_FORMAT_RGBA;
    Texture out;
    out.width = static_cast<int>(png.width), out.height = static_cast<int>(png.height);
    out.rgba.resize(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, out.rgba.data(), 0, nullptr)) throw Failure(png.message);
    out.wrap_s = sampler.at("wrapS").get<int>(), out.wrap_t = sampler.at("wrapT").get<int>();
    return out;
}

MorphTarget target_of(const Glb &glb, const Json &target)
{
    MorphTarget out;
    const auto sparse = [&](const char *name, std::vector<float> &values) {
        const Json &accessor = glb.json.at("accessors").at(target.at(name).get<size_t>());
        if (!accessor.contains("sparse")) return;
        const Json &s = accessor.at("sparse");
        out.vertices = glb.values<uint32_t>(s.at("indices").at("bufferView").get<size_t>());
        values = glb.values<float>(s.at("values").at("bufferView").get<size_t>());
    };
    sparse("POSITION", out.positions);
    sparse("NORMAL", out.normals);
    return out;
}

void read_attributes(const Glb &glb, const Json &attributes, Mesh &out)
{
    const auto at = [&](const std::string &name) { return attributes.at(name).get<size_t>(); };
    out.positions = glb.accessor<float>(at("POSITION"));
    out.normals = glb.accessor<float>(at("NORMAL"));
    out.uvs = glb.accessor<float>(at("TEXCOORD_0"));
    out.vertices = out.positions.size() / 3;
    if (attributes.contains("COLOR_0")) out.colours = glb.accessor<uint8_t>(at("COLOR_0"));
    for (int set = 0; attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
        const auto joints = glb.accessor<uint16_t>(at("JOINTS_" + std::to_string(set)));
        out.joints.emplace_back(joints.begin(), joints.end());
        out.weights.push_back(glb.accessor<float>(at("WEIGHTS_" + std::to_string(set))));
    }
}

// The triangles of a dirty primitive once more for each zone that they may show.
void read_dirty_zones(const Glb &glb, const Json &primitive, Mesh &out)
{
    const Json &extras = primitive.at("extras");
    if (!extras.at("zone").is_null()) return;
    const size_t material = primitive.at("material").get<size_t>();
    for (size_t i = 0; i < extras.at("zones").size(); ++i) {
        const auto indices = glb.accessor<uint32_t>(extras.at("zone_indices").at(i).get<size_t>());
        out.zone_ranges.push_back(
            {extras.at("zones").at(i).get<uint32_t>(), {material, out.indices.size(), indices.size()}});
        out.indices.insert(out.indices.end(), indices.begin(), indices.end());
    }
}

Mesh mesh_of(const Glb &glb, const Json &json)
{
    Mesh out;
    for (const Json &primitive : json.at("primitives")) {
        if (out.ranges.empty()) {
            read_attributes(glb, primitive.at("attributes"), out);
            for (const Json &target : primitive.value("targets", Json::array()))
                out.targets.push_back(target_of(glb, target));
        }
        const size_t material = primitive.at("material").get<size_t>();
        const auto indices = glb.accessor<uint32_t>(primitive.at("indices").get<size_t>());
        if (out.ranges.empty() || out.ranges.back().material != material)
            out.ranges.push_back({material, out.indices.size(), 0});
        const Json &zone = primitive.at("extras").at("zone");
        if (!zone.is_null())
            out.zone_ranges.push_back({zone.get<uint32_t>(), {material, out.indices.size(), indices.size()}});
        out.indices.insert(out.indices.end(), indices.begin(), indices.end());
        out.ranges.back().count += indices.size();
    }
    for (const Json &primitive : json.at("primitives")) read_dirty_zones(glb, primitive, out);
    for (size_t i = 0; i < out.targets.size(); ++i)
        out.targets[i].weight = json.at("extras").at("morph_weights").at(i).get<uint32_t>();
    return out;
}

}  // namespace

void read_glb(const std::string &path, SceneIn &out)
{
    const Glb glb(path);
    for (const Json &texture : glb.json.at("textures")) out.textures.push_back(texture_of(glb, texture));
    for (const Json &material : glb.json.at("materials"))
        out.materials.push_back(
            {material.at("pbrMetallicRoughness").at("baseColorTexture").at("index").get<size_t>(),
             material.at("doubleSided").get<bool>(), material.value("alphaMode", "OPAQUE") == "MASK",
             material.contains("extensions") && material.at("extensions").contains("KHR_materials_unlit"),
             material.value("emissiveFactor", std::array<float, 3>{})});
    for (const Json &mesh : out.json.at("meshes"))
        out.meshes.push_back(mesh_of(glb, glb.json.at("meshes").at(mesh.at("mesh").get<size_t>())));
}

}  // namespace parity_test

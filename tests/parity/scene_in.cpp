#include "tests/parity/scene_in.h"

#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/parity/gl20.h"

namespace parity_test
{
namespace
{

template <size_t count>
std::array<float, count> numbers(const Json &json)
{
    std::array<float, count> out{};
    for (size_t i = 0; i < count; ++i) out[i] = json.at(i).get<float>();
    return out;
}

Lighting lighting_of(const Json &json)
{
    Lighting out;
    out.enabled = json.at("enabled").get<bool>();
    out.ambient = numbers<3>(json.at("ambient"));
    for (const Json &light : json.at("lights")) {
        Light made;
        made.position = numbers<4>(light.at("position_eye"));
        made.ambient = numbers<3>(light.at("ambient"));
        made.diffuse = numbers<3>(light.at("diffuse"));
        made.attenuation = numbers<3>(light.at("attenuation"));
        made.spot = light.contains("spot");
        if (made.spot) {
            const Json &spot = light.at("spot");
            made.spot_direction = numbers<3>(spot.at("direction_eye"));
            made.spot_exponent = spot.at("exponent").get<float>();
            made.spot_cutoff_deg = spot.at("cutoff_deg").get<float>();
        }
        out.lights.push_back(made);
    }
    return out;
}

Fog fog_of(const Json &json)
{
    Fog out;
    if (json.is_null()) return out;
    out.mode = json.at("mode").get<std::string>();
    out.colour = numbers<3>(json.at("colour"));
    out.density = json.at("density").get<float>();
    out.start = json.at("start").get<float>(), out.end = json.at("end").get<float>();
    return out;
}

void read_individuals(const std::string &folder, SceneIn &out)
{
    const auto table = read_array<uint32_t>(folder + "/actors.npy", "<u4");
    const auto places = read_array<float>(folder + "/model_view.npy", "<f4");
    const Json &names = out.json.at("actor_columns");
    const size_t columns = names.size(), rows = table.size() / columns;
    const auto column = [&](const char *name) {
        for (size_t c = 0; c < columns; ++c)
            if (names[c] == name) return c;
        throw Failure(folder + "/actors.npy has no column " + name);
    };
    for (size_t row = 0; row < rows; ++row) {
        const auto value = [&](const char *name) { return table[row * columns + column(name)]; };
        Individual person;
        person.actor = value("actor"), person.mesh = value("mesh");
        person.first_vertex = value("first_vertex"), person.vertex_count = value("vertex_count");
        person.first_palette = value("first_palette"), person.palette_count = value("palette_count");
        person.first_weight = value("first_weight"), person.weight_count = value("weight_count");
        person.draw_order = value("draw_order"), person.mirrored = (value("flags") & 1) != 0;
        for (size_t k = 0; k < 16; ++k) person.model_view[k] = places[16 * row + 4 * (k % 4) + k / 4];
        out.individuals.push_back(person);
    }
}

}  // namespace

std::string bytes_of(const std::string &path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Failure(path + " could not be read");
    return {std::istreambuf_iterator<char>(file), {}};
}

template <class Value>
std::vector<Value> read_array(const std::string &path, const char *type)
{
    const std::string file = bytes_of(path);
    if (file.size() < 10 || file.compare(0, 6, "\x93NUMPY") != 0) throw Failure(path + " is no NumPy array");
    const size_t head = 10 + static_cast<uint8_t>(file[8]) + 256 * static_cast<size_t>(static_cast<uint8_t>(file[9]));
    if (file.substr(0, head).find(std::string("'descr': '") + type + "'") == std::string::npos)
        throw Failure(path + " is not of type " + type);
    std::vector<Value> out((file.size() - head) / sizeof(Value));
    if (!out.empty()) std::memcpy(out.data(), file.data() + head, out.size() * sizeof(Value));
    return out;
}
template std::vector<float> read_array<float>(const std::string &, const char *);
template std::vector<uint32_t> read_array<uint32_t>(const std::string &, const char *);
template std::vector<uint16_t> read_array<uint16_t>(const std::string &, const char *);
template std::vector<uint8_t> read_array<uint8_t>(const std::string &, const char *);

SceneIn read_scene(const std::string &folder)
{
    SceneIn out;
    out.json = Json::parse(bytes_of(folder + "/capture.json"));
    if (out.json.at("format") != "claque-parity" || out.json.at("version") != 1 || out.json.at("kind") != "scene")
        throw Failure(folder + " holds no parity scene of version 1");
    out.width = out.json.at("width").get<int>(), out.height = out.json.at("height").get<int>();
    for (size_t k = 0; k < 16; ++k) out.projection[k] = out.json.at("projection").at(k % 4).at(k / 4).get<float>();
    out.lighting = lighting_of(out.json.at("lighting"));
    out.fog = fog_of(out.json.at("fog"));
    read_individuals(folder, out);
    out.palettes = read_array<float>(folder + "/palettes.npy", "<f4");
    out.weights = read_array<float>(folder + "/morph_weights.npy", "<f4");
    out.atlas = read_array<uint8_t>(folder + "/atlas.npy", "|u1");
    read_glb(folder + "/scene.glb", out);
    for (size_t i = 0; i < out.meshes.size(); ++i)
        out.meshes[i].normals_by_inverse = out.json.at("meshes").at(i).at("normals") == "inverse";
    return out;
}

}  // namespace parity_test

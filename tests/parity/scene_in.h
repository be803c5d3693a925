// A scene written by claque parity export, read by docs/parity.md alone.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace parity_test
{

using Json = nlohmann::ordered_json;

struct Texture {
    int width = 0, height = 0;
    int wrap_s = 0, wrap_t = 0;  // OpenGL's
    std::vector<uint8_t> rgba;
};

struct Material {
    size_t texture = 0;
    bool double_sided = false, holes = false, unlit = false;
    std::array<float, 3> emission{};
};

struct MorphTarget {
    uint32_t weight = 0;
    std::vector<uint32_t> vertices;
    std::vector<float> positions, normals;  // 3 each
};

// Neighbouring primitives of one material, as one range of indices.
struct Range {
    size_t material = 0, first = 0, count = 0;
};

// Triangles of one material that may show a zone: a clean primitive, or that part of a dirty one.
struct ZoneRange {
    uint32_t zone = 0;
    Range range;
};

struct Mesh {
    size_t vertices = 0;
    std::vector<float> positions, normals, uvs;
    std::vector<uint8_t> colours;                     // 4 a vertex, or none
    std::vector<std::vector<float>> joints, weights;  // sets of four a vertex
    std::vector<MorphTarget> targets;
    std::vector<uint32_t> indices;
    std::vector<Range> ranges;
    std::vector<ZoneRange> zone_ranges;  // the same, zone by zone
    bool normals_by_inverse = false;
};

struct Individual {
    uint32_t actor = 0, mesh = 0, first_vertex = 0, vertex_count = 0, first_palette = 0, palette_count = 0,
             first_weight = 0, weight_count = 0, draw_order = 0;
    bool mirrored = false;
    std::array<float, 16> model_view{};  // column after column
};

struct Light {
    std::array<float, 4> position{};
    std::array<float, 3> ambient{}, diffuse{}, attenuation{};
    bool spot = false;
    std::array<float, 3> spot_direction{};
    float spot_exponent = 0, spot_cutoff_deg = 180;
};

struct Lighting {
    bool enabled = false;
    std::array<float, 3> ambient{};
    std::vector<Light> lights;
};

struct Fog {
    std::string mode;  // empty: none
    std::array<float, 3> colour{};
    float density = 0, start = 0, end = 0;
};

struct SceneIn {
    Json json;  // capture.json
    int width = 0, height = 0;
    std::array<float, 16> projection{};  // column after column
    Lighting lighting;
    Fog fog;
    std::vector<Individual> individuals;
    std::vector<float> palettes, weights;  // 12 a joint: three rows of four
    std::vector<uint8_t> atlas;            // plates of 1024 rows of 256 colours
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
};

// Throws Failure.
SceneIn read_scene(const std::string &folder);

// Steps of reading: meshes, materials and textures of scene.glb; a NumPy array of this type, and its number of values.
void read_glb(const std::string &path, SceneIn &out);
std::string bytes_of(const std::string &path);
template <class Value>
std::vector<Value> read_array(const std::string &path, const char *type);

}  // namespace parity_test

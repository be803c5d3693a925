// A character as loaded: parts with their own vertices, materials, images. Made by lib/asset, lib/figures or from a
// host's own arrays; meshsplit turns it into a Template. Start-up only: plain std containers.
#pragma once

#include "lib/model/rig.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace claque::model
{

enum class Topology : uint8_t {
    points = 0,
    lines = 1,
    line_loop = 2,
    line_strip = 3,
    triangles = 4,
    triangle_strip = 5,
    triangle_fan = 6
};
enum class Wrap : uint8_t { repeat = 0, clamp = 1, mirror = 2 };
enum class AlphaMode : uint8_t {
    opaque = 0,
    mask = 1
};  // BLEND has become opaque, with a warning, before it comes here
enum class AlphaMeaning : uint8_t { opacity = 0, zone_keys = 1 };

// 8-bit RGBA, row 0 at v = 0 (glTF's and claque's top row; GL is given the same bytes with the same v).
struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;
    AlphaMeaning alpha = AlphaMeaning::opacity;
    std::string name;
};

// A hue range may wrap (first > last). Degrees [0, 360), fractions [0, 1]. S2 5.
struct HsbRange {
    float hue_min_deg = 0, hue_max_deg = 0;
    float saturation_min = 0, saturation_max = 0;
    float brightness_min = 1, brightness_max = 1;
};

// A region that has one colour per individual.
struct Zone {
    std::string name;
    uint8_t key = 0;                          // where images carry zone keys: the alpha that means this zone
    std::array<float, 3> colour = {1, 1, 1};  // colour of an individual that was given none; as GL takes it
    HsbRange range;                           // what claque draws colours from unless told otherwise
};

struct Material {
    std::string name;
    std::array<float, 4> base_colour = {1, 1, 1, 1};  // as GL takes it: already encoded, not linear
    uint32_t image = none;
    Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    uint32_t zone = none;  // the zone of everything drawn with it; none where its image carries zone keys
};

// Other images for the same surfaces: individuals that differ in more than colours (S1 1, S2 2.1). The first set is what
// the materials have themselves.
struct TextureSet {
    std::string name;
    std::vector<uint32_t> images;  // one a material: shown in place of its own; none: its own
};

struct MorphTarget {
    std::vector<glm::vec3> positions;  // deltas, one per vertex of the part, or empty
    std::vector<glm::vec3> normals;    // deltas, likewise
};

struct Part {
    std::string name;
    uint32_t node = none;  // the node that it hangs on (a skinned part's own node does not move it, but names it)
    bool skinned = false;
    uint32_t material = none;
    Topology topology = Topology::triangles;
    bool hidden = false;  // kept for dump, left out of the Template

    // S0 5.1: at which distances from the eye it is drawn, first <= d < last. A geometry in several levels of detail is
    // several parts with adjoining ranges.
    float lod_min_m = 0, lod_max_m = std::numeric_limits<float>::infinity();

    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // one per vertex, or empty: flat normals are made where the format wants it
    std::vector<glm::vec2> uvs;      // one per vertex or empty
    std::vector<std::array<uint8_t, 4>> colours;  // as GL takes them, one per vertex or empty
    std::vector<uint32_t> indices;                // empty: vertices in order

    // Influences: `influence_count` per vertex, entries of rig.palette and weights that sum to 1 (0 weight: unused).
    // Rigid parts have one influence of weight 1 on the entry (node, identity); every part has its influences filled
    // in.
    uint32_t influence_count = 1;
    std::vector<uint32_t> joints;
    std::vector<float> weights;

    uint32_t morph_set = none;
    std::vector<MorphTarget> morphs;
};

constexpr uint32_t max_texture_sets = 64;

struct Model {
    std::string name;
    Rig rig;
    std::vector<Zone> zones;
    std::vector<Image> images;
    std::vector<Material> materials;
    std::vector<TextureSet> texture_sets;  // besides the materials' own
    std::vector<Part> parts;               // file order: nodes depth first, primitives in order
    std::vector<std::string> warnings;
};

// Throws base::Error (CLQ_ARGUMENT) for the first broken rule: indices in range, arrays of equal length, finite
// numbers, weights that sum to 1 within 1e-3, images whose bytes match their size. What passes here is safe to split.
void check(const Model &model);
void check_texture_sets(const Model &model);  // of it alone

// The triangles of a part, strips and fans unrolled with their winding kept, degenerate ones dropped; none for points,
// lines.
std::vector<std::array<uint32_t, 3>> triangles_of(const Part &part);

}  // namespace claque::model

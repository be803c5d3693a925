// A character as loaded: parts with their own vertices, materials and images. lib/asset, lib/figures or a host's arrays
// produce it, and meshsplit turns it into a Template. It is used at start-up only, so it has plain std containers.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lib/model/rig.h"

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
enum class AlphaMode : uint8_t { opaque = 0, mask = 1 };  // BLEND has already become one of these
enum class AlphaMeaning : uint8_t { opacity = 0, zone_keys = 1 };

// 8-bit RGBA. Row 0 is at v = 0: the top row in glTF and in claque, and GL gets the same bytes with the same v.
struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;
    AlphaMeaning alpha = AlphaMeaning::opacity;
    std::string name;
};

// Hue wraps when min > max. Degrees [0, 360), fractions [0, 1]. S2 5.
struct HsbRange {
    float hue_min_deg = 0, hue_max_deg = 0;
    float saturation_min = 0, saturation_max = 0;
    float brightness_min = 1, brightness_max = 1;
};

// A region that has one colour per individual.
struct Zone {
    std::string name;
    uint8_t key = 0;                          // the alpha that marks this zone in images with zone keys
    std::array<float, 3> colour = {1, 1, 1};  // default colour of an individual, as for glColor
    HsbRange range;                           // the range that colours are sampled from by default
};

// How light acts on a material.
struct Lighting {
    bool unlit = false;                         // its colours are shown as they are
    std::array<float, 3> emission = {0, 0, 0};  // as for GL_EMISSION: encoded, in [0, 1]; none if unlit

    bool emits() const { return emission[0] > 0 || emission[1] > 0 || emission[2] > 0; }
    bool operator==(const Lighting &o) const { return unlit == o.unlit && emission == o.emission; }
    bool operator!=(const Lighting &o) const { return !(*this == o); }
    bool operator<(const Lighting &o) const { return unlit != o.unlit ? o.unlit : emission < o.emission; }
};

struct Material {
    std::string name;
    std::array<float, 4> base_colour = {1, 1, 1, 1};  // as for glColor: encoded, not linear
    uint32_t image = none;
    Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    Lighting lighting;
    uint32_t zone = none;  // the zone of all triangles with this material; none if its image has zone keys
};

// Images that replace the materials' own, so that individuals differ in more than colours (S1 1, S2 2.1). The
// materials' own images are the first set.
struct TextureSet {
    std::string name;
    std::vector<uint32_t> images;  // one per material, shown instead of its own; none: its own
};

struct MorphTarget {
    std::vector<glm::vec3> positions;  // deltas, one per vertex of the part, or empty
    std::vector<glm::vec3> normals;    // deltas, one per vertex of the part, or empty
    std::string name = {};
};

struct Part {
    std::string name;
    // The node that it hangs on. The own node of a skinned part does not move it but names it.
    uint32_t node = none;
    bool skinned = false;
    uint32_t material = none;
    Topology topology = Topology::triangles;
    bool hidden = false;  // kept for dumps, left out of the Template

    // S0 5.1: drawn at eye distances d with min <= d < max. A geometry with several levels of detail is several parts
    // with adjoining ranges.
    float lod_min_m = 0, lod_max_m = std::numeric_limits<float>::infinity();

    std::vector<glm::vec3> positions;
    // One per vertex or empty; flat normals are then made if the vertex format needs them.
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;  // one per vertex or empty
    // As for glColor, one per vertex or empty.
    std::vector<std::array<uint8_t, 4>> colours;
    std::vector<uint32_t> indices;  // empty: the vertices in order

    // `influence_count` influences per vertex: entries of rig.palette, and weights that sum to 1 (weight 0: unused). A
    // vertex of a rigid part has one influence of weight 1 on the entry (node, identity). Every part has influences.
    uint32_t influence_count = 1;
    std::vector<uint32_t> joints;
    std::vector<float> weights;

    uint32_t morph_set = none;
    std::vector<MorphTarget> morphs;
};

// A clip whose motion over the ground is taken out of its poses when the model is split (meshsplit/root_motion.h), and
// the node of the rig that carries that motion.
struct RootMotionRequest {
    uint32_t clip = 0, node = 0;
};

constexpr uint32_t max_texture_sets = 64;
constexpr uint32_t max_image_px = 16384;  // of either side
constexpr uint32_t max_influences = 64;   // of a vertex, in a Template

struct Model {
    std::string name;
    Rig rig;
    std::vector<Zone> zones;
    std::vector<Image> images;
    std::vector<Material> materials;
    std::vector<TextureSet> texture_sets;  // besides the materials' own
    std::vector<Part> parts;               // file order: nodes depth first, primitives in order
    std::vector<RootMotionRequest> root_motions;
    // Joints that the file names as parts of a human body (VRM): leftUpperLeg and a node of the rig.
    std::vector<std::pair<std::string, uint32_t>> human_bones;
    // Clips that came when levels of detail were accepted already: they do not count for what joints levels keep apart,
    // so that a character keeps its levels.
    uint32_t first_late_clip = 0, late_clip_count = 0;
    std::vector<std::string> warnings;

    // Bytes read, bytes after decompression and 4 bytes a decoded pixel; 0 without a file. The split may take a small
    // multiple of it (meshsplit/allowance.h).
    uint64_t source_bytes = 0;
};

// Throws base::Error (CLQ_ARGUMENT) for the first broken rule: indices in range, arrays of equal length, finite
// numbers, unit rotations, weights that sum to 1 within 1e-3, images whose bytes match their size, colours and ranges
// of zones within [0, 1] or [0, 360]. Every reader relies on these rules, which stand only here. A model that passes
// is safe to split. The split itself checks what root_motions name.
void check(const Model &model);

// Parts of the check that are needed earlier. A reader checks sizes before it copies arrays.
void check_texture_sets(const Model &model);
inline bool is_image_size(uint32_t width, uint32_t height)
{
    return width >= 1 && width <= max_image_px && height >= 1 && height <= max_image_px;
}
// Parts of a Template keep this limit; parts that are not drawn may exceed it. Throws base::Error (CLQ_ARGUMENT).
void check_influence_count(uint32_t influence_count, size_t part, const char *part_name);

// The triangles of a part. Strips and fans are unrolled with their winding, degenerate triangles are dropped; points
// and lines give none.
std::vector<std::array<uint32_t, 3>> triangles_of(const Part &part);

bool is_drawn(const Part &part);  // neither hidden nor without triangles

}  // namespace claque::model

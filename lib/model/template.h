// A character after splitting: immutable and shared by all its individuals. Made by meshsplit; S1 3, S1 4, S2 2.1.
//
// A Level holds one mesh in one vertex order: first `source_count` vertices that are skinned, then copies of some of
// them for the fused strategy. That strategy draws a dirty triangle once per zone it touches, with vertices of its own
// for each zone. A geometry cache array has room for all vertices; skinning fills the first part, copying the second.
#pragma once

#include "lib/model/model.h"
#include "lib/model/motion.h"
#include "lib/model/skin_plan.h"

namespace claque::model
{

// Vertices [first, first + count) have exactly `influences` influences each, from `first_influence` on.
struct InfluenceRun {
    uint32_t first = 0;
    uint32_t count = 0;
    uint32_t influences = 1;
    uint32_t first_influence = 0;
};

struct MorphDelta {
    uint32_t vertex = 0;
    float position[3] = {0, 0, 0};
    float normal[3] = {0, 0, 0};
};

// The deltas of one weight of the pose: level.morph_deltas[first .. first + count).
struct MorphRange {
    uint32_t weight = 0;
    uint32_t first = 0;
    uint32_t count = 0;
};

struct IndexRange {
    uint32_t first = 0;  // index of Level::indices
    uint32_t count = 0;  // three per triangle
};

// A zone of one texture. `key` is the renumbered alpha in the texture given to GL; keys ascend with the index.
struct ZoneKey {
    uint32_t zone = 0;  // index of Template::zones
    uint8_t key = 0;
};

// The image of a texture in one further texture set; its zones and wraps are the texture's.
struct TextureImage {
    explicit TextureImage(std::pmr::memory_resource *memory) : rgba(memory) {}
    uint32_t width = 0, height = 0;  // powers of two
    Array<uint8_t> rgba;             // as Texture::rgba
};

struct Texture {
    explicit Texture(std::pmr::memory_resource *memory) : rgba(memory), keys(memory), set_images(memory) {}
    uint32_t width = 0, height = 0;                     // powers of two
    Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;  // repeat or clamp; mirror has been baked
    // Alpha: the renumbered key, or 0 for a hole of an alpha-masked material.
    Array<uint8_t> rgba;
    Array<ZoneKey> keys;     // ascending by key
    bool has_holes = false;  // in any set
    // One per Template::texture_sets if any of them differs; empty: all show the same image. Triangles are clean or
    // dirty by their zones in all sets, so that all sets share indices and vertices.
    Array<TextureImage> set_images;
};

// The triangles of one zone. `zone_index` counts within the texture's keys.
struct Bin {
    uint32_t zone_index = 0;
    IndexRange range;
};

// The triangles with one texture, sidedness and lighting: the unit of drawing. Most characters have one.
struct Surface {
    explicit Surface(std::pmr::memory_resource *memory) : clean(memory), dirty_by_zone(memory), part_offsets(memory) {}
    uint32_t texture = 0;
    bool double_sided = false;
    Lighting lighting;  // its emission is multiplied by the texture, as all light
    Array<Bin> clean;   // triangles of one zone, one bin for each zone that has any
    // Triangles of several zones, once each (source vertices): S1's passes.
    IndexRange dirty;
    // For each zone, ascending: the dirty triangles that touch it (source vertices).
    Array<Bin> dirty_by_zone;
    // Clean triangles once; dirty ones once per zone touched; with their own vertices. In the order of the bins within
    // each part, so that strategies show the same triangle where depths tie.
    IndexRange fused;

    // The offsets of the level's parts in each of these ranges; the triangles of a range are sorted by part. Ranges are
    // in the order clean bins, dirty, dirty_by_zone bins, fused. Each has level.parts.size() + 1 offsets, from 0 to its
    // count. Empty if the level has one part.
    Array<uint32_t> part_offsets;
};

struct Sphere {
    glm::vec3 centre = glm::vec3(0);
    float radius = 0;
};

// A sphere of those vertices of one part that one palette entry influences, before that entry transforms them.
struct PartSphere {
    uint32_t entry = 0;
    Sphere bind;  // includes morph targets at their largest weights
};

// The unit of part culling (S0 4.1, 4.2 phase 3): rigid geometry on one node, or a skinned part. In a pose it lies
// inside the hull of its spheres, transformed by their entries; these spheres are the leaves of the Internal Bspheres.
struct LevelPart {
    // The node that it hangs on. For a skinned part: the lowest node above all nodes that move it, or the root above
    // the first of these if they are in several trees.
    uint32_t node = 0;
    uint32_t first_sphere = 0, sphere_count = 0;  // of Level::part_spheres
    uint32_t triangles = 0;
};

// A set of parts fits one 64-bit number; a model with more parts has some drawn together.
constexpr uint32_t max_level_parts = 64;
constexpr size_t max_levels = 64;

struct Level {
    explicit Level(std::pmr::memory_resource *memory)
        : positions(memory),
          normals(memory),
          runs(memory),
          joints(memory),
          weights(memory),
          skinning(memory),
          morph_deltas(memory),
          morph_ranges(memory),
          copies(memory),
          uvs(memory),
          colours(memory),
          slots(memory),
          indices(memory),
          surfaces(memory),
          active(memory),
          nodes(memory),
          entries(memory),
          parts(memory),
          part_spheres(memory)
    {
    }
    uint32_t source_count = 0;
    uint32_t vertex_count = 0;  // source_count + copies.size()

    Array<float> positions;    // bind pose, 3 per source vertex
    Array<float> normals;      // unit length, 3 per source vertex
    Array<InfluenceRun> runs;  // cover the source vertices in order, fewer influences first
    Array<uint16_t> joints;    // entries of rig.palette
    Array<float> weights;      // sum to 1 per vertex
    SkinPlan skinning;         // the order of skinning; empty: run by run
    Array<MorphDelta> morph_deltas;
    Array<MorphRange> morph_ranges;

    Array<uint32_t> copies;  // vertex source_count + i repeats source vertex copies[i]
    Array<float> uvs;        // 2 per vertex, copies included
    // RGBA per vertex, copies included, or empty; multiplied by the zone's colour
    Array<uint8_t> colours;
    // Per vertex, copies included: the entry of an individual's colour table that the fused strategy uses, 2 *
    // zone_index + raised of its surface. raised = 1 selects the alpha threshold of that zone.
    Array<uint16_t> slots;
    Array<uint32_t> indices;
    Array<Surface> surfaces;

    float switch_distance_m = 0;  // this level serves from here up to the next one's; the first from 0

    // S0 5.2: the part of the skeleton that this level needs. Levels with equal nodes and entries have equal
    // `skeletal_level` and share poses.
    uint32_t skeletal_level = 0;  // the first level that evaluates these nodes and entries
    // One per node: true if it is evaluated; if active, nodes and entries are empty, everything is evaluated.
    Array<uint8_t> active;
    Array<uint32_t> nodes;  // the evaluated nodes, ascending, so parents first
    // The palette entries that vertices of this level need, or of a later one with equal skeletal_level.
    Array<uint32_t> entries;

    Array<LevelPart> parts;  // at most max_level_parts, at least one if there are triangles
    Array<PartSphere> part_spheres;
};

// Bounds of a node in every pose that the Sklsroot Bsphere holds.
struct NodeReach {
    float distance = 0;  // of the node's origin from sklsroot.centre
    float scale = 1;     // of lengths in the node's frame
};

// A bound that grows with the weights of additive layers (pose/layer.h); these sum to most_added at most.
struct AdditiveBound {
    float base = 0;        // without additive layers
    float per_weight = 0;  // for each 1 of weight
    float at(float added) const { return base + per_weight * added; }
};
constexpr float max_additive_weight = 32;

// As NodeReach, for all blends of clips (S2 3.3).
struct BlendReach {
    AdditiveBound distance, scale;
};

struct SplitReport {
    uint32_t triangles = 0;
    uint32_t degenerate = 0;  // dropped: no area in any pose of the rest mesh
    uint32_t dirty = 0;
    uint32_t dirty_zone_sum = 0;   // zones touched, summed over dirty triangles: mean = sum / dirty
    uint32_t coincident = 0;       // triangles on another with the same corners
    uint32_t fused_triangles = 0;  // triangles of the fused stream
    uint32_t copies = 0;           // vertices that the fused stream adds
    uint32_t parts = 0;            // of the level that has most, before some are culled as one; not in prepared files
};

struct Template {
    explicit Template(std::pmr::memory_resource *memory)
        : name(memory),
          rig(memory),
          motion(memory),
          zone_names(memory),
          zone_colours(memory),
          zone_ranges(memory),
          zone_clean(memory),
          texture_sets(memory),
          textures(memory),
          levels(memory),
          node_reach(memory),
          blend_reach(memory)
    {
    }
    Template(const Template &) = delete;
    Template &operator=(const Template &) = delete;

    std::pmr::string name;
    Rig rig;
    Motion motion;  // its clips for sampling; empty: sampled from their channels
    // True if every palette matrix stays a similarity in every pose: normals may use it directly.
    bool similar_only = true;

    Array<std::pmr::string> zone_names;
    Array<std::array<float, 3>> zone_colours;
    Array<HsbRange> zone_ranges;
    Array<uint32_t> zone_clean;  // clean triangles per zone, level 0

    // Names of all but the first set, which is the default of all individuals.
    Array<std::pmr::string> texture_sets;
    Array<Texture> textures;
    Array<Level> levels;  // at least one, finest first

    // S0 4.1: in the actor's own space, holds every vertex of every level in every pose of every clip, with the degrees
    // of freedom anywhere in their ranges.
    Sphere sklsroot;
    // Per node: its bounds in all these poses, so that attached objects can be bounded.
    Array<NodeReach> node_reach;
    AdditiveBound blend_radius;     // of a sphere about sklsroot.centre that holds every vertex in every blend
    Array<BlendReach> blend_reach;  // per node
    SplitReport report;

    uint32_t zone_count() const { return static_cast<uint32_t>(zone_names.size()); }
    uint32_t texture_set_count() const { return 1 + static_cast<uint32_t>(texture_sets.size()); }

    // True if every vertex hangs on one node and nothing morphs, so that GL's matrix stack can transform it.
    bool has_rigid_parts_only() const;
};

}  // namespace claque::model

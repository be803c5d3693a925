// A character as split: immutable, shared by all its individuals. Made by meshsplit; S1 3, S1 4, S2 2.1.
//
// One Level holds one mesh in one vertex order: `source_count` vertices that are skinned, then copies of some of them
// that the fused strategy needs (a dirty triangle stands once per zone it touches, with vertices of its own for that
// zone). A geometry cache array is sized for all of them; skinning fills the first part, copying the second.
#pragma once

#include "lib/model/model.h"
#include "lib/model/motion.h"
#include "lib/model/skin_plan.h"

namespace claque::model
{

// Vertices [first, first + count) all have exactly `influences` influences, found from `first_influence` on.
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
    uint32_t first = 0;  // into Level::indices
    uint32_t count = 0;  // three a triangle
};

// A zone of one texture: `key` is the renumbered alpha that the texture given to GL holds, ascending with the index.
struct ZoneKey {
    uint32_t zone = 0;  // of Template::zones
    uint8_t key = 0;
};

// What a texture shows of one further texture set: zones and wraps are the texture's.
struct TextureImage {
    explicit TextureImage(std::pmr::memory_resource *memory) : rgba(memory) {}
    uint32_t width = 0, height = 0;  // powers of two
    Array<uint8_t> rgba;             // as Texture::rgba
};

struct Texture {
    explicit Texture(std::pmr::memory_resource *memory) : rgba(memory), keys(memory), set_images(memory) {}
    uint32_t width = 0, height = 0;                     // powers of two
    Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;  // repeat or clamp; mirror has been baked
    Array<uint8_t> rgba;     // alpha: the renumbered key, or 0 where an alpha-masked material has a hole
    Array<ZoneKey> keys;     // ascending by key
    bool has_holes = false;  // in any set
    // One for each of Template::texture_sets, where any of them differs; empty: all show the same. Triangles are clean
    // or dirty by what they show in any set, so that all sets share indices and vertices.
    Array<TextureImage> set_images;
};

// Index ranges of the triangles of one zone. `zone_index` counts within the texture's keys.
struct Bin {
    uint32_t zone_index = 0;
    IndexRange range;
};

// What one texture and one sidedness cover: the unit of drawing. Most characters have one.
struct Surface {
    explicit Surface(std::pmr::memory_resource *memory) : clean(memory), dirty_by_zone(memory), part_offsets(memory) {}
    uint32_t texture = 0;
    bool double_sided = false;
    Array<Bin> clean;          // triangles of one zone, one bin a zone that has any
    IndexRange dirty;          // triangles of several zones, once each (source vertices): S1's passes
    Array<Bin> dirty_by_zone;  // for each zone, ascending: the dirty triangles that touch it (source vertices)
    IndexRange fused;          // clean triangles once; dirty ones once per zone touched, ascending; own vertices

    // Where the parts of the level begin in each of these ranges, whose triangles stand part by part: the ranges in the
    // order clean bins, dirty, dirty_by_zone bins, fused; for each, level.parts.size() + 1 places within it, from 0 to
    // its count. Empty where the level has one part.
    Array<uint32_t> part_offsets;
};

struct Sphere {
    glm::vec3 centre = glm::vec3(0);
    float radius = 0;
};

// The vertices of one part that one palette entry has a hand in, as they lie before that entry moves them.
struct PartSphere {
    uint32_t entry = 0;
    Sphere bind;  // morph targets included, each at the most that its weight may be
};

// What is drawn or left out by itself (S0 4.1, 4.2 phase 3): rigid geometry on one node, or a skinned part. In a pose it
// lies inside the hull of its spheres as their entries move them: these are the leaves of the Internal Bspheres.
struct LevelPart {
    uint32_t node = 0;  // that it hangs on; of a skinned part the lowest node above all that moves it, or
                        // the root above the first of these where they stand in several trees
    uint32_t first_sphere = 0, sphere_count = 0;  // of Level::part_spheres
    uint32_t triangles = 0;
};

constexpr uint32_t max_level_parts =
    64;  // so that a set of them is one number; a model with more has some drawn together

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

    Array<float> positions;    // bind pose, 3 a source vertex
    Array<float> normals;      // unit, 3 a source vertex
    Array<InfluenceRun> runs;  // cover the source vertices in order, fewer influences first
    Array<uint16_t> joints;    // entries of rig.palette
    Array<float> weights;      // sum to 1 per vertex
    SkinPlan skinning;         // how to go through them; empty: run by run
    Array<MorphDelta> morph_deltas;
    Array<MorphRange> morph_ranges;

    Array<uint32_t> copies;  // vertex source_count + i repeats source vertex copies[i]
    Array<float> uvs;        // 2 a vertex, copies included
    Array<uint8_t> colours;  // RGBA a vertex, copies included, or empty: times the zone's colour
    // Per vertex, copies included: which entry of an individual's colour table the fused strategy gives it:
    // 2 * zone_index + raised of the surface it belongs to; raised = 1 carries the alpha threshold of that zone.
    Array<uint16_t> slots;
    Array<uint32_t> indices;
    Array<Surface> surfaces;

    float switch_distance_m = 0;  // this level serves from here on, up to the next one's; the first from 0

    // S0 5.2: what is left of the skeleton at this level. Levels with equal nodes and entries have equal `skeletal`, and
    // share poses.
    uint32_t skeletal_level = 0;  // the first level that evaluates these nodes and entries
    Array<uint8_t> active;        // one a node: whether it is evaluated; empty, all three: everything is
    Array<uint32_t> nodes;        // those that are, ascending, so parents first
    Array<uint32_t> entries;  // of the palette that this level's vertices, or a later one's of equal skeletal, ask for

    Array<LevelPart> parts;  // at most max_level_parts, at least one where there are triangles
    Array<PartSphere> part_spheres;
};

// In every pose that the Sklsroot Bsphere holds.
struct NodeReach {
    float distance = 0;  // of the node's origin from sklsroot.centre
    float scale = 1;     // that lengths in the node's frame undergo
};

// A bound that grows with the weights of what is added to a pose (pose/layer.h), which sum to most_added at most.
struct AdditiveBound {
    float base = 0;        // where nothing is added
    float per_weight = 0;  // for each 1 of weight
    float at(float added) const { return base + per_weight * added; }
};
constexpr float max_additive_weight = 32;

// As NodeReach, whatever clips are blended (S2 3.3).
struct BlendReach {
    AdditiveBound distance, scale;
};

struct SplitReport {
    uint32_t triangles = 0;
    uint32_t degenerate = 0;  // dropped: no area in any pose of the rest mesh
    uint32_t dirty = 0;
    uint32_t dirty_zone_sum = 0;   // over dirty triangles, zones touched: mean = sum / dirty
    uint32_t coincident = 0;       // triangles that lie on another with the same corners
    uint32_t fused_triangles = 0;  // triangles of the fused stream
    uint32_t copies = 0;           // vertices that the fused stream adds
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
    Motion motion;             // its clips as they are sampled; empty: from their channels
    bool similar_only = true;  // every palette matrix stays a similarity in every pose: normals may use it directly

    Array<std::pmr::string> zone_names;
    Array<std::array<float, 3>> zone_colours;
    Array<HsbRange> zone_ranges;
    Array<uint32_t> zone_clean;  // clean triangles per zone, level 0

    Array<std::pmr::string> texture_sets;  // names of those besides the first, which all individuals have at first
    Array<Texture> textures;
    Array<Level> levels;  // at least one, finest first

    Sphere
        sklsroot;  // S0 4.1: holds every vertex of every level in every pose of every clip with the degrees of freedom
                   // anywhere in their ranges, in the actor's own space
    Array<NodeReach>
        node_reach;  // per node: where it gets to in all these poses, so that what is attached to it can be held
    AdditiveBound blend_radius;     // of a sphere round sklsroot.centre that holds every vertex in every blend
    Array<BlendReach> blend_reach;  // per node
    SplitReport report;

    uint32_t zone_count() const { return static_cast<uint32_t>(zone_names.size()); }
    uint32_t texture_set_count() const { return 1 + static_cast<uint32_t>(texture_sets.size()); }

    // Whether everything hangs on one node each and nothing morphs, so that GL's matrix stack can place it.
    bool has_rigid_parts_only() const;
};

}  // namespace claque::model

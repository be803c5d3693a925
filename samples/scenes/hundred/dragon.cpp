#include "samples/scenes/hundred/dragon.h"

#include "samples/scenes/hundred/dragon_shape.h"
#include "samples/scenes/hundred/paint.h"
#include "samples/scenes/hundred/swim.h"

namespace scenes::hundred
{
namespace
{

bool lives_at(uint32_t node, float distance_m)
{
    const float ends = skeleton()[node].ends_m;
    return ends == 0 || ends > distance_m;
}

// A node's piece and those of the nodes below it that have ended: the geometry that replaces them.
void gather(PieceMesh &into, uint32_t node, float distance_m, Detail detail)
{
    const PieceMesh own = piece_of(node, detail);
    into.positions.insert(into.positions.end(), own.positions.begin(), own.positions.end());
    into.uvs.insert(into.uvs.end(), own.uvs.begin(), own.uvs.end());
    for (uint32_t child = node + 1; child < bone_count; ++child)
        if (skeleton()[child].parent == static_cast<int>(node) && !lives_at(child, distance_m))
            gather(into, child, distance_m, detail);
}

struct Piece {
    uint32_t node;
    float first_m, last_m;
    PieceMesh mesh;  // in the node's own frame
};

std::vector<Piece> pieces()
{
    constexpr float from[] = {0, mid_m, far_m}, to[] = {mid_m, far_m, 0};
    std::vector<Piece> out;
    for (int level = 0; level < 3; ++level)
        for (uint32_t node = 0; node < bone_count; ++node) {
            if (!lives_at(node, from[level])) continue;
            Piece piece = {node, from[level], to[level], {}};
            gather(piece.mesh, node, from[level], static_cast<Detail>(level));
            const Point at = joint(node);
            const float origin[3] = {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
            for (size_t i = 0; i < piece.mesh.positions.size(); ++i) piece.mesh.positions[i] -= origin[i % 3];
            out.push_back(std::move(piece));
        }
    return out;
}

std::vector<clq_node_def> nodes()
{
    std::vector<clq_node_def> out;
    for (uint32_t node = 0; node < bone_count; ++node) {
        const Bone &bone = skeleton()[node];
        const Point at = joint(node),
                    above = bone.parent < 0 ? Point{0, 0, 0} : joint(static_cast<uint32_t>(bone.parent));
        clq_node_def def = {};
        def.name = bone.name;
        def.parent = bone.parent < 0 ? CLQ_NONE : static_cast<uint32_t>(bone.parent);
        const Point step = at - above;
        def.translation[0] = static_cast<float>(step.x);
        def.translation[1] = static_cast<float>(step.y);
        def.translation[2] = static_cast<float>(step.z);
        def.deactivation_m = bone.ends_m;
        out.push_back(def);
    }
    return out;
}

std::vector<clq_part_def> parts_of(const std::vector<Piece> &pieces)
{
    std::vector<clq_part_def> out;
    for (const Piece &piece : pieces) {
        clq_part_def def = {};
        def.name = skeleton()[piece.node].name;
        def.node = piece.node;
        def.vertex_count = static_cast<uint32_t>(piece.mesh.positions.size() / 3);
        def.positions = piece.mesh.positions.data();
        def.uvs = piece.mesh.uvs.data();
        def.lod_min_m = piece.first_m;
        def.lod_max_m = piece.last_m;
        out.push_back(def);
    }
    return out;
}

std::vector<clq_zone_def> zones()
{
    std::vector<clq_zone_def> out;
    for (uint32_t cell = 0; cell < cell_count; ++cell) {
        const ZonePaint &paint = zone_paint(static_cast<Cell>(cell));
        out.push_back({paint.name,
                       key_of(static_cast<Cell>(cell)),
                       {paint.colour[0], paint.colour[1], paint.colour[2]},
                       paint.range});
    }
    return out;
}

template <class Def>
uint32_t count_of(const Def &list)
{
    return static_cast<uint32_t>(list.size());
}

Own<clq_template> make_dragon(clq_context *context)
{
    const std::vector<Piece> made = pieces();
    const std::vector<clq_node_def> bones = nodes();
    const std::vector<clq_part_def> parts = parts_of(made);
    const std::vector<clq_zone_def> dyed = zones();
    const std::array<clq_dof_def, dof_count> freedoms = dofs();
    const std::vector<uint8_t> picture = atlas();
    const clq_image_def image = {"dragon", atlas_cells_wide * cell_px, atlas_cells_high * cell_px, picture.data(),
                                 CLQ_ALPHA_ZONE_KEYS};
    clq_material_def material = {};
    material.name = "lacquer";
    material.wrap_s = material.wrap_t = CLQ_WRAP_CLAMP;
    material.zone = CLQ_NONE;
    const Swim swim;

    clq_template_def def = clq_template_def_init();
    def.name = "dragon";
    def.node_count = count_of(bones);
    def.nodes = bones.data();
    def.image_count = 1;
    def.images = &image;
    def.zone_count = count_of(dyed);
    def.zones = dyed.data();
    def.material_count = 1;
    def.materials = &material;
    def.part_count = count_of(parts);
    def.parts = parts.data();
    def.clip_count = 1;
    def.clips = &swim.clip;
    def.dof_count = dof_count;
    def.dofs = freedoms.data();
    clq_template *out = nullptr;
    check(clq_template_build(context, &def, &out), "the dragon");
    return Own<clq_template>(out);
}

}  // namespace

clq_template *dragon_of(Library &library)
{
    return library.own("dragon", [&] { return make_dragon(library.context()); });
}

}  // namespace scenes::hundred

#include "samples/parity/write/drawn_actors.h"

#include <algorithm>

#include "samples/scenes/check.h"

namespace parity
{

using scenes::check;

namespace
{

constexpr const char *columns[] = {"actor",         "mesh",         "first_vertex", "vertex_count", "first_palette",
                                   "palette_count", "first_weight", "weight_count", "draw_order",   "flags"};

clq_template_info info_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    return info;
}

}  // namespace

DrawnActors::DrawnActors(const clq_view *view) : view_(view)
{
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(view, &stats));
    for (uint32_t i = 0; i < stats.visible; ++i) {
        Individual person = {};
        check(clq_view_get_drawn_actor(view, i, &person.drawn_actors));
        person.place = i;
        if (!person.drawn_actors.shadow_only) individuals_.push_back(person);
    }
    std::sort(individuals_.begin(), individuals_.end(), [](const Individual &a, const Individual &b) {
        return a.drawn_actors.actor.index1 < b.drawn_actors.actor.index1;
    });
    // Individuals that are left out leave no gaps.
    std::vector<uint32_t> places;
    for (const Individual &person : individuals_) places.push_back(person.place);
    std::sort(places.begin(), places.end());
    for (Individual &person : individuals_) {
        person.draw_order =
            static_cast<uint32_t>(std::lower_bound(places.begin(), places.end(), person.place) - places.begin());
        person.mesh = mesh_of(person.drawn_actors);
        person.first_vertex = static_cast<uint32_t>(vertices_);
        person.first_palette = static_cast<uint32_t>(palette_rows_);
        person.first_weight = static_cast<uint32_t>(morph_weights_);
        vertices_ += person.drawn_actors.vertex_count;
        palette_rows_ += person.drawn_actors.joint_count;
        morph_weights_ += person.drawn_actors.morph_weight_count;
    }
    if (vertices_ > UINT32_MAX || palette_rows_ > UINT32_MAX)
        throw scenes::Failure("more vertices or matrices than a parity folder counts: show fewer individuals");
}

uint32_t DrawnActors::mesh_of(const clq_drawn_actor &drawn_actors)
{
    const size_t known =
        static_cast<size_t>(std::find(templates_.begin(), templates_.end(), drawn_actors.tmpl) - templates_.begin());
    const clq_template_info info = info_of(drawn_actors.tmpl);
    if (known == templates_.size()) {
        templates_.push_back(drawn_actors.tmpl);
        first_mesh_.push_back(static_cast<uint32_t>(meshes_.size()));
        for (uint32_t set = 0; set < info.texture_set_count; ++set)
            for (uint32_t level = 0; level < info.level_count; ++level)
                meshes_.push_back({static_cast<uint32_t>(known), level, set});
    }
    return first_mesh_[known] + drawn_actors.texture_set * info.level_count + drawn_actors.level;
}

void DrawnActors::write_actors(Folder &folder) const
{
    std::vector<uint32_t> table;
    for (const Individual &person : individuals_)
        table.insert(
            table.end(),
            {person.drawn_actors.actor.index1, person.mesh, person.first_vertex, person.drawn_actors.vertex_count,
             person.first_palette, person.drawn_actors.joint_count, person.first_weight,
             person.drawn_actors.morph_weight_count, person.draw_order, person.drawn_actors.mirrored ? 1u : 0u});
    folder.array("actors.npy", table, {individuals_.size(), std::size(columns)});
}

void DrawnActors::describe(Json &out) const
{
    out["actors"] = individuals_.size();
    out["vertices"] = vertices_;
    out["actor_columns"] = columns;
    out["templates"] = Json::array();
    for (const clq_template *tmpl : templates_) {
        const clq_template_info info = info_of(tmpl);
        Json zones = Json::array();
        for (uint32_t i = 0; i < info.zone_count; ++i) {
            clq_zone_info zone = clq_zone_info_init();
            check(clq_template_get_zone(tmpl, i, &zone));
            zones.push_back(zone.name);
        }
        out["templates"].push_back({{"name", info.name}, {"zones", zones}});
    }
    out["meshes"] = Json::array();
    for (const MeshName &name : meshes_) {
        clq_level_info level = clq_level_info_init();
        clq_mesh mesh = clq_mesh_init();
        check(clq_template_get_level(templates_[name.tmpl], name.level, &level));
        check(clq_template_get_mesh(templates_[name.tmpl], name.level, &mesh));
        out["meshes"].push_back({{"template", name.tmpl},
                                 {"level", name.level},
                                 {"texture_set", name.texture_set},
                                 {"vertices", mesh.vertex_count},
                                 {"triangles", level.triangle_count},
                                 {"normals", mesh.normals_by_inverse ? "inverse" : "direct"}});
    }
}

Skinned::Skinned(const DrawnActors &drawn_actors)
    : positions(3 * drawn_actors.vertices()), normals(3 * drawn_actors.vertices())
{
    for (const Individual &person : drawn_actors.individuals()) {
        const uint32_t count = person.drawn_actors.vertex_count;
        float *own = positions.data() + 3 * static_cast<size_t>(person.first_vertex);
        check(clq_view_get_vertices(drawn_actors.view(), person.place, own,
                                    normals.data() + 3 * static_cast<size_t>(person.first_vertex), count));
        float longest = 0;
        for (int axis = 0; axis < 3; ++axis) {
            float low = count ? own[axis] : 0, high = low;
            for (uint32_t v = 0; v < count; ++v) {
                low = std::min(low, own[3 * static_cast<size_t>(v) + static_cast<size_t>(axis)]);
                high = std::max(high, own[3 * static_cast<size_t>(v) + static_cast<size_t>(axis)]);
            }
            longest = std::max(longest, high - low);
        }
        sizes.push_back(longest);
    }
}

}  // namespace parity

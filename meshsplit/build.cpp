#include "meshsplit/build.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "lib/base/error.h"
#include "lib/model/template_check.h"
#include "meshsplit/allowance.h"
#include "meshsplit/blend_reach.h"
#include "meshsplit/charges.h"
#include "meshsplit/level_builder.h"
#include "meshsplit/level_plan.h"
#include "meshsplit/reach.h"
#include "meshsplit/rest.h"
#include "meshsplit/skeletal.h"
#include "meshsplit/spheres.h"
#include "meshsplit/template_rig.h"
#include "meshsplit/textures.h"

namespace claque::meshsplit
{

namespace
{

void copy_zones(const MaterialPlan &materials, model::Template &out)
{
    for (const model::Zone &zone : materials.zones) {
        out.zone_names.emplace_back(zone.name.c_str());
        out.zone_colours.push_back(zone.colour);
        out.zone_ranges.push_back(zone.range);
    }
}

void report(const Mesh &mesh, const TriangleZones &zones, model::Template &out)
{
    model::SplitReport &r = out.report;
    r.triangles = static_cast<uint32_t>(mesh.triangles.size());
    r.degenerate = mesh.degenerate;
    r.coincident = mesh.coincident;
    r.copies = static_cast<uint32_t>(out.levels[0].copies.size());
    out.zone_clean.assign(out.zone_names.size(), 0);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uint32_t count = zones.count(t);
        r.fused_triangles += count;
        if (count > 1) ++r.dirty, r.dirty_zone_sum += count;
        const model::Texture &texture = out.textures[mesh.surfaces[mesh.triangles[t].surface].texture];
        if (count == 1) ++out.zone_clean[texture.keys[zones.of(t)[0]].zone];
    }
}

void check_palette(const model::Model &model, const model::Rig &rig)
{
    if (rig.palette.size() > 65536)
        base::fail(CLQ_LIMIT, "model '%s' has %zu joints: a template can have 65536", model.name.c_str(),
                   rig.palette.size());
}

void check_limits(const model::Model &model)
{
    check_palette(model, model.rig);
    for (size_t i = 0; i < model.parts.size(); ++i)
        if (!model.parts[i].hidden)
            model::check_influence_count(model.parts[i].influence_count, i, model.parts[i].name.c_str());
}

uint32_t texture_limit(uint32_t wanted)
{
    if (wanted == 0) base::fail(CLQ_ARGUMENT, "the maximum texture size is 0 texels");
    uint32_t p = 1;
    while (p <= wanted / 2 && p < 16384) p *= 2;
    return p;
}

class Builder
{
public:
    Builder(const model::Model &model, const BuildOptions &options, Allowance &allowance, model::Template &out)
        : model_(model),
          materials_(plan_materials(model)),
          plans_(plan_levels(model)),
          drawn_(drawn_parts(model)),
          allowance_(allowance),
          first_weights_(fill_rig(model, allowance, out.rig)),
          whole_(charged_whole()),
          options_(options),
          memory_(out.levels.get_allocator().resource()),
          out_(out)
    {
        if (whole_.triangles.empty()) refuse_empty(whole_);
        out_.name = model.name.c_str();
        copy_zones(materials_, out_);
        for (const model::TextureSet &set : model.texture_sets) out_.texture_sets.emplace_back(set.name.c_str());
        for (const uint32_t part : drawn_)
            for (const glm::vec3 &p : model.parts[part].positions) extent_ = std::max(extent_, glm::length(p));
    }

    void run()
    {
        charge_textures(model_, materials_, texture_limit(options_.max_texture_px), allowance_);
        const auto make = [this] {
            texture_of_ =
                make_textures(model_, materials_, texture_limit(options_.max_texture_px), whole_, out_.textures);
        };
        std::vector<Mesh> meshes;
        options_.jobs.try_each(2, [&](uint32_t job) {
            if (job == 0) make();
            else if (plans_.size() > 1) meshes = all_meshes();
        });
        if (plans_.size() == 1) meshes.push_back(std::move(whole_));
        for (const LevelPlan &plan : plans_) {
            out_.levels.emplace_back(memory_);
            if (plans_.size() > 1) out_.levels.back().switch_distance_m = plan.distance_m;
        }
        fill_levels(meshes);
        std::vector<const std::vector<uint8_t> *> active;
        for (const LevelPlan &plan : plans_) active.push_back(&plan.active);
        set_skeletons(active, out_.rig.palette.size(), out_.levels);
        out_.similar_only = similar_only(out_.rig);
    }

private:
    static std::vector<uint32_t> drawn_parts(const model::Model &model)
    {
        std::vector<uint32_t> out;
        for (uint32_t p = 0; p < model.parts.size(); ++p)
            if (model::is_drawn(model.parts[p])) out.push_back(p);
        return out;
    }

    Mesh charged_whole()
    {
        charge_meshes(model_, plans_, allowance_);
        return merge(model_, materials_, whole());
    }

    // What is shown at any distance: textures are made for all of it.
    Selection whole() const
    {
        Selection all = all_visible(model_);
        all.first_weights = first_weights_;
        return all;
    }

    [[noreturn]] void refuse_empty(const Mesh &mesh) const
    {
        base::fail(CLQ_ARGUMENT, "model '%s' has no triangle to draw%s: %zu parts, %u triangles without area",
                   model_.name.c_str(), plans_.size() > 1 ? " near the eye" : "", drawn_.size(), mesh.degenerate);
    }

    // In sequence, because meshes append matrices to the palette.
    std::vector<Mesh> all_meshes()
    {
        std::vector<Mesh> meshes;
        for (const LevelPlan &plan : plans_) {
            meshes.push_back(mesh_at(plan));
            if (meshes[0].triangles.empty()) refuse_empty(meshes[0]);
        }
        return meshes;
    }

    Mesh mesh_at(const LevelPlan &plan)
    {
        std::vector<uint8_t> used(model_.rig.palette.size());
        for (const uint32_t p : plan.parts)
            for (size_t i = 0; i < model_.parts[p].joints.size(); ++i)
                if (model_.parts[p].weights[i] != 0) used[model_.parts[p].joints[i]] = 1;
        Selection selection;
        selection.parts = plan.parts;
        selection.entries = surviving_entries(out_.rig, plan.active, used, extent_);
        selection.rig = &out_.rig;
        selection.first_weights = first_weights_;
        check_palette(model_, out_.rig);
        return merge(model_, materials_, selection);
    }

    void fill_levels(std::vector<Mesh> &meshes)
    {
        const ZoneImages zone_images(out_.textures);
        const ZoneLimits limits = {allowance_.bytes() / 2, allowance_.texels(), allowance_.source_bytes(),
                                   model_.zones.size()};
        const uint32_t count = static_cast<uint32_t>(meshes.size());
        std::vector<TriangleZones> zones(count);
        options_.jobs.try_each(count, [&](uint32_t k) {
            for (MeshSurface &surface : meshes[k].surfaces) surface.texture = texture_of_[surface.texture];
            zones[k] = zones_of_triangles(meshes[k], zone_images, limits);
        });
        // All levels share the limit: the finest has most of the triangles.
        allowance_.take(stream_bytes(zones, limits), "zones of triangles");
        options_.jobs.try_each(count, [&](uint32_t k) { build_level(meshes[k], zones[k], out_.rig, out_.levels[k]); });
        report(meshes[0], zones[0], out_);
        for (const Mesh &mesh : meshes) out_.report.parts = std::max(out_.report.parts, mesh.parts);
    }

    const model::Model &model_;
    const MaterialPlan materials_;
    const std::vector<LevelPlan> plans_;
    const std::vector<uint32_t> drawn_;  // parts
    Allowance &allowance_;
    const std::vector<uint32_t> first_weights_;  // of each of the model's morph sets in `out_`
    Mesh whole_;                                 // everything visible at some distance; textures are made for all of it
    const BuildOptions &options_;
    std::pmr::memory_resource *memory_;
    model::Template &out_;
    std::vector<uint32_t> texture_of_;  // [planned textures]
    float extent_ = 0;
};

// Fills sklsroot and node_reach. Returns false if there are more poses than the limit.
bool search(const SearchLimits &limits, model::Template &out)
{
    const std::optional<model::Sphere> sphere = enclosing_sphere(out, limits);
    if (!sphere) return false;
    out.sklsroot = *sphere;
    const std::vector<model::NodeReach> reach = find_node_reach(out.rig, out.sklsroot.centre, limits.poses);
    out.node_reach.assign(reach.begin(), reach.end());
    return !reach.empty();
}

}  // namespace

void build(const model::Model &model, const BuildOptions &options, model::Template &out)
{
    model::check(model);
    check_limits(model);
    Allowance allowance(model);
    Builder(model, options, allowance, out).run();
    const SearchLimits limits = search_limits(out, allowance);
    std::vector<NodeExtent> extents;
    float more = 0;
    bool found = false;
    options.jobs.try_each(2, [&](uint32_t job) {
        if (job == 0) {
            found = limits.search && search(limits, out);
        } else {
            if (limits.search) extents = node_extents(out.rig, limits.poses);
            if (extents.empty()) extents = key_extents(out.rig);
            more = make_motion(options.motion, out, {allowance.bytes() / 4, allowance.transforms()});
        }
    });
    if (!found) bound_by_lengths(key_extents(out.rig), out);
    find_blend_reach(extents, out);
    inflate(more, out);
    model::check_spheres(out);
}

}  // namespace claque::meshsplit

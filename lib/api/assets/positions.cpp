// Animated positions of a loaded character, in file order, computed by the same pose and skinning code that crowds use.
#include <claque/assets.h>

#include <algorithm>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/assets/placement.h"
#include "lib/api/boundary.h"
#include "lib/pose/pose.h"
#include "lib/skin/skin.h"

using namespace claque;

namespace
{

// A part as a level that can be skinned, and the index of each of its vertices in the part.
struct PartLevel {
    model::Level level{std::pmr::get_default_resource()};
    std::vector<uint32_t> part_vertex;
};

uint32_t influences_of(const model::Part &part, uint32_t vertex)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < part.influence_count; ++k) count += part.weights[vertex * part.influence_count + k] != 0;
    return std::max(count, 1u);
}

void add_influences(const model::Part &part, uint32_t vertex, model::Level &level)
{
    const uint32_t count = influences_of(part, vertex);
    if (level.runs.empty() || level.runs.back().influences != count) {
        model::InfluenceRun run;
        run.first = level.source_count;
        run.influences = count;
        run.first_influence = static_cast<uint32_t>(level.joints.size());
        level.runs.push_back(run);
    }
    ++level.runs.back().count;
    uint32_t taken = 0;
    for (uint32_t k = 0; k < part.influence_count && taken < count; ++k) {
        const size_t at = static_cast<size_t>(vertex) * part.influence_count + k;
        const bool last_chance = part.influence_count - k == count - taken;
        if (part.weights[at] == 0 && !last_chance) continue;
        level.joints.push_back(static_cast<uint16_t>(part.joints[at]));
        level.weights.push_back(part.weights[at]);
        ++taken;
    }
}

void add_morphs(const model::Part &part, const model::Rig &rig, const std::vector<uint32_t> &level_vertex,
                model::Level &level)
{
    for (size_t m = 0; m < part.morphs.size(); ++m) {
        model::MorphRange range;
        range.weight = rig.morph_sets[part.morph_set].first_weight + static_cast<uint32_t>(m);
        range.first = static_cast<uint32_t>(level.morph_deltas.size());
        const std::vector<glm::vec3> &deltas = part.morphs[m].positions;
        for (size_t v = 0; v < deltas.size(); ++v)
            level.morph_deltas.push_back({level_vertex[v], {deltas[v].x, deltas[v].y, deltas[v].z}, {0, 0, 0}});
        range.count = static_cast<uint32_t>(level.morph_deltas.size()) - range.first;
        level.morph_ranges.push_back(range);
    }
}

PartLevel level_of(const model::Part &part, const model::Rig &rig)
{
    PartLevel out;
    const uint32_t n = static_cast<uint32_t>(part.positions.size());
    for (uint32_t v = 0; v < n; ++v) out.part_vertex.push_back(v);
    std::stable_sort(out.part_vertex.begin(), out.part_vertex.end(),
                     [&](uint32_t a, uint32_t b) { return influences_of(part, a) < influences_of(part, b); });
    std::vector<uint32_t> level_vertex(n);
    for (const uint32_t v : out.part_vertex) {
        level_vertex[v] = out.level.source_count;
        for (int k = 0; k < 3; ++k) {
            out.level.positions.push_back(part.positions[v][k]);
            out.level.normals.push_back(k == 2 ? 1.0f : 0.0f);  // the kernel needs normals; the result is not read
        }
        add_influences(part, v, out.level);
        ++out.level.source_count;
    }
    out.level.vertex_count = out.level.source_count;
    add_morphs(part, rig, level_vertex, out.level);
    return out;
}

uint64_t vertex_count(const model::Model &model)
{
    uint64_t count = 0;
    for (const model::Part &part : model.parts) count += part.positions.size();
    return count;
}

class Evaluator
{
public:
    Evaluator(const model::Model &model, uint32_t clip, float time_s) : model_(model), workspace_(model.rig)
    {
        palette_ = workspace_.pose(clip, static_cast<double>(time_s));
    }

    void write(const model::Part &part, float *out_xyz) const
    {
        if (part.positions.empty()) return;
        const PartLevel made = level_of(part, model_.rig);
        skin::SkinJob job;
        job.level = &made.level;
        job.palette = palette_;
        job.morph_weights = workspace_.weights();
        std::vector<float> scratch(skin::scratch_floats(made.level, palette_.count, job.normals));
        std::vector<float> positions(made.level.positions.size()), normals(made.level.normals.size());
        job.scratch = base::Span<float>(scratch);
        job.out_positions = base::Span<float>(positions);
        job.out_normals = base::Span<float>(normals);
        api::require(job.check());
        job.run();
        for (size_t i = 0; i < made.part_vertex.size(); ++i)
            for (size_t k = 0; k < 3; ++k)
                out_xyz[3 * static_cast<size_t>(made.part_vertex[i]) + k] = positions[3 * i + k];
    }

private:
    const model::Model &model_;
    pose::Workspace workspace_;
    base::Span<const math::Affine> palette_;
};

}  // namespace

api::Box api::rest_box(const model::Model &model)
{
    Box box;
    const Evaluator rest(model, model::none, 0);
    for (const model::Part &part : model.parts) {
        if (part.hidden) continue;
        std::vector<float> xyz(3 * part.positions.size());
        rest.write(part, xyz.data());
        for (size_t i = 0; i < xyz.size(); ++i) {
            box.min[i % 3] = std::min(box.min[i % 3], xyz[i]);
            box.max[i % 3] = std::max(box.max[i % 3], xyz[i]);
        }
    }
    return box;
}

extern "C" {

clq_status clq_asset_get_positions(const clq_asset *asset, uint32_t clip, float time_s, float *out_xyz,
                                   size_t capacity_floats)
{
    return api::boundary("clq_asset_get_positions", [&] {
        api::require(asset && out_xyz, "asset or out_xyz is NULL");
        const model::Model &model = asset->model;
        if (clip != CLQ_NONE && clip >= model.rig.clips.size())
            base::fail(CLQ_ARGUMENT, "clip %u does not exist: '%s' has %zu", clip, model.name.c_str(),
                       model.rig.clips.size());
        if (capacity_floats < 3 * vertex_count(model))
            base::fail(CLQ_ARGUMENT, "%zu floats for %llu vertices", capacity_floats,
                       static_cast<unsigned long long>(vertex_count(model)));
        const Evaluator evaluator(model, clip, time_s);
        for (const model::Part &part : model.parts) {
            evaluator.write(part, out_xyz);
            out_xyz += 3 * part.positions.size();
        }
    });
}

clq_status clq_asset_get_info(const clq_asset *asset, clq_asset_info *out)
{
    return api::boundary("clq_asset_get_info", [&] {
        api::require(asset && out, "asset or out is NULL");
        api::require_size(*out, "clq_asset_info_init");
        const model::Model &model = asset->model;
        clq_asset_info info = clq_asset_info_init();
        info.name = model.name.c_str();
        info.part_count = static_cast<uint32_t>(model.parts.size());
        info.node_count = model.rig.node_count();
        info.joint_count = static_cast<uint32_t>(model.rig.palette.size());
        info.clip_count = static_cast<uint32_t>(model.rig.clips.size());
        info.zone_count = static_cast<uint32_t>(model.zones.size());
        info.image_count = static_cast<uint32_t>(model.images.size());
        info.material_count = static_cast<uint32_t>(model.materials.size());
        info.warning_count = static_cast<uint32_t>(model.warnings.size());
        info.vertex_count = static_cast<uint32_t>(vertex_count(model));
        for (const model::Part &part : model.parts) {
            info.hidden_part_count += part.hidden;
            info.morph_target_count += static_cast<uint32_t>(part.morphs.size());
            info.triangle_count += static_cast<uint32_t>(model::triangles_of(part).size());
            for (uint32_t v = 0; v < part.positions.size(); ++v)
                info.max_influences = std::max(info.max_influences, influences_of(part, v));
        }
        const api::Box box = api::rest_box(model);
        for (size_t k = 0; k < 3 && box.min[0] <= box.max[0]; ++k)
            info.box_min[k] = box.min[k], info.box_max[k] = box.max[k];
        api::write_out(out, info);
    });
}

clq_status clq_asset_get_part(const clq_asset *asset, uint32_t part, clq_asset_part *out)
{
    return api::boundary("clq_asset_get_part", [&] {
        api::require(asset && out, "asset or out is NULL");
        api::require_size(*out, "clq_asset_part_init");
        const model::Model &model = asset->model;
        if (part >= model.parts.size())
            base::fail(CLQ_ARGUMENT, "part %u does not exist: '%s' has %zu", part, model.name.c_str(),
                       model.parts.size());
        const model::Part &p = model.parts[part];
        clq_asset_part info = clq_asset_part_init();
        info.name = p.name.c_str();
        info.node_name = p.node == model::none ? "" : model.rig.node_names[p.node].c_str();
        info.material_name = p.material == model::none ? "" : model.materials[p.material].name.c_str();
        info.vertex_count = static_cast<uint32_t>(p.positions.size());
        info.triangle_count = static_cast<uint32_t>(model::triangles_of(p).size());
        info.influence_count = p.influence_count;
        info.morph_target_count = static_cast<uint32_t>(p.morphs.size());
        info.skinned = p.skinned;
        info.hidden = p.hidden;
        info.topology = static_cast<uint32_t>(p.topology);
        api::write_out(out, info);
    });
}

clq_status clq_asset_get_node(const clq_asset *asset, uint32_t node, clq_asset_node *out)
{
    return api::boundary("clq_asset_get_node", [&] {
        api::require(asset && out, "asset or out is NULL");
        api::require_size(*out, "clq_asset_node_init");
        const model::Rig &rig = asset->model.rig;
        if (node >= rig.node_count())
            base::fail(CLQ_ARGUMENT, "node %u does not exist: '%s' has %u", node, asset->model.name.c_str(),
                       rig.node_count());
        clq_asset_node info = clq_asset_node_init();
        info.name = rig.node_names[node].c_str();
        info.parent = rig.parents[node];
        for (const model::PaletteEntry &entry : rig.palette) info.joint |= entry.node == node;
        api::write_out(out, info);
    });
}

clq_status clq_asset_get_clip(const clq_asset *asset, uint32_t clip, clq_clip_info *out)
{
    return api::boundary("clq_asset_get_clip", [&] {
        api::require(asset && out, "asset or out is NULL");
        api::require_size(*out, "clq_clip_info_init");
        const model::Rig &rig = asset->model.rig;
        if (clip >= rig.clips.size())
            base::fail(CLQ_ARGUMENT, "clip %u does not exist: '%s' has %zu", clip, asset->model.name.c_str(),
                       rig.clips.size());
        clq_clip_info info = clq_clip_info_init();
        info.name = rig.clip_names[clip].c_str();
        info.start_s = rig.clips[clip].start_s, info.duration_s = rig.clips[clip].duration_s;
        info.channel_count = rig.clips[clip].channel_count;
        api::write_out(out, info);
    });
}

const char *clq_asset_get_morph_name(const clq_asset *asset, uint32_t part, uint32_t target)
{
    if (!asset || part >= asset->model.parts.size()) return "";
    const std::vector<model::MorphTarget> &morphs = asset->model.parts[part].morphs;
    return target < morphs.size() ? morphs[target].name.c_str() : "";
}

const char *clq_asset_get_warning(const clq_asset *asset, uint32_t warning)
{
    return asset && warning < asset->model.warnings.size() ? asset->model.warnings[warning].c_str() : "";
}

}  // extern "C"

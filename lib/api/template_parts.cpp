#include "lib/api/template_parts.h"

#include <map>

#include "lib/api/boundary.h"

namespace claque::api
{

using base::fail;

namespace
{

template <class V>
void take(std::vector<V> &out, const float *values, uint32_t count)
{
    if (!values) return;
    out.resize(count);
    for (uint32_t i = 0; i < count; ++i)
        for (int k = 0; k < static_cast<int>(sizeof(V) / sizeof(float)); ++k)
            out[i][k] = values[static_cast<size_t>(i) * (sizeof(V) / sizeof(float)) + k];
}

class PartReader
{
public:
    PartReader(const clq_template_def &def, model::Model &model) : def_(def), model_(model) {}

    void read(uint32_t index)
    {
        const clq_part_def &part = def_.parts[index];
        model::Part made;
        made.name = name_of(part.name);
        made.node = part.node;
        made.material = part.material;
        if (!part.positions || part.vertex_count == 0)
            fail(CLQ_ARGUMENT, "part %u '%s' has no positions", index, made.name.c_str());
        if (part.index_count % 3 || (part.index_count == 0 && part.vertex_count % 3))
            fail(CLQ_ARGUMENT, "part %u '%s' has %u indices and %u vertices: three a triangle", index,
                 made.name.c_str(), part.index_count, part.vertex_count);
        require_array(part.indices, part.index_count, "indices");
        take(made.positions, part.positions, part.vertex_count);
        take(made.normals, part.normals, part.vertex_count);
        take(made.uvs, part.uvs, part.vertex_count);
        if (part.colours)
            for (uint32_t v = 0; v < part.vertex_count; ++v)
                made.colours.push_back({part.colours[4ull * v], part.colours[4ull * v + 1], part.colours[4ull * v + 2],
                                        part.colours[4ull * v + 3]});
        if (part.index_count) made.indices.assign(part.indices, part.indices + part.index_count);
        made.lod_min_m = part.lod_min_m;
        if (part.lod_max_m != 0) made.lod_max_m = part.lod_max_m;
        read_influences(part, made, index);
        read_morphs(part, made, index);
        model_.parts.push_back(std::move(made));
    }

private:
    void read_influences(const clq_part_def &part, model::Part &made, uint32_t index)
    {
        made.skinned = part.influence_count > 0;
        if (!made.skinned) {
            if (part.node >= def_.node_count)
                fail(CLQ_ARGUMENT, "rigid part %u '%s' hangs on node %u, which does not exist: there are %u", index,
                     made.name.c_str(), part.node, def_.node_count);
            made.influence_count = 1;
            made.joints.assign(part.vertex_count, rigid_entry(part.node));
            made.weights.assign(part.vertex_count, 1.0f);
            return;
        }
        model::check_influence_count(part.influence_count, index, made.name.c_str());
        if (!part.joints || !part.weights)
            fail(CLQ_ARGUMENT, "skinned part %u '%s' lacks joints or weights", index, made.name.c_str());
        const size_t count = static_cast<size_t>(part.influence_count) * part.vertex_count;
        // Checked here and not in model::check: entries of rigid parts follow the host's own, and the host cannot name
        // them.
        for (size_t i = 0; i < count; ++i)
            if (part.joints[i] >= def_.joint_count)
                fail(CLQ_ARGUMENT, "vertex %zu of part %u '%s' names joint %u, which does not exist: there are %u",
                     i / part.influence_count, index, made.name.c_str(), part.joints[i], def_.joint_count);
        made.influence_count = part.influence_count;
        made.joints.assign(part.joints, part.joints + count);
        made.weights.assign(part.weights, part.weights + count);
    }

    uint32_t rigid_entry(uint32_t node)
    {
        const auto found = rigid_entries_.find(node);
        if (found != rigid_entries_.end()) return found->second;
        model::PaletteEntry entry;
        entry.node = node;
        model_.rig.palette.push_back(entry);
        return rigid_entries_[node] = static_cast<uint32_t>(model_.rig.palette.size() - 1);
    }

    void read_morphs(const clq_part_def &part, model::Part &made, uint32_t index)
    {
        if (part.morph_count == 0) return;
        require_array(part.morphs, part.morph_count, "morphs");
        if (part.node >= def_.node_count)
            fail(CLQ_ARGUMENT, "morphed part %u '%s' names node %u, which does not exist: there are %u", index,
                 made.name.c_str(), part.node, def_.node_count);
        made.morph_set = morph_set(part);
        for (uint32_t m = 0; m < part.morph_count; ++m) {
            model::MorphTarget target;
            take(target.positions, part.morphs[m].positions, part.vertex_count);
            take(target.normals, part.morphs[m].normals, part.vertex_count);
            made.morphs.push_back(std::move(target));
        }
    }

    uint32_t morph_set(const clq_part_def &part)
    {
        for (uint32_t i = 0; i < model_.rig.morph_sets.size(); ++i)
            if (model_.rig.morph_sets[i].node == part.node) return i;
        model::MorphSet set;
        set.node = part.node;
        set.first_weight = static_cast<uint32_t>(model_.rig.rest_weights.size());
        set.target_count = part.morph_count;
        for (uint32_t m = 0; m < part.morph_count; ++m) model_.rig.rest_weights.push_back(part.morphs[m].rest_weight);
        model_.rig.morph_sets.push_back(set);
        return static_cast<uint32_t>(model_.rig.morph_sets.size() - 1);
    }

    const clq_template_def &def_;
    model::Model &model_;
    std::map<uint32_t, uint32_t> rigid_entries_;
};

}  // namespace

void add_parts(const clq_template_def &def, model::Model &model)
{
    require_array(def.parts, def.part_count, "parts");
    PartReader reader(def, model);
    for (uint32_t i = 0; i < def.part_count; ++i) reader.read(i);
}

}  // namespace claque::api

#include "meshsplit/template_rig.h"

#include <limits>

#include "lib/base/error.h"
#include "meshsplit/root_motion.h"

namespace claque::meshsplit
{

using model::none;

namespace
{

class RigFiller
{
public:
    RigFiller(const model::Model &model, model::Rig &out) : model_(model), from_(model.rig), out_(out) {}

    std::vector<uint32_t> run()
    {
        add_nodes();
        add_morph_sets();
        add_dofs();
        for (size_t i = 0; i < from_.clips.size(); ++i) add_clip(i);
        out_.markers = from_.markers;
        add_names(from_.marker_names, out_.marker_names);
        out_.root_curves = from_.root_curves;
        out_.root_samples = from_.root_samples;
        return std::move(first_weights_);
    }

private:
    // Names of files may hold any byte; a host reads them up to the first zero.
    static void add_names(const model::Array<std::pmr::string> &from, model::Array<std::pmr::string> &out)
    {
        out.reserve(from.size());
        for (const std::pmr::string &name : from) out.emplace_back(name.c_str());
    }

    void add_nodes()
    {
        out_.parents = from_.parents;
        out_.rest = from_.rest;
        out_.palette = from_.palette;
        add_names(from_.node_names, out_.node_names);
        out_.deactivation_m = from_.deactivation_m;
        out_.deactivation_m.resize(from_.node_count(), std::numeric_limits<float>::infinity());
    }

    void add_morph_sets()
    {
        std::vector<bool> used(from_.morph_sets.size());
        for (const model::Part &part : model_.parts)
            if (!part.morphs.empty() && !part.hidden && part.topology >= model::Topology::triangles)
                used[part.morph_set] = true;
        sets_.assign(used.size(), none);
        first_weights_.assign(used.size(), none);
        for (size_t i = 0; i < used.size(); ++i) {
            if (!used[i]) continue;
            sets_[i] = static_cast<uint32_t>(out_.morph_sets.size());
            first_weights_[i] = static_cast<uint32_t>(out_.rest_weights.size());
            model::MorphSet set = from_.morph_sets[i];
            const auto first = from_.rest_weights.begin() + set.first_weight;
            out_.rest_weights.insert(out_.rest_weights.end(), first, first + set.target_count);
            set.first_weight = first_weights_[i];
            out_.morph_sets.push_back(set);
        }
    }

    void add_dofs()
    {
        add_names(from_.dof_names, out_.dof_names);
        out_.dofs = from_.dofs;
        for (size_t i = 0; i < out_.dofs.size(); ++i) {
            model::Dof &dof = out_.dofs[i];
            if (dof.kind != model::DofKind::morph) continue;
            if (sets_[dof.node] == none)
                base::fail(CLQ_ARGUMENT,
                           "degree of freedom %zu is of a morph target of node %u, which has no morphed part", i,
                           from_.morph_sets[dof.node].node);
            dof.node = sets_[dof.node];
        }
    }

    void add_clip(size_t index)
    {
        const model::Clip &clip = from_.clips[index];
        model::Clip made;
        made.first_channel = static_cast<uint32_t>(out_.channels.size());
        for (uint32_t i = 0; i < clip.channel_count; ++i) add_channel(from_.channels[clip.first_channel + i]);
        made.channel_count = static_cast<uint32_t>(out_.channels.size()) - made.first_channel;
        model::set_span(out_, made);
        out_.clips.push_back(made);
        out_.clip_names.emplace_back(from_.clip_names[index].c_str());
    }

    void add_channel(const model::Channel &channel)
    {
        model::Channel made = channel;
        if (channel.target == model::ChannelTarget::morph_weights) {
            made.node = sets_[channel.node];
            if (made.node == none) return;
        }
        const size_t groups = channel.interpolation == model::Interpolation::cubic_spline ? 3 : 1;
        const float *times = from_.times.data() + channel.first_time;
        const float *values = from_.values.data() + channel.first_value;
        made.first_time = static_cast<uint32_t>(out_.times.size());
        made.first_value = static_cast<uint32_t>(out_.values.size());
        out_.times.insert(out_.times.end(), times, times + channel.key_count);
        out_.values.insert(out_.values.end(), values, values + groups * channel.key_count * channel.component_count);
        out_.channels.push_back(made);
    }

    const model::Model &model_;
    const model::Rig &from_;
    model::Rig &out_;
    std::vector<uint32_t> sets_, first_weights_;  // by morph set of the model, none: left out
};

// Keys that channels share are repeated; the arrays grow by doubling.
uint64_t own_key_bytes(const model::Rig &rig)
{
    uint64_t sum = 0;
    for (const model::Channel &channel : rig.channels) {
        const uint64_t groups = channel.interpolation == model::Interpolation::cubic_spline ? 3 : 1;
        sum += sizeof channel + channel.key_count * (1 + groups * channel.component_count) * sizeof(float);
    }
    return 3 * sum;
}

}  // namespace

std::vector<uint32_t> fill_rig(const model::Model &model, Allowance &allowance, model::Rig &out)
{
    allowance.take(own_key_bytes(model.rig), "channels with keys of their own");
    std::vector<uint32_t> first_weights = RigFiller(model, out).run();
    extract_root_motions(model, allowance, out);
    return first_weights;
}

}  // namespace claque::meshsplit

#include "lib/model/rig.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/error.h"

namespace claque::model
{

using base::fail;

namespace
{

template <class T>
Array<T> copy_of(const Array<T> &other, std::pmr::memory_resource *memory)
{
    return Array<T>(other.begin(), other.end(), memory);
}

Array<std::pmr::string> copy_of(const Array<std::pmr::string> &other, std::pmr::memory_resource *memory)
{
    Array<std::pmr::string> out(memory);
    out.reserve(other.size());
    for (const std::pmr::string &s : other) out.emplace_back(std::string_view(s));
    return out;
}

uint32_t find(const Array<std::pmr::string> &names, std::string_view name)
{
    for (size_t i = 0; i < names.size(); ++i)
        if (std::string_view(names[i]) == name) return static_cast<uint32_t>(i);
    return none;
}

bool finite(const float *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (!std::isfinite(values[i])) return false;
    return true;
}

void check_nodes(const Rig &rig)
{
    const uint32_t n = rig.node_count();
    if (rig.rest.size() != n || rig.node_names.size() != n)
        fail(CLQ_ARGUMENT, "%u nodes have %zu rest transforms and %zu names", n, rig.rest.size(),
             rig.node_names.size());
    for (uint32_t i = 0; i < n; ++i) {
        const math::Trs &trs = rig.rest[i];
        if (rig.parents[i] != none && rig.parents[i] >= i)
            fail(CLQ_ARGUMENT, "node %u '%s' has parent %u: parents come before children", i, rig.node_names[i].c_str(),
                 rig.parents[i]);
        if (!finite(&trs.translation.x, 3) || !finite(&trs.scale.x, 3) || !finite(&trs.rotation.x, 4))
            fail(CLQ_ARGUMENT, "node %u '%s' has a rest transform that is not finite", i, rig.node_names[i].c_str());
        const glm::dquat q(trs.rotation);
        const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
        if (!(std::fabs(length - 1) <= 1e-3))
            fail(CLQ_ARGUMENT, "node %u '%s' has a rotation of length %g instead of 1", i, rig.node_names[i].c_str(),
                 length);
    }
    for (size_t i = 0; i < rig.palette.size(); ++i) {
        if (rig.palette[i].node >= n)
            fail(CLQ_ARGUMENT, "palette entry %zu names node %u, which does not exist: there are %u", i,
                 rig.palette[i].node, n);
        if (!finite(rig.palette[i].inverse_bind.c, 12))
            fail(CLQ_ARGUMENT, "palette entry %zu has an inverse bind matrix that is not finite", i);
    }
}

// Where key times do not ascend, in order. Channels may share their times, so these are looked at once for all.
std::vector<uint32_t> descents_of(const Rig &rig)
{
    std::vector<uint32_t> out;
    for (uint32_t i = 1; i < rig.times.size(); ++i)
        if (!(rig.times[i] > rig.times[i - 1])) out.push_back(i);
    return out;
}

void check_channel(const Rig &rig, const Channel &channel, size_t index, const std::vector<uint32_t> &descents)
{
    const bool morphs = channel.target == ChannelTarget::morph_weights;
    const size_t targets = morphs ? rig.morph_sets.size() : rig.parents.size();
    if (channel.node >= targets)
        fail(CLQ_ARGUMENT, "channel %zu moves node or morph set %u, which does not exist: there are %zu", index,
             channel.node, targets);
    const uint32_t wanted = morphs                                      ? rig.morph_sets[channel.node].target_count
                            : channel.target == ChannelTarget::rotation ? 4u
                                                                        : 3u;
    if (channel.component_count != wanted)
        fail(CLQ_ARGUMENT, "channel %zu has %u components a key instead of %u", index, channel.component_count, wanted);
    if (channel.key_count == 0) fail(CLQ_ARGUMENT, "channel %zu has no keys", index);
    const uint64_t groups = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
    const uint64_t time_end = uint64_t(channel.first_time) + channel.key_count;
    const uint64_t value_end = uint64_t(channel.first_value) + groups * channel.key_count * wanted;
    if (time_end > rig.times.size() || value_end > rig.values.size())
        fail(CLQ_ARGUMENT, "channel %zu needs %llu key times of %zu and %llu values of %zu", index,
             static_cast<unsigned long long>(time_end), rig.times.size(), static_cast<unsigned long long>(value_end),
             rig.values.size());
    const auto descent = std::upper_bound(descents.begin(), descents.end(), channel.first_time);
    if (descent != descents.end() && *descent < time_end)
        fail(CLQ_ARGUMENT, "key times of channel %zu do not ascend at key %u", index, *descent - channel.first_time);
}

void check_deactivations(const Rig &rig)
{
    if (rig.deactivation_m.empty()) return;
    if (rig.deactivation_m.size() != rig.node_count())
        fail(CLQ_ARGUMENT, "%u nodes have %zu deactivation distances", rig.node_count(), rig.deactivation_m.size());
    for (uint32_t i = 0; i < rig.node_count(); ++i)
        if (!(rig.deactivation_m[i] > 0))
            fail(CLQ_ARGUMENT, "node %u '%s' is deactivated from %g m on: more than 0 is wanted", i,
                 rig.node_names[i].c_str(), static_cast<double>(rig.deactivation_m[i]));
}

void check_dof(const Rig &rig, const Dof &dof, size_t index)
{
    const char *name = rig.dof_names[index].c_str();
    if (dof.kind > DofKind::morph)
        fail(CLQ_ARGUMENT, "degree of freedom %zu '%s' is of kind %u", index, name, unsigned(dof.kind));
    const bool morphs = dof.kind == DofKind::morph;
    const size_t owners = morphs ? rig.morph_sets.size() : rig.parents.size();
    if (dof.node >= owners)
        fail(CLQ_ARGUMENT, "degree of freedom %zu '%s' is of %s %u, which does not exist: there are %zu", index, name,
             morphs ? "morph set" : "node", dof.node, owners);
    if (morphs && dof.morph_target >= rig.morph_sets[dof.node].target_count)
        fail(CLQ_ARGUMENT, "degree of freedom %zu '%s' is of morph target %u, which does not exist: there are %u",
             index, name, dof.morph_target, rig.morph_sets[dof.node].target_count);
    const glm::vec3 &a = dof.axis;
    const float length2 = a.x * a.x + a.y * a.y + a.z * a.z;
    if (!morphs && !(length2 > 0.998f && length2 < 1.002f))
        fail(CLQ_ARGUMENT, "degree of freedom %zu '%s' has an axis of length %g: a unit one is wanted", index, name,
             std::sqrt(static_cast<double>(length2)));
    if (!std::isfinite(dof.min) || !std::isfinite(dof.max) || !(dof.min <= dof.rest && dof.rest <= dof.max))
        fail(CLQ_ARGUMENT, "degree of freedom %zu '%s' rests at %g in a range from %g to %g", index, name,
             static_cast<double>(dof.rest), static_cast<double>(dof.min), static_cast<double>(dof.max));
}

}  // namespace

Rig::Rig(const Rig &other, std::pmr::memory_resource *memory)
    : parents(copy_of(other.parents, memory)),
      rest(copy_of(other.rest, memory)),
      node_names(copy_of(other.node_names, memory)),
      palette(copy_of(other.palette, memory)),
      morph_sets(copy_of(other.morph_sets, memory)),
      rest_weights(copy_of(other.rest_weights, memory)),
      clips(copy_of(other.clips, memory)),
      clip_names(copy_of(other.clip_names, memory)),
      channels(copy_of(other.channels, memory)),
      times(copy_of(other.times, memory)),
      values(copy_of(other.values, memory)),
      deactivation_m(copy_of(other.deactivation_m, memory)),
      dofs(copy_of(other.dofs, memory)),
      dof_names(copy_of(other.dof_names, memory)),
      markers(copy_of(other.markers, memory)),
      marker_names(copy_of(other.marker_names, memory)),
      root_curves(copy_of(other.root_curves, memory)),
      root_samples(copy_of(other.root_samples, memory))
{
}

uint32_t Rig::find_node(std::string_view name) const { return find(node_names, name); }
uint32_t Rig::find_clip(std::string_view name) const { return find(clip_names, name); }
uint32_t Rig::find_dof(std::string_view name) const { return find(dof_names, name); }

float Rig::deactivation_of(uint32_t node) const
{
    return deactivation_m.empty() ? std::numeric_limits<float>::infinity() : deactivation_m[node];
}

void set_span(const Rig &rig, Clip &clip)
{
    float first = 0, last = 0;
    for (uint32_t i = 0; i < clip.channel_count; ++i) {
        const Channel &channel = rig.channels[clip.first_channel + i];
        const float begin = rig.times[channel.first_time];
        const float end = rig.times[channel.first_time + channel.key_count - 1];
        first = i == 0 ? begin : std::fmin(first, begin);
        last = i == 0 ? end : std::fmax(last, end);
    }
    clip.start_s = first;
    clip.duration_s = last - first;
}

void check(const Rig &rig)
{
    check_nodes(rig);
    uint64_t weights = 0;
    for (size_t i = 0; i < rig.morph_sets.size(); ++i) {
        const MorphSet &set = rig.morph_sets[i];
        weights += set.target_count;
        if (set.node >= rig.node_count() || uint64_t(set.first_weight) + set.target_count > rig.rest_weights.size())
            fail(CLQ_ARGUMENT, "morph set %zu is out of range", i);
    }
    if (weights > rig.rest_weights.size())
        fail(CLQ_ARGUMENT, "%zu morph sets have %llu weights of %zu: they overlap", rig.morph_sets.size(),
             static_cast<unsigned long long>(weights), rig.rest_weights.size());
    if (rig.clips.size() != rig.clip_names.size())
        fail(CLQ_ARGUMENT, "%zu clips have %zu names", rig.clips.size(), rig.clip_names.size());
    if (!finite(rig.times.data(), rig.times.size()) || !finite(rig.values.data(), rig.values.size()) ||
        !finite(rig.rest_weights.data(), rig.rest_weights.size()))
        fail(CLQ_ARGUMENT, "a key time or key value is not finite");
    for (size_t i = 0; i < rig.clips.size(); ++i) {
        const Clip &clip = rig.clips[i];
        if (uint64_t(clip.first_channel) + clip.channel_count > rig.channels.size())
            fail(CLQ_ARGUMENT, "clip %zu '%s' has channels out of range", i, rig.clip_names[i].c_str());
        if (!std::isfinite(clip.start_s) || !(clip.duration_s >= 0) || !std::isfinite(clip.duration_s))
            fail(CLQ_ARGUMENT, "clip %zu '%s' has an invalid length", i, rig.clip_names[i].c_str());
    }
    const std::vector<uint32_t> descents = descents_of(rig);
    for (size_t i = 0; i < rig.channels.size(); ++i) check_channel(rig, rig.channels[i], i, descents);
    check_deactivations(rig);
    if (rig.dofs.size() != rig.dof_names.size())
        fail(CLQ_ARGUMENT, "%zu degrees of freedom have %zu names", rig.dofs.size(), rig.dof_names.size());
    for (size_t i = 0; i < rig.dofs.size(); ++i) check_dof(rig, rig.dofs[i], i);
    check_annotations(rig);
}

}  // namespace claque::model

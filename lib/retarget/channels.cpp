// Clips between skeletons that agree: channels are copied; only axes and scales above the topmost bound joints are
// converted.
#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "lib/retarget/new_clips.h"

namespace claque::retarget
{

using model::none;

namespace
{

// Converts a joint's channels from the source's parent frame to the target's.
struct Rebase {
    math::Affine transform;
    glm::quat rotation = glm::quat(1, 0, 0, 0);
    bool changes = false;
};

bool alike(const math::Affine &a, const math::Affine &b, float size)
{
    for (int k = 0; k < 12; ++k)
        if (!(std::fabs(a.c[k] - b.c[k]) <= (k < 9 ? 0.005f : 0.005f * size))) return false;
    return true;
}

// The frame of a joint's parent, relative to the bound ancestor joint, or in model space if there is none.
struct Frame {
    math::Affine transform;
    glm::dquat rotation = glm::dquat(1, 0, 0, 0);
};

Frame frame_of(const GlobalPose &rest, const model::Rig &rig, uint32_t node, uint32_t anchor)
{
    Frame out;
    const uint32_t parent = rig.parents[node];
    if (parent == anchor) return out;
    out.transform = rest.globals[parent];
    out.rotation = rest.rotations[parent];
    if (anchor == none) return out;
    out.transform = math::mul(math::inverse(rest.globals[anchor]), out.transform);
    out.rotation = glm::conjugate(rest.rotations[anchor]) * out.rotation;
    return out;
}

struct Frames {
    Frame target, source;
};

class Pairs
{
public:
    Pairs(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches)
        : target_(target), source_(source), matches_(matches), rest_t_(rest_pose(target)), rest_s_(rest_pose(source))
    {
    }

    Frames frames(const JointMatch &match) const
    {
        const bool top = match.above == none;
        return {frame_of(rest_t_, target_, match.target, top ? none : matches_[match.above].target),
                frame_of(rest_s_, source_, match.source, top ? none : matches_[match.above].source)};
    }

    Rebase rebase(const JointMatch &match) const
    {
        Rebase out;
        const Frames f = frames(match);
        if (alike(f.target.transform, f.source.transform, 1e-4f)) return out;
        const glm::dquat rotation = glm::normalize(glm::conjugate(f.target.rotation) * f.source.rotation);
        out.transform = math::mul(math::inverse(f.target.transform), f.source.transform);
        out.rotation = glm::quat(static_cast<float>(rotation.w), static_cast<float>(rotation.x),
                                 static_cast<float>(rotation.y), static_cast<float>(rotation.z));
        out.changes = true;
        return out;
    }

    // The largest distance of a bound joint from the topmost one.
    float size() const
    {
        double maximum = 0;
        const glm::dvec3 top = rest_t_.positions[matches_[0].target];
        for (const JointMatch &m : matches_)
            maximum = std::max(maximum, glm::length(rest_t_.positions[m.target] - top));
        return static_cast<float>(maximum);
    }

private:
    const model::Rig &target_, &source_;
    const std::vector<JointMatch> &matches_;
    GlobalPose rest_t_, rest_s_;
};

uint32_t morph_set_on(const model::Rig &rig, uint32_t node, uint32_t target_count)
{
    for (uint32_t i = 0; i < rig.morph_sets.size(); ++i)
        if (rig.morph_sets[i].node == node && rig.morph_sets[i].target_count == target_count) return i;
    return none;
}

// Splines store in-tangent, value, out-tangent; tangents are converted as directions.
void append_values(const model::Rig &source, const model::Channel &channel, const Rebase &rebase,
                   std::vector<float> &out)
{
    const bool cubic = channel.interpolation == model::Interpolation::cubic_spline;
    const size_t count = size_t(channel.key_count) * (cubic ? 3 : 1), width = channel.component_count;
    const float *from = source.values.data() + channel.first_value;
    for (size_t i = 0; i < count; ++i, from += width) {
        if (rebase.changes && channel.target == model::ChannelTarget::rotation) {
            const glm::quat q = rebase.rotation * glm::quat(from[3], from[0], from[1], from[2]);
            out.insert(out.end(), {q.x, q.y, q.z, q.w});
        } else if (rebase.changes && channel.target == model::ChannelTarget::translation) {
            const glm::vec3 v(from[0], from[1], from[2]);
            const glm::vec3 moved = cubic && i % 3 != 1 ? math::transform_vector(rebase.transform, v)
                                                        : math::transform_point(rebase.transform, v);
            out.insert(out.end(), {moved.x, moved.y, moved.z});
        } else out.insert(out.end(), from, from + width);
    }
}

// The pose of a file that rests in the first pose of its clip is in its rest where a channel would not change it.
void add_rest_rotation(const model::Rig &target, const model::Rig &source, const JointMatch &match,
                       const Rebase &rebase, float time_s, NewClips &added)
{
    const glm::quat rotation = rebase.rotation * source.rest[match.source].rotation;
    if (std::fabs(glm::dot(rotation, target.rest[match.target].rotation)) > 0.9999f) return;
    model::Channel out;
    out.node = match.target;
    out.target = model::ChannelTarget::rotation;
    out.component_count = 4;
    out.key_count = 1;
    out.first_time = static_cast<uint32_t>(added.times.size());
    out.first_value = static_cast<uint32_t>(added.values.size());
    added.times.push_back(time_s);
    added.values.insert(added.values.end(), {rotation.x, rotation.y, rotation.z, rotation.w});
    added.channels.push_back(out);
}

}  // namespace

bool rest_poses_agree(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches)
{
    const Pairs pairs(target, source, matches);
    const float size = pairs.size();
    for (const JointMatch &match : matches) {
        if (!hangs_alike(source, matches, match)) return false;
        const Frames frames = pairs.frames(match);
        if (!alike(math::mul(frames.target.transform, math::affine_of(target.rest[match.target])),
                   math::mul(frames.source.transform, math::affine_of(source.rest[match.source])), size))
            return false;
    }
    return true;
}

void copy_channels(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
                   uint32_t clip, NewClips &added)
{
    const Pairs pairs(target, source, matches);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> times;  // samplers mostly share key times
    const model::Clip &from = source.clips[clip];
    model::Clip made;
    made.first_channel = static_cast<uint32_t>(added.channels.size());
    made.start_s = from.start_s;
    made.duration_s = from.duration_s;
    for (const JointMatch &match : matches) {
        const Rebase rebase = pairs.rebase(match);
        bool rotates = false;
        for (uint32_t c = 0; c < from.channel_count; ++c) {
            const model::Channel &channel = source.channels[from.first_channel + c];
            const bool morphs = channel.target == model::ChannelTarget::morph_weights;
            if ((morphs ? source.morph_sets[channel.node].node : channel.node) != match.source) continue;
            model::Channel out = channel;
            out.node = morphs ? morph_set_on(target, match.target, channel.component_count) : match.target;
            if (out.node == none) continue;
            const auto first = source.times.begin() + channel.first_time;
            const auto [entry, fresh] = times.emplace(std::make_pair(channel.first_time, channel.key_count),
                                                      static_cast<uint32_t>(added.times.size()));
            if (fresh) added.times.insert(added.times.end(), first, first + channel.key_count);
            out.first_time = entry->second;
            out.first_value = static_cast<uint32_t>(added.values.size());
            append_values(source, channel, rebase, added.values);
            added.channels.push_back(out);
            rotates |= out.target == model::ChannelTarget::rotation;
        }
        if (!rotates) add_rest_rotation(target, source, match, rebase, from.start_s, added);
    }
    made.channel_count = static_cast<uint32_t>(added.channels.size()) - made.first_channel;
    added.clips.push_back(made);
}

}  // namespace claque::retarget

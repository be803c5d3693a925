#include "meshsplit/root_motion.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "lib/model/root_motion.h"
#include "meshsplit/reach_poses.h"

namespace claque::meshsplit
{

using base::fail;
using model::GroundTransform;
using model::none;

namespace
{

constexpr double rate_hz = 60;

struct Frame {
    glm::dvec3 position = glm::dvec3(0);
    glm::dquat rotation = glm::dquat(1, 0, 0, 0);
    double yaw = 0;
};

class RootMotionExtractor
{
public:
    RootMotionExtractor(model::Rig &rig, uint32_t clip, uint32_t node)
        : rig_(rig), clip_(clip), node_(node), poser_(rig)
    {
        for (uint32_t n = rig.parents[node]; n != none; n = rig.parents[n]) {
            above_ = math::mul(math::affine_of(rig.rest[n]), above_);
            turned_ = glm::normalize(glm::dquat(rig.rest[n].rotation)) * turned_;
        }
        below_ = math::inverse(above_);
    }

    void run()
    {
        find_track();
        const size_t first = rig_.clips[clip_].first_channel, count = rig_.clips[clip_].channel_count;
        for (size_t i = first; i < first + count; ++i) {
            const model::ChannelTarget path = rig_.channels[i].target;
            if (path != model::ChannelTarget::morph_weights && rig_.channels[i].node == node_ &&
                path != model::ChannelTarget::scale)
                replace(rig_.channels[i]);
        }
        // Only now, because the poses above were sampled from the old channels.
        for (const Fresh &fresh : fresh_) {
            model::Channel &channel = *fresh.channel;
            channel.interpolation = model::Interpolation::linear;
            channel.first_time = static_cast<uint32_t>(rig_.times.size());
            channel.key_count = static_cast<uint32_t>(fresh.times.size());
            channel.first_value = static_cast<uint32_t>(rig_.values.size());
            rig_.times.insert(rig_.times.end(), fresh.times.begin(), fresh.times.end());
            rig_.values.insert(rig_.values.end(), fresh.values.begin(), fresh.values.end());
        }
        add_track();
    }

private:
    struct Fresh {
        model::Channel *channel;
        std::vector<float> times, values;
    };

    Frame frame_at(double time_s)
    {
        poser_.pose({clip_, time_s}, locals_);
        const math::Trs &local = locals_.nodes[node_];
        Frame frame;
        frame.position = glm::dvec3(math::transform_point(above_, local.translation));
        frame.rotation = glm::normalize(turned_ * glm::dquat(local.rotation));
        return frame;
    }

    double time_of(size_t sample) const
    {
        const model::Clip &clip = rig_.clips[clip_];
        return double(clip.start_s) + double(clip.duration_s) * double(sample) / double(steps_.size() - 1);
    }

    void find_track()
    {
        const double length = double(rig_.clips[clip_].duration_s);
        steps_.resize(static_cast<size_t>(std::ceil(length * rate_hz)) + 1);
        if (steps_.size() < 2) steps_.resize(2);
        const Frame first = frame_at(time_of(0));
        double before = 0;
        for (size_t i = 0; i < steps_.size(); ++i) {
            const Frame now = frame_at(time_of(i));
            const glm::dquat turn = now.rotation * glm::conjugate(first.rotation);
            double yaw = 2 * math::atan2(turn.y, turn.w);
            yaw += 2 * math::pi * std::floor((before - yaw) / (2 * math::pi) + 0.5);  // unwraps the angle
            before = yaw;
            const GroundTransform from = model::compose({0, 0, yaw}, {first.position.x, first.position.z, 0});
            steps_[i] = {now.position.x - from.x, now.position.z - from.z, yaw};
        }
    }

    GroundTransform step_at(double time_s) const
    {
        const model::Clip &clip = rig_.clips[clip_];
        const double length = double(clip.duration_s);
        double at = length > 0 ? (time_s - double(clip.start_s)) / length * double(steps_.size() - 1) : 0;
        at = std::min(std::max(at, 0.0), double(steps_.size() - 1));
        const size_t i = std::min(static_cast<size_t>(at), steps_.size() - 2);
        const GroundTransform &a = steps_[i], &b = steps_[i + 1];
        const double f = at - double(i);
        return {a.x + f * (b.x - a.x), a.z + f * (b.z - a.z), a.yaw + f * (b.yaw - a.yaw)};
    }

    void replace(model::Channel &channel)
    {
        Fresh fresh{&channel, {}, {}};
        const float *keys = rig_.times.data() + channel.first_time;
        fresh.times.assign(keys, keys + channel.key_count);
        for (size_t i = 0; i < steps_.size(); ++i) fresh.times.push_back(static_cast<float>(time_of(i)));
        std::sort(fresh.times.begin(), fresh.times.end());
        fresh.times.erase(std::unique(fresh.times.begin(), fresh.times.end()), fresh.times.end());
        for (const float time : fresh.times) {
            const Frame frame = frame_at(double(time));
            const GroundTransform back = model::inverse(step_at(double(time)));
            if (channel.target == model::ChannelTarget::translation) {
                const GroundTransform at = model::compose(back, {frame.position.x, frame.position.z, 0});
                const glm::vec3 local = math::transform_point(below_, glm::vec3(at.x, frame.position.y, at.z));
                for (int k = 0; k < 3; ++k) fresh.values.push_back(local[k]);
            } else {
                const glm::dquat turn(math::cos(0.5 * back.yaw), 0, math::sin(0.5 * back.yaw), 0);
                const glm::quat local(glm::normalize(glm::conjugate(turned_) * turn * frame.rotation));
                for (const float x : {local.x, local.y, local.z, local.w}) fresh.values.push_back(x);
            }
        }
        fresh_.push_back(std::move(fresh));
    }

    void add_track()
    {
        model::RootCurve track;
        track.clip = clip_;
        track.first_sample = static_cast<uint32_t>(rig_.root_samples.size() / 3);
        track.sample_count = static_cast<uint32_t>(steps_.size());
        for (const GroundTransform &step : steps_)
            for (const double x : {step.x, step.z, step.yaw}) rig_.root_samples.push_back(static_cast<float>(x));
        const auto later = [](uint32_t clip, const model::RootCurve &other) { return other.clip > clip; };
        rig_.root_curves.insert(std::upper_bound(rig_.root_curves.begin(), rig_.root_curves.end(), clip_, later),
                                track);
    }

    model::Rig &rig_;
    const uint32_t clip_, node_;
    LocalPoser poser_;
    Locals locals_;
    math::Affine above_, below_;
    glm::dquat turned_ = glm::dquat(1, 0, 0, 0);
    std::vector<GroundTransform> steps_;
    std::vector<Fresh> fresh_;
};

}  // namespace

namespace
{

// Each sample is a step, two fresh keys and a sample of the curve; the last three in arrays that grow by doubling.
constexpr uint64_t bytes_per_sample = sizeof(GroundTransform) + 3 * (4 + 12 + 4 + 16 + 12);

void charge(const model::Model &model, Allowance &allowance, const model::Rig &rig)
{
    double samples = 0, transforms = 0;
    for (const model::RootMotionRequest &request : model.root_motions) {
        if (request.clip >= rig.clips.size()) continue;
        const model::Clip &clip = rig.clips[request.clip];
        double steps = std::ceil(double(clip.duration_s) * rate_hz) + 2;
        for (uint32_t c = clip.first_channel; c < clip.first_channel + clip.channel_count; ++c)
            if (rig.channels[c].node == request.node) steps += rig.channels[c].key_count;
        samples += steps;
        transforms += 3 * steps * (double(rig.node_count()) + clip.channel_count);
    }
    const auto whole = [](double x) { return static_cast<uint64_t>(std::min(x, 1e18)); };
    allowance.take(whole(samples * bytes_per_sample), "root motion at 60 Hz");
    allowance.take_transforms(whole(transforms), "root motion at 60 Hz");
}

}  // namespace

void extract_root_motion(model::Rig &rig, uint32_t clip, uint32_t node)
{
    if (clip >= rig.clips.size())
        fail(CLQ_ARGUMENT, "root motion names clip %u, which does not exist: there are %zu", clip, rig.clips.size());
    if (node >= rig.node_count())
        fail(CLQ_ARGUMENT, "root motion names node %u, which does not exist: there are %u", node, rig.node_count());
    const auto before = [](const model::RootCurve &curve, uint32_t of) { return curve.clip < of; };
    const auto curve = std::lower_bound(rig.root_curves.begin(), rig.root_curves.end(), clip, before);
    if (curve != rig.root_curves.end() && curve->clip == clip)
        fail(CLQ_ARGUMENT, "clip '%s' has root motion twice", rig.clip_names[clip].c_str());
    const model::Clip &of = rig.clips[clip];
    std::vector<bool> moves(rig.node_count());
    for (uint32_t i = of.first_channel; i < of.first_channel + of.channel_count; ++i)
        if (rig.channels[i].target != model::ChannelTarget::morph_weights) moves[rig.channels[i].node] = true;
    for (uint32_t n = rig.parents[node]; n != none; n = rig.parents[n])
        if (moves[n])
            fail(CLQ_ARGUMENT, "root motion of node '%s': clip '%s' animates node '%s' above it",
                 rig.node_names[node].c_str(), rig.clip_names[clip].c_str(), rig.node_names[n].c_str());
    RootMotionExtractor(rig, clip, node).run();
}

void extract_root_motions(const model::Model &model, Allowance &allowance, model::Rig &rig)
{
    if (model.root_motions.empty()) return;
    charge(model, allowance, rig);
    for (const model::RootMotionRequest &request : model.root_motions)
        extract_root_motion(rig, request.clip, request.node);
    model::check(rig);
}

}  // namespace claque::meshsplit

// Clips between skeletons that differ: transfers rotations in model space from rest to rest, and the path of the
// topmost joints.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/base/error.h"
#include "lib/retarget/followers.h"
#include "lib/retarget/new_clips.h"
#include "lib/retarget/pose_check.h"
#include "lib/retarget/source_pose.h"
#include "lib/retarget/source_rest.h"

namespace claque::retarget
{

using model::none;

namespace
{

// Poses of the target, one a key: rotations of the bound joints in model space and positions of the topmost ones.
struct Keys {
    std::vector<double> times_s;
    std::vector<std::vector<glm::dquat>> rotations;  // [key][match]
    std::vector<std::vector<glm::dvec3>> positions;  // [key][match]: meaningful for topmost joints
};

class Transfer
{
public:
    Transfer(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
             const RestChoice &rest, const Options &options)
        : target_(target),
          source_(source),
          matches_(matches),
          rest_(rest),
          alignment_(rest.alignment),
          options_(options),
          rest_t_(rest_pose(target)),
          match_of_(target.node_count(), none),
          follower_bindings_(match_followers(target, matches, options))
    {
        for (uint32_t i = 0; i < matches.size(); ++i) match_of_[matches[i].target] = i;
        find_soles();
    }

    void run(uint32_t clip, NewClips &added, PoseCheck &check)
    {
        Keys keys = sample_keys(clip);
        if (options_.travel == RootTravel::in_place) remove_travel(keys);
        place_on_ground(keys);
        look(clip, keys, check);
        const std::vector<std::vector<glm::dquat>> locals = locals_of(keys);
        write(keys, locals, added);
    }

private:
    // Finds the joints of the target that are near the ground at rest; they are to stand on it.
    void find_soles()
    {
        double low = 1e300, high = -1e300;
        for (const JointMatch &m : matches_) {
            low = std::min(low, rest_t_.positions[m.target].y);
            high = std::max(high, rest_t_.positions[m.target].y);
        }
        for (const JointMatch &m : matches_)
            if (rest_t_.positions[m.target].y <= low + 0.08 * (high - low)) soles_.push_back(m.target);
        // A character may rest in a jump, or round its hips. Some maps bind no feet.
        double lowest = low;
        std::vector<bool> hangs(target_.node_count());
        for (uint32_t i = 0; i < target_.node_count(); ++i) {
            hangs[i] = match_of_[i] != none || (target_.parents[i] != none && hangs[target_.parents[i]]);
            if (hangs[i]) lowest = std::min(lowest, rest_t_.positions[i].y);
        }
        if (std::fabs(lowest) > 0.15 * (high - lowest)) ground_ = lowest;
    }

    Keys sample_keys(uint32_t clip) const
    {
        const model::Clip &from = source_.clips[clip];
        const double length = static_cast<double>(from.duration_s), first = std::min(options_.start_s, length);
        const double last = std::min(options_.end_s, length);
        if (options_.start_s > length && length > 0)
            base::fail(CLQ_ARGUMENT, "clip '%s' is %g s long: nothing is left of it from %g s on",
                       source_.clip_names[clip].c_str(), length, options_.start_s);
        if (!(last >= first))
            base::fail(CLQ_ARGUMENT, "the range %g s to %g s is empty in clip '%s', which is %g s long",
                       options_.start_s, options_.end_s, source_.clip_names[clip].c_str(), length);
        const double steps = std::ceil((last - first) * options_.rate_hz - 1e-6);
        if (steps > 1e7) base::fail(CLQ_LIMIT, "clip '%s' would have %g keys", source_.clip_names[clip].c_str(), steps);
        const uint32_t count = static_cast<uint32_t>(std::max(steps, 0.0));
        SourcePose pose(source_, clip);
        Keys keys;
        for (uint32_t k = 0; k <= count; ++k) {
            const double time_s = count == 0 ? 0 : (last - first) * k / count;
            keys.times_s.push_back(time_s);
            pose.at(static_cast<double>(from.start_s) + first + time_s);
            keys.rotations.emplace_back();
            keys.positions.emplace_back();
            for (uint32_t i = 0; i < matches_.size(); ++i) {
                const JointMatch &m = matches_[i];
                const glm::dquat turned = pose.rotation(m.source) * glm::conjugate(rest_.rotations[i]);
                keys.rotations.back().push_back(alignment_.axes * turned * glm::conjugate(alignment_.axes) *
                                                alignment_.aligned[i] * rest_t_.rotations[m.target]);
                keys.positions.back().push_back(alignment_.scale * (alignment_.axes * pose.position(m.source)));
            }
        }
        move_to_rest(keys);
        return keys;
    }

    // Every clip starts where the first topmost joint rests, horizontally; place_on_ground sets the height.
    void move_to_rest(Keys &keys) const
    {
        glm::dvec3 by = rest_t_.positions[matches_[0].target] - keys.positions[0][0];
        by.y = 0;
        for (auto &positions : keys.positions)
            for (glm::dvec3 &position : positions) position += by;
    }

    void remove_travel(Keys &keys) const
    {
        glm::dvec3 travelled = keys.positions.back()[0] - keys.positions.front()[0];
        travelled.y = 0;
        for (size_t k = 0; k < keys.positions.size(); ++k) {
            const double share = keys.times_s.back() > 0 ? keys.times_s[k] / keys.times_s.back() : 0;
            for (glm::dvec3 &position : keys.positions[k]) position -= travelled * share;
        }
    }

    // Returns the positions of all joints of the target with these rotations; unbound joints are at rest.
    std::vector<glm::dvec3> posed(const std::vector<glm::dquat> &rotations, const std::vector<glm::dvec3> &tops) const
    {
        std::vector<glm::dquat> rotation(target_.node_count());
        std::vector<glm::dvec3> position(target_.node_count());
        for (uint32_t i = 0; i < target_.node_count(); ++i) {
            const uint32_t parent = target_.parents[i], match = match_of_[i];
            const glm::dquat above = parent == none ? glm::dquat(1, 0, 0, 0) : rotation[parent];
            rotation[i] = match != none ? rotations[match] : above * glm::normalize(dquat_of(target_.rest[i].rotation));
            if (match != none && matches_[match].above == none) position[i] = tops[match];
            else if (parent == none) position[i] = rest_t_.positions[i];
            else  // the rest bone, rotated with its parent
                position[i] = position[parent] + above * (glm::conjugate(rest_t_.rotations[parent]) *
                                                          (rest_t_.positions[i] - rest_t_.positions[parent]));
        }
        return position;
    }

    // Lowers the motion so that soles touch the ground. Each pose counts by its lowest sole; the result is the median
    // of the lower quarter, so that neither a jump nor one bad frame shifts the whole clip.
    void place_on_ground(Keys &keys) const
    {
        std::vector<double> gaps;
        for (size_t k = 0; k < keys.times_s.size(); ++k) {
            const std::vector<glm::dvec3> positions = posed(keys.rotations[k], keys.positions[k]);
            double gap = 1e300;
            for (const uint32_t sole : soles_)
                gap = std::min(gap, positions[sole].y - rest_t_.positions[sole].y + ground_);
            gaps.push_back(gap);
        }
        std::sort(gaps.begin(), gaps.end());
        const double gap = gaps[gaps.size() / 8];
        for (auto &positions : keys.positions)
            for (glm::dvec3 &position : positions) position.y -= gap;
    }

    // At the first key, the middle one and the last.
    void look(uint32_t clip, const Keys &keys, PoseCheck &check) const
    {
        const size_t last = keys.times_s.size() - 1;
        for (const size_t k : {size_t(0), last / 2, last}) {
            const std::vector<glm::dvec3> nodes = posed(keys.rotations[k], keys.positions[k]);
            std::vector<glm::dvec3> own, wanted;
            for (uint32_t i = 0; i < matches_.size(); ++i) {
                own.push_back(nodes[matches_[i].target]);
                wanted.push_back(rest_.upright * (glm::conjugate(alignment_.axes) * keys.positions[k][i]));
            }
            check.look(clip, keys.times_s[k], own, wanted);
        }
    }

    // Local rotations of the matches, then of the followers.
    std::vector<std::vector<glm::dquat>> locals_of(const Keys &keys) const
    {
        std::vector<std::vector<glm::dquat>> out;
        for (const std::vector<glm::dquat> &rotations : keys.rotations) {
            out.emplace_back();
            for (const JointMatch &m : matches_) {
                // Joints between a joint and its bound ancestor are at rest.
                glm::dquat above(1, 0, 0, 0);
                const uint32_t parent = target_.parents[m.target];
                if (parent != none) above = rest_t_.rotations[parent];
                if (m.above != none)
                    above = rotations[m.above] * glm::conjugate(rest_t_.rotations[matches_[m.above].target]) * above;
                out.back().push_back(
                    glm::normalize(glm::conjugate(above) * rotations[static_cast<size_t>(&m - matches_.data())]));
            }
            for (const FollowerBinding &f : follower_bindings_)
                out.back().push_back(local_rotation(f, target_, rest_t_, matches_, rotations));
        }
        return out;
    }

    // Returns how much of the blend into the first pose is done at this key.
    double closing(const Keys &keys, size_t k) const
    {
        if (!(options_.close_s > 0)) return 0;
        const double from = std::max(0.0, keys.times_s.back() - options_.close_s), length = keys.times_s.back() - from;
        const double t = length > 0 ? std::clamp((keys.times_s[k] - from) / length, 0.0, 1.0) : 0;
        return t * t * t * (10 + t * (6 * t - 15));
    }

    void write(const Keys &keys, const std::vector<std::vector<glm::dquat>> &locals, NewClips &added) const
    {
        model::Clip made;
        made.first_channel = static_cast<uint32_t>(added.channels.size());
        made.duration_s = static_cast<float>(keys.times_s.back());
        model::Channel channel;
        channel.first_time = static_cast<uint32_t>(added.times.size());
        channel.key_count = static_cast<uint32_t>(keys.times_s.size());
        for (const double time_s : keys.times_s) added.times.push_back(static_cast<float>(time_s));
        for (uint32_t i = 0; i < matches_.size(); ++i) {
            channel.node = matches_[i].target;
            if (matches_[i].above == none) write_positions(keys, i, channel, added);
            write_rotations(keys, locals, i, channel, added);
        }
        for (uint32_t i = 0; i < follower_bindings_.size(); ++i) {
            channel.node = follower_bindings_[i].joint;
            write_rotations(keys, locals, static_cast<uint32_t>(matches_.size()) + i, channel, added);
        }
        made.channel_count = static_cast<uint32_t>(added.channels.size()) - made.first_channel;
        added.clips.push_back(made);
    }

    void write_positions(const Keys &keys, uint32_t i, model::Channel channel, NewClips &added) const
    {
        channel.target = model::ChannelTarget::translation;
        channel.component_count = 3;
        channel.first_value = static_cast<uint32_t>(added.values.size());
        const uint32_t parent = target_.parents[matches_[i].target];
        const math::Affine local = parent == none ? math::Affine() : math::inverse(rest_t_.globals[parent]);
        const glm::dvec3 closes = keys.positions.front()[i] - keys.positions.back()[i];
        for (size_t k = 0; k < keys.positions.size(); ++k) {
            const glm::vec3 p =
                math::transform_point(local, glm::vec3(keys.positions[k][i] + closing(keys, k) * closes));
            added.values.insert(added.values.end(), {p.x, p.y, p.z});
        }
        added.channels.push_back(channel);
    }

    void write_rotations(const Keys &keys, const std::vector<std::vector<glm::dquat>> &locals, uint32_t i,
                         model::Channel channel, NewClips &added) const
    {
        channel.target = model::ChannelTarget::rotation;
        channel.component_count = 4;
        channel.first_value = static_cast<uint32_t>(added.values.size());
        const glm::dquat closes = glm::conjugate(locals.back()[i]) * locals.front()[i];
        glm::dquat before(1, 0, 0, 0);
        for (size_t k = 0; k < locals.size(); ++k) {
            const double share = closing(keys, k);
            glm::dquat q = locals[k][i];
            if (share > 0) q = glm::normalize(q * partial_rotation(closes, share));
            if (glm::dot(before, q) < 0) q = -q;  // the shorter arc from key to key
            before = q;
            added.values.insert(added.values.end(), {static_cast<float>(q.x), static_cast<float>(q.y),
                                                     static_cast<float>(q.z), static_cast<float>(q.w)});
        }
        added.channels.push_back(channel);
    }

    const model::Rig &target_, &source_;
    const std::vector<JointMatch> &matches_;
    const RestChoice &rest_;
    const SkeletonAlignment &alignment_;
    const Options &options_;
    GlobalPose rest_t_;
    std::vector<uint32_t> match_of_;  // [nodes of the target]
    std::vector<FollowerBinding> follower_bindings_;
    std::vector<uint32_t> soles_;
    double ground_ = 0;  // the height of the ground in the pose of rest
};

}  // namespace

void transfer(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
              const RestChoice &rest, const Options &options, uint32_t clip, NewClips &added, PoseCheck &check)
{
    Transfer(target, source, matches, rest, options).run(clip, added, check);
}

}  // namespace claque::retarget

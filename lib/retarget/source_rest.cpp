#include "lib/retarget/source_rest.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "lib/retarget/bones.h"
#include "lib/retarget/new_clips.h"
#include "lib/retarget/source_pose.h"

namespace claque::retarget
{

using model::none;

namespace
{

constexpr uint32_t looked_at = 64;  // of the keys of a clip

class RestChooser
{
public:
    RestChooser(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
                const Options &options, uint32_t clip)
        : target_(target),
          source_(source),
          matches_(matches),
          options_(options),
          clip_(clip),
          own_(rest_pose(target)),
          file_(rest_pose(source)),
          bones_(bones_of(matches, own_))
    {
        for (uint32_t c = 0; c < source.clips[clip].channel_count; ++c) {
            const model::Channel &channel = source.channels[source.clips[clip].first_channel + c];
            if (!keys_ || channel.key_count > keys_->key_count) keys_ = &channel;
        }
    }

    RestChoice automatic(std::vector<std::string> &warnings) const
    {
        const RestChoice file = of_file();
        if (file.channels || options_.mode == Mode::channels) return file;
        const auto hangs = [&](const JointMatch &match) { return hangs_alike(source_, matches_, match); };
        double scale = 1;
        if (std::all_of(matches_.begin(), matches_.end(), hangs) && offsets_agree(matches_, own_, file_, scale)) {
            RestChoice same = of_character();
            same.channels = std::fabs(scale - 1) <= 0.01 && same.alignment.axes.w > 0.999;
            return same;
        }
        const AxisShare along = along_one_axis(bones_, matches_, file_);
        if (along.share > 0.8 && likeness_of(file_, file.alignment.axes) < 0.5) {
            const uint32_t key = likest_key();
            warnings.push_back(base::text_of(
                "the clips' skeleton rests in no pose: %.0f %% of its bones lie along %c. Frame %u of '%s' takes its "
                "place; rest = \"frame:N\" in the map names another, rest = \"file\" keeps it",
                100 * along.share, "xyz"[along.axis], key, source_.clip_names[clip_].c_str()));
            return of_bones(key);
        }
        const double off = degrees_off(file);
        if (off < 15) return file;
        const RestChoice copied = of_character();
        const double copied_off = degrees_off(copied);
        if (copied_off > 10 || copied_off > off / 2) return file;
        warnings.push_back(base::text_of(
            "from rest to rest bones would point %.0f degrees elsewhere than in '%s', %.0f with copied rotations: they "
            "are copied. rest = \"file\" in the map keeps the rest pose",
            off, source_.clip_names[clip_].c_str(), copied_off));
        return copied;
    }

    RestChoice of_file() const
    {
        RestChoice out;
        out.alignment = align_skeletons(matches_, own_, file_, common_axes(matches_, own_, file_));
        // Axes that fit no pose say nothing of what is up.
        if (likeness_of(file_, out.alignment.axes) >= 0.5) out.upright = out.alignment.axes;
        take_rotations(file_, out);
        out.channels = rest_poses_agree(target_, source_, matches_);
        return out;
    }

    RestChoice of_frame() const
    {
        const uint32_t count = keys_ ? keys_->key_count : 1;
        if (options_.rest_frame >= count)
            base::fail(CLQ_ARGUMENT, "the skeleton is to rest as in frame %u, and clip '%s' has the frames 0 to %u",
                       options_.rest_frame, source_.clip_names[clip_].c_str(), count - 1);
        const GlobalPose pose = pose_at(time_of(options_.rest_frame));
        RestChoice out;
        out.kind = SourceRest::frame;
        out.alignment = align_skeletons(matches_, own_, pose, axes_of(pose));
        out.upright = out.alignment.axes;
        take_rotations(pose, out);
        return out;
    }

    RestChoice of_bones(uint32_t key) const
    {
        const GlobalPose pose = pose_at(time_of(key));
        const glm::dquat axes = axes_of(pose);
        std::vector<JointMatch> aligned = matches_;
        for (JointMatch &match : aligned) match.rest = RestAlignment::align;
        for (const uint32_t joint : upright_joints(pose, axes)) aligned[joint].rest = RestAlignment::keep;
        RestChoice out;
        out.kind = SourceRest::bones;
        out.alignment = align_skeletons(aligned, own_, pose, axes);
        out.upright = out.alignment.axes;
        take_rotations(pose, out);
        return out;
    }

    RestChoice of_character() const
    {
        RestChoice out;
        out.kind = SourceRest::character;
        const JointMatch &top = matches_[0];
        glm::dquat axes(1, 0, 0, 0);
        // Equal frames above the skeletons: one pair of axes. Else the topmost joints tell them.
        if (std::fabs(glm::dot(above(own_, target_, top.target), above(file_, source_, top.source))) < 0.999) {
            const glm::dquat turned = file_.rotations[top.source] * glm::conjugate(own_.rotations[top.target]);
            GlobalPose pose;
            pose.positions.resize(source_.node_count());
            for (const JointMatch &match : matches_)
                pose.positions[match.source] = turned * own_.positions[match.target];
            axes = common_axes(matches_, own_, pose);
        }
        out.alignment = align_skeletons(matches_, own_, file_, axes);
        out.alignment.aligned.assign(matches_.size(), glm::dquat(1, 0, 0, 0));
        out.upright = axes;
        for (const JointMatch &match : matches_)
            out.rotations.push_back(glm::conjugate(axes) * own_.rotations[match.target]);
        return out;
    }

    // Returns the key whose pose has the bones most like the target's at rest; the first of those that are nearly so.
    uint32_t likest_key() const
    {
        const uint32_t count = keys_ ? keys_->key_count : 1, looks = std::min(count, looked_at);
        std::vector<double> alike;
        for (uint32_t i = 0; i < looks; ++i) {
            const GlobalPose pose = pose_at(time_of(key_of(i, looks, count)));
            alike.push_back(likeness_of(pose, axes_of(pose)));
        }
        const double most = *std::max_element(alike.begin(), alike.end());
        const auto first = std::find_if(alike.begin(), alike.end(), [&](double x) { return x >= most - 0.02; });
        return key_of(static_cast<uint32_t>(first - alike.begin()), looks, count);
    }

private:
    static uint32_t key_of(uint32_t look, uint32_t looks, uint32_t count)
    {
        return looks < 2 ? 0 : static_cast<uint32_t>(uint64_t(look) * (count - 1) / (looks - 1));
    }

    double time_of(uint32_t key) const
    {
        return static_cast<double>(keys_ ? source_.times[keys_->first_time + key] : source_.clips[clip_].start_s);
    }

    GlobalPose pose_at(double time_s) const
    {
        SourcePose pose(source_, clip_);
        pose.at(time_s);
        GlobalPose out;
        for (uint32_t i = 0; i < source_.node_count(); ++i) {
            out.rotations.push_back(pose.rotation(i));
            out.positions.push_back(pose.position(i));
        }
        return out;
    }

    glm::dquat axes_of(const GlobalPose &pose) const
    {
        const glm::dquat axes = common_axes(matches_, own_, pose);
        return facing_rotation(bones_, matches_, own_, pose, axes) * axes;
    }

    double likeness_of(const GlobalPose &pose, const glm::dquat &axes) const
    {
        return likeness(bones_, matches_, own_, pose, axes);
    }

    void take_rotations(const GlobalPose &pose, RestChoice &out) const
    {
        for (const JointMatch &match : matches_) out.rotations.push_back(pose.rotations[match.source]);
    }

    // Returns the joints from the highest one at rest down to the root, below which no bone differs by 25 degrees: a
    // trunk that stands keeps the posture of the character, whose spine and neck are bent in their own way.
    std::vector<uint32_t> upright_joints(const GlobalPose &pose, const glm::dquat &axes) const
    {
        uint32_t joint = 0;
        for (uint32_t i = 1; i < matches_.size(); ++i)
            if (own_.positions[matches_[i].target].y > own_.positions[matches_[joint].target].y) joint = i;
        std::vector<uint32_t> out = {joint};
        for (uint32_t up = matches_[joint].above; up != none; joint = up, up = matches_[up].above) {
            const glm::dvec3 own = own_.positions[matches_[joint].target] - own_.positions[matches_[up].target];
            const glm::dvec3 other =
                axes * (pose.positions[matches_[joint].source] - pose.positions[matches_[up].source]);
            if (glm::dot(own, other) < 0.9 * glm::length(own) * glm::length(other)) return {};
            out.push_back(up);
        }
        return out;
    }

    static glm::dquat above(const GlobalPose &pose, const model::Rig &rig, uint32_t node)
    {
        const uint32_t parent = rig.parents[node];
        return parent == none ? glm::dquat(1, 0, 0, 0) : pose.rotations[parent];
    }

    // How far bones point elsewhere than in the clip, at its begin, middle and end: the mean by lengths.
    double degrees_off(const RestChoice &choice) const
    {
        const model::Clip &clip = source_.clips[clip_];
        const glm::dquat &axes = choice.alignment.axes;
        double sum = 0, all = 0;
        for (const double share : {0.0, 0.5, 1.0}) {
            const GlobalPose pose =
                pose_at(static_cast<double>(clip.start_s) + share * static_cast<double>(clip.duration_s));
            for (const Bone &bone : bones_) {
                const JointMatch &upper = matches_[bone.upper], &lower = matches_[bone.lower];
                const glm::dquat moved = axes * pose.rotations[upper.source] *
                                         glm::conjugate(choice.rotations[bone.upper]) * glm::conjugate(axes) *
                                         choice.alignment.aligned[bone.upper];
                const glm::dvec3 own = moved * (own_.positions[lower.target] - own_.positions[upper.target]);
                const glm::dvec3 other = axes * (pose.positions[lower.source] - pose.positions[upper.source]);
                const double length = glm::length(other);
                if (!(length > 0)) continue;
                all += bone.length;
                sum += bone.length * math::acos(glm::dot(own, other) / (bone.length * length));
            }
        }
        return all > 0 ? sum / all * 180 / math::pi : 0;
    }

    const model::Rig &target_, &source_;
    const std::vector<JointMatch> &matches_;
    const Options &options_;
    uint32_t clip_;
    GlobalPose own_, file_;
    std::vector<Bone> bones_;
    const model::Channel *keys_ = nullptr;  // the channel of the clip with the most keys
};

}  // namespace

RestChoice choose_rest(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches,
                       const Options &options, const std::vector<uint32_t> &clips, std::vector<std::string> &warnings)
{
    const RestChooser chooser(target, source, matches, options, clips.front());
    switch (options.rest) {
        case SourceRest::automatic:
            return chooser.automatic(warnings);
        case SourceRest::file:
            return chooser.of_file();
        case SourceRest::frame:
            return chooser.of_frame();
        case SourceRest::bones:
            return chooser.of_bones(chooser.likest_key());
        case SourceRest::character:
            return chooser.of_character();
    }
    return chooser.of_file();
}

}  // namespace claque::retarget

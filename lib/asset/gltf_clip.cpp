#include "lib/asset/gltf_clip.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "lib/asset/clip_extras.h"

namespace claque::asset
{

using base::fail;
using model::Channel;
using model::ChannelTarget;
using model::Interpolation;

namespace
{

class ClipReader
{
public:
    ClipReader(File &file, const NodeTree &tree, const TargetCounts &targets, const RigMapping &mapping,
               model::Rig &rig)
        : file_(file), tree_(tree), targets_(targets), mapping_(mapping), rig_(rig)
    {
    }

    void read(const JsonView &animation, size_t number)
    {
        animation.object();
        const JsonView channels = animation["channels"], samplers = animation["samplers"];
        for (const JsonView *list : {&channels, &samplers})
            if (!list->exists()) fail(CLQ_FORMAT, "%s is missing", list->path().c_str());
        model::Clip clip;
        clip.first_channel = static_cast<uint32_t>(rig_.channels.size());
        std::set<std::pair<uint32_t, ChannelTarget>> taken;
        for (size_t i = 0; i < channels.count(); ++i) read_channel(channels.at(i), samplers, taken);
        clip.channel_count = static_cast<uint32_t>(rig_.channels.size()) - clip.first_channel;
        model::set_span(rig_, clip);
        rig_.clips.push_back(clip);
        rig_.clip_names.emplace_back(animation["name"].text_or("").c_str());
        if (rig_.clip_names.back().empty()) rig_.clip_names.back() = "clip " + std::to_string(number);
    }

private:
    struct Sampler {
        JsonView view;
        uint32_t input = 0, output = 0;
        Interpolation interpolation = Interpolation::linear;
    };

    Sampler sampler_of(const JsonView &view) const
    {
        Sampler out;
        out.view = view;
        view.object();
        out.input = file_.accessors.reference(view["input"]);
        out.output = file_.accessors.reference(view["output"]);
        const std::string way = view["interpolation"].text_or("LINEAR");
        if (way == "STEP") out.interpolation = Interpolation::step;
        if (way == "CUBICSPLINE") out.interpolation = Interpolation::cubic_spline;
        if (way != "STEP" && way != "LINEAR" && way != "CUBICSPLINE")
            fail(CLQ_FORMAT, "%s.interpolation is '%.40s': STEP, LINEAR and CUBICSPLINE are known", view.path().c_str(),
                 way.c_str());
        return out;
    }

    // False for targets that only other extensions define.
    bool path_of(const JsonView &view, ChannelTarget &out)
    {
        const std::string &name = view.text();
        if (name == "translation") return out = ChannelTarget::translation, true;
        if (name == "rotation") return out = ChannelTarget::rotation, true;
        if (name == "scale") return out = ChannelTarget::scale, true;
        if (name == "weights") return out = ChannelTarget::morph_weights, true;
        file_.warn(base::text_of("%s is '%.40s': not animated", view.path().c_str(), name.c_str()));
        return false;
    }

    void read_channel(const JsonView &view, const JsonView &samplers,
                      std::set<std::pair<uint32_t, ChannelTarget>> &taken)
    {
        view.object();
        const uint32_t number = view["sampler"].index(samplers.count(), "sampler");
        const JsonView target = view["target"];
        target.object();
        ChannelTarget path{};
        if (!path_of(target["path"], path)) return;
        const uint32_t node = target["node"].index_or_none(tree_.file_count, "node");
        if (node == none) return;  // legal: an extension may define the target
        if (!taken.insert({node, path}).second)
            fail(CLQ_FORMAT, "%s: another channel of the same clip moves the same", target.path().c_str());
        Channel channel;
        channel.target = path;
        channel.component_count = static_cast<uint16_t>(components(node, path, target));
        read_keys(sampler_of(samplers.at(number)), channel);
        channel.node = path == ChannelTarget::morph_weights ? mapping_.morph_set[node] : mapping_.node[node];
        if (channel.node != none) rig_.channels.push_back(channel);
        if (tree_.nodes[node].has_matrix)
            file_.warn(base::text_of("%s moves a node that has a matrix: moved as its translation, rotation and scale",
                                     target.path().c_str()));
    }

    uint32_t components(uint32_t node, ChannelTarget path, const JsonView &target) const
    {
        if (path == ChannelTarget::rotation) return 4;
        if (path != ChannelTarget::morph_weights) return 3;
        if (targets_[node] == 0)
            fail(CLQ_FORMAT, "%s animates morph weights of a node without morph targets", target.path().c_str());
        return targets_[node];
    }

    // Key times as the rig holds them. Two keys at one time are not legal but occur; the first of them counts.
    struct Times {
        uint32_t first = 0;
        std::vector<uint32_t> kept;  // indices of the keys that count; empty: all
    };

    void read_keys(const Sampler &sampler, Channel &channel)
    {
        const uint32_t listed = file_.accessors.at(sampler.input).count;
        channel.interpolation = sampler.interpolation;
        if (channel.interpolation == Interpolation::cubic_spline && listed < 2)
            fail(CLQ_FORMAT, "%s: a cubic spline has 2 keys at least", sampler.view.path().c_str());
        const Times &times = times_of(sampler);
        channel.first_time = times.first;
        channel.key_count = times.kept.empty() ? listed : static_cast<uint32_t>(times.kept.size());
        channel.first_value = values_of(sampler, channel, listed, times.kept);
    }

    // Samplers of one file mostly share their times, and all channels of a sampler share its values. Each is kept once.
    const Times &times_of(const Sampler &sampler)
    {
        const auto [place, is_new] = times_.emplace(sampler.input, Times());
        if (!is_new) return place->second;
        const std::string path = sampler.view["input"].path();
        if (file_.accessors.at(sampler.input).component != Component::f32)
            fail(CLQ_FORMAT, "%s: key times are not floats", path.c_str());
        const std::vector<float> listed = file_.accessors.floats(sampler.input, 1, path);
        std::vector<float> times;
        std::vector<uint32_t> kept;
        for (size_t i = 0; i < listed.size(); ++i) {
            if (listed[i] < 0 || (i > 0 && listed[i] < listed[i - 1]))
                fail(CLQ_FORMAT, "%s: key time number %zu is %g: times start at 0 or later and ascend", path.c_str(), i,
                     static_cast<double>(listed[i]));
            if (i > 0 && listed[i] == listed[i - 1]) continue;
            times.push_back(listed[i]);
            kept.push_back(static_cast<uint32_t>(i));
        }
        place->second.first = static_cast<uint32_t>(rig_.times.size());
        if (kept.size() < listed.size()) {
            file_.warn(base::text_of("%s: %zu keys have the time of the one before: left out", path.c_str(),
                                     listed.size() - kept.size()));
            place->second.kept = std::move(kept);
        }
        grow(rig_.times, times, path);
        return place->second;
    }

    uint32_t values_of(const Sampler &sampler, const Channel &channel, uint32_t listed,
                       const std::vector<uint32_t> &kept)
    {
        const std::string path = sampler.view["output"].path();
        const uint64_t groups = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
        const bool morphs = channel.target == ChannelTarget::morph_weights;
        const uint64_t wanted = groups * listed * (morphs ? channel.component_count : 1);
        if (file_.accessors.at(sampler.output).count != wanted)
            fail(CLQ_FORMAT, "%s has %u elements instead of %llu for %u keys", path.c_str(),
                 file_.accessors.at(sampler.output).count, static_cast<unsigned long long>(wanted), listed);
        const auto key = std::make_tuple(sampler.output, kept.empty() ? none : sampler.input, channel.target,
                                         channel.interpolation, channel.component_count);
        const auto [place, is_new] = values_.emplace(key, static_cast<uint32_t>(rig_.values.size()));
        if (!is_new) return place->second;
        std::vector<float> values = file_.accessors.floats(sampler.output, morphs ? 1 : channel.component_count, path);
        if (channel.target == ChannelTarget::rotation) make_unit(values, groups == 3, path);
        if (!kept.empty()) values = picked(values, kept, groups * channel.component_count);
        grow(rig_.values, values, path);
        return place->second;
    }

    static std::vector<float> picked(const std::vector<float> &values, const std::vector<uint32_t> &keys, size_t width)
    {
        std::vector<float> out;
        out.reserve(keys.size() * width);
        for (const uint32_t key : keys)
            out.insert(out.end(), values.begin() + key * width, values.begin() + (key + 1) * width);
        return out;
    }

    // Normalises rotations. Tangents of splines are not rotations and stay as they are.
    static void make_unit(std::vector<float> &values, bool cubic, const std::string &path)
    {
        for (size_t i = cubic ? 4 : 0; i < values.size(); i += cubic ? 12 : 4) {
            double sum = 0;
            for (size_t k = 0; k < 4; ++k)
                sum += static_cast<double>(values[i + k]) * static_cast<double>(values[i + k]);
            const double length = std::sqrt(sum);
            if (!(std::fabs(length - 1) < 0.1))
                fail(CLQ_FORMAT, "%s: rotation number %zu has length %g instead of 1", path.c_str(), i / 4, length);
            for (size_t k = 0; k < 4; ++k)
                values[i + k] = static_cast<float>(static_cast<double>(values[i + k]) / length);
        }
    }

    void grow(model::Array<float> &to, const std::vector<float> &from, const std::string &path)
    {
        if (to.size() + from.size() > 0xffffffffull) fail(CLQ_LIMIT, "%s: too many keys", path.c_str());
        file_.budget.charge(2 * sizeof(float) * from.size(), path.c_str());
        to.insert(to.end(), from.begin(), from.end());
    }

    File &file_;
    const NodeTree &tree_;
    const TargetCounts &targets_;
    const RigMapping &mapping_;
    model::Rig &rig_;
    std::map<uint32_t, Times> times_;  // by accessor
    std::map<std::tuple<uint32_t, uint32_t, ChannelTarget, Interpolation, uint16_t>, uint32_t> values_;
};

}  // namespace

void read_clips(File &file, const NodeTree &tree, const TargetCounts &targets, const RigMapping &mapping,
                model::Rig &rig)
{
    ClipReader reader(file, tree, targets, mapping, rig);
    const JsonView list = file.root["animations"];
    for (size_t i = 0; i < list.count(); ++i) {
        reader.read(list.at(i), i);
        read_clip_extras(list.at(i)["extras"], file, rig);
    }
}

}  // namespace claque::asset

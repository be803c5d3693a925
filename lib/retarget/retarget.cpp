#include "lib/retarget/retarget.h"

#include <algorithm>

#include "lib/base/error.h"
#include "lib/base/near_names.h"
#include "lib/retarget/new_clips.h"
#include "lib/retarget/pose_check.h"
#include "lib/retarget/source_rest.h"
#include "lib/retarget/standing_rest.h"

namespace claque::retarget
{

using base::fail;
using model::none;

namespace
{

void check(const Options &o)
{
    if (!(o.rate_hz >= 1 && o.rate_hz <= 1000))
        fail(CLQ_ARGUMENT, "the rate is %g keys per second: it must be from 1 to 1000", o.rate_hz);
    if (!(o.start_s >= 0) || !(o.end_s >= o.start_s))
        fail(CLQ_ARGUMENT, "the range of the clips is %g s to %g s: it must ascend from 0 or later", o.start_s,
             o.end_s);
    if (!(o.close_s >= 0)) fail(CLQ_ARGUMENT, "the time to close clips is %g s: it must not be negative", o.close_s);
}

std::vector<uint32_t> wanted_clips(const model::Rig &source, const Options &options)
{
    std::vector<uint32_t> out;
    if (source.clips.empty()) fail(CLQ_ARGUMENT, "there are no clips to add");
    if (options.clips.empty())
        for (uint32_t i = 0; i < source.clips.size(); ++i) out.push_back(i);
    for (const std::string &name : options.clips) {
        out.push_back(source.find_clip(name));
        if (out.back() == none)
            fail(CLQ_ARGUMENT, "there is no clip '%s' among the %zu clips%s", name.c_str(), source.clips.size(),
                 base::names_near(name, source.clip_names).c_str());
    }
    return out;
}

bool is_taken(const model::Rig &target, const NewClips &added, const std::string &name)
{
    return target.find_clip(name) != none ||
           std::find(added.names.begin(), added.names.end(), name) != added.names.end();
}

std::string unique_name(const model::Rig &target, const NewClips &added, const std::string &name, Report &report)
{
    if (!is_taken(target, added, name)) return name;
    for (int number = 2;; ++number) {
        const std::string other = name + "." + std::to_string(number);
        if (is_taken(target, added, other)) continue;
        report.warnings.push_back("clip '" + name + "' already exists: the new clip is '" + other + "'");
        return other;
    }
}

// For the clip that was added last.
void copy_markers(const model::Rig &source, uint32_t clip, const Options &options, Mode mode, NewClips &added)
{
    const model::Clip &made = added.clips.back();
    for (size_t i = 0; i < source.markers.size(); ++i) {
        const model::Marker &marker = source.markers[i];
        if (marker.clip != clip) continue;
        double time_s = static_cast<double>(marker.time_s);
        if (mode == Mode::motion) {
            time_s -= static_cast<double>(source.clips[clip].start_s) + options.start_s;
            if (time_s < 0 || time_s > static_cast<double>(made.duration_s)) continue;
        }
        added.markers.push_back({static_cast<uint32_t>(added.clips.size()) - 1, static_cast<float>(time_s)});
        added.marker_names.emplace_back(source.marker_names[i].c_str());
    }
}

template <class To, class From>
void append(To &to, const From &from)
{
    to.insert(to.end(), from.begin(), from.end());
}

// Everything that may fail comes before the first change of the target.
void merge(model::Rig &target, NewClips &&added)
{
    const uint64_t room = 0xffffffffull;
    if (target.times.size() + added.times.size() > room || target.values.size() + added.values.size() > room)
        fail(CLQ_LIMIT, "the clips have more keys or values than a character can hold");
    const uint32_t channels = static_cast<uint32_t>(target.channels.size());
    const uint32_t times = static_cast<uint32_t>(target.times.size());
    const uint32_t values = static_cast<uint32_t>(target.values.size());
    for (model::Clip &clip : added.clips) clip.first_channel += channels;
    for (model::Channel &channel : added.channels) channel.first_time += times, channel.first_value += values;
    model::Array<std::pmr::string> names(target.clip_names.get_allocator());
    names.reserve(target.clip_names.size() + added.names.size());
    for (const std::pmr::string &name : target.clip_names) names.emplace_back(std::string_view(name));
    for (const std::string &name : added.names) names.emplace_back(std::string_view(name));
    const uint32_t clips = static_cast<uint32_t>(target.clips.size());
    for (model::Marker &marker : added.markers) marker.clip += clips;
    model::Array<std::pmr::string> marker_names(target.marker_names.get_allocator());
    marker_names.reserve(target.marker_names.size() + added.marker_names.size());
    for (const std::pmr::string &name : target.marker_names) marker_names.emplace_back(std::string_view(name));
    for (const std::string &name : added.marker_names) marker_names.emplace_back(std::string_view(name));
    target.markers.reserve(target.markers.size() + added.markers.size());
    target.clips.reserve(target.clips.size() + added.clips.size());
    target.channels.reserve(channels + added.channels.size());
    target.times.reserve(times + added.times.size());
    target.values.reserve(values + added.values.size());
    append(target.clips, added.clips);
    append(target.channels, added.channels);
    append(target.times, added.times);
    append(target.values, added.values);
    append(target.markers, added.markers);
    target.clip_names = std::move(names);
    target.marker_names = std::move(marker_names);
}

}  // namespace

Report add_clips(model::Rig &target, const model::Rig &source, const Options &asked, const Before &before)
{
    check(asked);
    Options options = asked;
    Report report;
    const std::optional<model::Rig> standing = standing_rest(target);
    const model::Rig &posed = standing ? *standing : target;
    const std::vector<uint32_t> clips = wanted_clips(source, options);
    std::vector<JointMatch> matches = match_joints(posed, source, options, report.warnings);
    std::vector<std::string> notes;
    RestChoice rest = choose_rest(posed, source, matches, options, clips, notes);
    report.mode = options.mode;
    if (options.mode == Mode::automatic) {
        const bool whole =
            options.start_s == 0 && options.close_s == 0 && options.end_s == std::numeric_limits<double>::infinity();
        report.mode = whole && rest.channels ? Mode::channels : Mode::motion;
    }
    if (report.mode == Mode::motion && options.joints.empty() && drop_armatures(posed, source, matches)) {
        notes.clear();
        rest = choose_rest(posed, source, matches, options, clips, notes);
    }
    append(report.warnings, notes);
    report.joint_count = static_cast<uint32_t>(matches.size());
    report.clip_count = static_cast<uint32_t>(clips.size());
    PoseCheck looked(posed, source, matches);
    NewClips added;
    for (const uint32_t clip : clips) {
        if (report.mode == Mode::channels) copy_channels(target, source, matches, clip, added);
        else transfer(posed, source, matches, rest, options, clip, added, looked);
        copy_markers(source, clip, options, report.mode, added);
        const std::string name = options.prefix + source.clip_names[clip].c_str();
        added.names.push_back(unique_name(target, added, name, report));
    }
    looked.tell(rest.kind, report.warnings);
    report.clips = clips;
    for (const JointMatch &match : matches) report.joints.emplace_back(match.source, match.target);
    if (before) before(report);
    merge(target, std::move(added));
    return report;
}

}  // namespace claque::retarget

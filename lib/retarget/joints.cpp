#include "lib/retarget/joints.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "lib/base/error.h"
#include "lib/base/near_names.h"
#include "lib/retarget/human_bones.h"

namespace claque::retarget
{

using base::fail;
using model::none;

namespace
{

constexpr size_t max_listed = 12;
constexpr char map_helps[] = "; a joint map (--map of the command, clq_clips_def.joints) binds joints of other names";

// For example "3 joints of the map not in the character: Hip ('Hips' is near), b, c". `there`: looks for near names.
void warn(std::vector<std::string> &warnings, const std::vector<std::string> &names, const char *what,
          const model::Rig *there = nullptr)
{
    if (names.empty()) return;
    std::string text = std::to_string(names.size()) + (names.size() == 1 ? " joint " : " joints ") + what + ":";
    for (size_t i = 0; i < names.size() && i < max_listed; ++i) {
        const std::string near = there ? base::near_names(names[i], there->node_names) : "";
        text += (i == 0 ? " " : ", ") + names[i] + (near.empty() ? "" : " (" + near + ")");
    }
    if (names.size() > max_listed) text += " ...";
    warnings.push_back(text);
}

std::vector<JointMatch> by_map(const model::Rig &target, const model::Rig &source, const Options &options,
                               std::vector<std::string> &warnings)
{
    std::vector<JointMatch> out;
    std::vector<std::string> not_in_source, not_in_target;
    std::map<uint32_t, std::string> taken;
    for (const JointPair &pair : options.joints) {
        const JointMatch match = {source.find_node(pair.source), target.find_node(pair.target), pair.rest, none};
        if (match.source == none) not_in_source.push_back(pair.source);
        if (match.target == none) not_in_target.push_back(pair.target);
        if (match.source == none || match.target == none) continue;
        const auto [place, fresh] = taken.emplace(match.target, pair.source);
        if (!fresh)
            fail(CLQ_ARGUMENT, "the map binds joint '%s' to both '%s' and '%s'", pair.target.c_str(),
                 place->second.c_str(), pair.source.c_str());
        out.push_back(match);
    }
    warn(warnings, not_in_source, "of the map not in the clips' skeleton", &source);
    warn(warnings, not_in_target, "of the map not in the character", &target);
    return out;
}

std::vector<JointMatch> by_name(const model::Rig &target, const model::Rig &source, std::vector<std::string> &warnings)
{
    std::map<std::string_view, uint32_t> places;
    for (uint32_t i = 0; i < target.node_count(); ++i)
        if (!target.node_names[i].empty()) places.emplace(std::string_view(target.node_names[i]), i);
    std::vector<JointMatch> out;
    std::vector<std::string> lost;
    std::map<uint32_t, bool> taken;
    for (uint32_t i = 0; i < source.node_count(); ++i) {
        const auto found = places.find(std::string_view(source.node_names[i]));
        if (found != places.end() && taken.emplace(found->second, true).second)
            out.push_back({i, found->second, RestAlignment::keep, none});
        else if (moves(source, i)) lost.emplace_back(source.node_names[i].c_str());
    }
    warn(warnings, lost, "of the clips not in the character");
    if (lost.size() > out.size()) warnings.back() += map_helps;
    return out;
}

// Joints of equal names, or those that are equal parts of a body if these are clearly more.
std::vector<JointMatch> without_map(const model::Rig &target, const model::Rig &source, Options &options,
                                    std::vector<std::string> &warnings)
{
    std::vector<std::string> of_names;
    std::vector<JointMatch> named = by_name(target, source, of_names);
    HumanBinding human = bind_human(target, source, options);
    const bool listed = !options.target_bones.empty() && !options.source_bones.empty();
    if (human.matches.empty() || (!listed && 2 * human.matches.size() <= 3 * named.size())) {
        warnings.insert(warnings.end(), of_names.begin(), of_names.end());
        return named;
    }
    if (options.followers.empty()) options.followers = std::move(human.followers);
    std::string unbound;
    for (const std::string &bone : human.unbound) unbound += (unbound.empty() ? "" : ", ") + bone;
    if (!unbound.empty())
        warnings.push_back(
            base::text_of("without a map %zu joints are bound as parts of a human body, and none as %s%s",
                          human.matches.size(), unbound.c_str(), map_helps));
    return std::move(human.matches);
}

// A node with the same name that has no channel does not count as a binding.
bool binds(const std::vector<JointMatch> &matches, const model::Rig &source)
{
    std::vector<bool> matched(source.node_count(), false);
    for (const JointMatch &match : matches) matched[match.source] = true;
    for (const model::Channel &channel : source.channels)
        if (channel.target != model::ChannelTarget::morph_weights && matched[channel.node]) return true;
    return false;
}

}  // namespace

std::vector<JointMatch> match_joints(const model::Rig &target, const model::Rig &source, Options &options,
                                     std::vector<std::string> &warnings)
{
    std::vector<JointMatch> out = options.joints.empty() ? without_map(target, source, options, warnings)
                                                         : by_map(target, source, options, warnings);
    if (!binds(out, source))
        fail(CLQ_ARGUMENT, "none of the %zu joints of the clips is bound to any of the character's %u joints%s",
             static_cast<size_t>(source.node_count()), target.node_count(),
             options.joints.empty() ? map_helps : " by the map");
    std::sort(out.begin(), out.end(), [](const JointMatch &a, const JointMatch &b) { return a.target < b.target; });
    std::vector<uint32_t> match_of(target.node_count(), none);
    for (uint32_t i = 0; i < out.size(); ++i) match_of[out[i].target] = i;
    for (JointMatch &match : out)
        for (uint32_t up = target.parents[match.target]; up != none && match.above == none; up = target.parents[up])
            match.above = match_of[up];
    return out;
}

bool drop_armatures(const model::Rig &target, const model::Rig &source, std::vector<JointMatch> &matches)
{
    const GlobalPose rest = rest_pose(target);
    bool any = false;
    while (matches.size() > 2 && !moves(source, matches[0].source)) {
        double low = 1e300, high = -1e300;
        for (size_t i = 1; i < matches.size(); ++i) {
            // Ancestors come first: the second joint is the only one below the first.
            if (matches[i].above == none || (i > 1 && matches[i].above == 0)) return any;
            low = std::min(low, rest.positions[matches[i].target].y);
            high = std::max(high, rest.positions[matches[i].target].y);
        }
        if (rest.positions[matches[0].target].y > low + 0.1 * (high - low)) return any;
        matches.erase(matches.begin());
        for (JointMatch &match : matches) match.above = match.above == 0 ? none : match.above - 1;
        any = true;
    }
    return any;
}

bool hangs_alike(const model::Rig &source, const std::vector<JointMatch> &matches, const JointMatch &match)
{
    const uint32_t anchor = match.above == none ? none : matches[match.above].source;
    uint32_t up = source.parents[match.source];
    for (; up != anchor && up != none; up = source.parents[up])
        if (moves(source, up)) return false;
    return up == anchor;
}

bool moves(const model::Rig &rig, uint32_t node)
{
    const math::Trs &rest = rig.rest[node];
    const glm::quat &q = rest.rotation;
    const float turns[4] = {q.x, q.y, q.z, q.w}, turns_other[4] = {-q.x, -q.y, -q.z, -q.w};
    const auto differs = [](const float *value, const float *from, size_t count) {
        for (size_t k = 0; k < count; ++k)
            if (!(std::fabs(value[k] - from[k]) <= 1e-4f * std::fmax(1.0f, std::fabs(from[k])))) return true;
        return false;
    };
    for (const model::Channel &channel : rig.channels) {
        if (channel.target == model::ChannelTarget::morph_weights || channel.node != node) continue;
        const size_t width = channel.component_count;
        const bool cubic = channel.interpolation == model::Interpolation::cubic_spline;
        for (size_t k = 0; k < channel.key_count; ++k) {
            const float *value = rig.values.data() + channel.first_value + width * (cubic ? 3 * k + 1 : k);
            if (channel.target == model::ChannelTarget::rotation) {
                if (differs(value, turns, 4) && differs(value, turns_other, 4)) return true;
            } else if (differs(value,
                               channel.target == model::ChannelTarget::scale ? &rest.scale.x : &rest.translation.x, 3))
                return true;
        }
    }
    return false;
}

GlobalPose rest_pose(const model::Rig &rig)
{
    GlobalPose out;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const uint32_t parent = rig.parents[i];
        const glm::dquat turn = glm::normalize(dquat_of(rig.rest[i].rotation));
        const math::Affine local = math::affine_of(rig.rest[i]);
        out.rotations.push_back(parent == none ? turn : out.rotations[parent] * turn);
        out.globals.push_back(parent == none ? local : math::mul(out.globals[parent], local));
        out.positions.push_back(dvec_of(out.globals.back().column(3)));
    }
    return out;
}

}  // namespace claque::retarget

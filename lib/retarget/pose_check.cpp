#include "lib/retarget/pose_check.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "lib/base/error.h"

namespace claque::retarget
{

using model::none;

PoseCheck::PoseCheck(const model::Rig &target, const model::Rig &source, const std::vector<JointMatch> &matches)
    : target_(target), source_(source), matches_(matches)
{
    if (matches.size() > 1000) return;  // more joints than a person has
    const GlobalPose rest = rest_pose(target);
    const auto high = [&](uint32_t i) { return rest.positions[matches[i].target].y; };
    for (uint32_t i = 1; i < matches.size(); ++i)
        if (high(i) > high(head_)) head_ = i;
    for (uint32_t i = head_; i != none; i = matches[i].above) trunk_.push_back(i);
    const auto carries_head = [&](uint32_t i) { return std::find(trunk_.begin(), trunk_.end(), i) != trunk_.end(); };
    uint32_t lowest = none;
    for (uint32_t i = 0; i < matches.size(); ++i)
        if (!carries_head(i) && (lowest == none || high(i) < high(lowest))) lowest = i;
    // The hips carry the head and the lowest joint.
    for (hips_ = lowest; hips_ != none && !carries_head(hips_);) hips_ = matches[hips_].above;
    const double height = lowest == none ? 0 : high(head_) - high(lowest);
    if (hips_ == none || !(high(head_) - high(hips_) > 0.15 * height && high(hips_) - high(lowest) > 0.2 * height))
        return;
    height_ = height;
    for (uint32_t i = 0; i < matches.size(); ++i)
        if (high(i) <= high(lowest) + 0.08 * height) feet_.push_back(i);
    find_limbs(rest);
}

// Limbs are what hangs on the trunk above the hips, from a length on that no shoulder has.
void PoseCheck::find_limbs(const GlobalPose &rest)
{
    trunk_.erase(std::find(trunk_.begin(), trunk_.end(), hips_) + 1, trunk_.end());
    trunk_.erase(trunk_.begin());  // the head
    std::reverse(trunk_.begin(), trunk_.end());
    std::vector<size_t> place(matches_.size(), trunk_.size());  // in the trunk
    for (size_t k = 0; k < trunk_.size(); ++k) place[trunk_[k]] = k;
    struct Way {
        uint32_t root = none;  // the first joint off the trunk
        size_t from = 0;
        double length = 0;
    };
    std::vector<Way> ways(matches_.size());
    size_t carries = 0;  // joints of the trunk up to the last one with an arm
    for (uint32_t i = 0; i < matches_.size(); ++i) {
        const uint32_t above = matches_[i].above;
        if (above == none || i == head_ || place[i] < trunk_.size()) continue;
        Way &way = ways[i];
        if (place[above] < trunk_.size()) way.root = i, way.from = place[above];
        else way = ways[above];
        way.length += glm::length(rest.positions[matches_[i].target] - rest.positions[matches_[above].target]);
        if (way.root == none || way.from == 0 || way.length < 0.15 * height_) continue;
        limbs_.push_back(i);
        if (std::find(roots_.begin(), roots_.end(), way.root) == roots_.end()) roots_.push_back(way.root);
        carries = std::max(carries, way.from + 1);
    }
    trunk_.resize(carries);
}

// The trunk goes on to the middle of where the arms begin.
double PoseCheck::to_trunk(const std::vector<glm::dvec3> &at, uint32_t match) const
{
    std::vector<glm::dvec3> points;
    for (const uint32_t joint : trunk_) points.push_back(at[joint]);
    glm::dvec3 middle(0);
    for (const uint32_t root : roots_) middle += at[root] / static_cast<double>(roots_.size());
    if (roots_.size() > 1) points.push_back(middle);
    double nearest = 1e300;
    for (size_t k = 0; k + 1 < points.size(); ++k) {
        const glm::dvec3 along = points[k + 1] - points[k], off = at[match] - points[k];
        const double length = glm::dot(along, along);
        const double share = length > 0 ? std::clamp(glm::dot(off, along) / length, 0.0, 1.0) : 0;
        nearest = std::min(nearest, glm::length(off - share * along));
    }
    return nearest;
}

const char *PoseCheck::name(uint32_t match) const { return target_.node_names[matches_[match].target].c_str(); }

void PoseCheck::note(Fault &fault, uint32_t clip, double time_s, const std::string &text)
{
    if (fault.last_clip == clip) return;
    fault.last_clip = clip;
    if (++fault.clip_count == 1)
        fault.text = base::text_of("clip '%s' at %.3g s: ", source_.clip_names[clip].c_str(), time_s) + text;
}

void PoseCheck::look(uint32_t clip, double time_s, const std::vector<glm::dvec3> &own,
                     const std::vector<glm::dvec3> &wanted)
{
    if (!(height_ > 0)) return;
    const auto upright = [&](const std::vector<glm::dvec3> &at) {
        const glm::dvec3 way = at[head_] - at[hips_];
        const double length = glm::length(way);
        return length > 0 ? way.y / length : 1;
    };
    // Proportions differ: directions are compared. Within 45 degrees of upright, and beyond 78.
    if (upright(wanted) > 0.7 && upright(own) < 0.2)
        note(lying_, clip, time_s, base::text_of("'%s' is not above '%s'", name(head_), name(hips_)));
    const auto lower = [](const std::vector<glm::dvec3> &at) {
        return [&at](uint32_t a, uint32_t b) { return at[a].y < at[b].y; };
    };
    const auto over_lowest = [&](const std::vector<glm::dvec3> &at) {
        double low = 1e300;
        for (const glm::dvec3 &place : at) low = std::min(low, place.y);
        return at[*std::min_element(feet_.begin(), feet_.end(), lower(at))].y - low;
    };
    if (over_lowest(wanted) < 0.05 * height_ && over_lowest(own) > 0.1 * height_)
        note(lifted_, clip, time_s,
             base::text_of("'%s' is %.2f above the lowest joint",
                           name(*std::min_element(feet_.begin(), feet_.end(), lower(own))), over_lowest(own)));
    for (const uint32_t limb : limbs_)
        if (to_trunk(wanted, limb) > 0.1 * height_ && to_trunk(own, limb) < 0.06 * height_)
            note(inside_, clip, time_s, base::text_of("'%s' is inside the trunk", name(limb)));
}

void PoseCheck::tell(SourceRest rest, std::vector<std::string> &warnings) const
{
    const auto say = [&](const Fault &fault, const char *help) {
        if (fault.clip_count == 0) return;
        std::string text = fault.text;
        if (fault.clip_count > 1) text += base::text_of(", and so in %u more clips", fault.clip_count - 1);
        warnings.push_back(text + ", unlike in the clips' own skeleton: " + help);
    };
    const char *const other_pose = rest == SourceRest::file
                                       ? "rest = \"bones\" in the map takes its rest from the clip's poses"
                                       : "rest = \"frame:N\" in the map names a frame in which it stands";
    say(lying_, other_pose);
    say(lifted_, other_pose);
    say(inside_,
        rest == SourceRest::file
            ? "`align` in the map lists joints that point as there; rest = \"character\" copies rotations, for "
              "skeletons of one kind"
            : "rest = \"bones\" in the map lets all bones point as there");
}

}  // namespace claque::retarget

// Finds thigh, shin, foot and toes of both legs, torso, neck and head by their names.
#include <string>

#include "lib/base/error.h"
#include "lib/model/limb_names.h"
#include "lib/track/locomotion.h"

namespace claque::track
{

using model::has;
using model::is_below;
using model::none;

namespace
{

// Figures of blocks have legs without knees, which no names of nodes replace.
void expect_knees(const model::Rig &rig, const LocomotionClips &clips)
{
    for (const auto &leg : clips.legs)
        if (leg[0] != none || leg[1] != none || leg[2] != none) return;
    uint32_t whole[2] = {none, none};
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const std::pmr::string plain = model::plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
        const model::Side side = model::side_of(rig.node_names[i], plain);
        if (side == model::Side::unknown || !has(plain, "leg") || model::is_control(plain)) continue;
        uint32_t &leg = whole[side == model::Side::left ? 0 : 1];
        if (leg != none) return;  // more than one node of a leg
        leg = i;
    }
    if (whole[0] == none || whole[1] == none) return;
    const std::string walk =
        clips.walk < rig.clip_names.size() ? " --clip " + std::string(rig.clip_names[clips.walk]) : "";
    base::fail(CLQ_ARGUMENT,
               "each leg is one node ('%s', '%s'), and walkers on tracks bend thigh, shin and foot: no option replaces "
               "joints that a file lacks; 'claque render FILE%s' shows it walking on the spot",
               rig.node_names[whole[0]].c_str(), rig.node_names[whole[1]].c_str(), walk.c_str());
}

}  // namespace

void find_legs(const model::Rig &rig, LocomotionClips &clips)
{
    for (const auto &leg : clips.legs)
        for (const uint32_t node : leg)
            if (node != none) return;
    model::find_limbs(rig, clips.legs);
    expect_knees(rig, clips);
    constexpr const char *sides[] = {"left", "right"}, *parts[] = {"thigh", "shin", "foot"};
    for (int side = 0; side < 2; ++side)
        for (int part = 0; part < 3; ++part)
            if (clips.legs[side][part] == none)
                base::fail(CLQ_ARGUMENT,
                           "no node is named like a %s %s: name the nodes of the legs (legs of a scenario's class, "
                           "--legs of the command, clq_locomotion_def.legs)",
                           sides[side], parts[part]);
}

void find_upper(const model::Rig &rig, LocomotionClips &clips)
{
    if (clips.torso != none || clips.neck != none || clips.head != none) return;
    const auto find = [&](const auto &is) {
        for (uint32_t i = 0; i < rig.node_count(); ++i) {
            const std::pmr::string plain = model::plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
            if (!model::is_control(plain) && is(i, std::string_view(plain))) return i;
        }
        return none;
    };
    const auto carries_leg = [&](uint32_t node) {
        for (const auto &leg : clips.legs)
            for (int part = 0; part < 3; ++part)
                if (is_below(rig, leg[part], node)) return true;
        return false;
    };
    clips.head = find([&](uint32_t i, std::string_view plain) {
        return has(plain, "head") && !has(plain, "top") && !has(plain, "nub") && !carries_leg(i);
    });
    const uint32_t top = clips.head;
    const auto carries_head = [&](uint32_t i) { return top != none && i != top && is_below(rig, top, i); };
    clips.neck = find([&](uint32_t i, std::string_view plain) { return has(plain, "neck") && carries_head(i); });
    clips.torso = find([&](uint32_t i, std::string_view plain) {
        for (const char *part : {"spine", "torso", "abdomen", "waist", "chest"})
            if (has(plain, part) && carries_head(i) && !carries_leg(i)) return true;
        return false;
    });
}

}  // namespace claque::track

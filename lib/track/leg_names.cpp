// Finds thigh, shin, foot and toes of both legs, torso, neck and head by their names.
#include "lib/base/error.h"
#include "lib/model/limb_names.h"
#include "lib/track/locomotion.h"

namespace claque::track
{

using model::has;
using model::is_below;
using model::none;

void find_legs(const model::Rig &rig, LocomotionClips &clips)
{
    for (const auto &leg : clips.legs)
        for (const uint32_t node : leg)
            if (node != none) return;
    model::find_limbs(rig, clips.legs);
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

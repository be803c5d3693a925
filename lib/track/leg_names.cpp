// Finds thigh, shin, foot and toes of both legs, torso, neck and head by the names that are common in files: Mixamo,
// Unreal, Rigify, VRM, KayKit, Quaternius and claque's own.
#include <cctype>

#include "lib/base/error.h"
#include "lib/track/locomotion.h"

namespace claque::track
{

namespace
{

using model::none;

enum class Side { left, right, unknown };

// Lower case without separators, and without what stands before a colon.
std::pmr::string plain_name(std::string_view name, std::pmr::memory_resource *memory)
{
    std::pmr::string out(memory);
    for (const char c : name) {
        if (c == ':') out.clear();
        else if (std::isalnum(static_cast<unsigned char>(c)))
            out.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
    return out;
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

// A side is a word ("LeftFoot", "foot_left") or a letter between separators or at the end ("foot.L", "l_foot").
Side side_of(std::string_view name, std::string_view plain)
{
    if (has(plain, "left")) return Side::left;
    if (has(plain, "right")) return Side::right;
    const auto is_separator = [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); };
    for (size_t i = 0; i < name.size(); ++i) {
        const bool begins = i == 0 || is_separator(name[i - 1]),
                   ends = i + 1 == name.size() || is_separator(name[i + 1]);
        if (!begins || !ends) continue;
        if (name[i] == 'l' || name[i] == 'L') return Side::left;
        if (name[i] == 'r' || name[i] == 'R') return Side::right;
    }
    // Some writers drop the separator: FootL.
    if (name.size() > 1 && std::islower(static_cast<unsigned char>(name[name.size() - 2]))) {
        if (name.back() == 'L') return Side::left;
        if (name.back() == 'R') return Side::right;
    }
    return Side::unknown;
}

bool is_control(std::string_view plain)
{
    for (const char *other : {"twist", "ik", "pole", "roll", "control", "ctrl", "target", "end", "helper"})
        if (has(plain, other)) return true;
    return false;
}

// 0 thigh, 1 shin, 2 foot, 3 toes; none: another part, or a control that is no bone of the leg.
uint32_t part_of(std::string_view plain)
{
    if (is_control(plain)) return none;
    if (has(plain, "thigh") || has(plain, "upleg") || has(plain, "upperleg") || has(plain, "legupper")) return 0;
    if (has(plain, "shin") || has(plain, "calf") || has(plain, "lowerleg") || has(plain, "leglower")) return 1;
    if (has(plain, "toe") || has(plain, "ball")) return 3;
    if (has(plain, "foot") || has(plain, "ankle")) return 2;
    return plain == "leftleg" || plain == "rightleg" || plain == "legl" || plain == "legr" ? 1 : none;  // Mixamo's shin
}

bool is_below(const model::Rig &rig, uint32_t node, uint32_t above)
{
    while (node != none && node != above) node = rig.parents[node];
    return node == above;
}

}  // namespace

void find_legs(const model::Rig &rig, LocomotionClips &clips)
{
    for (const auto &leg : clips.legs)
        for (const uint32_t node : leg)
            if (node != none) return;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const std::pmr::string plain = plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
        const Side side = side_of(rig.node_names[i], plain);
        const uint32_t part = part_of(plain);
        if (side == Side::unknown || part == none) continue;
        uint32_t *leg = clips.legs[side == Side::left ? 0 : 1];
        // The first of a name is the nearest to the root. Feet may hang on the root.
        if (leg[part] != none) continue;
        if ((part == 1 || part == 3) && (leg[part - 1] == none || !is_below(rig, i, leg[part - 1]))) continue;
        leg[part] = i;
    }
    constexpr const char *sides[] = {"left", "right"}, *parts[] = {"thigh", "shin", "foot"};
    for (int side = 0; side < 2; ++side)
        for (int part = 0; part < 3; ++part)
            if (clips.legs[side][part] == none)
                base::fail(CLQ_ARGUMENT,
                           "no node is named like a %s %s: name the legs' nodes in clq_locomotion_def.legs",
                           sides[side], parts[part]);
}

void find_upper(const model::Rig &rig, LocomotionClips &clips)
{
    if (clips.torso != none || clips.neck != none || clips.head != none) return;
    const auto find = [&](const auto &is) {
        for (uint32_t i = 0; i < rig.node_count(); ++i) {
            const std::pmr::string plain = plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
            if (!is_control(plain) && is(i, std::string_view(plain))) return i;
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

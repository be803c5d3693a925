// Finds thigh, shin, foot and toes of both legs, torso, neck and head by their names.
#include <algorithm>
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

constexpr const char *parts[] = {"thigh", "shin", "foot"};

std::string quoted(const model::Rig &rig, uint32_t node) { return "'" + std::string(rig.node_names[node]) + "'"; }

std::string clip_option(const model::Rig &rig, const LocomotionClips &clips)
{
    if (clips.walk >= rig.clip_names.size()) return "";
    const std::string name(rig.clip_names[clips.walk]);
    const bool is_word = std::all_of(name.begin(), name.end(), [](char c) {  // for a shell: Armature|Walk is none
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
    });
    return " --clip " + (is_word ? name : '"' + name + '"');
}

[[noreturn]] void refuse_knees(const model::Rig &rig, const LocomotionClips &clips, const std::string &legs)
{
    base::fail(CLQ_ARGUMENT,
               "each leg is %s, and walkers on tracks bend thigh, shin and foot: no option replaces joints that a file "
               "lacks; 'claque render FILE%s' shows it walking on the spot",
               legs.c_str(), clip_option(rig, clips).c_str());
}

// Whether all nodes below move others, or end a chain.
bool is_last(const model::Rig &rig, uint32_t node)
{
    for (uint32_t i = 0; i < rig.node_count(); ++i)
        if (rig.parents[i] == node &&
            !model::is_control(model::plain_name(rig.node_names[i], rig.parents.get_allocator().resource())))
            return false;
    return true;
}

// Figures of blocks have legs without knees or without ankles, which no names of nodes replace.
void expect_three_nodes(const model::Rig &rig, const LocomotionClips &clips)
{
    std::string pairs;
    for (const auto &leg : clips.legs) {
        const bool kneeless = leg[1] == none && leg[2] != none && leg[0] != none && rig.parents[leg[2]] == leg[0];
        const bool footless = leg[2] == none && leg[1] != none && leg[0] != none && is_last(rig, leg[1]);
        if (!kneeless && !footless) continue;
        pairs += (pairs.empty() ? "" : ", ") + quoted(rig, leg[0]) + " with " + quoted(rig, leg[kneeless ? 2 : 1]);
    }
    if (has(pairs, ", ")) refuse_knees(rig, clips, "two nodes (" + pairs + ")");
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
    refuse_knees(rig, clips, "one node (" + quoted(rig, whole[0]) + ", " + quoted(rig, whole[1]) + ")");
}

// The parts of a leg that have names, as ", though 'thigh_l' is like a thigh".
std::string found_of(const model::Rig &rig, const uint32_t (&leg)[4])
{
    std::string out;
    for (int part = 0; part < 3; ++part)
        if (leg[part] != none)
            out += (out.empty() ? ", though " : " and ") + quoted(rig, leg[part]) + " is like a " + parts[part];
    return out;
}

}  // namespace

void find_legs(const model::Rig &rig, LocomotionClips &clips)
{
    for (const auto &leg : clips.legs)
        for (const uint32_t node : leg)
            if (node != none) return;
    model::find_limbs(rig, clips.legs);
    expect_three_nodes(rig, clips);
    constexpr const char *sides[] = {"left", "right"};
    for (int side = 0; side < 2; ++side)
        for (int part = 0; part < 3; ++part)
            if (clips.legs[side][part] == none)
                base::fail(CLQ_ARGUMENT,
                           "no node is named like a %s %s%s: name the nodes of the legs (legs of a scenario's class, "
                           "--legs of the command, clq_locomotion_def.legs), each with a hip, a knee and an ankle; "
                           "without them 'claque render FILE%s' shows its clips on the spot",
                           sides[side], parts[part], found_of(rig, clips.legs[side]).c_str(),
                           clip_option(rig, clips).c_str());
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
    const auto is_head = [&](uint32_t i, std::string_view plain) {
        return has(plain, "head") && !has(plain, "top") && !has(plain, "nub") && !carries_leg(i);
    };
    // A mesh may have the name too: the first joint of a skin, and of a chain of heads the topmost.
    const std::vector<uint8_t> ranks = model::ranks_of(rig);
    for (uint8_t rank = 0; rank <= 2 && clips.head == none; ++rank)
        clips.head = find([&](uint32_t i, std::string_view plain) { return ranks[i] == rank && is_head(i, plain); });
    clips.head = find([&](uint32_t i, std::string_view plain) {
        return clips.head != none && is_below(rig, clips.head, i) && is_head(i, plain);
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

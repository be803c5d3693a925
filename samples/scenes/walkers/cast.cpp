#include "samples/scenes/walkers/cast.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "lib/base/near_names.h"
#include "samples/io/joined.h"
#include "samples/scenes/posed_template.h"
#include "samples/scenes/template_names.h"

namespace scenes::walkers
{

namespace
{

constexpr double person_m = 1.75;

// "walk" of "Armature|Walk" and of "Walk_001".
std::string own_name(const std::string &name)
{
    const size_t bar = name.find_last_of("|:");
    std::string own = lower_case(bar == std::string::npos ? name : name.substr(bar + 1));
    const size_t letter = own.find_last_not_of("0123456789");
    if (letter != std::string::npos && letter > 0 && (own[letter] == '_' || own[letter] == '.')) own.resize(letter);
    return own;
}

// "man_" of "man_walk", "man_run" and "man_idle": the first word of more than half of the names.
std::string common_prefix(const std::vector<std::string> &names)
{
    std::map<std::string, size_t> counts;
    for (const std::string &name : names) {
        const size_t end = name.find('_');
        if (end != std::string::npos && 2 * ++counts[name.substr(0, end + 1)] > names.size())
            return name.substr(0, end + 1);
    }
    return "";
}

// At rest, in model units; 0 without vertices.
double height_of(Library &library, const clq_template *tmpl)
{
    const PoseBox box = PosedTemplate(library, tmpl).box();
    return box.is_none() ? 0 : box.size(1);
}

// The clip that the description names, or one with a usual name.
uint32_t clip_of(const Member &member, const std::string &named, const std::vector<std::string> &usual)
{
    if (named.empty()) return find_clip(member.tmpl, usual);
    const uint32_t clip = clq_template_find_clip(member.tmpl, named.c_str());
    if (clip == CLQ_NONE)
        throw Failure("the character " + member.described.character + " has no clip named " + named +
                      claque::base::names_near(named, names_of_clips(member.tmpl)));
    return clip;
}

std::vector<uint32_t> idles_of(const Member &member)
{
    std::vector<uint32_t> idles;
    for (const std::string &named : member.described.clips.idles) idles.push_back(clip_of(member, named, {}));
    if (!idles.empty()) return idles;
    for (const char *word :
         {"stand", "stand_look", "stand_shift", "idle", "idle_neutral", "idle_loop", "unarmed_idle", "standing_idle"}) {
        const uint32_t clip = find_clip(member.tmpl, {word});
        if (clip != CLQ_NONE && idles.size() < 4) idles.push_back(clip);
    }
    return idles;
}

uint32_t node_of(const Member &member, const std::string &name)
{
    const uint32_t node = name.empty() ? CLQ_NONE : clq_template_find_node(member.tmpl, name.c_str());
    if (!name.empty() && node == CLQ_NONE)
        throw Failure("the character " + member.described.character + " has no node named " + name +
                      claque::base::names_near(name, names_of_nodes(member.tmpl)));
    return node;
}

// Two legs of thigh, shin and foot, and the node above them. No clip and no option replaces them.
void expect_limbs(const Member &member)
{
    constexpr size_t least_nodes = 7;
    const size_t nodes = names_of_nodes(member.tmpl).size();
    if (nodes < least_nodes)
        throw Failure(
            "the character " + member.described.character + " has a skeleton of " + std::to_string(nodes) +
            (nodes == 1 ? " node" : " nodes") +
            ", and walkers have a hip, a knee and an ankle on each side: another character walks, or this one "
            "with a skeleton from a modelling program; 'claque render FILE' shows it as it is");
}

void name_limbs(const Member &member, clq_locomotion_def &def)
{
    const WalkingNodes &limbs = member.described.limbs;
    def.torso = node_of(member, limbs.torso);
    def.neck = node_of(member, limbs.neck), def.head = node_of(member, limbs.head);
    const size_t each = limbs.legs.size() / 2;
    if (limbs.legs.empty()) return;
    if (limbs.legs.size() != 6 && limbs.legs.size() != 8)
        throw Failure(
            "the legs of " + member.described.character + " are " + std::to_string(limbs.legs.size()) +
            " names; 6 or 8 are wanted: thigh, shin and foot of the left leg, then of the right, or toes too");
    for (size_t side = 0; side < 2; ++side) {
        const auto node = [&](size_t part) { return node_of(member, limbs.legs[side * each + part]); };
        def.legs[side] = {node(0), node(1), node(2), each == 4 ? node(3) : CLQ_NONE};
    }
}

}  // namespace

namespace
{

uint32_t find_name(std::vector<std::string> names, const std::vector<std::string> &words)
{
    for (std::string &name : names) name = own_name(name);
    const std::string prefix = common_prefix(names);
    for (const std::string &before : {std::string(), prefix})
        for (const std::string &word : words) {
            const auto found = std::find(names.begin(), names.end(), before + word);
            if (found != names.end()) return static_cast<uint32_t>(found - names.begin());
        }
    return CLQ_NONE;
}

const std::vector<std::string> walk_names = {"walk", "walking", "walking_a", "walk_loop"};

// A person whose file has no walk takes those of the built-in citizen, if its joints can be bound to them.
void borrow_gaits(Library &library, const SocialClass &one, clq_asset *asset)
{
    clq_asset_info info = clq_asset_info_init();
    check(clq_asset_get_info(asset, &info));
    std::vector<std::string> names;
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        check(clq_asset_get_clip(asset, i, &clip));
        names.emplace_back(clip.name);
    }
    if (!one.clips.walk.empty() || find_name(names, walk_names) != CLQ_NONE) return;
    clq_asset *source = nullptr;
    check(clq_asset_builtin(library.context(), "citizen", &source));
    const Own<clq_asset> held(source);
    const char *const gaits[] = {"walk", "walk_slow", "jog", "turn", "stand", "stand_look"};
    clq_clips_def def = clq_clips_def_init();
    def.clips = gaits, def.clip_count = static_cast<uint32_t>(std::size(gaits));
    clq_clips_report report = clq_clips_report_init();
    if (clq_asset_add_clips(library.context(), asset, source, &def, &report) != CLQ_OK || report.joint_count < 10)
        return;
    clq_context_log(
        library.context(), CLQ_LOG_WARNING,
        (one.character + " has no clip named walk (it has: " + (names.empty() ? "none" : io::joined(names)) +
         "): its people walk and stand by clips of the built-in citizen; --walk NAME where people walk on "
         "tracks, or walk in the clips of a scenario's class, names one of its own, and --clips FILE of play "
         "and prepare adds others")
            .c_str());
}

}  // namespace

uint32_t find_clip(const clq_template *tmpl, const std::vector<std::string> &words)
{
    return find_name(names_of_clips(tmpl), words);
}

SocialClass class_of(const std::string &character)
{
    SocialClass one;
    one.name = one.character = character;
    return one;
}

void take_template(Library &library, Member &member, Lod lod, Heads heads)
{
    const std::string &character = member.described.character;
    if (!is_file(character)) {
        if (heads == Heads::turn && is_person(character)) member.tmpl = library.looking(character, lod == Lod::on);
        else member.tmpl = lod == Lod::on ? library.builtin(character, {}) : library.builtin(character);
        return;
    }
    member.own = template_of_file(library, member.described);
    member.tmpl = member.own.get();
}

Own<clq_template> template_of_file(Library &library, const SocialClass &one)
{
    if (is_prepared(one.character)) {
        if (one.placement.any() || one.add_clips)
            throw Failure(one.character +
                          " is prepared already, with claque prepare, which takes --turn, --height, --scale, --blend, "
                          "--hide and --clips");
        return library.load_prepared(one.character, one.placement.wild_colours);
    }
    clq_asset_options options = clq_asset_options_init();
    std::vector<const char *> hidden;
    one.placement.give(options, hidden);
    clq_asset *asset = nullptr;
    check(clq_asset_load_file(library.context(), one.character.c_str(), &options, &asset));
    const Own<clq_asset> held(asset);
    if (one.add_clips) one.add_clips(library, asset);
    borrow_gaits(library, one, asset);
    clq_template *made = nullptr;
    check(clq_asset_build(library.context(), asset, 0, &made), one.character);
    return Own<clq_template>(made);
}

GaitClips gait_clips(const Member &member)
{
    const SocialClass::Clips &clips = member.described.clips;
    GaitClips out;
    out.walk = clip_of(member, clips.walk, walk_names);
    out.run = clip_of(member, clips.run, {"jog", "run", "running", "running_a", "run_loop"});
    out.slow_walk = clip_of(member, clips.slow_walk, {"walk_slow", "walking_slow", "walk_formal"});
    out.turn = clip_of(member, clips.turn, {"turn"});
    out.idles = idles_of(member);
    const std::vector<std::string> names = names_of_clips(member.tmpl);
    if (out.walk == CLQ_NONE && names.size() == 1) out.walk = 0;  // that it walks is measured
    if (out.walk != CLQ_NONE) return out;
    expect_limbs(member);
    throw Failure("the character " + member.described.character +
                  " has no clip named walk; it has: " + (names.empty() ? "none" : io::joined(names)) +
                  "; --walk NAME where people walk on tracks, or walk in the clips of a scenario's class, chooses one, "
                  "and --clips FILE of play and prepare adds one");
}

OwnLocomotion locomotion_of(Library &library, const Member &member)
{
    const GaitClips clips = gait_clips(member);
    if (member.own && clips.idles.empty())
        clq_context_log(
            library.context(), CLQ_LOG_WARNING,
            (member.described.character +
             " has no clip named idle or stand, so it stands in its rest pose: --idle NAME where people walk "
             "on tracks, or idles in the clips of a scenario's class, names one, and --clips FILE of play and prepare "
             "adds one")
                .c_str());
    clq_locomotion_def def = clq_locomotion_def_init();
    def.tmpl = member.tmpl;
    def.walk = clips.walk, def.run = clips.run, def.slow_walk = clips.slow_walk, def.turn = clips.turn;
    def.idles = clips.idles.data(), def.idle_count = static_cast<uint32_t>(clips.idles.size());
    name_limbs(member, def);
    clq_locomotion *made = nullptr;
    check(clq_locomotion_create(library.context(), &def, &made), "the character " + member.described.character);
    return OwnLocomotion(made);
}

namespace
{

// A walk that does not stay above its origin, as one cut from the middle of a way.
void warn_of_way_aside(Library &library, const Member &member)
{
    const uint32_t walk = gait_clips(member).walk;
    const PoseBox box = PosedTemplate(library, member.tmpl).box_of_clip(walk, 4);
    if (box.is_none()) return;
    const double aside = std::hypot(box.low[0] + box.high[0], box.low[2] + box.high[2]) / 2;
    if (aside < 0.3 * box.size(1)) return;
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", aside * member.scale);
    clq_context_log(library.context(), CLQ_LOG_WARNING,
                    (member.described.character + ": its clip " + names_of_clips(member.tmpl)[walk] + " walks " + text +
                     " m beside the origin, and so far beside their paths and shadows its people walk: --clips citizen "
                     "of play and prepare gives a walk that stays on them")
                        .c_str());
}

}  // namespace

Member cast(Library &library, const SocialClass &described, Lod lod, Heads heads)
{
    Member member;
    member.described = described;
    asked_at(described.at, [&] {
        const bool has_size = described.placement.has_size();
        if (!has_size && is_file(described.character) && !is_prepared(described.character))
            member.described.placement.scale = 1;  // the file's own: no warning asks for the size that it gets below
        take_template(library, member, lod, heads);
        const double height = member.own && !has_size ? height_of(library, member.tmpl) : 0;
        if (height > 0) member.scale = person_m / height;
        member.locomotion = locomotion_of(library, member);
        if (member.own) warn_of_way_aside(library, member);
    });
    return member;
}

}  // namespace scenes::walkers

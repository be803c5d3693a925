#include "samples/scenes/walkers/gaits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "lib/base/near_names.h"
#include "samples/io/joined.h"
#include "samples/scenes/posed_template.h"
#include "samples/scenes/template_names.h"
#include "samples/scenes/walkers/cast.h"

namespace scenes::walkers
{

namespace
{

constexpr uint32_t least_joints = 10;  // of a person whose clips are those of another
constexpr double most_offset = 0.3;    // of a walk from its origin, in heights
const char *const lender = "citizen";
const std::vector<std::string> walk_names = {"walk", "walking", "walking_a", "walk_loop"};

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

std::vector<std::string> clips_of(const clq_asset *asset)
{
    clq_asset_info info = clq_asset_info_init();
    check(clq_asset_get_info(asset, &info));
    std::vector<std::string> names;
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        check(clq_asset_get_clip(asset, i, &clip));
        names.emplace_back(clip.name);
    }
    return names;
}

// The number of joints that are bound; 0: none can be.
uint32_t add_gaits(clq_context *context, clq_asset *asset)
{
    clq_asset *source = nullptr;
    check(clq_asset_builtin(context, lender, &source));
    const Own<clq_asset> held(source);
    const char *const gaits[] = {"walk", "walk_slow", "jog", "turn", "stand", "stand_look"};
    clq_clips_def def = clq_clips_def_init();
    def.clips = gaits, def.clip_count = static_cast<uint32_t>(std::size(gaits));
    clq_clips_report report = clq_clips_report_init();
    return clq_asset_add_clips(context, asset, source, &def, &report) == CLQ_OK ? report.joint_count : 0;
}

// Tries it on a copy whose warnings nobody asked for.
bool can_borrow(const std::string &file, const clq_asset_options &options)
{
    clq_context *context = nullptr;
    check(clq_context_create(nullptr, &context));
    const Own<clq_context> quiet(context);
    clq_asset *asset = nullptr;
    check(clq_asset_load_file(context, file.c_str(), &options, &asset));
    const Own<clq_asset> held(asset);
    return add_gaits(context, asset) >= least_joints;
}

}  // namespace

uint32_t find_clip(const clq_template *tmpl, const std::vector<std::string> &words)
{
    return find_name(names_of_clips(tmpl), words);
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

void borrow_gaits(Library &library, const SocialClass &one, const clq_asset_options &options, clq_asset *asset)
{
    const std::vector<std::string> names = clips_of(asset);
    if (!one.clips.walk.empty() || find_name(names, walk_names) != CLQ_NONE) return;
    if (!can_borrow(one.character, options) || add_gaits(library.context(), asset) < least_joints) return;
    const std::string sentence =
        one.character + " has no clip named walk (it has: " + (names.empty() ? "none" : io::joined(names)) +
        ") and takes the gaits of the built-in citizen: --walk NAME, or walk in the clips of a scenario's class, takes "
        "one of its own";
    clq_context_log(library.context(), CLQ_LOG_WARNING, sentence.c_str());
}

void warn_of_offset_walk(Library &library, const Member &member)
{
    const uint32_t walk = gait_clips(member).walk;
    const PoseBox box = PosedTemplate(library, member.tmpl).box_of_clip(walk, 4);
    const double offset = std::hypot(box.low[0] + box.high[0], box.low[2] + box.high[2]) / 2;
    if (box.is_none() || offset < most_offset * box.size(1)) return;
    const std::string own = names_of_clips(member.tmpl)[walk];
    char text[200];
    std::snprintf(
        text, sizeof text,
        " walks %.2g m beside its origin, so people walk beside their paths and shadows: --clips %s --walk %s "
        "of play takes a walk above its origin",
        offset * member.scale, lender, own == "walk" ? "walk.2" : "walk");  // a taken name gets a number
    clq_context_log(library.context(), CLQ_LOG_WARNING,
                    (member.described.character + ": its clip '" + own + "'" + text).c_str());
}

}  // namespace scenes::walkers

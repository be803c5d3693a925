// [[characters]]: the classes of a scenario's people.
#include <algorithm>

#include "samples/scenes/odeon/programme.h"
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

constexpr Limits unit_interval = {0, 1}, most_people = {0, 100000}, odds_limits = {0, 1000};
constexpr size_t most_classes = 64, most_idles = 4;
const char *const who_can_sit[] = {"citizen", "patrician", "decurion", "plebeian"};

clq_hsb_range range_of(TomlTable dye)
{
    const auto hue = dye.pair("hue", {0, 360}), saturation = dye.pair("saturation", unit_interval),
               brightness = dye.pair("brightness", unit_interval);
    if (saturation[0] > saturation[1]) dye.refuse("has its saturation in the wrong order", "saturation");
    if (brightness[0] > brightness[1]) dye.refuse("has its brightness in the wrong order", "brightness");
    dye.done();
    return {static_cast<float>(hue[0]),        static_cast<float>(hue[1]),        static_cast<float>(saturation[0]),
            static_cast<float>(saturation[1]), static_cast<float>(brightness[0]), static_cast<float>(brightness[1])};
}

Temperament manners_of(const std::string &character)
{
    return character == "decurion"    ? Temperament::grave
           : character == "patrician" ? Temperament::gracious
                                      : Temperament::hearty;
}

void read_programme(TomlTable programme, Temperament &out)
{
    for (size_t i = 0; i < seated_count; ++i) {
        const char *clip = clip_name(static_cast<Act>(i));
        if (programme.has(clip)) out.odds[i] = programme.number(clip, odds_limits);
    }
    if (programme.has("cheer")) out.cheer = programme.number("cheer", odds_limits);
    if (programme.has("laugh")) out.laugh = programme.number("laugh", odds_limits);
    if (programme.has("rise")) out.rise = programme.number("rise", odds_limits);
    programme.done();
    if (!(out.odds[0] > 0)) programme.refuse("has sit = 0, and it is the clip that everyone can play", "sit");
}

void read_sitters(TomlTable &described, SocialClass &made)
{
    described.expect_no("share", "which goes with [tracks]; in a theatre 'count' says how many people are of a class");
    described.expect_no("clips", "which go with [tracks]; in a theatre 'programme' weighs the clips");
    made.count = described.whole("count", most_people);
    made.temperament = manners_of(made.character);
    if (described.has("programme"))
        read_programme(described.table("programme", "the programme of class '" + made.name + "'"), made.temperament);
    if (std::find(std::begin(who_can_sit), std::end(who_can_sit), made.character) == std::end(who_can_sit))
        described.refuse(
            "has the character '" + made.character +
                "', which is not built in or cannot sit; there are: citizen, patrician, decurion, plebeian",
            "character");
}

void read_clips(TomlTable clips, SocialClass::Clips &out)
{
    for (const auto &[key, name] :
         {std::pair("walk", &out.walk), {"slow_walk", &out.slow_walk}, {"run", &out.run}, {"turn", &out.turn}})
        if (clips.has(key)) *name = clips.text(key);
    if (clips.has("idles")) out.idles = clips.texts("idles");
    clips.done();
    if (out.idles.size() > most_idles)
        clips.refuse(
            "has " + std::to_string(out.idles.size()) + " idles; at most " + std::to_string(most_idles) + " are played",
            "idles");
}

// How its file is placed, what becomes of its blending, and which nodes walk.
void read_placement(TomlTable &described, SocialClass &made)
{
    const auto has = [&](const char *key) {
        if (described.has(key) && !is_file(made.character))
            described.refuse("has " + std::string(key) + ", which is for files; " + made.character + " is built in",
                             key);
        return described.has(key);
    };
    if (has("turn_deg")) made.placement.turn_deg = described.number("turn_deg", {-1e9, 1e9});
    if (has("height_m")) made.placement.height_m = described.number("height_m", {0.001, 1000});
    if (has("scale")) made.placement.scale = described.number("scale", {1e-6, 1e6});
    if (made.placement.height_m != 0 && made.placement.scale != 0)
        described.refuse("has a height_m and a scale; each gives the size", "scale");
    if (has("blend")) {
        const std::string name = described.text("blend");
        if (name != "mask" && name != "opaque")
            described.refuse("has the blend '" + name + "': mask or opaque", "blend");
        made.placement.blend = name == "opaque" ? CLQ_BLEND_OPAQUE : CLQ_BLEND_MASK;
    }
    if (has("legs")) made.limbs.legs = described.texts("legs");
    for (const auto &[key, name] :
         {std::pair("torso", &made.limbs.torso), {"neck", &made.limbs.neck}, {"head", &made.limbs.head}})
        if (has(key)) *name = described.text(key);
}

// With [stage] a class is what it looks like: how many there are of it, and what they do, is said by [[agents]].
void read_agents_class(TomlTable &described, const ScenarioFiles &files, SocialClass &made)
{
    for (const char *key : {"count", "share", "programme"})
        described.expect_no(key,
                            "which goes with [theatre] or [tracks] alone; with [stage], [[agents]] says how many "
                            "people there are and what they do");
    read_clips_and_file(described, files, made);
}

void read_walkers(TomlTable &described, const ScenarioFiles &files, SocialClass &made)
{
    described.expect_no("count",
                        "which goes with [theatre]; on tracks the file says how many people there are, and "
                        "'share' how many of them are of this class");
    described.expect_no("programme", "which goes with [theatre]; on tracks people walk and stand");
    if (described.has("share")) made.share = described.number("share", {0, 1e6});
    read_clips_and_file(described, files, made);
}

}  // namespace

void read_palette(TomlTable &described, SocialClass &made)
{
    if (!described.has("palette")) return;
    for (auto &[zone, dye] : described.table("palette", "class '" + made.name + "'")
                                 .named_tables("palette entry of class '" + made.name + "' for"))
        made.palette.push_back({zone, range_of(dye)});
}

void read_clips_and_file(TomlTable &described, const ScenarioFiles &files, SocialClass &made)
{
    if (described.has("clips"))
        read_clips(described.table("clips", "the clips of class '" + made.name + "'"), made.clips);
    read_placement(described, made);
    if (is_file(made.character)) made.character = file_of(described, "character", files);
}

void read_characters(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    const bool decide = all.has("stage") || all.has("people"), sit = !decide && all.has("theatre");
    double shares = 0;
    for (TomlTable &described : all.tables("characters", "[[characters]]")) {
        SocialClass made;
        made.at = described.place();
        made.name = described.text("name");
        described.renamed("figure", "character");
        made.character = described.text("character");
        read_palette(described, made);
        if (decide) read_agents_class(described, files, made);
        else if (sit) read_sitters(described, made);
        else read_walkers(described, files, made);
        described.done();
        for (const SocialClass &other : scenario.characters)
            if (other.name == made.name) described.refuse("is a second class '" + made.name + "'", "name");
        shares += made.share;
        scenario.characters.push_back(std::move(made));
        if (scenario.characters.size() > most_classes)
            described.refuse("is one too many: a scenario has at most " + std::to_string(most_classes) + " classes");
    }
    if (!sit && !scenario.characters.empty() && !(shares > 0))
        all.refuse("has characters whose shares are all 0", "characters");
}

}  // namespace scenes

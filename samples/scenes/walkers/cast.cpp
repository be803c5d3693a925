#include "samples/scenes/walkers/cast.h"

#include "lib/base/near_names.h"
#include "samples/scenes/posed_template.h"
#include "samples/scenes/template_names.h"

namespace scenes::walkers
{

namespace
{

constexpr double person_m = 1.75;

// At rest, in model units; 0 without vertices.
double height_of(Library &library, const clq_template *tmpl)
{
    const PoseBox box = PosedTemplate(library, tmpl).box();
    return box.is_none() ? 0 : box.size(1);
}

uint32_t node_of(const Member &member, const std::string &name)
{
    const uint32_t node = name.empty() ? CLQ_NONE : clq_template_find_node(member.tmpl, name.c_str());
    if (!name.empty() && node == CLQ_NONE)
        throw Failure("the character " + member.described.character + " has no node named " + name +
                      claque::base::names_near(name, names_of_nodes(member.tmpl)));
    return node;
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
        return library.load_prepared(one.character, one.placement.colours);
    }
    clq_asset_options options = clq_asset_options_init();
    std::vector<const char *> hidden;
    one.placement.give(options, hidden);
    clq_asset *asset = nullptr;
    check(clq_asset_load_file(library.context(), one.character.c_str(), &options, &asset));
    const Own<clq_asset> held(asset);
    clq_asset_info info = clq_asset_info_init();
    check(clq_asset_get_info(asset, &info));
    if (info.vertex_count == 0 && info.clip_count > 0)
        throw Failure(one.character + " has clips and nothing to draw: --clips " + one.character +
                      " adds them to a character");
    if (one.add_clips) one.add_clips(library, asset);
    borrow_gaits(library, one, options, asset);
    clq_template *made = nullptr;
    check(clq_asset_build(library.context(), asset, 0, &made), one.character);
    return Own<clq_template>(made);
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
        if (member.own) warn_of_offset_walk(library, member);
    });
    return member;
}

}  // namespace scenes::walkers

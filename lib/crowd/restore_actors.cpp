// One actor of a saved crowd, in the order of save_actors.cpp.
#include <cmath>

#include "lib/crowd/edits.h"
#include "lib/crowd/restore.h"
#include "lib/crowd/rows.h"

namespace claque::crowd
{

using base::fail;
using model::none;

namespace
{

void read_group(Reader &in, Crowd &out, uint32_t row)
{
    uint32_t group = none;
    in.value(group);
    if (group == none) return;
    if (group >= out.group_count() || !out.tables.groups.all.in_use(group))
        fail(CLQ_FORMAT, "a saved crowd's actor %u is in group %u, which there is not", row, group);
    enter_group(out, row, group);
}

void read_columns(Reader &in, Crowd &out, Id id)
{
    Transform transform;
    Play playing;
    float priority = 0, speed = 0, up = 0, down = 0;
    walk_transform(in, transform), walk_play(in, playing);
    in.value(priority), in.value(speed), in.value(up), in.value(down);
    set_transforms(out, &id, &transform, 1);
    play(out, id, playing);
    set_priority(out, id, priority);
    set_speeds(out, &id, &speed, 1);
    if (up != 0 || down != 0) follow_ground(out, id, up, down);
}

void read_colours(Reader &in, Tables &out, uint32_t row)
{
    bool own = false;
    in.flag(own);
    if (!own) return;
    const uint32_t bytes = out.colours[out.actors.all[row].tmpl].stride();
    if (bytes == 0) fail(CLQ_FORMAT, "a saved crowd's actor %u has colours of no zone", row);
    uint8_t *rgb = make_colours(out, row);
    for (uint32_t i = 0; i < bytes; ++i) in.value(rgb[i]);
}

const track::Track &known_track(const Crowd &crowd, uint32_t row, uint64_t hash)
{
    const track::Track *track = crowd.follows().find(hash, crowd.template_of(row));
    if (!track)
        throw Missing(
            CLQ_ARGUMENT,
            base::text_of("actor %u of the saved crowd follows a track of hash %016llx and template '%s', which "
                          "this crowd does not know: add it with clq_crowd_add_track",
                          row + 1, base::big(hash), crowd.template_of(row).name.c_str()));
    return *track;
}

void read_follow(Reader &in, Crowd &out, uint32_t row)
{
    bool follows = false;
    in.flag(follows);
    if (!follows) return;
    Follow read;
    uint64_t hash = 0, earlier[max_earlier_pieces] = {};
    walk_follow(in, read), in.value(hash);
    for (uint64_t &before : earlier) in.value(before);
    follow_track(out, out.id_of(row), known_track(out, row, hash), read.start_s);
    if (!std::isfinite(read.offset_s)) fail(CLQ_FORMAT, "a saved crowd's actor %u has a clock that is not finite", row);
    Follow &follow = *out.tables.follows.of(row);
    follow.walks = read.walks, follow.offset_s = read.offset_s;
    const track::Track *piece = follow.track;
    for (uint32_t i = 0; i < max_earlier_pieces && piece; ++i) {
        if (earlier[i] != 0 && earlier[i] != piece->previous_hash)
            fail(CLQ_FORMAT, "a saved crowd's actor %u follows pieces of different tracks", row);
        piece = follow.earlier[i] = earlier[i] != 0 ? &known_track(out, row, earlier[i]) : nullptr;
    }
}

void read_actor(Reader &in, Crowd &out, uint32_t row)
{
    ActorRow &actor = out.tables.actors.all[row];
    const Id id = out.id_of(row);
    uint32_t texture_set = 0;
    in.value(actor.tmpl), in.value(actor.seed), in.value(texture_set);
    template_at(out.tables, actor.tmpl);
    if (texture_set == random_texture_set) fail(CLQ_FORMAT, "a saved crowd's actor %u has no texture set", row);
    set_texture_set(out, id, texture_set);
    read_group(in, out, row);
    read_columns(in, out, id);
    read_colours(in, out.tables, row);
    read_uses(in, out, row);
    read_follow(in, out, row);
    read_layer_state(in, out, row);
}

}  // namespace

void read_actors(Reader &in, Crowd &out)
{
    const auto append = [&](uint32_t generation) { append_row(out.tables, generation); };
    read_rows(in, "actor", out.tables.actors.all, append, [&](uint32_t row) { read_actor(in, out, row); });
}

}  // namespace claque::crowd

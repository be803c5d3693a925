// One actor of a saved crowd; restore_actors.cpp reads in the same order.
#include <algorithm>

#include "lib/crowd/save_rows.h"

namespace claque::crowd
{

using model::none;

namespace
{

void write_colours(Writer &out, const Crowd &crowd, uint32_t row)
{
    const uint8_t *rgb = crowd.zone_rgb(row);
    out.flag(rgb != nullptr);
    if (!rgb) return;
    const uint32_t bytes = 3 * crowd.template_of(row).zone_count();
    for (uint32_t i = 0; i < bytes; ++i) out.value(rgb[i]);
}

void write_behaviour(Writer &out, const Behaviours &from, uint32_t row)
{
    out.flag(from.has_root_path_play(row));
    if (from.has_root_path_play(row)) walk_root_path_play(out, from.root_path_play(row));
    uint8_t uses = 0;
    for (uint32_t i = from.first_attachment(row); i != none; i = from.attachment_at(i).next) ++uses;
    out.value(uses);
    for (uint32_t i = from.first_attachment(row); i != none; i = from.attachment_at(i).next) {
        walk_mechanism_attachment(out, from.attachment_at(i));
        const CommandHistory *history = from.command_history_of(from.attachment_at(i));
        out.flag(history != nullptr);
        if (history) walk_command(out, *history), walk_command(out, history->before);
    }
}

void write_layering(Writer &out, const LayerState *from)
{
    out.flag(from != nullptr);
    if (!from) return;
    walk_source(out, from->now);
    out.value(static_cast<uint8_t>(from->fade_count)), out.value(static_cast<uint8_t>(from->layer_count));
    for (uint32_t k = 0; k < from->fade_count; ++k) walk_fade(out, from->fades[k]);
    for (uint32_t k = 0; k < from->layer_count; ++k) walk_layer(out, from->layers[k]);
}

}  // namespace

void write_actor(Writer &out, const Crowd &crowd, uint32_t row)
{
    const Actor &actor = crowd.actor(row);
    out.value(actor.tmpl), out.value(actor.seed), out.value(actor.texture_set);
    out.value(crowd.group_of(row));
    walk_transform(out, crowd.transform_of(row));
    walk_play(out, crowd.play_of(row));
    out.value(crowd.extent_of(row).priority), out.value(crowd.extent_of(row).speed);
    const Extra *extra = crowd.extra_of(row);
    out.value(extra ? extra->max_up : 0.0f), out.value(extra ? extra->max_down : 0.0f);
    write_colours(out, crowd, row);
    write_behaviour(out, crowd.behaviours(), row);
    const Follow *follow = crowd.follows().of(row);
    out.flag(follow != nullptr);
    if (follow) {
        walk_follow(out, *follow);
        out.value(follow->track->hash);
        for (const track::Track *earlier : follow->earlier) out.value(earlier ? earlier->hash : uint64_t(0));
    }
    const base::Span<const uint32_t> watched = crowd.watched();
    out.flag(std::binary_search(watched.begin(), watched.end(), row));
    write_layering(out, crowd.layers().of(row));
}

}  // namespace claque::crowd

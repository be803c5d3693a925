#include "lib/stage/flow/shown.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "lib/stage/error.h"
#include "lib/stage/host_call.h"

namespace claque::stage
{

Shown::~Shown() { clear(); }

void Shown::clear()
{
    for (Row &row : rows)
        for (clq_track *track : row.tracks) clq_track_destroy(track);
    rows.clear();
    masks.clear();
}

// Makes room, before anything is done.
void Shown::make_row(uint32_t agent)
{
    if (rows.size() <= agent) rows.resize(agent + 1);
}

void Shown::apply(Handover &from, clq_crowd *crowd, double time_s, clq_stage_applied &out)
{
    while (Command *command = from.front(time_s)) {
        const clq_status status = give(*command, crowd, out);
        if (status == CLQ_OUT_OF_MEMORY || status == CLQ_BUSY) throw Error(status, clq_last_error());
        if (status != CLQ_OK) {
            ++out.refused;
            clq_context_log(context_, CLQ_LOG_WARNING, clq_last_error());
        }
        ++out.commands;
        out.late += command->at_s <= shown_s;
        clq_track_destroy(std::exchange(command->track, nullptr));
        from.pop();
    }
    shown_s = std::max(shown_s, time_s);
}

clq_status Shown::give(Command &command, clq_crowd *crowd, clq_stage_applied &out)
{
    if (command.kind == CommandKind::call) {
        call(command, crowd);
        return CLQ_OK;
    }
    if (command.actor.index1 == 0) return CLQ_OK;
    switch (command.kind) {
        case CommandKind::play:
        case CommandKind::fade:
            return fade(command, crowd, out);
        case CommandKind::gesture:
            make_row(command.agent);
            return gesture(command, crowd);
        case CommandKind::end_gesture:
            make_row(command.agent);
            return end_gesture(command, crowd);
        case CommandKind::walk_on:
            return clq_actor_fade_to_track(crowd, command.actor, command.at_s, command.fade_s);
        case CommandKind::look:
            return clq_actor_gaze(crowd, command.actor, command.gaze, command.point, command.at_s);
        case CommandKind::look_away:
            return clq_actor_gaze(crowd, command.actor, command.gaze, nullptr, command.at_s);
        default:
            make_row(command.agent);
            return follow(command, crowd);
    }
}

clq_status Shown::fade(const Command &command, clq_crowd *crowd, clq_stage_applied &out)
{
    clq_fade_def def = clq_fade_def_init();
    def.play.clip = command.clip;
    def.play.start_s = command.at_s;
    def.play.speed = command.speed;
    def.play.phase_s = command.phase_s;
    if (command.kind == CommandKind::play) return clq_actor_play(crowd, command.actor, &def.play);
    def.at_s = command.at_s;
    def.length_s = command.fade_s;
    def.curve = static_cast<clq_curve>(command.curve);
    clq_status status = clq_actor_fade_to(crowd, command.actor, &def);
    if (status == CLQ_UNSUPPORTED) {  // an inertial fade from a gait
        def.curve = CLQ_CURVE_SMOOTH;
        status = clq_actor_fade_to(crowd, command.actor, &def);
    }
    if (status != CLQ_LIMIT) return status;
    ++out.cut;
    return clq_actor_play(crowd, command.actor, &def.play);
}

clq_status Shown::find_mask(const Command &command, clq_crowd *crowd, clq_mask &out)
{
    for (const MaskOf &one : masks)
        if (one.machine == command.machine && one.cast == command.cast && one.mask == command.mask) {
            out = one.made;
            return CLQ_OK;
        }
    const Mask &mask = command.machine->masks[command.mask];
    std::vector<const char *> nodes;
    for (const std::string &node : mask.nodes) nodes.push_back(node.c_str());
    clq_mask_def def = clq_mask_def_init();
    def.tmpl = command.machine->casts[command.cast].tmpl;
    def.node_count = static_cast<uint32_t>(nodes.size());
    def.nodes = nodes.data();
    def.feather = mask.feather;
    def.inverted = mask.inverted;
    masks.reserve(masks.size() + 1);
    const clq_status status = clq_crowd_add_mask(crowd, &def, &out);
    if (status == CLQ_OK) masks.push_back({command.machine, command.cast, command.mask, out});
    return status;
}

clq_status Shown::gesture(const Command &command, clq_crowd *crowd)
{
    clq_layer_def def = clq_layer_def_init();
    def.kind = command.adds ? CLQ_LAYER_ADD : CLQ_LAYER_REPLACE;
    def.play.clip = command.clip;
    def.play.start_s = command.at_s;
    def.play.speed = command.speed;
    def.weight = command.weight;
    def.loops = command.loops;
    def.fade_in_s = command.fade_s;
    def.fade_out_s = command.fade_out_s;
    if (command.mask != none) {
        const clq_status status = find_mask(command, crowd, def.mask);
        if (status != CLQ_OK) return status;
    }
    clq_layer made{};
    const clq_status status = clq_actor_add_layer(crowd, command.actor, &def, &made);
    if (status != CLQ_OK) return status;
    Row &row = rows[command.agent];
    if (row.gestures[max_gestures - 1].index1) std::copy(row.gestures + 1, row.gestures + max_gestures, row.gestures);
    else
        for (clq_layer &free : row.gestures)
            if (free.index1 == 0) {
                free = made;
                return CLQ_OK;
            }
    row.gestures[max_gestures - 1] = made;
    return CLQ_OK;
}

// A layer that has ended by itself, or that the actor no longer has, needs no end.
clq_status Shown::end_gesture(const Command &command, clq_crowd *crowd)
{
    Row &row = rows[command.agent];
    for (uint32_t i = max_gestures; i-- > 0;) {
        if (row.gestures[i].index1 == 0) continue;
        const clq_status status =
            clq_actor_end_layer(crowd, command.actor, row.gestures[i], command.at_s, command.fade_s);
        if (status == CLQ_OUT_OF_MEMORY || status == CLQ_BUSY) return status;
        row.gestures[i] = {};
        return status == CLQ_STALE_ID ? CLQ_OK : status;
    }
    return CLQ_OK;
}

clq_status Shown::follow(Command &command, clq_crowd *crowd)
{
    const clq_status status = command.track
                                  ? clq_actor_follow_track(crowd, command.actor, command.track, command.start_s)
                                  : clq_actor_leave_track(crowd, command.actor, command.at_s);
    if (status != CLQ_OK) return status;
    // The command's hold becomes the row's; the caller ends the one that is left in the command.
    clq_track *(&tracks)[CLQ_TRACK_PIECES] = rows[command.agent].tracks;
    std::rotate(tracks, tracks + 1, tracks + CLQ_TRACK_PIECES);
    std::swap(tracks[CLQ_TRACK_PIECES - 1], command.track);
    return CLQ_OK;
}

void Shown::call(const Command &command, clq_crowd *crowd)
{
    const clq_action_call made = {{command.agent + 1}, command.actor, command.at_s, command.value, crowd};
    call_host(context_, command.action->name.c_str(),
              [&] { command.action->def.show(command.action->def.user, &made); });
}

}  // namespace claque::stage

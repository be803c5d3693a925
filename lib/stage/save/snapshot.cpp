#include <algorithm>

#include "lib/stage/hash.h"
#include "lib/stage/save/fields.h"

namespace claque::stage
{

namespace
{

int take_bytes(void *user, const void *bytes, size_t size)
{
    auto &out = *static_cast<std::vector<uint8_t> *>(user);
    try {
        out.insert(out.end(), static_cast<const uint8_t *>(bytes), static_cast<const uint8_t *>(bytes) + size);
    } catch (...) {
        return 1;
    }
    return 0;
}

void save_track(clq_track *track, std::vector<uint8_t> &out)
{
    if (!track) return;
    const clq_status status = clq_track_save(track, take_bytes, &out);
    if (status == CLQ_IO) throw std::bad_alloc();
    if (status != CLQ_OK) throw Error(status, clq_last_error());
}

template <class Pointers, class Pointer>
uint32_t number_in(const Pointers &all, const Pointer *wanted)
{
    for (size_t i = 0; i < all.size(); ++i)
        if (all[i].get() == wanted) return static_cast<uint32_t>(i);
    return none;
}

uint64_t sum_text(uint64_t h, const std::string &value)
{
    for (const char c : value) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return sum(h, uint64_t(value.size()));
}

}  // namespace

uint64_t hash_of_parts(const Director &director)
{
    const clq_stage_def &def = director.def;
    uint64_t h = sum(sum(start_of_sum, uint64_t(def.mode)), def.seed);
    h = sum(sum(sum(h, def.start_s), def.tick_s), uint64_t(def.budget));
    h = sum(sum(h, double(def.budget_us)), double(def.metres_per_unit));
    for (const float share : def.shares) h = sum(h, double(share));
    for (const auto &machine : director.machines) h = sum(h, machine->hash);
    for (const std::string &action : director.shared.actions) h = sum_text(h, action);
    for (const Event &event : director.shared.events) h = sum(sum_text(h, event.name), uint64_t(event.priority));
    for (const Variable &variable : director.shared.crowd) h = sum_text(h, variable.name);
    return sum(h, uint64_t(director.movement != nullptr));
}

SavedStage snapshot(const Director &director, const Shown &shown)
{
    SavedStage out;
    out.made_of = hash_of_parts(director);
    out.classes = director.shared.classes;
    out.crowd = director.crowd;
    out.agents = director.agents;
    out.timetable = director.timetable;
    out.messages = director.inbox.copy();
    director.scheduler.save(out, director);
    out.tick = director.tick, out.crowd_changed = director.crowd_changed;
    out.transitions = director.transitions, out.events = director.events, out.command_count = director.command_count;
    out.late_messages = director.late_messages, out.runaways = director.runaways, out.hash = director.hash;
    for (const Command &command : director.handover.left()) {
        SavedCommand saved;
        saved.command = command;
        saved.machine = number_in(director.machines, command.machine);
        saved.action = number_in(director.actions, command.action);
        save_track(command.track, saved.track);
        out.commands.push_back(std::move(saved));
    }
    for (const Shown::Row &row : shown.rows) {
        SavedRow saved;
        for (uint32_t i = 0; i < Shown::max_gestures; ++i) saved.gestures[i] = row.gestures[i].index1;
        for (uint32_t i = 0; i < CLQ_TRACK_PIECES; ++i) save_track(row.tracks[i], saved.tracks[i]);
        out.rows.push_back(std::move(saved));
    }
    for (const Shown::MaskOf &mask : shown.masks)
        out.masks.push_back({number_in(director.machines, mask.machine), mask.cast, mask.mask, mask.made.index1});
    out.shown_s = shown.shown_s;
    if (director.movement) director.movement->save(out.movement);
    return out;
}

}  // namespace claque::stage

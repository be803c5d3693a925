#include <utility>

#include "lib/stage/save/fields.h"

namespace claque::stage
{

namespace
{

// Holds of tracks until they have found their place.
class Tracks
{
public:
    ~Tracks()
    {
        for (clq_track *track : all) clq_track_destroy(track);
    }
    clq_track *load(const clq_locomotion *locomotion, const std::vector<uint8_t> &bytes)
    {
        if (bytes.empty()) return nullptr;
        all.reserve(all.size() + 1);
        clq_track *track = nullptr;
        const clq_status status = clq_track_load(locomotion, bytes.data(), bytes.size(), &track);
        if (status != CLQ_OK) throw Error(status, clq_last_error());
        all.push_back(track);
        return track;
    }
    std::vector<clq_track *> all;
};

}  // namespace

void put_back(SavedStage &&saved, Director &director, Shown &shown, clq_crowd *crowd)
{
    const auto locomotion_of = [&](uint32_t agent) {
        const Agent &of = saved.agents[agent];
        return director.machines[of.machine]->casts[of.cast].locomotion;
    };
    Tracks tracks;
    std::vector<Command> commands;
    for (SavedCommand &one : saved.commands) {
        one.command.machine = one.machine == none ? nullptr : director.machines[one.machine].get();
        one.command.action = one.action == none ? nullptr : director.actions[one.action].get();
        one.command.track = tracks.load(locomotion_of(one.command.agent), one.track);
        commands.push_back(one.command);
    }
    std::vector<Shown::Row> rows(saved.rows.size());
    for (size_t i = 0; i < rows.size(); ++i) {
        for (uint32_t k = 0; k < Shown::max_gestures; ++k) rows[i].gestures[k] = {saved.rows[i].gestures[k]};
        for (uint32_t k = 0; k < CLQ_TRACK_PIECES; ++k)
            rows[i].tracks[k] = tracks.load(locomotion_of(static_cast<uint32_t>(i)), saved.rows[i].tracks[k]);
    }
    std::vector<Shown::MaskOf> masks;
    for (const SavedMask &one : saved.masks)
        masks.push_back({director.machines[one.machine].get(), one.cast, one.mask, {one.made}});
    if (!tracks.all.empty() && !crowd) fail(CLQ_ARGUMENT, "crowd is NULL, and %zu tracks are saved", tracks.all.size());
    for (clq_track *track : tracks.all) {
        const clq_status status = clq_crowd_add_track(crowd, track);
        if (status != CLQ_OK) throw Error(status, clq_last_error());
    }
    Neighbours neighbours(static_cast<double>(director.def.metres_per_unit));
    for (uint32_t i = 0; i < saved.agents.size(); ++i)
        if (!saved.agents[i].is_removed) neighbours.place(i, saved.agents[i].agent_class, saved.agents[i].position);
    Scheduler scheduler = director.scheduler.empty_copy();
    scheduler.restore(saved);
    director.restore(std::move(saved), std::move(scheduler), std::move(neighbours), commands);
    // Nothing below throws.
    shown.clear();
    shown.rows.swap(rows);
    shown.masks.swap(masks);
    shown.shown_s = saved.shown_s;
    tracks.all.clear();
}

}  // namespace claque::stage

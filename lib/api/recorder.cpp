#include "lib/api/recorder.h"

#include <algorithm>
#include <cstdio>

#include "lib/api/boundary.h"
#include "lib/record/crowd_def.h"
#include "lib/record/locomotion_fields.h"
#include "lib/track/track_file.h"

namespace claque::api
{

using base::fail;
using record::Kind;

Recorder::Recorder(const clq_crowd &crowd, const clq_recording_def &def)
    : crowd_(crowd),
      def_(def),
      blocks_(&crowd.context->memory),
      templates_(&crowd.context->memory),
      locomotions_(&crowd.context->memory),
      tracks_(&crowd.context->memory),
      info_(clq_recording_info_init()),
      index_(&crowd.context->memory),
      descriptions_(&crowd.context->memory)
{
}

void Recorder::begin()
{
    uint8_t header[record::file_header_bytes] = {};
    std::copy(std::begin(record::magic), std::end(record::magic), header);
    header[8] = record::version;
    describe(Kind::crowd_def, [&](crowd::Writer &out) { record::walk_crowd_def(out, crowd_.def); });
    state(Kind::state);
    give(header, sizeof header);
    flush();
}

void Recorder::step(double time_s) noexcept
{
    guarded([&] {
        if (written() - state_end_ >= std::max(def_.key_bytes, state_bytes_))
            state(Kind::key_state), ++info_.key_states;
        blocks_.entry(Kind::step, [&](crowd::Writer &out) { out.value(time_s); });
        index_.end_s = info_.steps ? std::max(index_.end_s, time_s) : time_s;
        index_.states.back().earliest_s = std::min(index_.states.back().earliest_s, time_s);
        ++info_.steps;
        flush();
    });
}

void Recorder::end() noexcept
{
    guarded([&] {
        if (blocks_.contents_size() > 0) flush();
        try {
            index();
        } catch (const std::exception &) {  // no memory, or more than a block can be: a record does without it
            blocks_.clear();
            blocks_.entry(Kind::end, [](crowd::Writer &) {});
        }
        flush();
    });
}

void Recorder::index()
{
    for (size_t i = index_.states.size(); i-- > 1;)
        index_.states[i - 1].earliest_s = std::min(index_.states[i - 1].earliest_s, index_.states[i].earliest_s);
    index_.step_count = info_.steps, index_.call_count = blocks_.calls();
    blocks_.entry(Kind::index, [&](crowd::Writer &out) {
        record::walk_index(out, index_);
        out.flush();
        blocks_.take(descriptions_.data(), descriptions_.size());
    });
    blocks_.entry(Kind::end, [&](crowd::Writer &out) {
        out.value(block_at()), out.value(static_cast<uint32_t>(blocks_.number()));
    });
}

clq_recording_info Recorder::info() const
{
    clq_recording_info out = info_;
    out.tracks = tracks_.size();
    out.held_bytes = blocks_.held_bytes() + descriptions_.capacity() + index_.bytes();
    return out;
}

void Recorder::stop(clq_status status, const char *text) noexcept
{
    info_.status = status;
    std::snprintf(info_.text, sizeof info_.text, "%s", text);
    char warning[300];
    std::snprintf(warning, sizeof warning, "the recording of a crowd has ended: %s", info_.text);
    crowd_.context->log.warn(warning);
}

void Recorder::flush()
{
    const model::Array<uint8_t> &block = blocks_.sealed();
    give(block.data(), block.size());
    blocks_.clear();
}

void Recorder::flush_if_full()
{
    constexpr size_t piece_bytes = 65536;
    if (blocks_.contents_size() >= piece_bytes) flush();
}

void Recorder::give(const uint8_t *bytes, size_t size)
{
    if (!host_takes(def_.write, def_.user, bytes, size))
        fail(CLQ_IO, "the writer refused %zu bytes of a record, after %llu that it took", size, base::big(info_.bytes));
    info_.bytes += size;
}

uint32_t Recorder::number_of(const model::Template &tmpl)
{
    const auto found = std::find(templates_.begin(), templates_.end(), &tmpl);
    const uint32_t number = static_cast<uint32_t>(found - templates_.begin());
    if (found != templates_.end()) return number;
    describe(Kind::tmpl, [&](crowd::Writer &out) {
        out.value(crowd::structure_hash(tmpl));
        for (const char c : tmpl.name) out.value(c);
    });
    templates_.push_back(&tmpl);
    return number;
}

uint32_t Recorder::number_of(const track::Locomotion &locomotion)
{
    const Key key(locomotion.hash, locomotion.tmpl);
    if (const auto found = locomotions_.find(key); found != locomotions_.end()) return found->second;
    const uint32_t number = static_cast<uint32_t>(locomotions_.size());
    if (number >= record::max_locomotions)
        fail(CLQ_LIMIT, "a record has at most %u locomotions", record::max_locomotions);
    const uint32_t tmpl = number_of(*locomotion.tmpl);
    describe(Kind::locomotion, [&](crowd::Writer &out) {
        out.value(tmpl);
        record::walk_clips(out, locomotion.clips);
    });
    locomotions_.emplace(key, number);
    return number;
}

uint32_t Recorder::number_of(const track::Track &track)
{
    const Key key(track.hash, track.locomotion->tmpl);
    if (const auto found = tracks_.find(key); found != tracks_.end()) return found->second;
    const uint32_t locomotion = number_of(*track.locomotion), number = static_cast<uint32_t>(tracks_.size());
    model::Array<uint8_t> bytes(&crowd_.context->memory);
    track::save(track, bytes);
    index_.tracks.push_back(entry_at());
    blocks_.entry(Kind::track, [&](crowd::Writer &out) {
        out.value(locomotion);
        out.flush();
        blocks_.take(bytes.data(), bytes.size());
    });
    tracks_.emplace(key, number);
    return number;
}

void Recorder::create(const clq_actor_def &def, clq_actor made)
{
    call(record::ActorCreate{number_of(*def.tmpl), def.transform, def.play, def.seed, def.texture_set, made});
}

void Recorder::follow(clq_actor actor, const clq_track &track, double start_s)
{
    call(record::ActorFollowTrack{actor, number_of(static_cast<const track::Track &>(track)), start_s});
}

void Recorder::transforms(const clq_actor *actors, const clq_transform *places, uint32_t count)
{
    blocks_.transforms(actors, places, count);
    ++info_.calls;
}

void Recorder::speeds(const clq_actor *actors, const float *speeds, uint32_t count)
{
    blocks_.entry(Kind::crowd_set_speeds, [&](crowd::Writer &out) {
        for (uint32_t i = 0; i < count; ++i) record::walk_id(out, actors[i]), out.value(speeds[i]);
    });
    ++info_.calls;
}

void Recorder::colours(const clq_actor *actors, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = crowd_.crowd.row_of(id_of(actors[i]));
        const uint8_t *rgb = crowd_.crowd.zone_rgb(row);
        if (!rgb) continue;  // a template without zones
        blocks_.entry(Kind::actor_colours, [&](crowd::Writer &out) {
            record::walk_id(out, actors[i]);
            for (uint32_t k = 0; k < 3 * crowd_.crowd.template_of(row).zone_count(); ++k) out.value(rgb[k]);
        });
        ++info_.calls;
    }
}

void Recorder::state(Kind kind)
{
    const crowd::Crowd &crowd = crowd_.crowd;
    for (const model::Template *tmpl : crowd.templates()) number_of(*tmpl);
    model::Array<uint32_t> tracks(&crowd_.context->memory);
    for (uint32_t row = 0; row < crowd.row_count(); ++row) {
        const crowd::Follow *follow = crowd.alive(row) ? crowd.follows().of(row) : nullptr;
        if (!follow) continue;
        tracks.push_back(number_of(*follow->track));
        for (const track::Track *earlier : follow->earlier)
            if (earlier) tracks.push_back(number_of(*earlier));
    }
    note_state(tracks);
    const size_t before = blocks_.contents_size();
    blocks_.entry(kind, [&](crowd::Writer &out) {
        out.count(crowd.templates().count);
        for (const model::Template *tmpl : crowd.templates()) out.value(number_of(*tmpl));
        out.flush();
        crowd::save(crowd, blocks_);
    });
    state_bytes_ = blocks_.contents_size() - before;
    state_end_ = written();
}

// Its entry is the next one.
void Recorder::note_state(model::Array<uint32_t> &tracks)
{
    record::IndexedState made;
    made.at = entry_at(), made.block_at = block_at(), made.block = static_cast<uint32_t>(blocks_.number());
    made.steps_before = info_.steps, made.first_run = static_cast<uint32_t>(index_.runs.size());
    std::sort(tracks.begin(), tracks.end());
    tracks.erase(std::unique(tracks.begin(), tracks.end()), tracks.end());
    for (const uint32_t number : tracks) {
        const bool goes_on =
            index_.runs.size() > made.first_run && index_.runs.back().first + index_.runs.back().count == number;
        if (!goes_on) index_.runs.push_back({number, 0});
        ++index_.runs.back().count;
    }
    made.runs = static_cast<uint32_t>(index_.runs.size()) - made.first_run;
    index_.states.push_back(made);
}

void end_recording(clq_crowd *crowd) noexcept
{
    if (!crowd->recorder) return;
    crowd->recorder->end();
    unmake(crowd->context, crowd->recorder);
    crowd->recorder = nullptr;
}

}  // namespace claque::api

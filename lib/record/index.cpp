// How the index of a record is read, which may be anything.
#include <algorithm>
#include <cmath>

#include "lib/crowd/save.h"
#include "lib/record/contents.h"

namespace claque::record
{

namespace
{

constexpr uint64_t end_entry_bytes = entry_header_bytes + end_bytes;

uint64_t number_at(const uint8_t *bytes, size_t size)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < size; ++i) bits |= uint64_t(bytes[i]) << (8 * i);
    return bits;
}

}  // namespace

void require_index(bool good, const char *otherwise)
{
    if (!good) base::fail(CLQ_FORMAT, "the index of a record %s", otherwise);
}

void Contents::open(const uint8_t *bytes, size_t size)
{
    check_file(bytes, size);
    if (!has_index(size)) return read(bytes, size);
    read_index(size);
}

bool Contents::has_index(size_t size) const
{
    if (size < file_header_bytes + block_header_bytes + end_entry_bytes) return false;
    const uint8_t *last = bytes_ + size - end_entry_bytes;
    return number_at(bytes_ + 8, 4) > first_version && number_at(last, 4) == 1 + end_bytes &&
           static_cast<Kind>(last[4]) == Kind::end;
}

void Contents::read_index(size_t size)
{
    const uint8_t *last = bytes_ + size - end_bytes;
    const uint64_t at = number_at(last, 8), number = number_at(last + 8, 4);
    require_index(at >= file_header_bytes && at <= size - block_header_bytes - end_entry_bytes, "is beyond its end");
    const uint64_t contents = read_header(at, number);
    require_index(contents == size - at - block_header_bytes, "is not its last block");
    check_contents(at, contents, number);
    const uint64_t begin = at + block_header_bytes;
    const Entry entry = checked_entry(begin, size);
    require_index(entry.kind == Kind::index && begin + entry_header_bytes + entry.size + end_entry_bytes == size,
                  "is not before its end");
    crowd::Reader in("the index of a record", entry.fields, entry.size);
    walk_index(in, index_);
    check_index(at, number);
    const uint64_t fields_end = begin + entry_header_bytes + entry.size;
    for (uint64_t place = fields_end - in.left(); place < fields_end;) {
        const Entry described = checked_entry(place, fields_end);
        require_index(
            described.kind == Kind::crowd_def || described.kind == Kind::tmpl || described.kind == Kind::locomotion,
            "describes what needs no description");
        read_entry(described, {});
        place += entry_header_bytes + described.size;
    }
    require_index(crowd_def.fields != nullptr, "lacks the definition of the crowd");
    for (const IndexedState &state : index_.states) states.push_back({state.at, state.block});
    index_at_ = at;
    ends_.resize(number + 1);
    ends_.back() = size;
    steps_.resize(index_.step_count);
    parts_.resize(states.size());
    call_count = index_.call_count, is_whole = true;
    if (index_.step_count > 0) start_s = index_.states.front().earliest_s, end_s = index_.end_s;
    read_bytes_ = file_header_bytes + block_header_bytes + contents;
}

// `at` and `blocks`: the place of the index, and the number of blocks before it.
void Contents::check_index(uint64_t at, uint64_t blocks) const
{
    require_index(blocks <= at / block_header_bytes && index_.step_count <= at / (entry_header_bytes + sizeof(double)),
                  "has more blocks or steps than bytes");
    require_index(!index_.states.empty() && index_.states[0].block == 0 &&
                      index_.states[0].block_at == file_header_bytes && index_.states[0].steps_before == 0,
                  "has no first state");
    require_index(
        std::isfinite(index_.end_s) && (index_.step_count == 0 || index_.end_s >= index_.states[0].earliest_s),
        "has no last time");
    uint64_t last_at = file_header_bytes;
    for (const uint64_t place : index_.tracks) {
        require_index(place > last_at && place < at, "has a track that is not in it");
        last_at = place;
    }
    uint64_t run_count = 0;
    const IndexedState *before = nullptr;
    for (const IndexedState &state : index_.states) {
        require_index(state.block < blocks && state.at > state.block_at && state.at < at &&
                          state.steps_before <= index_.step_count,
                      "has a state that is not in it");
        require_index(
            state.earliest_s > -HUGE_VAL && std::isfinite(state.earliest_s) == (state.steps_before < index_.step_count),
            "has a state without a time");
        require_index(state.first_run == run_count && state.runs <= index_.runs.size() - run_count,
                      "has a state with other tracks");
        uint64_t next_track = 0;
        for (; run_count < uint64_t(state.first_run) + state.runs; ++run_count) {
            const TrackRun &run = index_.runs[run_count];
            require_index(run.first >= next_track, "has a state with other tracks");
            next_track = uint64_t(run.first) + run.count;
            require_index(next_track <= index_.tracks.size(), "has a state with other tracks");
        }
        require_index(!before || (before->at < state.at && before->block <= state.block &&
                                  (before->block == state.block) == (before->block_at == state.block_at) &&
                                  before->block_at <= state.block_at && before->steps_before <= state.steps_before &&
                                  before->earliest_s <= state.earliest_s),
                      "has states out of order");
        before = &state;
    }
}

}  // namespace claque::record

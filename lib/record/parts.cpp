// Contents that are read in parts, from a state to the next, by the index of the record.
#include <algorithm>

#include "lib/crowd/save.h"
#include "lib/record/contents.h"

namespace claque::record
{

namespace
{

using base::big;
using base::fail;

}  // namespace

const IndexedState &Contents::indexed_at(const Cursor &state) const
{
    const auto found = std::lower_bound(states.begin(), states.end(), state);
    require_index(found != states.end() && found->at == state.at, "lacks a state");
    return index_.states[static_cast<size_t>(found - states.begin())];
}

void Contents::find_earliest(Step *steps, size_t count, double after_s)
{
    for (size_t i = count; i-- > 0;) after_s = steps[i].earliest_s = std::min(steps[i].time_s, after_s);
}

void Contents::require_part(size_t state) const
{
    const std::lock_guard lock(reading_);
    if (parts_[state]) return;
    read_part(state);
    parts_[state] = 1;
}

// The blocks from that of the state up to that of the next state.
void Contents::read_part(size_t number) const
{
    const IndexedState &state = index_.states[number];
    const bool is_last = number + 1 == states.size();
    const uint64_t blocks_end = is_last ? index_at_ : index_.states[number + 1].block_at;
    const uint64_t first_after = is_last ? ends_.size() - 1 : index_.states[number + 1].block;
    const uint64_t steps_after = is_last ? steps_.size() : index_.states[number + 1].steps_before;
    const double earliest_after = is_last ? HUGE_VAL : index_.states[number + 1].earliest_s;
    uint64_t at = state.block_at, step = state.steps_before;
    uint32_t block = state.block;
    // Other states before it may be in the same block. If the next one is, that is read with the next part.
    size_t expected = number;
    while (expected > 0 && index_.states[expected - 1].block == state.block) --expected;
    if (at == blocks_end) expected = number + 1;
    for (; at < blocks_end; ++block) {
        require_index(block < first_after && blocks_end - at >= block_header_bytes, "has other blocks");
        const uint64_t contents = read_header(at, block);
        require_index(contents <= blocks_end - at - block_header_bytes, "has other blocks");
        check_contents(at, contents, block);
        read_bytes_ += block_header_bytes + contents;
        const uint64_t end = at + block_header_bytes + contents;
        for (at += block_header_bytes; at < end;) {
            const Entry entry = checked_entry(at, end);
            if (entry.kind == Kind::state || entry.kind == Kind::key_state) {
                check_state(entry);
                if (expected <= number && at == index_.states[expected].at) ++expected;
            } else if (entry.kind == Kind::step) {
                require_index(step < steps_after, "has other steps");
                steps_[step] = {step_time(entry, step), 0, {at, block}};
                ++step;
            } else if (!is_call(entry.kind) && (entry.kind < Kind::crowd_def || entry.kind > Kind::track)) {
                fail(CLQ_FORMAT, "a record has an entry of kind %u before its end", unsigned(entry.kind));
            }
            at += entry_header_bytes + entry.size;
        }
        ends_[block] = end;
    }
    require_index(expected == number + 1 && block == first_after && step == steps_after,
                  "has other states, blocks or steps");
    find_earliest(steps_.data() + state.steps_before, step - state.steps_before, earliest_after);
    const double earliest = step > state.steps_before ? steps_[state.steps_before].earliest_s : earliest_after;
    require_index(earliest == state.earliest_s, "has other times");
}

// The last one of those that begin with this step has it.
size_t Contents::part_of_step(uint64_t number) const
{
    const auto later = std::upper_bound(index_.states.begin(), index_.states.end(), number,
                                        [](uint64_t step, const IndexedState &s) { return step < s.steps_before; });
    return static_cast<size_t>(later - index_.states.begin()) - 1;
}

const Step &Contents::step(uint64_t number) const
{
    if (is_in_parts()) require_part(part_of_step(number));
    return steps_[number];
}

uint64_t Contents::step_at(double time_s) const
{
    auto begin = steps_.begin(), end = steps_.end();
    if (is_in_parts()) {
        // Steps of a part without steps are those of the next one that has some.
        const auto later = std::upper_bound(index_.states.begin(), index_.states.end(), time_s,
                                            [](double time, const IndexedState &s) { return time < s.earliest_s; });
        if (later == index_.states.begin()) return 0;
        const uint64_t first = std::prev(later)->steps_before;
        const size_t part = part_of_step(std::min<uint64_t>(first, steps_.size() - 1));
        require_part(part);
        begin += static_cast<std::ptrdiff_t>(index_.states[part].steps_before);
        if (part + 1 < index_.states.size())
            end = steps_.begin() + static_cast<std::ptrdiff_t>(index_.states[part + 1].steps_before);
    }
    const auto later =
        std::upper_bound(begin, end, time_s, [](double time, const Step &step) { return time < step.earliest_s; });
    return later == steps_.begin() ? 0 : static_cast<uint64_t>(later - steps_.begin()) - 1;
}

void Contents::require_entries(const Cursor &from, const Cursor &to) const
{
    if (!is_in_parts()) return;
    const auto part_at = [&](const Cursor &cursor) {
        const auto later =
            std::upper_bound(index_.states.begin(), index_.states.end(), cursor.block,
                             [](uint32_t block, const IndexedState &state) { return block < state.block; });
        return later == index_.states.begin() ? 0 : static_cast<size_t>(later - index_.states.begin()) - 1;
    };
    for (size_t part = part_at(from); part <= part_at(to); ++part) require_part(part);
}

RecordedTrack Contents::track(uint32_t number) const
{
    if (!is_in_parts()) return tracks_[number];
    // Its own checksum is looked at when it is loaded.
    const uint64_t next = number + 1 < index_.tracks.size() ? index_.tracks[number + 1] : index_at_;
    const Entry entry = checked_entry(index_.tracks[number], next);
    require_index(entry.kind == Kind::track, "names a track where there is none");
    const std::lock_guard lock(reading_);
    read_bytes_ += entry_header_bytes + entry.size;
    return track_of(entry, number);
}

uint64_t Contents::bytes() const
{
    return templates.capacity() * sizeof(RecordedTemplate) + locomotions.capacity() * sizeof(RecordedLocomotion) +
           tracks_.capacity() * sizeof(RecordedTrack) + steps_.capacity() * sizeof(Step) +
           states.capacity() * sizeof(Cursor) + ends_.capacity() * sizeof(uint64_t) + index_.bytes() +
           parts_.capacity();
}

uint64_t Contents::read_bytes() const
{
    const std::lock_guard lock(reading_);
    return read_bytes_;
}

}  // namespace claque::record

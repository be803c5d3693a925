// What a record contains: where each of its steps and states is. The bytes may be anything and stay where they are.
#pragma once

#include <mutex>
#include <string_view>

#include "lib/model/template.h"
#include "lib/record/index.h"
#include "lib/track/locomotion.h"

namespace claque::record
{

struct Entry {
    Kind kind;
    const uint8_t *fields;
    uint32_t size;
};

// The place of an entry.
struct Cursor {
    uint64_t at = 0;
    uint32_t block = 0;
};
inline bool operator<(const Cursor &a, const Cursor &b) { return a.at < b.at; }

struct Step {
    double time_s = 0;
    double earliest_s = 0;  // the earliest time of this step and all after it
    Cursor cursor;
};

struct RecordedTemplate {
    std::string_view name;
    uint64_t structure = 0;
};
struct RecordedLocomotion {
    uint32_t tmpl = 0;
    track::LocomotionClips clips;
};
struct RecordedTrack {
    uint32_t locomotion = 0;
    const uint8_t *bytes = nullptr;
    uint32_t size = 0;
};

class Contents
{
public:
    explicit Contents(std::pmr::memory_resource *memory)
        : templates(memory),
          locomotions(memory),
          states(memory),
          tracks_(memory),
          steps_(memory),
          ends_(memory),
          index_(memory),
          parts_(memory)
    {
    }
    // One of these, once. read() reads all; open() reads the index, if there is one, and the rest in parts: from a
    // state to the next. Throw base::Error (CLQ_FORMAT) with what is wrong and where, or std::bad_alloc. Allocations
    // are proportional to the size.
    void read(const uint8_t *bytes, size_t size);
    void open(const uint8_t *bytes, size_t size);
    bool is_in_parts() const { return !parts_.empty(); }

    // Those that are const may be called by several threads. After open() they read the parts that they need, with
    // CLQ_FORMAT where one was changed.

    Cursor begin() const { return at_entry({file_header_bytes + block_header_bytes, 0}); }
    Cursor end() const;
    Entry entry(const Cursor &cursor) const;  // not at the end
    Cursor after(const Cursor &cursor) const;

    uint64_t step_count() const { return steps_.size(); }
    const Step &step(uint64_t number) const;
    // The last step at or before a time, in the order of the record; the first one if there is none. Needs a step.
    uint64_t step_at(double time_s) const;
    // Entries from one place up to another, which is that of a step or the end, can be looked at from now on.
    void require_entries(const Cursor &from, const Cursor &to) const;
    uint64_t track_count() const { return is_in_parts() ? index_.tracks.size() : tracks_.size(); }
    RecordedTrack track(uint32_t number) const;
    // After open(): calls use(number) for each track that the state at this place follows.
    template <class Use>
    void each_track_of(const Cursor &state, const Use &use) const
    {
        const IndexedState &indexed = indexed_at(state);
        for (uint32_t i = 0; i < indexed.runs; ++i) {
            const TrackRun &run = index_.runs[indexed.first_run + i];
            for (uint32_t k = 0; k < run.count; ++k) use(run.first + k);
        }
    }
    // The last state at or before a place.
    const Cursor &state_before(const Cursor &cursor) const;
    uint64_t bytes() const;       // held
    uint64_t read_bytes() const;  // of the record, so far

    Array<RecordedTemplate> templates;
    Array<RecordedLocomotion> locomotions;
    Array<Cursor> states;  // of both kinds
    uint64_t call_count = 0;
    double start_s = 0, end_s = 0;  // the earliest and the latest time of a step; 0 without steps
    bool is_whole = false;          // it has its end
    Entry crowd_def = {Kind::crowd_def, nullptr, 0};

private:
    Cursor at_entry(Cursor cursor) const;
    const IndexedState &indexed_at(const Cursor &state) const;
    void check_file(const uint8_t *bytes, size_t size);
    bool has_index(size_t size) const;
    void read_index(size_t size);
    void check_index(uint64_t at, uint64_t blocks) const;
    uint64_t read_header(uint64_t at, uint64_t number) const;  // returns the size of the contents
    void check_contents(uint64_t at, uint64_t size, uint64_t number) const;
    void require_part(size_t state) const;
    void read_part(size_t state) const;
    size_t part_of_step(uint64_t number) const;
    Entry checked_entry(uint64_t at, uint64_t end) const;
    double step_time(const Entry &entry, uint64_t number) const;
    void check_state(const Entry &entry) const;
    RecordedTrack track_of(const Entry &entry, uint64_t number) const;
    static void find_earliest(Step *steps, size_t count, double after_s);
    void read_block(uint64_t end);
    void read_entry(const Entry &entry, const Cursor &cursor);
    void read_description(const Entry &entry);

    const uint8_t *bytes_ = nullptr;
    Array<RecordedTrack> tracks_;  // after read()
    // After open(), what belongs to a part is filled in when the part is read, and not changed afterwards.
    mutable Array<Step> steps_;
    mutable Array<uint64_t> ends_;  // of the blocks
    Index index_;
    uint64_t index_at_ = 0;         // its block
    mutable Array<uint8_t> parts_;  // by state, after open(): 1: it was read
    mutable std::mutex reading_;
    mutable uint64_t read_bytes_ = 0;
};

// The numbers of a state's templates, in the order of the crowd's own; then the saved crowd.
struct StateFields {
    StateFields(const Entry &entry, std::pmr::memory_resource *memory);
    Array<uint32_t> templates;
    const uint8_t *saved = nullptr;
    size_t size = 0;
};

}  // namespace claque::record

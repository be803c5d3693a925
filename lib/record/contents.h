// What a record contains: where each of its steps and states is. The bytes may be anything and stay where they are.
#pragma once

#include <string_view>

#include "lib/model/template.h"
#include "lib/record/format.h"
#include "lib/track/locomotion.h"

namespace claque::record
{

using model::Array;

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
        : templates(memory), locomotions(memory), tracks(memory), steps(memory), states(memory), ends_(memory)
    {
    }
    // Once. Throws base::Error (CLQ_FORMAT) with what is wrong and where, or std::bad_alloc. Allocations are
    // proportional to the size.
    void read(const uint8_t *bytes, size_t size);

    Cursor begin() const { return at_entry({file_header_bytes + block_header_bytes, 0}); }
    Cursor end() const;
    Entry entry(const Cursor &cursor) const;  // not at the end
    Cursor after(const Cursor &cursor) const;

    // The last step at or before a time, in the order of the record; the first one if there is none. Needs a step.
    uint64_t step_at(double time_s) const;
    // The last state at or before a place.
    const Cursor &state_before(const Cursor &cursor) const;
    uint64_t bytes() const;  // held

    Array<RecordedTemplate> templates;
    Array<RecordedLocomotion> locomotions;
    Array<RecordedTrack> tracks;
    Array<Step> steps;
    Array<Cursor> states;  // of both kinds
    uint64_t call_count = 0;
    bool is_whole = false;  // it has its end
    Entry crowd_def = {Kind::crowd_def, nullptr, 0};

private:
    Cursor at_entry(Cursor cursor) const;
    void read_block(uint64_t end);
    void read_entry(const Entry &entry, const Cursor &cursor);
    void read_description(const Entry &entry);

    const uint8_t *bytes_ = nullptr;
    Array<uint64_t> ends_;  // of the blocks
};

// The numbers of a state's templates, in the order of the crowd's own; then the saved crowd.
struct StateFields {
    StateFields(const Entry &entry, std::pmr::memory_resource *memory);
    Array<uint32_t> templates;
    const uint8_t *saved = nullptr;
    size_t size = 0;
};

}  // namespace claque::record

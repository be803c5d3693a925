#include "lib/record/contents.h"

#include <algorithm>
#include <cmath>

#include "lib/crowd/save.h"
#include "lib/record/locomotion_fields.h"

namespace claque::record
{

namespace
{

using base::big;
using base::fail;

template <class T>
T number_at(const uint8_t *bytes)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < sizeof(T); ++i) bits |= uint64_t(bytes[i]) << (8 * i);
    return static_cast<T>(bits);
}

crowd::Reader reader_of(const Entry &entry) { return crowd::Reader("an entry of a record", entry.fields, entry.size); }

void require_number(uint32_t number, size_t count, const char *what)
{
    if (number >= count) fail(CLQ_FORMAT, "a record names %s %u, and has %zu before", what, number, count);
}

bool is_equal(const RecordedLocomotion &a, const RecordedLocomotion &b)
{
    return a.tmpl == b.tmpl && a.clips.walk == b.clips.walk && a.clips.run == b.clips.run &&
           a.clips.slow == b.clips.slow && a.clips.turn == b.clips.turn && a.clips.torso == b.clips.torso &&
           a.clips.neck == b.clips.neck && a.clips.head == b.clips.head && a.clips.idle_count == b.clips.idle_count &&
           std::equal(a.clips.idles, a.clips.idles + a.clips.idle_count, b.clips.idles) &&
           std::equal(&a.clips.legs[0][0], &a.clips.legs[0][0] + 8, &b.clips.legs[0][0]);
}

RecordedLocomotion locomotion_of(const Entry &entry)
{
    crowd::Reader in = reader_of(entry);
    RecordedLocomotion out;
    in.value(out.tmpl);
    walk_clips(in, out.clips);
    if (out.clips.idle_count > track::max_idles)
        fail(CLQ_FORMAT, "a record has a locomotion with %u idle clips", out.clips.idle_count);
    if (in.left() != 0) fail(CLQ_FORMAT, "a locomotion of a record has %zu bytes too many", in.left());
    return out;
}

}  // namespace

void Contents::check_file(const uint8_t *bytes, size_t size)
{
    if (size < file_header_bytes || !std::equal(magic, magic + 8, bytes)) fail(CLQ_FORMAT, "these bytes are no record");
    if (const uint32_t found = number_at<uint32_t>(bytes + 8); found < first_version || found > version)
        fail(CLQ_FORMAT, "a record of version %u; this library reads versions %u to %u", found, first_version, version);
    if (number_at<uint32_t>(bytes + 12) != 0) fail(CLQ_FORMAT, "the header of a record was changed");
    bytes_ = bytes;
}

uint64_t Contents::read_header(uint64_t at, uint64_t number) const
{
    const uint8_t *header = bytes_ + at;
    const uint32_t contents = number_at<uint32_t>(header);
    if (number_at<uint32_t>(header + 4) != check_of_header(contents, number_at<uint64_t>(header + 8), number))
        fail(CLQ_FORMAT, "block %llu of a record, at byte %llu, was changed or is another one", big(number), big(at));
    return contents;
}

void Contents::check_contents(uint64_t at, uint64_t size, uint64_t number) const
{
    const uint8_t *header = bytes_ + at;
    if (checksum_of(header + block_header_bytes, static_cast<uint32_t>(size), number) !=
        number_at<uint64_t>(header + 8))
        fail(CLQ_FORMAT, "block %llu of a record, at byte %llu, was changed", big(number), big(at));
}

void Contents::read(const uint8_t *bytes, size_t size)
{
    check_file(bytes, size);
    uint64_t at = file_header_bytes;
    while (size - at >= block_header_bytes && !is_whole) {
        const uint64_t number = ends_.size(), contents = read_header(at, number);
        if (contents > size - at - block_header_bytes) break;
        check_contents(at, contents, number);
        at += block_header_bytes + contents;
        ends_.push_back(at);
        read_block(at);
    }
    if (is_whole && at != size) fail(CLQ_FORMAT, "a record has %llu bytes after its end", big(size - at));
    if (states.empty()) fail(CLQ_FORMAT, "a record of %zu bytes ends before its first state", size);
    find_earliest(steps_.data(), steps_.size(), HUGE_VAL);
    read_bytes_ = size;
    if (steps_.empty()) return;
    start_s = end_s = steps_.front().earliest_s;
    for (const Step &step : steps_) end_s = std::max(end_s, step.time_s);
}

void Contents::read_block(uint64_t end)
{
    const uint32_t block = static_cast<uint32_t>(ends_.size() - 1);
    Cursor cursor{(block ? ends_[block - 1] : file_header_bytes) + block_header_bytes, block};
    while (cursor.at < end) {
        const Entry entry = checked_entry(cursor.at, end);
        if (is_whole) fail(CLQ_FORMAT, "a record has an entry after its end, at byte %llu", big(cursor.at));
        read_entry(entry, cursor);
        cursor.at += entry_header_bytes + entry.size;
    }
}

// The entry at a place of a block that ends at `end`.
Entry Contents::checked_entry(uint64_t at, uint64_t end) const
{
    const uint64_t left = end - at;
    const uint32_t size = left < entry_header_bytes ? 0 : number_at<uint32_t>(bytes_ + at);
    if (size < 1 || size > left - sizeof size)
        fail(CLQ_FORMAT, "the entry at byte %llu of a record is longer than its block", big(at));
    return entry({at, 0});
}

double Contents::step_time(const Entry &entry, uint64_t number) const
{
    double time_s = 0;
    crowd::Reader in = reader_of(entry);
    in.value(time_s);
    if (in.left() != 0 || !std::isfinite(time_s)) fail(CLQ_FORMAT, "step %llu of a record has no time", big(number));
    return time_s;
}

void Contents::check_state(const Entry &entry) const
{
    for (const uint32_t tmpl : StateFields(entry, states.get_allocator().resource()).templates)
        require_number(tmpl, templates.size(), "template");
}

void Contents::read_entry(const Entry &entry, const Cursor &cursor)
{
    if ((entry.kind == Kind::crowd_def) != (crowd_def.fields == nullptr))
        fail(CLQ_FORMAT, "a record has no definition of its crowd, or a second one");
    if (states.empty() && (is_call(entry.kind) || entry.kind == Kind::step || entry.kind == Kind::key_state))
        fail(CLQ_FORMAT, "a record has calls before its first state");
    if (is_call(entry.kind)) {
        ++call_count;
        return;
    }
    switch (entry.kind) {
        case Kind::crowd_def:
            crowd_def = entry;
            return;
        case Kind::state:
        case Kind::key_state:
            check_state(entry);
            states.push_back(cursor);
            return;
        case Kind::step:
            steps_.push_back({step_time(entry, steps_.size()), 0, cursor});
            return;
        case Kind::index:
            return;
        case Kind::end:
            is_whole = true;
            return;
        default:
            read_description(entry);
    }
}

void Contents::read_description(const Entry &entry)
{
    if (entry.kind == Kind::tmpl) {
        if (entry.size < sizeof(uint64_t)) fail(CLQ_FORMAT, "template %zu of a record has no name", templates.size());
        const char *name = reinterpret_cast<const char *>(entry.fields + sizeof(uint64_t));
        templates.push_back({{name, entry.size - sizeof(uint64_t)}, number_at<uint64_t>(entry.fields)});
    } else if (entry.kind == Kind::locomotion) {
        const RecordedLocomotion made = locomotion_of(entry);
        require_number(made.tmpl, templates.size(), "template");
        if (locomotions.size() >= max_locomotions)
            fail(CLQ_FORMAT, "a record has more than %u locomotions", max_locomotions);
        for (const RecordedLocomotion &other : locomotions)
            if (is_equal(made, other)) fail(CLQ_FORMAT, "a record has a locomotion twice");
        locomotions.push_back(made);
    } else if (entry.kind == Kind::track) {
        tracks_.push_back(track_of(entry, tracks_.size()));
    } else {
        fail(CLQ_FORMAT, "a record has an entry of kind %u, which this library does not know", unsigned(entry.kind));
    }
}

RecordedTrack Contents::track_of(const Entry &entry, uint64_t number) const
{
    if (entry.size < sizeof(uint32_t)) fail(CLQ_FORMAT, "track %llu of a record is empty", big(number));
    const uint32_t locomotion = number_at<uint32_t>(entry.fields);
    require_number(locomotion, locomotions.size(), "locomotion");
    return {locomotion, entry.fields + sizeof(uint32_t), entry.size - uint32_t(sizeof(uint32_t))};
}

Entry Contents::entry(const Cursor &cursor) const
{
    const uint8_t *at = bytes_ + cursor.at;
    return {static_cast<Kind>(at[4]), at + entry_header_bytes, number_at<uint32_t>(at) - 1};
}

// From the end of a block to the next entry: a block may be empty.
Cursor Contents::at_entry(Cursor cursor) const
{
    while (cursor.block < ends_.size() && cursor.at == ends_[cursor.block])
        ++cursor.block, cursor.at += block_header_bytes;
    return cursor;
}

Cursor Contents::after(const Cursor &cursor) const
{
    return at_entry({cursor.at + sizeof(uint32_t) + number_at<uint32_t>(bytes_ + cursor.at), cursor.block});
}

Cursor Contents::end() const { return {ends_.back() + block_header_bytes, static_cast<uint32_t>(ends_.size())}; }

const Cursor &Contents::state_before(const Cursor &cursor) const
{
    return *(std::upper_bound(states.begin(), states.end(), cursor) - 1);
}

StateFields::StateFields(const Entry &entry, std::pmr::memory_resource *memory) : templates(memory)
{
    crowd::Reader in = reader_of(entry);
    in.array(templates, 4, [&](uint32_t &number) { in.value(number); });
    size = in.left(), saved = entry.fields + (entry.size - size);
}

}  // namespace claque::record

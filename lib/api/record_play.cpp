// Plays a record into a crowd: from where the crowd is, or from a state of the record.
#include <algorithm>
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/record_handle.h"
#include "lib/crowd/restore.h"

using namespace claque;

namespace claque::api
{

namespace
{

using base::big;
using base::fail;
using record::Kind;

// Holds the templates and tracks of the record for the crowd.
void borrow(const clq_record &played, clq_crowd *crowd)
{
    if (crowd->lender == played.id) return;
    crowd->held.reserve(crowd->held.size() + played.templates.size());
    for (clq_template *tmpl : played.templates) {
        if (std::find(crowd->held.begin(), crowd->held.end(), tmpl) != crowd->held.end()) continue;
        hold(tmpl);
        crowd->held.push_back(tmpl);
    }
    if (!played.contents.is_in_parts())
        for (uint32_t i = 0; i < played.tracks.size(); ++i) borrow_track(played, crowd, i);
    crowd->lender = played.id;
}

void restore(const clq_record &played, clq_crowd *crowd, const record::Cursor &cursor, const record::Entry &entry)
{
    if (played.contents.is_in_parts())
        played.contents.each_track_of(cursor, [&](uint32_t number) { borrow_track(played, crowd, number); });
    std::pmr::memory_resource *memory = &crowd->context->memory;
    const record::StateFields state(entry, memory);
    std::pmr::vector<clq_template *> templates(memory);
    for (const uint32_t number : state.templates) templates.push_back(played.templates[number]);
    HostResolver resolver(*crowd, templates.data(), static_cast<uint32_t>(templates.size()), &played.lent);
    restore_state(crowd, state.saved, state.size, resolver);
}

// Whether the calls from here to the target are fewer than those from a state: it lies before at most one state that
// would have to be passed.
bool goes_on(const record::Contents &contents, const clq_crowd *crowd, uint64_t id, const record::Cursor &target)
{
    const Played &at = crowd->played;
    if (at.record != id || target < at.next) return false;
    const auto first =
        std::lower_bound(contents.states.begin(), contents.states.end(), at.next) - contents.states.begin();
    const auto last =
        std::upper_bound(contents.states.begin(), contents.states.end(), target) - contents.states.begin();
    return last - first <= 1;
}

// A rule that a call breaks is a fault of the record, but not where the host lacks something.
template <class Body>
void as_format(const record::Cursor &cursor, const Body &body)
{
    try {
        body();
    } catch (const crowd::Missing &) {
        throw;
    } catch (const base::Error &error) {
        if (error.status() == CLQ_OUT_OF_MEMORY) throw;
        fail(CLQ_FORMAT, "the entry at byte %llu of the record: %s", big(cursor.at), error.what());
    }
}

}  // namespace

void play_to(const clq_record &played, clq_crowd *crowd, const record::Cursor &target)
{
    const record::Contents &contents = played.contents;
    borrow(played, crowd);
    const bool on = goes_on(contents, crowd, played.id, target);
    record::Cursor next = on ? crowd->played.next : contents.state_before(target);
    contents.require_entries(next, target);
    crowd->played = {};
    for (bool first = !on; next < target; first = false) {
        const record::Entry entry = contents.entry(next);
        as_format(next, [&] {
            if (entry.kind == Kind::state || (first && entry.kind == Kind::key_state))
                restore(played, crowd, next, entry);
            else if (entry.kind >= Kind::first_call) apply(played, crowd, entry);
        });
        next = contents.after(next);
    }
    crowd->played = {played.id, next};
}

}  // namespace claque::api

namespace
{

void play_step(const clq_record *played, clq_crowd *crowd, uint64_t step)
{
    const record::Contents &contents = played->contents;
    if (played->templates.size() != contents.templates.size())
        base::fail(CLQ_ARGUMENT, "the record has no templates yet: clq_record_set_templates gives them");
    api::require(crowd->context == played->context, "the record is of another context");
    api::require(!crowd->recorder, "the crowd is recorded itself: end its recording before a record is played into it");
    if (step > contents.step_count())
        base::fail(CLQ_ARGUMENT, "step %llu does not exist: the record has %llu", base::big(step),
                   base::big(contents.step_count()));
    api::play_to(*played, crowd, step < contents.step_count() ? contents.step(step).cursor : contents.end());
}

}  // namespace

extern "C" {

clq_status clq_record_play_step(const clq_record *record, clq_crowd *crowd, uint64_t step)
{
    return api::boundary("clq_record_play_step", [&] {
        api::require(record && crowd, "record or crowd is NULL");
        const api::Busy busy(crowd);
        play_step(record, crowd, step);
    });
}

clq_status clq_record_play(const clq_record *record, clq_crowd *crowd, double time_s)
{
    return api::boundary("clq_record_play", [&] {
        api::require(record && crowd, "record or crowd is NULL");
        if (!std::isfinite(time_s)) base::fail(CLQ_ARGUMENT, "time_s is not finite");
        const api::Busy busy(crowd);
        const record::Contents &contents = record->contents;
        if (contents.step_count() == 0) return play_step(record, crowd, 0);
        const uint64_t step = contents.step_at(time_s), count = contents.step_count();
        const bool after = step + 1 == count && time_s > contents.step(step).time_s;
        play_step(record, crowd, after ? count : step);
    });
}

}  // extern "C"

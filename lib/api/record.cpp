// clq_record: opened, asked, and given what it needs; and recordings.
#include <claque/record.h>

#include <algorithm>
#include <atomic>

#include "lib/api/boundary.h"
#include "lib/api/record_handle.h"
#include "lib/api/recorder.h"
#include "lib/record/crowd_def.h"
#include "lib/track/track_file.h"

using namespace claque;

clq_record::~clq_record()
{
    for (clq_track *track : tracks)
        if (track) api::release(track);
    for (const clq_locomotion *walk : walks) api::release(walk);
    for (clq_template *tmpl : templates) api::release(tmpl);
}

namespace
{

uint64_t next_record_id()
{
    static std::atomic<uint64_t> last{0};
    return ++last;
}

// What is known of a record, once its contents were read or opened.
void describe(clq_record &out)
{
    const record::Entry &entry = out.contents.crowd_def;
    crowd::Reader in("the definition of a recorded crowd", entry.fields, entry.size);
    record::walk_crowd_def(in, out.crowd_def);
    if (in.left() != 0) base::fail(CLQ_FORMAT, "the definition of a recorded crowd has %zu bytes too many", in.left());
    out.names.reserve(out.contents.templates.size());
    for (const record::RecordedTemplate &tmpl : out.contents.templates) out.names.emplace_back(tmpl.name);
    out.id = next_record_id();
}

// The templates, locomotions and tracks of a record, given back unless they are kept.
struct Given {
    explicit Given(clq_context *owner)
        : context(owner), templates(&owner->memory), walks(&owner->memory), tracks(&owner->memory)
    {
    }
    Given(const Given &) = delete;
    Given &operator=(const Given &) = delete;
    ~Given()
    {
        for (clq_track *track : tracks)
            if (track) api::release(track);
        for (const clq_locomotion *walk : walks) api::release(walk);
    }
    clq_context *context;
    std::pmr::vector<clq_template *> templates;
    std::pmr::vector<const clq_locomotion *> walks;
    std::pmr::vector<clq_track *> tracks;
};

void measure_walks(const clq_record &of, Given &given)
{
    given.walks.reserve(of.contents.locomotions.size());
    for (const record::RecordedLocomotion &one : of.contents.locomotions) {
        clq_locomotion *made = api::make<clq_locomotion>(of.context, given.templates[one.tmpl]);
        given.walks.push_back(made);
        try {
            track::measure(*given.templates[one.tmpl], one.clips, *made);
        } catch (const base::Error &error) {
            base::fail(CLQ_FORMAT, "locomotion %zu of the record: %s", given.walks.size() - 1, error.what());
        }
    }
}

clq_track *load_track(const clq_record &of, const std::pmr::vector<const clq_locomotion *> &walks, uint32_t number)
{
    const record::RecordedTrack one = of.contents.track(number);
    api::Making<clq_track> made(of.context, walks[one.locomotion]);
    try {
        track::load(one.bytes, one.size, *walks[one.locomotion], *made);
    } catch (const base::Error &error) {
        base::fail(error.status(), "track %u of the record: %s", number, error.what());
    }
    return made.release();
}

void load_tracks(const clq_record &of, Given &given)
{
    given.tracks.resize(of.contents.track_count());
    if (of.contents.is_in_parts()) return;
    for (uint32_t i = 0; i < given.tracks.size(); ++i) given.tracks[i] = load_track(of, given.walks, i);
}

}  // namespace

const clq_track &claque::api::borrow_track(const clq_record &played, clq_crowd *crowd, uint32_t number)
{
    if (number >= played.tracks.size())
        base::fail(CLQ_FORMAT, "a record names track %u of %zu", number, played.tracks.size());
    clq_track *track = nullptr;
    {
        const std::lock_guard lock(played.making);
        clq_track *&own = played.tracks[number];
        if (!own) own = load_track(played, played.walks, number);
        track = own;
    }
    if (crowd->tracks.insert(track).second) hold(track);
    return *track;
}

extern "C" {

clq_status clq_crowd_begin_recording(clq_crowd *crowd, const clq_recording_def *def)
{
    return api::boundary("clq_crowd_begin_recording", [&] {
        api::require(crowd && def, "crowd or def is NULL");
        const clq_recording_def wanted = api::read_def(def, clq_recording_def_init, "clq_recording_def_init");
        api::require(wanted.write != nullptr, "write is NULL");
        const api::Busy busy(crowd);
        api::require(!crowd->recorder, "the crowd is recorded already");
        api::Making<api::Recorder> made(crowd->context, *crowd, wanted);
        made->begin();
        crowd->recorder = made.release();
    });
}

clq_status clq_crowd_end_recording(clq_crowd *crowd, clq_recording_info *out)
{
    return api::boundary("clq_crowd_end_recording", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        if (out) api::require_size(*out, "clq_recording_info_init");
        const api::Busy busy(crowd);
        api::require(crowd->recorder != nullptr, "the crowd is not recorded");
        crowd->recorder->end();
        const clq_recording_info info = crowd->recorder->info();
        api::unmake(crowd->context, std::exchange(crowd->recorder, nullptr));
        if (out) api::write_out(out, info);
        if (info.status != CLQ_OK) base::fail(info.status, "%s", info.text);
    });
}

clq_status clq_crowd_get_recording(const clq_crowd *crowd, clq_recording_info *out)
{
    return api::boundary("clq_crowd_get_recording", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        api::require_size(*out, "clq_recording_info_init");
        const api::Reading reading(crowd);
        api::require(crowd->recorder != nullptr, "the crowd is not recorded");
        api::write_out(out, crowd->recorder->info());
    });
}

clq_status clq_record_load(clq_context *context, const void *bytes, size_t size_bytes, clq_record **out)
{
    return api::boundary("clq_record_load", [&] {
        api::require(context && bytes && out, "context, bytes or out is NULL");
        api::Making<clq_record> made(context, context);
        made->contents.read(static_cast<const uint8_t *>(bytes), size_bytes);
        describe(*made);
        *out = made.release();
    });
}

clq_status clq_record_open(clq_context *context, const void *bytes, size_t size_bytes, clq_record **out)
{
    return api::boundary("clq_record_open", [&] {
        api::require(context && bytes && out, "context, bytes or out is NULL");
        api::Making<clq_record> made(context, context);
        made->contents.open(static_cast<const uint8_t *>(bytes), size_bytes);
        describe(*made);
        *out = made.release();
    });
}

void clq_record_destroy(clq_record *record)
{
    if (record) api::unmake(record->context, record);
}

clq_status clq_record_get_info(const clq_record *record, clq_record_info *out)
{
    return api::boundary("clq_record_get_info", [&] {
        api::require(record && out, "record or out is NULL");
        api::require_size(*out, "clq_record_info_init");
        const record::Contents &contents = record->contents;
        clq_record_info info = clq_record_info_init();
        info.whole = contents.is_whole;
        info.template_count = static_cast<uint32_t>(contents.templates.size());
        info.track_count = static_cast<uint32_t>(contents.track_count());
        info.step_count = contents.step_count(), info.call_count = contents.call_count;
        info.state_count = contents.states.size();
        info.start_s = contents.start_s, info.end_s = contents.end_s;
        info.bytes = sizeof *record + contents.bytes();
        const std::lock_guard lock(record->making);
        for (const clq_track *track : record->tracks) info.bytes += track ? track->bytes() : 0;
        info.read_bytes = contents.read_bytes();
        api::write_out(out, info);
    });
}

clq_status clq_record_get_crowd_def(const clq_record *record, clq_crowd_def *out)
{
    return api::boundary("clq_record_get_crowd_def", [&] {
        api::require(record && out, "record or out is NULL");
        api::require_size(*out, "clq_crowd_def_init");
        api::write_out(out, record->crowd_def);
    });
}

const char *clq_record_get_template_name(const clq_record *record, uint32_t index)
{
    return record && index < record->names.size() ? record->names[index].c_str() : "";
}

clq_status clq_record_set_templates(clq_record *record, clq_template *const *templates, uint32_t template_count)
{
    return api::boundary("clq_record_set_templates", [&] {
        api::require(record != nullptr, "record is NULL");
        api::check_templates(record->context, templates, template_count);
        api::require(record->templates.empty(), "the record has its templates already");
        std::pmr::vector<clq_template *> left(templates, templates + template_count, &record->context->memory);
        Given given(record->context);
        for (const record::RecordedTemplate &wanted : record->contents.templates)
            given.templates.push_back(api::take_template(left, wanted.name, wanted.structure, "the recorded crowd"));
        measure_walks(*record, given);
        load_tracks(*record, given);
        for (clq_template *tmpl : given.templates) api::hold(tmpl);
        record->templates.swap(given.templates);
        record->walks.swap(given.walks);
        record->tracks.swap(given.tracks);
    });
}

clq_status clq_record_lend_mechanism(clq_record *record, clq_mechanism mechanism, const clq_host_mechanism_def *def)
{
    return api::boundary("clq_record_lend_mechanism", [&] {
        api::require(record && def, "record or def is NULL");
        api::require(def->run != nullptr, "run is NULL");
        api::require(mechanism.index1 != 0, "mechanism 0 is none");
        record->lent[mechanism.index1] = *def;
    });
}

clq_status clq_record_get_time(const clq_record *record, uint64_t step, double *out_s)
{
    return api::boundary("clq_record_get_time", [&] {
        api::require(record && out_s, "record or out_s is NULL");
        if (step >= record->contents.step_count())
            base::fail(CLQ_ARGUMENT, "step %llu does not exist: the record has %llu", base::big(step),
                       base::big(record->contents.step_count()));
        *out_s = record->contents.step(step).time_s;
    });
}

}  // extern "C"

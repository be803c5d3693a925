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
    for (clq_track *track : tracks) api::release(track);
    for (clq_template *tmpl : templates) api::release(tmpl);
}

namespace
{

uint64_t next_record_id()
{
    static std::atomic<uint64_t> last{0};
    return ++last;
}

void read(clq_record &out, const void *bytes, size_t size)
{
    out.contents.read(static_cast<const uint8_t *>(bytes), size);
    const record::Entry &entry = out.contents.crowd_def;
    crowd::Reader in("the definition of a recorded crowd", entry.fields, entry.size);
    record::walk_crowd_def(in, out.crowd_def);
    if (in.left() != 0) base::fail(CLQ_FORMAT, "the definition of a recorded crowd has %zu bytes too many", in.left());
    out.names.reserve(out.contents.templates.size());
    for (const record::RecordedTemplate &tmpl : out.contents.templates) out.names.emplace_back(tmpl.name);
    out.id = next_record_id();
}

// The templates and tracks of a record, given back unless they are kept.
struct Given {
    explicit Given(clq_context *owner) : context(owner), templates(&owner->memory), tracks(&owner->memory) {}
    Given(const Given &) = delete;
    Given &operator=(const Given &) = delete;
    ~Given()
    {
        for (clq_track *track : tracks) api::release(track);
    }
    clq_context *context;
    std::pmr::vector<clq_template *> templates;
    std::pmr::vector<clq_track *> tracks;
};

// Of the host for the time of the loading; tracks hold it on.
class Walk
{
public:
    Walk(clq_context *context, clq_template *tmpl, const track::LocomotionClips &clips)
        : made_(api::make<clq_locomotion>(context, tmpl))
    {
        try {
            track::measure(*tmpl, clips, *made_);
        } catch (...) {
            api::release(made_);
            throw;
        }
    }
    Walk(Walk &&other) noexcept : made_(std::exchange(other.made_, nullptr)) {}
    Walk &operator=(Walk &&) = delete;
    ~Walk()
    {
        if (made_) api::release(made_);
    }
    const clq_locomotion *get() const { return made_; }

private:
    clq_locomotion *made_;
};

void load_tracks(const clq_record &of, Given &given)
{
    std::pmr::vector<Walk> walks(&of.context->memory);
    for (const record::RecordedLocomotion &one : of.contents.locomotions) {
        try {
            walks.emplace_back(of.context, given.templates[one.tmpl], one.clips);
        } catch (const base::Error &error) {
            base::fail(CLQ_FORMAT, "locomotion %zu of the record: %s", walks.size(), error.what());
        }
    }
    given.tracks.reserve(of.contents.tracks.size());
    for (const record::RecordedTrack &one : of.contents.tracks) {
        api::Making<clq_track> made(of.context, walks[one.locomotion].get());
        try {
            track::load(one.bytes, one.size, *walks[one.locomotion].get(), *made);
        } catch (const base::Error &error) {
            base::fail(error.status(), "track %zu of the record: %s", given.tracks.size(), error.what());
        }
        given.tracks.push_back(made.release());
    }
}

}  // namespace

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
        read(*made, bytes, size_bytes);
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
        info.track_count = static_cast<uint32_t>(contents.tracks.size());
        info.step_count = contents.steps.size(), info.call_count = contents.call_count;
        info.state_count = contents.states.size();
        if (!contents.steps.empty()) {
            info.start_s = contents.steps.front().earliest_s;
            info.end_s = info.start_s;
            for (const record::Step &step : contents.steps) info.end_s = std::max(info.end_s, step.time_s);
        }
        info.bytes = sizeof *record + contents.bytes();
        for (const clq_track *track : record->tracks) info.bytes += track->bytes();
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
        load_tracks(*record, given);
        for (clq_template *tmpl : given.templates) api::hold(tmpl);
        record->templates.swap(given.templates);
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
        if (step >= record->contents.steps.size())
            base::fail(CLQ_ARGUMENT, "step %llu does not exist: the record has %zu", base::big(step),
                       record->contents.steps.size());
        *out_s = record->contents.steps[step].time_s;
    });
}

}  // extern "C"

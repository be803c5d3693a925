// Records for `claque bench readers`: loading one, and playing it to its end.
#include <claque/record.h>

#include "samples/cli/reader_parts.h"

namespace cli
{

using scenes::check;
using scenes::Own;

namespace
{

struct DestroyRecord {
    void operator()(clq_record *p) const { clq_record_destroy(p); }
};

// A crowd of one, recorded while `act` makes its calls.
template <class Act>
std::string recorded(const Act &act)
{
    const scenes::Library library{1};
    const Own<clq_template> tmpl = template_of(library, gltf_with_animations(1));
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &made));
    const Own<clq_crowd> crowd(made);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl.get();
    clq_actor first;
    check(clq_actor_create(made, &def, &first));
    std::string out;
    clq_recording_def to = clq_recording_def_init();
    to.write = append_bytes, to.user = &out;
    check(clq_crowd_begin_recording(made, &to));
    act(made, def, first);
    check(clq_crowd_update(made, 1, nullptr, 0));
    check(clq_crowd_end_recording(made, nullptr));
    return out;
}

std::string recorded_steps(uint32_t count)
{
    return recorded([&](clq_crowd *crowd, const clq_actor_def &, clq_actor) {
        for (uint32_t i = 0; i < count; ++i) check(clq_crowd_update(crowd, i, nullptr, 0));
    });
}

std::string recorded_plays(uint32_t count)
{
    return recorded([&](clq_crowd *crowd, const clq_actor_def &, clq_actor first) {
        clq_play play = clq_play_init();
        for (uint32_t i = 0; i < count; ++i) {
            play.start_s = i;
            check(clq_actor_play(crowd, first, &play));
        }
    });
}

std::string recorded_actors(uint32_t count)
{
    return recorded([&](clq_crowd *crowd, const clq_actor_def &def, clq_actor) {
        clq_actor made;
        for (uint32_t i = 0; i < count; ++i) check(clq_actor_create(crowd, &def, &made));
    });
}

std::string recorded_groups(uint32_t count)
{
    return recorded([&](clq_crowd *crowd, const clq_actor_def &, clq_actor first) {
        clq_group made;
        for (uint32_t i = 0; i < count; ++i) {
            check(clq_group_create(crowd, nullptr, &made));
            check(clq_actor_join(crowd, first, made, nullptr));
        }
    });
}

Reading read_record(scenes::Library &library, const std::string &bytes)
{
    const Own<clq_template> tmpl = template_of(library, gltf_with_animations(1));
    clq_template *templates[] = {tmpl.get()};
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), nullptr, &made));
    const Own<clq_crowd> crowd(made);
    clq_record *record = nullptr;
    Reading out = timed([&] {
        const clq_status status = clq_record_load(library.context(), bytes.data(), bytes.size(), &record);
        return outcome_of(status == CLQ_OK ? clq_record_set_templates(record, templates, 1) : status);
    });
    const std::unique_ptr<clq_record, DestroyRecord> own(record);
    if (out.loaded != "ok") return out;
    // Step by step, as a film plays it. Calls between two steps that are far apart may be left out by way of a state.
    const double begin = processor_ms();
    clq_record_info info = clq_record_info_init();
    clq_status status = clq_record_get_info(record, &info);
    for (uint64_t step = 0; status == CLQ_OK && step <= info.step_count; ++step)
        status = clq_record_play_step(record, made, step);
    out.built = outcome_of(status);
    out.build_ms = processor_ms() - begin;
    return out;
}

}  // namespace

std::vector<ReaderElement> reader_elements_of_records()
{
    return {{"record", "steps", most_elements, recorded_steps, read_record},
            {"record", "plays of one actor", most_elements, recorded_plays, read_record},
            {"record", "actors that come", most_elements, recorded_actors, read_record},
            {"record", "groups that one actor joins", most_elements, recorded_groups, read_record}};
}

}  // namespace cli

// What a crowd that is recorded tells of its calls. Calls for the crowd never fail because of it: the recording then
// ends, and says why when it is asked.
#pragma once

#include <claque/record.h>

#include <algorithm>
#include <map>

#include "lib/api/crowd_handle.h"
#include "lib/api/track_handle.h"
#include "lib/record/block_writer.h"
#include "lib/record/index.h"

namespace claque::api
{

class Recorder
{
public:
    Recorder(const clq_crowd &crowd, const clq_recording_def &def);
    Recorder(const Recorder &) = delete;
    Recorder &operator=(const Recorder &) = delete;

    void begin();  // throws; then discard it

    // After the change. `make` may write one entry or more, and may throw.
    template <class Make>
    void note(const Make &make) noexcept
    {
        guarded([&] {
            make(*this);
            flush_if_full();
        });
    }
    void step(double time_s) noexcept;
    void end() noexcept;

    clq_recording_info info() const;

    // For `note`.
    template <class Call>
    void call(const Call &call)
    {
        blocks_.call(call), ++info_.calls;
    }
    template <class Write>
    void description(record::Kind kind, const Write &write)
    {
        blocks_.entry(kind, write), ++info_.calls;
    }
    void create(const clq_actor_def &def, clq_actor made);
    void follow(clq_actor actor, const clq_track &track, double start_s);
    void transforms(const clq_actor *actors, const clq_transform *places, uint32_t count);
    void speeds(const clq_actor *actors, const float *speeds, uint32_t count);
    void colours(const clq_actor *actors, uint32_t count);
    void restored() { state(record::Kind::state), ++info_.calls; }

private:
    template <class Body>
    void guarded(const Body &body) noexcept
    {
        if (info_.status != CLQ_OK) return;
        try {
            body();
        } catch (const base::Error &error) {
            stop(error.status(), error.what());
        } catch (const std::exception &) {
            stop(CLQ_OUT_OF_MEMORY, "memory was refused to the recording of a crowd");
        }
    }
    void state(record::Kind kind);
    // An entry that the index repeats.
    template <class Body>
    void describe(record::Kind kind, const Body &body)
    {
        const size_t before = blocks_.contents_size();
        blocks_.entry(kind, body);
        descriptions_.insert(descriptions_.end(), blocks_.contents() + before,
                             blocks_.contents() + blocks_.contents_size());
    }
    void index();
    void note_state(model::Array<uint32_t> &tracks);
    void stop(clq_status status, const char *text) noexcept;
    void flush();
    void flush_if_full();
    void give(const uint8_t *bytes, size_t size);
    uint64_t written() const { return info_.bytes + blocks_.contents_size(); }
    // Of the block that is being made, and of its next entry. The header of the file is given with the first block.
    uint64_t block_at() const { return std::max<uint64_t>(info_.bytes, record::file_header_bytes); }
    uint64_t entry_at() const { return block_at() + record::block_header_bytes + blocks_.contents_size(); }
    uint32_t number_of(const model::Template &tmpl);
    uint32_t number_of(const track::Locomotion &locomotion);
    uint32_t number_of(const track::Track &track);

    const clq_crowd &crowd_;
    clq_recording_def def_;
    record::BlockWriter blocks_;
    // Numbers by what they name: the crowd holds templates to its end, but tracks and locomotions may go before.
    using Key = std::pair<uint64_t, const model::Template *>;  // a hash and a template
    model::Array<const model::Template *> templates_;
    std::pmr::map<Key, uint32_t> locomotions_, tracks_;
    clq_recording_info info_;
    uint64_t state_bytes_ = 0, state_end_ = 0;
    record::Index index_;
    model::Array<uint8_t> descriptions_;
};

void end_recording(clq_crowd *crowd) noexcept;  // if it is recorded

// After each change of a crowd's state by a host.
template <class Make>
void changed_by(clq_crowd *crowd, const Make &make) noexcept
{
    crowd->played = {};
    if (crowd->recorder) crowd->recorder->note(make);
}

// A call that is recorded as it was made.
template <class Call>
void changed(clq_crowd *crowd, const Call &call) noexcept
{
    changed_by(crowd, [&](Recorder &recorder) { recorder.call(call); });
}

inline clq_transform place_or_none(const clq_transform *transform) { return transform ? *transform : clq_transform{}; }

}  // namespace claque::api

// All stores of shared key-poses of a crowd, one a template and level (S3 5), within one budget. What an update asks of
// them is chosen, then skinned, each once; whoever shows it, in whichever view, is given the same memory.
#pragma once

#include "animcache/evaluate.h"
#include "animcache/keypose_store.h"
#include "animcache/scratch.h"
#include "lib/base/services.h"
#include "lib/base/span.h"

namespace claque::animcache
{

struct KeyPoseCounters {
    uint32_t requested = 0;  // last update: individuals that show key-poses
    uint32_t served = 0;     // of these, whose key-poses are all kept; the others are skinned
    uint32_t wanted = 0;     // different key-poses that they show
    uint32_t updated = 0;    // of these, that were skinned into a store: each once, whoever shows it
    uint32_t held = 0;       // in all stores now
    uint64_t bytes = 0;
};

class KeyPoses
{
public:
    KeyPoses(std::pmr::memory_resource *memory, const KeyPoseSettings &settings, VertexFormat vertex_format);

    // Start-up, and whenever a template has come. The only call that may fail (std::bad_alloc); as it was then, or with
    // less kept.
    void reserve(uint32_t row_count, base::Span<const model::Template *const> templates);

    KeyPoseMode mode_at(float distance) const { return settings_.mode_at(distance); }
    // What an individual of templates[tmpl] shows; requires reserve().
    KeyPoseSelection select(uint32_t tmpl, uint32_t level, KeyPoseMode mode, uint32_t clip, double time_s) const;

    // An update: fills `kept` of every request that shows key-poses, then makes what is new.
    void choose(std::pmr::vector<Request> &requests);
    void make(const base::Jobs &jobs, ScratchPool &scratch);

    const KeyPoseCounters &counters() const { return counters_; }
    const KeyPoseSettings &settings() const { return settings_; }

private:
    struct Owner {
        const model::Template *tmpl = nullptr;
        uint32_t first_store = 0, end_store = 0;
        KeyPoseTable table;
    };
    struct Work {  // one key-pose to be skinned
        Request request;
        float *vertices = nullptr;
    };

    void make_room();
    void list_work();

    std::pmr::memory_resource *memory_;
    KeyPoseSettings settings_;
    VertexFormat vertex_format_;
    KeyPoseMemory shared_;
    KeyPoseCounters counters_;
    uint64_t frame_number_ = 0;
    model::Array<Owner> owners_;  // by template
    model::Array<KeyPoseStore> stores_;
    model::Array<Work> work_;
    model::Array<uint32_t> requested_;  // scratch: indices of requests
};

}  // namespace claque::animcache

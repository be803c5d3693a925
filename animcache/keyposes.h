// All stores of shared key-poses of a crowd, one per template and level (S3 5), within one budget. The key-poses that
// an update needs are chosen, then skinned once each; all individuals that show one share its memory in all views.
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
    uint32_t served = 0;     // of these, with all key-poses kept; the others are skinned
    uint32_t wanted = 0;     // distinct key-poses that they show
    uint32_t updated = 0;    // of these, skinned into a store: once each
    uint32_t held = 0;       // in all stores now
    uint64_t bytes = 0;
};

class KeyPoses
{
public:
    KeyPoses(std::pmr::memory_resource *memory, const KeyPoseSettings &settings, VertexFormat vertex_format);

    // At start-up and when a template was added. The only call that may fail (std::bad_alloc); the stores are unchanged
    // then, or keep less.
    void reserve(uint32_t request_count, base::Span<const model::Template *const> templates);

    KeyPoseMode mode_at(float distance) const { return settings_.mode_at(distance); }
    // What an individual of templates[tmpl] shows; requires reserve().
    KeyPoseSelection select(uint32_t tmpl, uint32_t level, KeyPoseMode mode, uint32_t clip, double time_s) const;

    // As in Caches: an update that can be undone frees nothing that was listed until commit().
    void begin(bool can_undo) { listed_from_ = can_undo ? last_listed_ : ~uint64_t(0); }
    void undo();
    void commit();
    // Per update: fills `kept` of every request that shows key-poses, then skins the new ones.
    void choose(std::pmr::vector<Request> &requests);
    void make(const base::Jobs &jobs, ScratchPool &scratch);

    uint64_t book_bytes() const;  // held besides the key-poses
    const KeyPoseCounters &counters() const { return counters_; }
    const KeyPoseSettings &settings() const { return settings_; }

private:
    struct Owner {
        const model::Template *tmpl = nullptr;
        uint32_t first_store = 0, end_store = 0;
        KeyPoseTable table;
    };
    struct Work {  // one key-pose to skin
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
    uint64_t frame_number_ = 0, last_listed_ = 0, listed_from_ = ~uint64_t(0);
    model::Array<Owner> owners_;  // by template
    model::Array<KeyPoseStore> stores_;
    model::Array<KeyPoseStore> retired_;  // of templates that the crowd has no more; lists point at them until commit()
    model::Array<Work> work_;
    model::Array<uint32_t> requested_;  // scratch: indices of requests
};

}  // namespace claque::animcache

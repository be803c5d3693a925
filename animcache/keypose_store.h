// The skinned key-poses of one template at one level (S3 3, 4.2): counts the needs of individuals, chooses key-poses
// and assigns them slots. Wanted key-poses keep their slots; the least recently used ones are replaced.
#pragma once

#include "animcache/keypose.h"
#include "animcache/keypose_choice.h"
#include "lib/base/span.h"

namespace claque::animcache
{

// Memory that all stores share.
struct KeyPoseMemory {
    std::pmr::memory_resource *memory = nullptr;
    uint64_t budget_bytes = 0, bytes = 0;
};

class KeyPoseStore
{
public:
    KeyPoseStore(std::pmr::memory_resource *memory, uint32_t pose_count, size_t floats_each);
    ~KeyPoseStore();
    KeyPoseStore(KeyPoseStore &&other) noexcept;
    KeyPoseStore(const KeyPoseStore &) = delete;
    KeyPoseStore &operator=(const KeyPoseStore &) = delete;
    KeyPoseStore &operator=(KeyPoseStore &&) = delete;

    void begin(uint64_t frame_number);
    void want(uint32_t first, uint32_t second);  // adds one individual's needs
    void close();                                // ends the calls of want()
    bool is_idle() const { return wanted_ == 0; }
    bool is_short_of_room(uint32_t max_kept, const KeyPoseMemory &memory) const;
    void release(KeyPoseMemory &memory);  // gives all memory back
    // Assigns a slot to every chosen key-pose; new ones are listed in `fresh`.
    void choose(uint32_t max_kept, KeyPoseMemory &memory);
    const float *find(uint32_t pose);  // null: not kept. Counts as a use

    // Kept from this update on; must be skinned before it is read.
    struct Fresh {
        uint32_t pose = 0;
        float *vertices = nullptr;
    };
    base::Span<const Fresh> fresh() const { return base::Span<const Fresh>(fresh_); }
    void keep_fresh() { fresh_.clear(); }
    void drop_fresh();  // as if they had not been chosen
    bool was_used_since(uint64_t frame_number) const { return !slots_.empty() && last_used_ >= frame_number; }
    uint32_t wanted() const { return wanted_; }  // distinct key-poses, in this update
    uint32_t held() const;
    uint64_t bytes() const { return slots_.size() * sizeof(float) * floats_each_; }

    uint64_t book_bytes() const
    {
        return base::held_bytes(slots_, slot_of_, counts_, bins_, held_, chosen_, fresh_) + choice_.bytes();
    }

private:
    struct Slot {
        float *vertices = nullptr;
        uint32_t pose = model::none;
        uint64_t used = 0;  // the last update that used it
    };
    uint32_t find_slot(uint32_t max_kept, KeyPoseMemory &memory);
    uint32_t room_for(uint32_t max_kept, const KeyPoseMemory &memory) const;

    std::pmr::memory_resource *memory_;
    size_t floats_each_;
    uint32_t pose_count_;
    uint64_t frame_number_ = 0, last_used_ = 0;
    uint32_t wanted_ = 0;
    model::Array<Slot> slots_;
    model::Array<uint32_t> slot_of_;  // by pose, or none
    model::Array<uint32_t> counts_;   // by bin: those with one key-pose, then those with two by their first one
    model::Array<KeyPoseBin> bins_;   // the bins that are not empty; their counts valid from choose() on
    KeyPoseChoice choice_;
    model::Array<uint8_t> held_, chosen_;
    model::Array<Fresh> fresh_;
};

}  // namespace claque::animcache

// The key-poses of one template at one level that are kept skinned (S3 3, 4.2): counts who needs which, chooses, finds
// them places. What is still wanted stays where it is; the least recently used goes.
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
    void want(uint32_t first, uint32_t second);  // one individual's needs
    void close();                                // all have said what they need
    bool is_idle() const { return wanted_ == 0; }
    bool is_short_of_room(uint32_t max_kept, const KeyPoseMemory &memory) const;
    void release(KeyPoseMemory &memory);  // gives back everything
    // Gives every key-pose that is worth it a place; those that were not there before wait in `fresh`.
    void choose(uint32_t max_kept, KeyPoseMemory &memory);
    const float *find(uint32_t pose);  // null: not kept. Counts as a use

    // Kept from this update on, to be skinned before anybody looks at them.
    struct Fresh {
        uint32_t pose = 0;
        float *vertices = nullptr;
    };
    base::Span<const Fresh> fresh() const { return base::Span<const Fresh>(fresh_); }
    uint32_t wanted() const { return wanted_; }  // different key-poses, in this update
    uint32_t held() const;
    uint64_t bytes() const { return slots_.size() * sizeof(float) * floats_each_; }

private:
    struct Slot {
        float *vertices = nullptr;
        uint32_t pose = model::none;
        uint64_t used = 0;  // in which update last
    };
    uint32_t find_slot(uint32_t max_kept, KeyPoseMemory &memory);
    uint32_t room_for(uint32_t max_kept, const KeyPoseMemory &memory) const;

    std::pmr::memory_resource *memory_;
    size_t floats_each_;
    uint32_t pose_count_;
    uint64_t frame_number_ = 0;
    uint32_t wanted_ = 0;
    model::Array<Slot> slots_;
    model::Array<uint32_t> slot_of_;  // by pose, or none
    model::Array<uint32_t> counts_;   // by bin: those of one key-pose, then those of two by their first one
    model::Array<KeyPoseBin> bins_;   // that are not empty; their counts from choose() on
    KeyPoseChoice choice_;
    model::Array<uint8_t> held_, chosen_;
    model::Array<Fresh> fresh_;
};

}  // namespace claque::animcache

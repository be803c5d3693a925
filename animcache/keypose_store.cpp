#include "animcache/keypose_store.h"

#include <algorithm>

#include "lib/math/simd.h"

namespace claque::animcache
{

KeyPoseStore::KeyPoseStore(std::pmr::memory_resource *memory, uint32_t pose_count, size_t floats_each)
    : memory_(memory),
      floats_each_(floats_each),
      pose_count_(pose_count),
      slots_(memory),
      slot_of_(pose_count, model::none, memory),
      counts_(2 * size_t(pose_count), 0, memory),
      bins_(memory),
      choice_(memory, pose_count, 2 * pose_count),
      held_(pose_count, 0, memory),
      chosen_(pose_count, 0, memory),
      fresh_(memory)
{
    slots_.reserve(pose_count);
    bins_.reserve(2 * size_t(pose_count));
    fresh_.reserve(pose_count);
}

KeyPoseStore::KeyPoseStore(KeyPoseStore &&other) noexcept = default;

KeyPoseStore::~KeyPoseStore()
{
    for (const Slot &slot : slots_) memory_->deallocate(slot.vertices, floats_each_ * sizeof(float), alignof(math::F4));
}

void KeyPoseStore::begin(uint64_t frame_number)
{
    frame_number_ = frame_number;
    for (const KeyPoseBin &bin : bins_) counts_[bin.first + (bin.first == bin.second ? 0 : pose_count_)] = 0;
    bins_.clear();
    fresh_.clear();
    wanted_ = 0;
}

// The second key-pose follows from the first, so the first and whether there is a second identify a bin.
void KeyPoseStore::want(uint32_t first, uint32_t second)
{
    uint32_t &count = counts_[first + (first == second ? 0 : pose_count_)];
    if (++count == 1) bins_.push_back({first, second, 0});
}

uint32_t KeyPoseStore::room_for(uint32_t max_kept, const KeyPoseMemory &memory) const
{
    const uint64_t left = memory.budget_bytes > memory.bytes ? memory.budget_bytes - memory.bytes : 0;
    const uint64_t more = left / (sizeof(float) * floats_each_);
    return static_cast<uint32_t>(std::min<uint64_t>(std::min(max_kept, pose_count_), slots_.size() + more));
}

// A new slot while there is room; then the least recently used slot whose key-pose is not wanted, ties by slot.
uint32_t KeyPoseStore::find_slot(uint32_t max_kept, KeyPoseMemory &memory)
{
    const size_t bytes = sizeof(float) * floats_each_;
    if (slots_.size() < room_for(max_kept, memory)) {
        try {
            slots_.push_back({static_cast<float *>(memory_->allocate(bytes, alignof(math::F4))), model::none, 0});
            memory.bytes += bytes;
            return static_cast<uint32_t>(slots_.size() - 1);
        } catch (...) {  // the host refuses: treated as a spent budget
        }
    }
    uint32_t oldest = model::none;
    for (uint32_t i = 0; i < slots_.size(); ++i) {
        if (slots_[i].pose != model::none && chosen_[slots_[i].pose]) continue;
        if (oldest == model::none || slots_[i].used < slots_[oldest].used) oldest = i;
    }
    if (oldest != model::none && slots_[oldest].pose != model::none) {
        slot_of_[slots_[oldest].pose] = model::none;
        held_[slots_[oldest].pose] = 0;
    }
    return oldest;
}

// Marks all wanted key-poses as chosen, for the time being.
void KeyPoseStore::close()
{
    std::fill(chosen_.begin(), chosen_.end(), uint8_t(0));
    for (KeyPoseBin &bin : bins_) {
        bin.count = counts_[bin.first + (bin.first == bin.second ? 0 : pose_count_)];
        wanted_ += uint32_t(!chosen_[bin.first]) + uint32_t(bin.second != bin.first && !chosen_[bin.second]);
        chosen_[bin.first] = chosen_[bin.second] = 1;
    }
}

bool KeyPoseStore::is_short_of_room(uint32_t max_kept, const KeyPoseMemory &memory) const
{
    return room_for(max_kept, memory) < std::min(max_kept, wanted_);
}

void KeyPoseStore::release(KeyPoseMemory &memory)
{
    memory.bytes -= bytes();
    for (const Slot &slot : slots_) memory_->deallocate(slot.vertices, floats_each_ * sizeof(float), alignof(math::F4));
    slots_.clear();
    std::fill(slot_of_.begin(), slot_of_.end(), model::none);
    std::fill(held_.begin(), held_.end(), uint8_t(0));
}

void KeyPoseStore::choose(uint32_t max_kept, KeyPoseMemory &memory)
{
    const uint32_t room = room_for(max_kept, memory);
    if (wanted_ > room) {
        std::fill(chosen_.begin(), chosen_.end(), uint8_t(0));
        choice_.choose(bins_.data(), static_cast<uint32_t>(bins_.size()), room, held_.data(), chosen_.data());
    }
    for (uint32_t pose = 0; pose < pose_count_; ++pose) {
        if (!chosen_[pose] || slot_of_[pose] != model::none) continue;
        const uint32_t slot = find_slot(max_kept, memory);
        if (slot == model::none) return;
        slots_[slot].pose = pose;
        slot_of_[pose] = slot;
        held_[pose] = 1;
        fresh_.push_back({pose, slots_[slot].vertices});
    }
}

void KeyPoseStore::drop_fresh()
{
    for (const Fresh &fresh : fresh_) {
        slots_[slot_of_[fresh.pose]].pose = model::none;
        slot_of_[fresh.pose] = model::none;
        held_[fresh.pose] = 0;
    }
    fresh_.clear();
}

const float *KeyPoseStore::find(uint32_t pose)
{
    if (slot_of_[pose] == model::none) return nullptr;
    Slot &slot = slots_[slot_of_[pose]];
    slot.used = last_used_ = frame_number_;
    return slot.vertices;
}

uint32_t KeyPoseStore::held() const
{
    return static_cast<uint32_t>(
        std::count_if(slots_.begin(), slots_.end(), [](const Slot &s) { return s.pose != model::none; }));
}

}  // namespace claque::animcache

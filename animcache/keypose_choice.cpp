#include "animcache/keypose_choice.h"

#include <algorithm>

namespace claque::animcache
{

KeyPoseChoice::KeyPoseChoice(std::pmr::memory_resource *memory, uint32_t pose_count, uint32_t max_bins)
    : poses_(pose_count, memory), by_pose_(2 * size_t(max_bins), 0, memory), heap_(memory), served_(max_bins, 0, memory)
{
    heap_.reserve(pose_count);
}

// Lists the bins by each of their key-poses.
void KeyPoseChoice::index(const KeyPoseBin *bins, uint32_t bin_count)
{
    std::fill(poses_.begin(), poses_.end(), Pose());
    const auto each = [&](const auto &visit) {
        for (uint32_t b = 0; b < bin_count; ++b) {
            visit(poses_[bins[b].first], b);
            if (bins[b].second != bins[b].first) visit(poses_[bins[b].second], b);
        }
    };
    each([&](Pose &pose, uint32_t b) { pose.missed += bins[b].count, ++pose.end_bin; });
    uint32_t end = 0;
    heap_.clear();
    for (uint32_t pose = 0; pose < poses_.size(); ++pose) {
        const uint32_t count = poses_[pose].end_bin;
        poses_[pose].first_bin = poses_[pose].end_bin = end;
        end += count;
        if (count == 0) continue;
        heap_.push_back(pose);
        poses_[pose].heap_index = static_cast<uint32_t>(heap_.size() - 1);
    }
    each([&](Pose &pose, uint32_t b) { by_pose_[pose.end_bin++] = b; });
    std::fill_n(served_.begin(), bin_count, uint8_t(1));
    for (const uint32_t pose : heap_) poses_[pose].paired = is_paired(bins, pose);
}

bool KeyPoseChoice::is_paired(const KeyPoseBin *bins, uint32_t pose) const
{
    for (uint32_t i = poses_[pose].first_bin; i < poses_[pose].end_bin; ++i) {
        const KeyPoseBin &bin = bins[by_pose_[i]];
        if (!served_[by_pose_[i]] || bin.first == bin.second || bin.count != poses_[pose].missed) continue;
        return poses_[bin.first].missed == poses_[bin.second].missed;
    }
    return false;
}

void KeyPoseChoice::refresh(const KeyPoseBin *bins, uint32_t pose, const uint8_t *held)
{
    poses_[pose].paired = is_paired(bins, pose);
    sift_up(poses_[pose].heap_index, held);
    for (uint32_t i = poses_[pose].first_bin; i < poses_[pose].end_bin; ++i) {
        const KeyPoseBin &bin = bins[by_pose_[i]];
        const uint32_t partner = bin.first == pose ? bin.second : bin.first;
        if (!served_[by_pose_[i]] || poses_[partner].paired || !is_paired(bins, partner)) continue;
        poses_[partner].paired = true;
        sift_up(poses_[partner].heap_index, held);
    }
}

bool KeyPoseChoice::goes_before(uint32_t a, uint32_t b, const uint8_t *held) const
{
    if (poses_[a].missed != poses_[b].missed) return poses_[a].missed < poses_[b].missed;
    if (poses_[a].paired != poses_[b].paired) return poses_[a].paired;
    if (held && held[a] != held[b]) return !held[a];
    return a > b;
}

void KeyPoseChoice::put(uint32_t heap_index, uint32_t pose)
{
    heap_[heap_index] = pose;
    poses_[pose].heap_index = heap_index;
}

void KeyPoseChoice::sift_up(uint32_t heap_index, const uint8_t *held)
{
    const uint32_t pose = heap_[heap_index];
    for (; heap_index > 0 && goes_before(pose, heap_[(heap_index - 1) / 2], held); heap_index = (heap_index - 1) / 2)
        put(heap_index, heap_[(heap_index - 1) / 2]);
    put(heap_index, pose);
}

void KeyPoseChoice::sift_down(uint32_t heap_index, const uint8_t *held)
{
    const uint32_t pose = heap_[heap_index], count = static_cast<uint32_t>(heap_.size());
    for (uint32_t child; (child = 2 * heap_index + 1) < count; heap_index = child) {
        if (child + 1 < count && goes_before(heap_[child + 1], heap_[child], held)) ++child;
        if (!goes_before(heap_[child], pose, held)) break;
        put(heap_index, heap_[child]);
    }
    put(heap_index, pose);
}

// Individuals that needed it are no longer served, so they do not miss their other key-pose either.
void KeyPoseChoice::drop(const KeyPoseBin *bins, const uint8_t *held)
{
    const uint32_t gone = heap_.front();
    const uint32_t last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
        put(0, last);
        sift_down(0, held);
    }
    for (uint32_t i = poses_[gone].first_bin; i < poses_[gone].end_bin; ++i) {
        const uint32_t b = by_pose_[i], other = bins[b].first == gone ? bins[b].second : bins[b].first;
        if (!served_[b]) continue;
        served_[b] = 0;
        if (other == gone) continue;
        poses_[other].missed -= bins[b].count;
        refresh(bins, other, held);
    }
}

uint32_t KeyPoseChoice::choose(KeyPoseBin *bins, uint32_t bin_count, uint32_t capacity, const uint8_t *held,
                               uint8_t *chosen)
{
    index(bins, bin_count);
    for (uint32_t heap_index = static_cast<uint32_t>(heap_.size()) / 2; heap_index-- > 0;) sift_down(heap_index, held);
    while (heap_.size() > capacity) drop(bins, held);
    uint32_t used = 0;
    for (const uint32_t pose : heap_)
        if (poses_[pose].missed > 0) chosen[pose] = 1, ++used;

    const auto more = [&](const KeyPoseBin &bin, const uint8_t *have) {
        return have ? uint32_t(!have[bin.first]) + uint32_t(bin.second != bin.first && !have[bin.second]) : 0;
    };
    std::sort(bins, bins + bin_count, [&](const KeyPoseBin &a, const KeyPoseBin &b) {
        if (a.count != b.count) return a.count > b.count;
        if (const uint32_t x = more(a, held), y = more(b, held); x != y) return x < y;
        return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    for (const KeyPoseBin *bin = bins; bin != bins + bin_count && used < capacity; ++bin) {
        const uint32_t wanted = more(*bin, chosen);
        if (bin->count == 0 || used + wanted > capacity) continue;
        chosen[bin->first] = chosen[bin->second] = 1;
        used += wanted;
    }
    return used;
}

}  // namespace claque::animcache

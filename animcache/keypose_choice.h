// Chooses the key-poses to keep (S3 4): those that serve the most individuals, each of which needs one key-pose or two.
// The problem is a set-union knapsack. S3 fills it bin by bin, the fullest first. This file starts with all key-poses
// and repeatedly drops the one that the fewest individuals would miss, which comes nearer to the optimum (S3 Fig. 7;
// tests require 97 %). Among ties, it drops one whose partner is then not needed either.
#pragma once

#include <cstdint>

#include "lib/base/held_bytes.h"
#include "lib/model/rig.h"

namespace claque::animcache
{

// Individuals with equal needs (S3 4.2: a temporal bin).
struct KeyPoseBin {
    uint32_t first = 0, second = 0;  // equal if one key-pose is all they need
    uint32_t count = 0;              // of individuals
};

class KeyPoseChoice
{
public:
    // At start-up: allocates. Throws std::bad_alloc.
    KeyPoseChoice(std::pmr::memory_resource *memory, uint32_t pose_count, uint32_t max_bins);

    // Marks at most `capacity` key-poses in `chosen` and returns their number. Remaining room goes to bins that still
    // fit, the fullest first. Ties: held key-poses first, then lower numbers.
    //   bins     [bin_count], at most most_bins; sorted on return
    //   held     by key-pose, 1: already in memory; null: none is
    //   chosen   by key-pose, all 0 on entry
    uint32_t choose(KeyPoseBin *bins, uint32_t bin_count, uint32_t capacity, const uint8_t *held, uint8_t *chosen);

    uint64_t bytes() const { return base::held_bytes(poses_, by_pose_, heap_, served_); }

private:
    struct Pose {
        uint64_t missed = 0;     // served individuals that need it
        uint32_t first_bin = 0;  // in by_pose_
        uint32_t end_bin = 0;
        uint32_t heap_index = 0;  // in heap_
        bool paired = false;      // they all also need one other key-pose, which only they need
    };
    void index(const KeyPoseBin *bins, uint32_t bin_count);
    void drop(const KeyPoseBin *bins, const uint8_t *held);  // drops the key-pose that the fewest would miss
    bool is_paired(const KeyPoseBin *bins, uint32_t pose) const;
    // Moves up the key-poses that now fewer individuals would miss, and updates `paired`.
    void refresh(const KeyPoseBin *bins, uint32_t pose, const uint8_t *held);
    bool goes_before(uint32_t a, uint32_t b, const uint8_t *held) const;
    void sift_up(uint32_t heap_index, const uint8_t *held);
    void sift_down(uint32_t heap_index, const uint8_t *held);
    void put(uint32_t heap_index, uint32_t pose);

    model::Array<Pose> poses_;
    model::Array<uint32_t> by_pose_;  // bins of each
    model::Array<uint32_t> heap_;     // the key-poses still kept, the least missed on top
    model::Array<uint8_t> served_;    // by bin
};

}  // namespace claque::animcache

// Which key-poses are worth keeping (S3 4): those that serve the most individuals, each of whom needs one key-pose or two.
// A set-union knapsack. S3 fills it bin by bin, the fullest first; here it is emptied key-pose by key-pose, the one that the
// fewest individuals would miss first, which comes nearer to the best choice (S3 Fig. 7; tests hold it to 97 %). Of those that
// as many would miss, one goes whose fellow nobody needs then.
#pragma once

#include <cstdint>

#include "lib/model/rig.h"

namespace claque::animcache
{

// Individuals with equal needs (S3 4.2: a temporal bin).
struct KeyPoseBin {
    uint32_t first = 0, second = 0;  // equal where one key-pose is all they need
    uint32_t count = 0;              // of individuals
};

class KeyPoseChoice
{
public:
    // Start-up: it allocates. Throws std::bad_alloc.
    KeyPoseChoice(std::pmr::memory_resource *memory, uint32_t pose_count, uint32_t max_bins);

    // Marks in `chosen` at most `capacity` key-poses, and returns how many. What room is left goes to bins that still fit, the
    // fullest first. Ties: key-poses that are held stay, then lower numbers.
    //   bins     [bin_count], at most most_bins; sorted on return
    //   held     by key-pose, 1: it lies there already; null: none does
    //   chosen   by key-pose, all 0 on entry
    uint32_t choose(KeyPoseBin *bins, uint32_t bin_count, uint32_t capacity, const uint8_t *held, uint8_t *chosen);

private:
    struct Pose {
        uint64_t missed = 0;     // individuals who are served and need it
        uint32_t first_bin = 0;  // in by_pose_
        uint32_t end_bin = 0;
        uint32_t heap_index = 0;  // in heap_
        bool paired = false;      // they all need one other as well, which nobody else does
    };
    void index(const KeyPoseBin *bins, uint32_t bin_count);
    void drop(const KeyPoseBin *bins, const uint8_t *held);  // whom the fewest would miss
    bool is_paired(const KeyPoseBin *bins, uint32_t pose) const;
    // Brings up what fewer would miss, and who is paired by that.
    void refresh(const KeyPoseBin *bins, uint32_t pose, const uint8_t *held);
    bool goes_before(uint32_t a, uint32_t b, const uint8_t *held) const;
    void sift_up(uint32_t heap_index, const uint8_t *held);
    void sift_down(uint32_t heap_index, const uint8_t *held);
    void put(uint32_t heap_index, uint32_t pose);

    model::Array<Pose> poses_;
    model::Array<uint32_t> by_pose_;  // bins of each
    model::Array<uint32_t> heap_;     // poses that are kept so far, whom the fewest would miss on top
    model::Array<uint8_t> served_;    // by bin
};

}  // namespace claque::animcache

// Which key-poses are worth keeping (S3 4): those that serve the most individuals, each of whom needs one key-pose or two.
// A set-union knapsack, solved greedily: bins of individuals with equal needs, the fullest first.
#pragma once

#include <cstdint>

namespace claque::animcache
{

// Individuals with equal needs (S3 4.2: a temporal bin).
struct KeyPoseBin {
    uint32_t first = 0, second = 0;  // equal where one key-pose is all they need
    uint32_t count = 0;              // of individuals
};

// Marks in `chosen` at most `capacity` key-poses, and returns how many. A bin that asks for more than is left over is passed
// by, and a smaller one may still find room (S3 stops there). Ties: fewer poses that are not held, then lower numbers.
//   bins     [bin_count], sorted on return
//   held     by key-pose, 1: it lies there already; null: none does
//   chosen   by key-pose, all 0 on entry
uint32_t choose_key_poses(KeyPoseBin *bins, uint32_t bin_count, uint32_t capacity, const uint8_t *held,
                          uint8_t *chosen);

}  // namespace claque::animcache

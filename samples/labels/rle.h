// Masks as COCO writes them: runs of pixels column by column, in letters.
#pragma once

#include <string>

#include "samples/labels/sample.h"

namespace labels
{

// The lengths of runs of 0 and 1 in turn, beginning with 0, down the columns from the left. `inside`: [width * height],
// rows from the top.
std::vector<uint32_t> runs_of(const std::vector<uint8_t> &inside, int width, int height);
// The same of the pixels with this value, none of which lies outside of the box: the rest is not read.
std::vector<uint32_t> runs_of(const std::vector<uint32_t> &values, uint32_t value, int width, int height,
                              const Box &box);
// COCO's compressed form of runs: five bits a letter, differences to the run before the last from the third on.
std::string letters_of(const std::vector<uint32_t> &runs);

}  // namespace labels

// Which frames, when, and into which files.
#pragma once

#include <string>
#include <vector>

namespace cli
{

struct FrameRange {
    int first = 0, last = 0, stride = 1;  // last is one of them, where the stride falls on it
};

// "A:B" with 0 <= A <= B. Returns a sentence where it is none, else "".
std::string read_range(const std::string &text, FrameRange &range);
std::vector<int> frames_of(const FrameRange &range);

// True where `pattern` has exactly one place for a number, like %05d, and no other %.
bool is_frame_pattern(const std::string &pattern);
std::string frame_path(const std::string &pattern, int frame);

}  // namespace cli

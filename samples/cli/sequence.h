// The frames of a sequence: their numbers, times and files.
#pragma once

#include <string>
#include <vector>

namespace cli
{

struct FrameRange {
    int first = 0, last = 0, stride = 1;  // last is included where the stride reaches it
};

// Parses "A:B" with 0 <= A <= B. Returns "" or an error message.
std::string read_range(const std::string &text, FrameRange &range);
std::vector<int> frames_of(const FrameRange &range);

// Parses a list of frames and of ranges, these with a stride if they have one: "0:99,120,200:240/4". Frames keep their
// order; none may be named twice. Returns "" or an error message.
std::string read_frames(const std::string &text, std::vector<int> &frames);

// Parses "3/40", share 3 of 40, of which the first is 0. Returns "" or an error message.
std::string read_share(const std::string &text, int &index, int &count);
// The frames of share `index` of `count` shares that are as large as each other, but for one frame.
std::vector<int> chunk_of(const std::vector<int> &frames, int index, int count);

// Returns true if `pattern` has exactly one place for a number, like %05d, and no other %.
bool is_frame_pattern(const std::string &pattern);
std::string frame_path(const std::string &pattern, int frame);

}  // namespace cli

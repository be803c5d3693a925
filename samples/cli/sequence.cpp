#include "samples/cli/sequence.h"

namespace cli
{
namespace
{

constexpr int last_frame = 999999999;

bool read_number(const std::string &text, int &number)
{
    if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) return false;
    number = std::stoi(text);
    return number <= last_frame;
}

struct Pattern {
    size_t first = std::string::npos, after = 0;
    size_t width = 0;
    bool zeros = false;
};

Pattern find_pattern(const std::string &text)
{
    Pattern p;
    const size_t percent = text.find('%');
    if (percent == std::string::npos || text.find('%', percent + 1) != std::string::npos) return {};
    size_t at = percent + 1;
    p.zeros = at < text.size() && text[at] == '0';
    while (at < text.size() && text[at] >= '0' && text[at] <= '9' && p.width <= 20)
        p.width = 10 * p.width + static_cast<size_t>(text[at++] - '0');
    if (at >= text.size() || text[at] != 'd' || p.width > 20) return {};
    p.first = percent;
    p.after = at + 1;
    return p;
}

}  // namespace

std::string read_range(const std::string &text, FrameRange &range)
{
    const size_t colon = text.find(':');
    if (colon == std::string::npos || !read_number(text.substr(0, colon), range.first) ||
        !read_number(text.substr(colon + 1), range.last) || range.first > range.last)
        return "'" + text + "' is not a range like 0:99, first to last";
    return {};
}

std::vector<int> frames_of(const FrameRange &range)
{
    std::vector<int> frames;
    for (long long frame = range.first; frame <= range.last; frame += range.stride)
        frames.push_back(static_cast<int>(frame));
    return frames;
}

bool is_frame_pattern(const std::string &pattern) { return find_pattern(pattern).first != std::string::npos; }

std::string frame_path(const std::string &pattern, int frame)
{
    const Pattern p = find_pattern(pattern);
    if (p.first == std::string::npos) return pattern;
    std::string number = std::to_string(frame);
    if (number.size() < p.width) number.insert(0, p.width - number.size(), p.zeros ? '0' : ' ');
    return pattern.substr(0, p.first) + number + pattern.substr(p.after);
}

}  // namespace cli

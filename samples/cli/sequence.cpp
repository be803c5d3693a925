#include "samples/cli/sequence.h"

#include <algorithm>
#include <cstdio>
#include <set>

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

std::string read_frames(const std::string &text, std::vector<int> &frames)
{
    constexpr size_t most_frames = 10000000;
    std::set<int> named;
    frames.clear();
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size()), slash = text.find('/', begin);
        const std::string one = text.substr(begin, std::min(slash, end) - begin);
        FrameRange range;
        if (slash < end && (!read_number(text.substr(slash + 1, end - slash - 1), range.stride) || range.stride < 1))
            return "'" + text + "': a stride is a number from 1, as in 0:99/4";
        if (one.find(':') != std::string::npos) {
            const std::string wrong = read_range(one, range);
            if (!wrong.empty()) return wrong;
        } else if (!read_number(one, range.first) || slash < end) {
            return "'" + text + "' is not a list of frames like 0:99,120,200:240/4";
        } else {
            range.last = range.first;
        }
        if (size_t(range.last - range.first) / size_t(range.stride) + frames.size() > most_frames)
            return "'" + text + "' has more than " + std::to_string(most_frames) + " frames";
        for (const int frame : frames_of(range)) {
            if (!named.insert(frame).second) return "'" + text + "' names frame " + std::to_string(frame) + " twice";
            frames.push_back(frame);
        }
        begin = end + 1;
    }
    return {};
}

std::string read_share(const std::string &text, int &index, int &count)
{
    int read = 0;
    if (std::sscanf(text.c_str(), "%d/%d%n", &index, &count, &read) == 2 && static_cast<size_t>(read) == text.size() &&
        count >= 1 && index >= 0 && index < count)
        return "";
    return "'" + text + "' is not a share like 3/40, from 0/40 to 39/40";
}

std::vector<int> chunk_of(const std::vector<int> &frames, int index, int count)
{
    const auto at = [&](int k) { return static_cast<ptrdiff_t>(frames.size() * size_t(k) / size_t(count)); };
    return {frames.begin() + at(index), frames.begin() + at(index + 1)};
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

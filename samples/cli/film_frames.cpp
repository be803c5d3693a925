#include "samples/cli/film_frames.h"

#include "samples/io/png.h"

namespace cli
{

std::vector<Frame> planned_frames(const RenderArguments &a, const scenes::SceneOptions &options)
{
    if (a.frames.empty()) return {{-1, a.time_s, a.out}};
    std::vector<Frame> frames;
    FrameRange range = a.range;
    if (a.whole_path) range.last = static_cast<int>(options.path->end_s() * a.fps);
    std::vector<int> numbers;
    for (size_t i = 0; i < a.list.size(); i += static_cast<size_t>(a.range.stride)) numbers.push_back(a.list[i]);
    if (a.list.empty()) numbers = frames_of(range);
    for (int number : chunk_of(numbers, a.chunk, a.chunk_count))
        frames.push_back({number, number / a.fps, frame_path(a.out, number)});
    return frames;
}

bool is_finished(const RenderArguments &a, const Frame &frame)
{
    return frame.number >= 0 && !a.again && frame.path != "-" &&
           io::is_whole_png(frame.path, a.setup.width, a.setup.height);
}

}  // namespace cli

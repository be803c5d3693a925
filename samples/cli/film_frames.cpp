#include "samples/cli/film_frames.h"

#include "samples/cli/scene_about.h"
#include "samples/io/json.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

// Frames of other rates have other numbers, not other pictures.
Json settings_of(const RenderArguments &a, const Frame &frame)
{
    Json settings = a.scene;
    settings.erase("fps");
    settings["time_s"] = frame.time_s;
    return settings;
}

}  // namespace

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

std::string frame_settings(const RenderArguments &a, const Frame &frame)
{
    if (a.scene.is_null() || frame.number < 0) return {};
    return settings_of(a, frame).dump(-1, ' ', true, Json::error_handler_t::replace);
}

bool is_finished(const RenderArguments &a, const Frame &frame)
{
    if (frame.number < 0 || a.again || frame.path == "-" || !io::is_whole_png(frame.path)) return false;
    const std::string there = io::text_in_png(frame.path, settings_keyword), here = frame_settings(a, frame);
    if (there == here) return true;
    std::string problem;
    const Json read = io::parse_json<Json>(there, problem);
    throw scenes::Failure(frame.path +
                          (problem.empty() && read.is_object()
                               ? " is a picture of other settings: " + difference(read, settings_of(a, frame))
                               : std::string(" is a picture that does not say how it was drawn")) +
                          "; choose another --out, or draw all anew with --again");
}

}  // namespace cli

#include "samples/cli/frame_worker.h"

#include <cstring>

#include "samples/cli/frame_division.h"
#include "samples/cli/provenance.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

Frame frame_of(const Json &task) { return {task["number"], task["time_s"], task["bare"].get<bool>() ? "-" : ""}; }

}  // namespace

FrameWorker::FrameWorker(const RenderArguments &a, int threads, uint8_t *pages, processes::Ranks *ranks)
    : drawer_(a, threads, ranks), pages_(pages), place_bytes_(place_bytes(a)), is_rank_(ranks != nullptr)
{
}

processes::Reply FrameWorker::answer(const Json &task)
{
    if (task["task"] == "frame") return draw_frame(frame_of(task), task["at"]);
    if (task["task"] == "tile") return draw_tile(task);
    const Subject &subject = drawer_.subject();
    Json told = {{"count", subject.count}, {"context", subject.context}, {"warnings", drawer_.warnings()}};
    if (is_rank_) told["provenance"] = provenance(subject.context);
    return told.dump();
}

processes::Reply FrameWorker::draw_frame(const Frame &frame, size_t at)
{
    Json report;
    const std::vector<uint8_t> &rgb = drawer_.draw(frame, report);
    drawer_.add_hashes(rgb, report);
    const std::vector<unsigned char> file =
        frame_bytes(drawer_.arguments(), frame, rgb.data(), drawer_.options(), drawer_.subject());
    if (file.size() > place_bytes_) throw scenes::Failure("a picture takes more memory than processes share");
    std::copy(file.begin(), file.end(), pages_ + at);
    return {Json{{"report", report}, {"bytes", file.size()}}.dump(), {at, file.size(), 1, 0}};
}

processes::Reply FrameWorker::draw_tile(const Json &task)
{
    const processes::Tile tile = {task["x0"], task["x1"]};
    drawer_.subject();
    const Stopwatch spent(Stopwatch::Clock::processor);
    Json report;
    const std::vector<uint8_t> &rgb = drawer_.draw(frame_of(task), tile, report);
    const double spent_ms = spent.ms();
    const size_t width = static_cast<size_t>(drawer_.options().width), own = 3 * static_cast<size_t>(tile.x1 - tile.x0);
    const processes::Pixels place = {task["at"].get<size_t>() + 3 * static_cast<size_t>(tile.x0), own, rgb.size() / own,
                                     3 * width};
    for (size_t y = 0; y < place.rows; ++y)
        std::memcpy(pages_ + place.at + place.stride * y, rgb.data() + own * y, own);
    return {Json{{"x_px", tile.x0},
                 {"width_px", tile.x1 - tile.x0},
                 {"cpu_ms", spent_ms},
                 {"update_ms", report["update_ms"]},
                 {"environment_ms", report["environment_ms"]},
                 {"draw_ms", report["draw_ms"]},
                 {"drawn", report["drawn"]}}
                .dump(),
            place};
}

}  // namespace cli

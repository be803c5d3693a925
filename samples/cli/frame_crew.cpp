#include "samples/cli/frame_crew.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <optional>

#include "samples/cli/provenance.h"
#include "samples/cli/stopwatch.h"
#include "samples/processes/crew.h"
#include "samples/processes/machine_share.h"
#include "samples/processes/shared_pages.h"

namespace cli
{
namespace
{

double cpu_ms()
{
    timespec now = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

// What the processes share: in a job of a scheduler its cores alone.
int shared_cores() { return is_scheduled() ? processes::scheduled_cores() : core_count(); }

// A PNG may be a little larger than its pixels.
size_t frame_capacity(const RenderArguments &a)
{
    const size_t pixels = (3 * static_cast<size_t>(a.setup.width) + 1) * static_cast<size_t>(a.setup.height);
    return pixels + pixels / 64 + 65536;
}

size_t picture_bytes(const RenderArguments &a)
{
    return 3 * static_cast<size_t>(a.setup.width) * static_cast<size_t>(a.setup.height);
}

Frame frame_of(const Json &task) { return {task["number"], task["time_s"], task["bare"].get<bool>() ? "-" : ""}; }

Json task_of(const char *kind, const Frame &frame)
{
    return {{"task", kind}, {"number", frame.number}, {"time_s", frame.time_s}, {"bare", frame.path == "-"}};
}

// A worker of a crew: it draws into memory that the coordinator reads.
class FrameWorker
{
public:
    FrameWorker(const RenderArguments &a, int threads, uint8_t *pages, size_t capacity)
        : drawer_(a, threads), pages_(pages), capacity_(capacity)
    {
    }

    Json answer(const Json &task)
    {
        if (task["task"] == "frame") return draw_frame(frame_of(task));
        if (task["task"] == "tile") return draw_tile(task);
        const Subject &subject = drawer_.subject();
        return {{"count", subject.count}, {"context", subject.context}, {"warnings", drawer_.warnings()}};
    }

private:
    Json draw_frame(const Frame &frame)
    {
        Json report;
        const std::vector<uint8_t> &rgb = drawer_.draw(frame, report);
        drawer_.add_hashes(rgb, report);
        const std::vector<unsigned char> file = frame_bytes(frame, rgb.data(), drawer_.options(), drawer_.subject());
        if (file.size() > capacity_) throw scenes::Failure("a picture takes more memory than processes share");
        std::copy(file.begin(), file.end(), pages_);
        return {{"report", report}, {"bytes", file.size()}};
    }

    Json draw_tile(const Json &task)
    {
        const processes::Tile tile = {task["x0"], task["x1"]};
        drawer_.subject();
        const double begun_ms = cpu_ms();
        Json report;
        const std::vector<uint8_t> &rgb = drawer_.draw(frame_of(task), tile, report);
        const double spent_ms = cpu_ms() - begun_ms;
        const size_t width = static_cast<size_t>(drawer_.options().width),
                     own = 3 * static_cast<size_t>(tile.x1 - tile.x0);
        uint8_t *out = pages_ + task["at"].get<size_t>() + 3 * static_cast<size_t>(tile.x0);
        for (size_t y = 0; own * y < rgb.size(); ++y) std::memcpy(out + 3 * width * y, rgb.data() + own * y, own);
        return {{"x_px", tile.x0},
                {"width_px", tile.x1 - tile.x0},
                {"cpu_ms", spent_ms},
                {"update_ms", report["update_ms"]},
                {"environment_ms", report["environment_ms"]},
                {"draw_ms", report["draw_ms"]},
                {"drawn", report["drawn"]}};
    }

    FrameDrawer drawer_;
    uint8_t *pages_;
    size_t capacity_;
};

}  // namespace

int process_count(const RenderArguments &a)
{
    return a.processes > 0 ? a.processes : is_scheduled() ? processes::scheduled_cores() : 1;
}

int threads_each(const RenderArguments &a)
{
    const int count = process_count(a);
    if (a.setup.threads > 0 || count == 1) return thread_count(a.setup);
    return std::max(1, shared_cores() / count);
}

Division division_of(const RenderArguments &a)
{
    if (a.divide.empty()) return a.frames.empty() ? Division::tiles : Division::frames;
    return a.divide == "tiles" ? Division::tiles : Division::frames;
}

struct FrameCrew::State {
    State(const RenderArguments &a, uint32_t count)
        : arguments(a),
          division(division_of(a)),
          stride(division == Division::frames ? frame_capacity(a) : picture_bytes(a)),
          pages(stride * (division == Division::frames ? count : 2)),
          crew_size(count),
          threads(threads_each(a)),
          borders(a.setup.width, static_cast<int>(count)),
          crew(count, [this](uint32_t worker) { return start(worker); })
    {
    }

    processes::Crew::Answering start(uint32_t worker)
    {
        processes::share_mesa_threads(static_cast<int>(crew_size), shared_cores());
        uint8_t *own = pages.data() + (division == Division::frames ? stride * worker : 0);
        const auto made = std::make_shared<FrameWorker>(arguments, threads, own, stride);
        return [made](const std::string &task) { return made->answer(Json::parse(task)).dump(); };
    }

    void draw_frames(const std::vector<Frame> &frames, const Done &done);
    void draw_tiles(const std::vector<Frame> &frames, const Done &done);
    Json finish_tiles(const std::vector<Frame> &frames, size_t index);

    const RenderArguments &arguments;
    Division division;
    size_t stride;  // bytes of a worker's share of the pages, or of a picture
    processes::SharedPages pages;
    uint32_t crew_size;
    int threads;
    std::optional<Subject> subject;
    std::vector<std::string> warnings;
    processes::TileBorders borders;
    processes::Crew crew;
};

FrameCrew::FrameCrew(const RenderArguments &arguments)
    : state_(std::make_unique<State>(arguments, static_cast<uint32_t>(process_count(arguments))))
{
}

FrameCrew::~FrameCrew() = default;

const Subject &FrameCrew::subject()
{
    State &s = *state_;
    if (s.subject) return *s.subject;
    for (uint32_t i = 0; i < s.crew.size(); ++i) s.crew.send(i, R"({"task":"subject"})");
    for (uint32_t i = 0; i < s.crew.size(); ++i) {
        const Json told = Json::parse(s.crew.wait().text);
        s.subject = Subject{told["count"], told["context"]};
        s.warnings = told["warnings"].get<std::vector<std::string>>();
    }
    return *s.subject;
}

void FrameCrew::draw(const std::vector<Frame> &frames, const Done &done)
{
    if (frames.empty()) return;
    if (state_->division == Division::frames) return state_->draw_frames(frames, done);
    subject();
    state_->draw_tiles(frames, done);
}

// Each process draws the next frame that none has. Frames for standard output wait in their worker's memory until
// those before them are written.
void FrameCrew::State::draw_frames(const std::vector<Frame> &frames, const Done &done)
{
    struct Held {
        size_t index;
        Json answer;
    };
    std::vector<std::optional<Held>> held(crew.size());
    std::vector<size_t> drawing(crew.size());
    size_t next = 0, written = 0;
    const auto give = [&](uint32_t worker) {
        if (next == frames.size()) return;
        drawing[worker] = next;
        crew.send(worker, task_of("frame", frames[next]).dump());
        ++next;
    };
    const bool in_order = frames[0].path == "-";
    for (uint32_t i = 0; i < crew.size(); ++i) give(i);
    while (written < frames.size()) {
        const processes::Crew::Answer answer = crew.wait();
        held[answer.worker] = Held{drawing[answer.worker], Json::parse(answer.text)};
        for (uint32_t i = 0; i < crew.size();) {
            if (!held[i] || (in_order && held[i]->index != written)) {
                ++i;
                continue;
            }
            const Held one = *std::exchange(held[i], {});
            Json report = frame_report(frames[one.index]);
            report.update(one.answer["report"]);
            done(one.index, report, pages.data() + stride * i, one.answer["bytes"]);
            ++written;
            give(i);
            i = 0;  // the one after it may wait already
        }
    }
}

// The pictures take turns in two places, so that one is written while the next is drawn.
void FrameCrew::State::draw_tiles(const std::vector<Frame> &frames, const Done &done)
{
    LoadedCharacter none;
    const scenes::SceneOptions options = scene_options(arguments.setup, none);
    Stopwatch drawing;
    const auto give = [&](size_t index) {
        drawing = Stopwatch();
        for (uint32_t i = 0; i < borders.tiles().size(); ++i) {
            Json task = task_of("tile", frames[index]);
            task["x0"] = borders.tiles()[i].x0, task["x1"] = borders.tiles()[i].x1;
            task["at"] = index % 2 * stride;
            crew.send(i, task.dump());
        }
    };
    give(0);
    for (size_t index = 0; index < frames.size(); ++index) {
        Json report = finish_tiles(frames, index);
        report["wall_ms"] = drawing.ms();
        if (index + 1 < frames.size()) give(index + 1);
        const uint8_t *rgb = pages.data() + index % 2 * stride;
        report["picture_hash"] = hex(scenes::hash_of(rgb, stride));
        const std::vector<unsigned char> bytes = frame_bytes(frames[index], rgb, options, *subject);
        done(index, report, bytes.data(), bytes.size());
    }
}

Json FrameCrew::State::finish_tiles(const std::vector<Frame> &frames, size_t index)
{
    Json report = frame_report(frames[index]);
    std::vector<Json> tiles(borders.tiles().size());
    std::vector<double> costs(tiles.size());
    for (size_t i = 0; i < tiles.size(); ++i) {
        const processes::Crew::Answer answer = crew.wait();
        tiles[answer.worker] = Json::parse(answer.text);
        costs[answer.worker] = tiles[answer.worker]["cpu_ms"];
    }
    borders.follow(costs);
    report["picture_hash"] = nullptr;
    report["tiles"] = tiles;
    return report;
}

uint32_t FrameCrew::replaced() const { return state_->crew.replaced(); }

const std::vector<std::string> &FrameCrew::warnings() const { return state_->warnings; }

}  // namespace cli

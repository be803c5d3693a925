#include "samples/cli/frame_crew.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include "samples/cli/frame_division.h"
#include "samples/cli/frame_worker.h"
#include "samples/cli/stopwatch.h"
#include "samples/processes/crew.h"
#include "samples/processes/machine_share.h"
#include "samples/processes/rank_team.h"
#include "samples/processes/shared_pages.h"

namespace cli
{
namespace
{

Json task_of(const char *kind, const Frame &frame)
{
    return {{"task", kind}, {"number", frame.number}, {"time_s", frame.time_s}, {"bare", frame.path == "-"}};
}

// What pixels depend on must be one and the same, as in the jobs of a film (docs/films.md).
void expect_same_pixels(std::optional<Json> &first, const Json &now, uint32_t worker)
{
    if (!first) first = now;
    for (const auto &[key, value] : first->items())
        if (now[key] != value)
            throw scenes::Failure("rank " + std::to_string(worker) + " would draw other pixels: its " + key + " is " +
                                  now[key].dump() + ", another one's is " + value.dump() +
                                  (key == "processor" ? "; --portable makes processors alike" : ""));
}

// All ranks have as many.
size_t bytes_of_places(const RenderArguments &a, const processes::Ranks &ranks)
{
    return place_bytes(a) * place_count(a, static_cast<uint32_t>(ranks.count()), processes::RankTeam::tasks_each);
}

int cores_each(const RenderArguments &a, const processes::Ranks *ranks)
{
    if (ranks) return processes::cores_of_rank(ranks->count(), ranks->count_here(), core_count());
    return processes::cores_of_worker(process_count(a), core_count());
}

// Made in the process that draws. `ranks`: those of the job, or null.
processes::Answering answering_of(const RenderArguments &a, uint8_t *pages, processes::Ranks *ranks)
{
    processes::take_mesa_threads(cores_each(a, ranks));
    const auto made = std::make_shared<FrameWorker>(a, threads_each(a, ranks), pages, ranks);
    return [made](const std::string &task) { return made->answer(Json::parse(task)); };
}

}  // namespace

int process_count(const RenderArguments &a)
{
    if (processes::ranks_started() > 1) return processes::ranks_started();
    return a.processes > 0 ? a.processes : processes::is_scheduled() ? processes::scheduled_cores() : 1;
}

int threads_each(const RenderArguments &a, const processes::Ranks *ranks)
{
    return a.setup.threads > 0 || process_count(a) == 1 ? thread_count(a.setup) : cores_each(a, ranks);
}

struct FrameCrew::State {
    explicit State(const RenderArguments &a)
        : arguments(a),
          stride(place_bytes(a)),
          pages(stride * place_count(a, static_cast<uint32_t>(process_count(a)), 1)),
          borders(a.setup.width, process_count(a))
    {
        team = std::make_unique<processes::Crew>(static_cast<uint32_t>(process_count(a)), [this](uint32_t) {
            return answering_of(arguments, pages.data(), nullptr);
        });
    }
    State(const RenderArguments &a, processes::Ranks &ranks)
        : arguments(a),
          stride(place_bytes(a)),
          pages(bytes_of_places(a, ranks)),
          borders(a.setup.width, ranks.count()),
          team(std::make_unique<processes::RankTeam>(ranks, answering_of(a, pages.data(), &ranks), pages.data()))
    {
    }

    void draw_frames(const std::vector<Frame> &frames, const Done &done);
    void draw_tiles(const std::vector<Frame> &frames, const Done &done);
    Json finish_tiles(const std::vector<Frame> &frames, size_t index);

    const RenderArguments &arguments;
    size_t stride;  // bytes of a place in the pages
    processes::SharedPages pages;
    std::optional<Subject> subject;
    std::vector<std::string> warnings;
    processes::TileBorders borders;
    std::unique_ptr<processes::Team> team;
};

FrameCrew::FrameCrew(const RenderArguments &arguments, processes::Ranks *ranks)
    : state_(ranks ? std::make_unique<State>(arguments, *ranks) : std::make_unique<State>(arguments))
{
}

void FrameCrew::serve(const RenderArguments &a, processes::Ranks &ranks)
{
    std::vector<uint8_t> pages(bytes_of_places(a, ranks));
    processes::serve(ranks, answering_of(a, pages.data(), &ranks), pages.data());
}

FrameCrew::~FrameCrew() = default;

const Subject &FrameCrew::subject()
{
    State &s = *state_;
    if (s.subject) return *s.subject;
    for (uint32_t i = 0; i < s.team->size(); ++i) s.team->send(i, R"({"task":"subject"})");
    std::optional<Json> first;
    for (uint32_t i = 0; i < s.team->size(); ++i) {
        const processes::Team::Answer answer = s.team->wait();
        const Json told = Json::parse(answer.text);
        if (told.contains("provenance")) expect_same_pixels(first, told["provenance"], answer.worker);
        s.subject = Subject{told["count"], told["context"]};
        s.warnings = told["warnings"].get<std::vector<std::string>>();
    }
    return *s.subject;
}

void FrameCrew::draw(const std::vector<Frame> &frames, const Done &done)
{
    if (frames.empty()) return;
    if (division_of(state_->arguments) == Division::frames) return state_->draw_frames(frames, done);
    subject();
    state_->draw_tiles(frames, done);
}

// Each worker draws the next frame that none has. Frames for standard output wait in their places until those before
// them are written.
void FrameCrew::State::draw_frames(const std::vector<Frame> &frames, const Done &done)
{
    struct Given {
        size_t index, at;
    };
    struct Held {
        uint32_t worker;
        size_t at;
        Json answer;
    };
    std::vector<std::deque<Given>> given(team->size());
    std::map<size_t, Held> held;  // by frame
    size_t next = 0, written = 0;
    const auto give = [&](uint32_t worker, size_t at) {
        if (next == frames.size()) return;
        Json task = task_of("frame", frames[next]);
        task["at"] = at;
        given[worker].push_back({next++, at});
        team->send(worker, task.dump());
    };
    for (uint32_t slot = 0; slot < team->depth(); ++slot)
        for (uint32_t i = 0; i < team->size(); ++i) give(i, stride * (size_t(slot) * team->size() + i));
    const bool in_order = frames[0].path == "-";
    while (written < frames.size()) {
        const processes::Team::Answer answer = team->wait();
        const Given one = given[answer.worker].front();
        given[answer.worker].pop_front();
        held[one.index] = {answer.worker, one.at, Json::parse(answer.text)};
        while (!held.empty() && (!in_order || held.begin()->first == written)) {
            const auto [index, frame] = *held.begin();
            Json report = frame_report(frames[index]);
            report.update(frame.answer["report"]);
            done(index, report, pages.data() + frame.at, frame.answer["bytes"]);
            ++written;
            held.erase(held.begin());
            give(frame.worker, frame.at);
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
            team->send(i, task.dump());
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
        const processes::Team::Answer answer = team->wait();
        tiles[answer.worker] = Json::parse(answer.text);
        costs[answer.worker] = tiles[answer.worker]["cpu_ms"];
    }
    borders.follow(costs);
    report["picture_hash"] = nullptr;
    report["tiles"] = tiles;
    return report;
}

uint32_t FrameCrew::replaced() const { return state_->team->replaced(); }

const std::vector<std::string> &FrameCrew::warnings() const { return state_->warnings; }

}  // namespace cli

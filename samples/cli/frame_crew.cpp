#include "samples/cli/frame_crew.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include "samples/cli/frame_division.h"
#include "samples/cli/frame_worker.h"
#include "samples/cli/message.h"
#include "samples/cli/stopwatch.h"
#include "samples/cli/work_share.h"
#include "samples/processes/frame_shares.h"
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

// All processes of a run have as many.
size_t bytes_of_places(const RenderArguments &a, const processes::Ranks *ranks)
{
    return place_bytes(a) * place_count(a, static_cast<uint32_t>(process_count(a.processes)),
                                        ranks ? processes::RankTeam::tasks_each : 1);
}

MakeAnswering answering_by(const RenderArguments &a, uint8_t *pages, processes::Ranks *ranks)
{
    return [&a, pages, ranks](int threads) -> processes::Answering {
        const auto made = std::make_shared<FrameWorker>(a, threads, pages, ranks);
        return [made](const std::string &task) { return made->answer(message_of<Json>(task)); };
    };
}

}  // namespace

struct FrameCrew::State {
    State(const RenderArguments &a, processes::Ranks *ranks)
        : arguments(a),
          stride(place_bytes(a)),
          pages(bytes_of_places(a, ranks)),
          borders(a.setup.width, process_count(a.processes)),
          team(make_team(a.setup, a.processes, ranks, pages.data(), answering_by(a, pages.data(), ranks)))
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
    : state_(std::make_unique<State>(arguments, ranks))
{
}

void FrameCrew::serve(const RenderArguments &a, processes::Ranks &ranks)
{
    std::vector<uint8_t> pages(bytes_of_places(a, &ranks));
    serve_team(a.setup, ranks, pages.data(), answering_by(a, pages.data(), &ranks));
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
        const Json told = message_of<Json>(answer.text);
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

// Each worker draws a share of frames that follow each other. Those for standard output are drawn in their order, and
// wait in their places until those before them are written.
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
    const bool in_order = frames[0].path == "-";
    processes::FrameShares shares(frames.size(), team->size(), in_order);
    size_t written = 0;
    const auto give = [&](uint32_t worker, size_t at) {
        const std::optional<size_t> next = shares.next(worker);
        if (!next) return;
        Json task = task_of("frame", frames[*next]);
        task["at"] = at;
        given[worker].push_back({*next, at});
        team->send(worker, task.dump());
    };
    for (uint32_t slot = 0; slot < team->depth(); ++slot)
        for (uint32_t i = 0; i < team->size(); ++i) give(i, stride * (size_t(slot) * team->size() + i));
    while (written < frames.size()) {
        const processes::Team::Answer answer = team->wait();
        const Given one = given[answer.worker].front();
        given[answer.worker].pop_front();
        held[one.index] = {answer.worker, one.at, message_of<Json>(answer.text)};
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
        const std::vector<unsigned char> bytes = frame_bytes(arguments, frames[index], rgb, options, *subject);
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
        tiles[answer.worker] = message_of<Json>(answer.text);
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

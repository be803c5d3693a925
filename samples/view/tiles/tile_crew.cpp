#include "samples/view/tiles/tile_crew.h"

#include <algorithm>

namespace view::tiles
{
namespace
{

// A window of a screen may grow; memory is taken when it is first written.
constexpr int grown_width = 2560, grown_height = 1600;

bool may_grow(const Request &request) { return request.script_file.empty() && !request.serve; }

size_t bytes_of(int width, int height) { return 3 * static_cast<size_t>(width) * static_cast<size_t>(height); }

}  // namespace

TileCrew::TileCrew(const Request &request)
    : width_(may_grow(request) ? std::max(request.width, grown_width) : request.width),
      height_(may_grow(request) ? std::max(request.height, grown_height) : request.height),
      pages_(bytes_of(width_, height_)),
      borders_(request.width, request.processes),
      divided_px_(request.width),
      crew_(
          static_cast<uint32_t>(borders_.tiles().size()),
          [this, &request](uint32_t) {
              const auto player = std::make_shared<TilePlayer>(request, Canvas{pages_.data(), width_, height_});
              return [player](const std::string &task) { return player->answer(task); };
          },
          processes::Crew::Ends::told)
{
    tell(Task());
}

std::vector<uint32_t> TileCrew::there() const
{
    std::vector<uint32_t> found;
    for (uint32_t i = 0; i < crew_.size(); ++i)
        if (crew_.is_there(i)) found.push_back(i);
    return found;
}

void TileCrew::tell(const Task &task)
{
    for (const uint32_t worker : there()) crew_.send(worker, text_of(task)), ++asked_;
}

void TileCrew::lose(uint32_t worker)
{
    crew_.dismiss(worker);
    ++lost_;
}

void TileCrew::divide(int width_px)
{
    const auto count = static_cast<int>(there().size());
    if (count == 0 || (width_px == divided_px_ && static_cast<size_t>(count) == borders_.tiles().size())) return;
    borders_ = processes::TileBorders(width_px, count);
    divided_px_ = width_px;
}

void TileCrew::begin(const Input &input, const Model &model)
{
    // What was asked before the frame, as to load.
    for (; asked_ > 0; --asked_)
        if (const auto answer = crew_.wait(); answer.ended) lose(answer.worker);
    divide(divided_px_);
    Task task;
    task.kind = Task::Kind::frame, task.of_px = divided_px_, task.film = model.film, task.input = input;
    drawing_ = there();
    for (size_t k = 0; k < drawing_.size(); ++k) {
        // More processes than columns: the last ones draw the same.
        task.tile = borders_.tiles()[std::min(k, borders_.tiles().size() - 1)];
        crew_.send(drawing_[k], text_of(task)), ++asked_;
    }
}

void TileCrew::paint(World &world, Model &model, uint64_t fingerprint)
{
    std::vector<double> costs(drawing_.size());
    clq_draw_stats sum = clq_draw_stats_init();
    bool whole = asked_ > 0;
    for (; asked_ > 0; --asked_) {
        const processes::Team::Answer answer = crew_.wait();
        const Done done = answer.ended ? Done() : done_of(answer.text);
        if (done.fingerprint != fingerprint) lose(answer.worker);
        whole = whole && done.drawn && done.fingerprint == fingerprint;
        const auto tile = std::find(drawing_.begin(), drawing_.end(), answer.worker) - drawing_.begin();
        costs[static_cast<size_t>(tile)] = done.cpu_ms;
        sum.individuals += done.stats.individuals, sum.draws += done.stats.draws;
        sum.triangles += done.stats.triangles, sum.vertices += done.stats.vertices;
    }
    if (whole) {
        world.put(pages_.data(), width_);
        model.cost.drawn = sum;
        borders_.follow(costs);
    } else world.draw(model);
    divide(world.width());
}

void TileCrew::renew()
{
    Task task;
    task.kind = Task::Kind::renew;
    tell(task);
}

}  // namespace view::tiles

#include "samples/hosts/tiles/tiled_picture.h"

#include <algorithm>
#include <ctime>
#include <memory>
#include <sstream>

#include "samples/hosts/multichannel/channel.h"
#include "samples/hosts/multichannel/wall.h"

namespace tiles
{
namespace
{

// What one process has: all of the scene, and a channel for its tile.
struct Worker {
    scenes::Library library{1};
    multichannel::People people{library};
    multichannel::Forum forum;
    std::unique_ptr<multichannel::Channel> channel;
};

double processor_s()
{
    timespec now = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

TiledPicture::TiledPicture(int width, int height, int processes)
    : width_(width),
      height_(height),
      pixels_(3 * static_cast<size_t>(width) * static_cast<size_t>(height)),
      borders_(width, processes),
      crew_(static_cast<uint32_t>(borders_.tiles().size()), [this](uint32_t) { return start(); })
{
}

// Runs in a worker. A task is a tile and a time; the answer is the processor time that it took.
processes::Answering TiledPicture::start() const
{
    const auto worker = std::make_shared<Worker>();
    return [this, worker](const std::string &task) {
        std::istringstream words(task);
        processes::Tile tile = {};
        double time_s = 0;
        words >> tile.x0 >> tile.x1 >> time_s;
        if (!worker->channel)
            worker->channel = std::make_unique<multichannel::Channel>(worker->library, worker->people, worker->forum,
                                                                      multichannel::Pane{width_, 0, width_, height_});
        worker->channel->show_columns(tile.x0, tile.x1 - tile.x0);
        const double begun_s = processor_s();
        const double eye[3] = {0, 2.3, 0}, target[3] = {0, 2.3, -1};
        const multichannel::Wall wall(0.9, 0.9 * height_ / width_, 0.25, 400);
        worker->people.place(time_s);
        worker->channel->set_camera(wall.camera(eye, target, 0, multichannel::Wall::columns));
        clq_view *views[] = {worker->channel->view()};
        scenes::check(clq_crowd_update(worker->people.crowd(), time_s, views, 1));
        const std::vector<uint8_t> &rgb = worker->channel->draw();
        const size_t row = 3 * static_cast<size_t>(tile.x1 - tile.x0), whole = 3 * static_cast<size_t>(width_);
        for (size_t y = 0; y < static_cast<size_t>(height_); ++y)
            std::copy_n(rgb.data() + y * row, row, pixels_.data() + y * whole + 3 * static_cast<size_t>(tile.x0));
        return std::to_string(processor_s() - begun_s);
    };
}

const uint8_t *TiledPicture::show(double time_s)
{
    drawn_ = borders_.tiles();
    for (uint32_t i = 0; i < drawn_.size(); ++i) {
        std::ostringstream task;
        task.precision(17);
        task << drawn_[i].x0 << ' ' << drawn_[i].x1 << ' ' << time_s;
        crew_.send(i, task.str());
    }
    std::vector<double> costs(drawn_.size());
    for (size_t i = 0; i < drawn_.size(); ++i) {
        const processes::Crew::Answer answer = crew_.wait();
        costs[answer.worker] = std::stod(answer.text);
    }
    borders_.follow(costs);
    return pixels_.data();
}

}  // namespace tiles

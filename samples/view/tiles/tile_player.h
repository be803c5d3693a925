// A process that plays the session of a window from the same inputs, and draws a tile of its picture.
#pragma once

#include <memory>
#include <optional>

#include "samples/processes/team.h"
#include "samples/view/session.h"
#include "samples/view/tiles/task.h"
#include "samples/view/view.h"

namespace view::tiles
{

// The memory that a picture is drawn into: rows of three bytes a pixel, the lowest first.
struct Canvas {
    uint8_t *rgb;
    int width, height;
};

class TilePlayer
{
public:
    // `request` must live as long as this.
    TilePlayer(const Request &request, const Canvas &canvas) : request_(request), canvas_(canvas) {}

    // Answers a Task with a Done. Throws scenes::Failure.
    processes::Reply answer(const std::string &task);

private:
    void load();
    Done draw(const Task &task);
    void take_wishes();

    const Request &request_;
    Canvas canvas_;
    std::unique_ptr<Surface> surface_;
    std::optional<Session> session_;
};

}  // namespace view::tiles

// What the window and the processes that draw for it tell each other.
#pragma once

#include <claque/renderer.h>

#include <string>

#include "samples/processes/tile_borders.h"
#include "samples/view/input.h"

namespace view::tiles
{

struct Task {
    enum class Kind : uint8_t { load, frame, renew };
    Kind kind = Kind::load;
    // Of a frame: its tile, of a picture that was `of_px` wide when the borders were made.
    processes::Tile tile = {0, 1};
    int of_px = 1;
    bool film = false;  // whether one is being made
    Input input;
};
std::string text_of(const Task &task);
Task task_of(const std::string &text);

// What was drawn: nothing, if the picture is larger than the memory for it.
struct Done {
    uint64_t fingerprint = 0;  // Session::fingerprint()
    bool drawn = false;
    double cpu_ms = 0;
    clq_draw_stats stats = {};
};
std::string text_of(const Done &done);
Done done_of(const std::string &text);

// The same share of a picture of another width.
processes::Tile scaled(const Task &task, int width_px);

}  // namespace view::tiles

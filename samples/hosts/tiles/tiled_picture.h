// One picture drawn by several processes: each has a crowd and a GL context of its own, and draws one tile into memory
// that all of them share. What claque draws is a function of calls and time, so the tiles fit together to the bit.
#pragma once

#include "samples/processes/crew.h"
#include "samples/processes/shared_pages.h"
#include "samples/processes/tile_borders.h"

namespace tiles
{

class TiledPicture
{
public:
    // Starts the processes. To be made before this process has threads or a GL context. Throws std::runtime_error.
    TiledPicture(int width, int height, int processes);

    // Three bytes a pixel, top row first, valid until the next call. Throws std::runtime_error.
    const uint8_t *show(double time_s);
    // Where the last picture was cut.
    const std::vector<processes::Tile> &tiles() const { return drawn_; }

private:
    processes::Answering start() const;

    int width_, height_;
    processes::SharedPages pixels_;
    processes::TileBorders borders_;
    std::vector<processes::Tile> drawn_;
    processes::Crew crew_;
};

}  // namespace tiles

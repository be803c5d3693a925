// The picture of a window by several processes. Each plays the same session from the same inputs and draws a tile. The
// interface stays in the window's own process, which draws the picture of a frame itself if another one has ended.
#pragma once

#include "samples/processes/crew.h"
#include "samples/processes/shared_pages.h"
#include "samples/processes/tile_borders.h"
#include "samples/view/painter.h"
#include "samples/view/tiles/tile_player.h"

namespace view::tiles
{

class TileCrew final : public Painter
{
public:
    // Starts request.processes processes, which load what they show at once. To be made where no thread and no GL
    // context is; `request` must live as long as this. Throws std::runtime_error.
    explicit TileCrew(const Request &request);

    void begin(const Input &input, const Model &model) override;
    void paint(World &world, Model &model, uint64_t fingerprint) override;
    void renew() override;

    uint32_t lost() const { return lost_; }  // processes that have ended, or showed something else

private:
    void tell(const Task &task);
    void lose(uint32_t worker);
    void divide(int width_px);
    std::vector<uint32_t> there() const;

    int width_, height_;
    processes::SharedPages pages_;
    processes::TileBorders borders_;
    int divided_px_;
    processes::Crew crew_;
    std::vector<uint32_t> drawing_;  // the worker of each tile
    uint32_t asked_ = 0, lost_ = 0;
};

}  // namespace view::tiles

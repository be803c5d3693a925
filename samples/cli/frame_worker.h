// What a process of several does: it draws frames, or tiles of them, into memory that the coordinator reads.
#pragma once

#include "samples/cli/frame_drawer.h"
#include "samples/processes/team.h"

namespace cli
{

class FrameWorker
{
public:
    // `pages`: places of place_bytes() each. `ranks`: those of the job, or null. Both and `arguments` must live as long
    // as this.
    FrameWorker(const RenderArguments &arguments, int threads, uint8_t *pages, processes::Ranks *ranks = nullptr);

    // Tasks: {"task": "subject"}; {"task": "frame" or "tile", "number", "time_s", "bare", "at"}, with x0 and x1 of a
    // tile. "at" is the place; "bare" asks for pixels instead of a PNG. Throws scenes::Failure.
    processes::Reply answer(const Json &task);

private:
    processes::Reply draw_frame(const Frame &frame, size_t at);
    processes::Reply draw_tile(const Json &task);

    FrameDrawer drawer_;
    uint8_t *pages_;
    size_t place_bytes_;
    bool is_rank_;
};

}  // namespace cli

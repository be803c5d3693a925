#include "samples/cli/frame_division.h"

namespace cli
{

Division division_of(const RenderArguments &a)
{
    if (a.divide.empty()) return a.frames.empty() ? Division::tiles : Division::frames;
    return a.divide == "tiles" ? Division::tiles : Division::frames;
}

// A PNG may be a little larger than its pixels.
size_t place_bytes(const RenderArguments &a)
{
    const size_t width = static_cast<size_t>(a.setup.width), height = static_cast<size_t>(a.setup.height);
    if (division_of(a) == Division::tiles) return 3 * width * height;
    const size_t pixels = (3 * width + 1) * height;
    return pixels + pixels / 64 + 65536;
}

size_t place_count(const RenderArguments &a, uint32_t workers, uint32_t tasks_each)
{
    return division_of(a) == Division::frames ? size_t(workers) * tasks_each : 2;
}

}  // namespace cli

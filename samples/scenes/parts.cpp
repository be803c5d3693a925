#include "samples/scenes/parts.h"

namespace scenes
{

void Parts::end()
{
    const Part part = {{fine_done_, static_cast<uint32_t>(fine.indices().size()) - fine_done_},
                       {coarse_done_, static_cast<uint32_t>(coarse.indices().size()) - coarse_done_}};
    fine_done_ += part.fine.count, coarse_done_ += part.coarse.count;
    if (part.fine.count > 0) parts_.push_back(part);
}

}  // namespace scenes

#include "samples/processes/frame_shares.h"

#include <algorithm>

namespace processes
{

FrameShares::FrameShares(size_t frames, uint32_t workers, bool in_order)
{
    const size_t count = in_order ? 1 : workers;
    for (size_t i = 0; i < count; ++i) shares_.push_back({frames * i / count, frames * (i + 1) / count});
}

std::optional<size_t> FrameShares::next(uint32_t worker)
{
    Share &own = shares_[std::min<size_t>(worker, shares_.size() - 1)];
    if (own.left() == 0) {
        Share &most = *std::max_element(shares_.begin(), shares_.end(),
                                        [](const Share &a, const Share &b) { return a.left() < b.left(); });
        const size_t taken = (most.left() + 1) / 2;
        own = {most.end - taken, most.end};
        if (&own != &most) most.end -= taken;
    }
    if (own.left() == 0) return {};
    return own.begin++;
}

}  // namespace processes

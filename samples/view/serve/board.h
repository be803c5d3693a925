// The newest frame of a window that is served. A viewer takes it when it is ready for one and never sees those in
// between, so a slow viewer costs the others nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace view::serve
{

struct Frame {
    uint64_t number = 0;
    std::vector<uint8_t> rgb;  // three bytes a pixel, top row first
};

class Board
{
public:
    void show(std::shared_ptr<const Frame> frame)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        newest_.swap(frame);
    }
    std::shared_ptr<const Frame> newest() const
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        return newest_;
    }

private:
    mutable std::mutex mutex_;
    std::shared_ptr<const Frame> newest_;
};

}  // namespace view::serve

// Which process draws which frames of a film.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace processes
{

// Frames that follow each other stay with one process, because it reads what they show, and neighbours show much the
// same.
class FrameShares
{
public:
    // `in_order`: frames are given out in their order instead, to whichever process is free.
    FrameShares(size_t frames, uint32_t workers, bool in_order);

    // The worker's next frame; none when all are given out. A worker whose share is done takes half of what is left of
    // the largest one.
    std::optional<size_t> next(uint32_t worker);

private:
    struct Share {
        size_t begin, end;
        size_t left() const { return end - begin; }
    };
    std::vector<Share> shares_;  // of each worker; one for all of them where frames keep their order
};

}  // namespace processes

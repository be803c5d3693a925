// Limits the memory that a file can make the loader allocate: the caller's limit, and a small multiple of the file's
// size.
#pragma once

#include <cstdint>

#include "lib/base/error.h"

namespace claque::asset
{

// Counts geometry, clips and buffers against both rules. Images count against the caller's limit alone; image.h has a
// rule of its own for them. Charges are never returned: charged memory is kept, or is as large as something that is.
class Budget
{
public:
    static constexpr uint64_t always_allowed = 8ull << 20;
    static constexpr uint64_t multiple = 40;

    explicit Budget(uint64_t limit_bytes) : limit_(limit_bytes) {}

    // Adds bytes of input: the file itself or an external buffer.
    void add_input(uint64_t bytes) { allowed_ += multiple * bytes, source_ += bytes, read_ += bytes; }
    // Adds the pixels of a decoded image.
    void add_pixels(uint64_t bytes) { source_ += bytes; }
    // Whether so many bytes of images can all have been read.
    bool take_encoded(uint64_t bytes) { return (encoded_ += bytes) <= read_; }
    // What was read, with decoded pixels: Model::source_bytes.
    uint64_t source_bytes() const { return source_; }

    // Throws base::Error (CLQ_LIMIT) that names `what`.
    void charge(uint64_t bytes, const char *what)
    {
        charge_image(bytes, what);
        if (bytes > allowed_ - taken_)
            base::fail(CLQ_LIMIT, "%s would take %llu bytes: more than %llu times what the file holds", what,
                       static_cast<unsigned long long>(bytes), static_cast<unsigned long long>(multiple));
        taken_ += bytes;
    }

    void charge_image(uint64_t bytes, const char *what)
    {
        if (bytes > limit_ - all_)
            base::fail(CLQ_LIMIT, "%s would take %llu bytes: the limit of %llu bytes for one file is reached", what,
                       static_cast<unsigned long long>(bytes), static_cast<unsigned long long>(limit_));
        all_ += bytes;
    }

    uint64_t remaining() const { return limit_ - all_; }

private:
    uint64_t limit_ = 0, all_ = 0;
    uint64_t allowed_ = always_allowed, taken_ = 0;
    uint64_t source_ = 0, read_ = 0, encoded_ = 0;
};

}  // namespace claque::asset

#include "lib/asset/trajectories/gzip.h"

#ifdef CLAQUE_HAS_Z
#include <zlib.h>
#endif

#include <algorithm>

#include "lib/asset/decoders.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint64_t most_times = 200, always_bytes = 1 << 20;

}  // namespace

bool is_gzip(const uint8_t *bytes, size_t size) { return size >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b; }

#ifdef CLAQUE_HAS_Z

namespace
{

constexpr size_t piece_bytes = 1 << 18;

class Inflater
{
public:
    Inflater()
    {
        if (inflateInit2(&stream_, 15 + 16) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater &) = delete;
    Inflater &operator=(const Inflater &) = delete;
    z_stream &stream() { return stream_; }

private:
    z_stream stream_{};
};

// Gives zlib more of the input, whose size may not fit its counter.
void feed(z_stream &stream, const uint8_t *bytes, size_t size, size_t &given)
{
    if (stream.avail_in > 0) return;
    const size_t more = std::min<size_t>(size - given, 1 << 30);
    stream.next_in = const_cast<Bytef *>(bytes + given);
    stream.avail_in = static_cast<uInt>(more);
    given += more;
}

}  // namespace

void unpack(const uint8_t *bytes, size_t size, Budget &budget, const std::function<bool(std::string_view)> &take)
{
    Inflater inflater;
    z_stream &stream = inflater.stream();
    std::vector<char> piece(piece_bytes);
    size_t given = 0;
    uint64_t made = 0;
    for (bool more = true; more;) {
        feed(stream, bytes, size, given);
        stream.next_out = reinterpret_cast<Bytef *>(piece.data()), stream.avail_out = piece_bytes;
        const int result = inflate(&stream, Z_NO_FLUSH);
        if (result == Z_MEM_ERROR) throw std::bad_alloc();
        const size_t got = piece_bytes - stream.avail_out;
        made += got;
        if (made > most_times * size + always_bytes)
            fail(CLQ_LIMIT, "the gzip data unpack to more than %llu times their %zu bytes and 1 MB",
                 base::big(most_times), size);
        budget.add_input(got);
        if (got > 0 && !take({piece.data(), got})) return;
        const bool at_end = stream.avail_in == 0 && given == size;
        if (result == Z_STREAM_END) {
            // Files may hold several members, one after another.
            if (at_end) return;
            if (inflateReset(&stream) != Z_OK) fail(CLQ_FORMAT, "the gzip data are damaged");
        } else if (result == Z_BUF_ERROR && at_end) {
            fail(CLQ_FORMAT, "the gzip data end early, after %llu bytes unpacked", base::big(made));
        } else if (result != Z_OK && result != Z_BUF_ERROR) {
            fail(CLQ_FORMAT, "the gzip data are damaged after %llu bytes unpacked", base::big(made));
        }
    }
}

#else

void unpack(const uint8_t *, size_t, Budget &, const std::function<bool(std::string_view)> &)
{
    refuse_without_library("gzip", "zlib");
}

#endif

std::vector<uint8_t> unpack_all(const uint8_t *bytes, size_t size, Budget &budget)
{
    std::vector<uint8_t> out;
    unpack(bytes, size, budget, [&](std::string_view piece) {
        budget.charge(2 * piece.size(), "the unpacked file");
        out.insert(out.end(), piece.begin(), piece.end());
        return true;
    });
    return out;
}

}  // namespace claque::asset

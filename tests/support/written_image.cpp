#include "tests/support/written_image.h"

#include <algorithm>

namespace claque::testing
{
namespace
{

void add_big_endian(Bytes &out, uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<uint8_t>(value >> shift));
}

uint32_t crc_of(const Bytes &bytes, size_t first)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = first; i < bytes.size(); ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

uint32_t adler_of(const Bytes &bytes)
{
    uint32_t low = 1, high = 0;
    for (const uint8_t byte : bytes) low = (low + byte) % 65521, high = (high + low) % 65521;
    return high << 16 | low;
}

void add_chunk(Bytes &out, const char *type, const Bytes &body)
{
    add_big_endian(out, static_cast<uint32_t>(body.size()));
    const size_t first = out.size();
    out.insert(out.end(), type, type + 4);
    out.insert(out.end(), body.begin(), body.end());
    add_big_endian(out, crc_of(out, first));
}

// A zlib stream of stored blocks.
Bytes stored(const Bytes &rows)
{
    Bytes out = {0x78, 0x01};
    for (size_t at = 0; at < rows.size();) {
        const size_t count = std::min<size_t>(rows.size() - at, 0xffff);
        out.push_back(at + count == rows.size());
        for (const size_t word : {count, ~count})
            for (int shift : {0, 8}) out.push_back(static_cast<uint8_t>(word >> shift));
        out.insert(out.end(), rows.begin() + static_cast<std::ptrdiff_t>(at),
                   rows.begin() + static_cast<std::ptrdiff_t>(at + count));
        at += count;
    }
    add_big_endian(out, adler_of(rows));
    return out;
}

}  // namespace

Bytes png_of(uint32_t width, uint32_t height, const std::function<Colour(uint32_t, uint32_t)> &colour)
{
    Bytes rows;
    for (uint32_t y = 0; y < height; ++y) {
        rows.push_back(0);  // no filter
        for (uint32_t x = 0; x < width; ++x) {
            const Colour c = colour(x, y);
            rows.insert(rows.end(), {c.r, c.g, c.b, c.a});
        }
    }
    Bytes head;
    add_big_endian(head, width);
    add_big_endian(head, height);
    head.insert(head.end(), {8, 6, 0, 0, 0});
    Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    add_chunk(out, "IHDR", head);
    add_chunk(out, "IDAT", stored(rows));
    add_chunk(out, "IEND", {});
    return out;
}

}  // namespace claque::testing

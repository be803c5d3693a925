#include "png.h"

namespace claque::testing
{
namespace
{

class Bits
{
public:
    void add(uint32_t value, int count)  // least significant bit first, as deflate has its numbers
    {
        for (int k = 0; k < count; ++k) {
            if (used_ == 0) bytes.push_back(0);
            bytes.back() = static_cast<uint8_t>(bytes.back() | ((value >> k & 1u) << used_));
            used_ = (used_ + 1) % 8;
        }
    }
    void code(uint32_t value, int count)  // most significant bit first, as deflate has its codes
    {
        for (int k = count - 1; k >= 0; --k) add(value >> k & 1u, 1);
    }
    Bytes bytes;

private:
    int used_ = 0;
};

// A literal of the fixed code.
void literal(Bits &out, uint8_t byte) { byte < 144 ? out.code(0x30u + byte, 8) : out.code(0x190u + byte - 144u, 9); }

// All bytes alike: one literal, then copies of 258 from one byte back. Anything else: literals.
Bytes packed(const Bytes &row, size_t rows)
{
    Bits out;
    out.add(0x78, 8), out.add(0x01, 8);
    out.add(1, 1), out.add(1, 2);
    bool alike = true;
    for (const uint8_t byte : row) alike = alike && byte == row[0];
    size_t left = row.size() * rows;
    if (alike) {
        literal(out, row[0]), --left;
        for (; left >= 258; left -= 258) out.code(0xc5, 8), out.code(0, 5);
    }
    for (size_t i = row.size() * rows - left; i < row.size() * rows; ++i) literal(out, row[i % row.size()]);
    out.code(0, 7);
    // The check sum at the end is not looked at by the decoder.
    for (int k = 0; k < 4; ++k) out.bytes.push_back(0);
    return out.bytes;
}

void chunk(Bytes &out, const char *type, const Bytes &body)
{
    for (int k = 3; k >= 0; --k) out.push_back(static_cast<uint8_t>(body.size() >> (8 * k)));
    out.insert(out.end(), type, type + 4);
    out.insert(out.end(), body.begin(), body.end());
    for (int k = 0; k < 4; ++k) out.push_back(0);
}

}  // namespace

Bytes make_png(uint32_t width, uint32_t height, uint8_t depth, const Bytes &row, size_t rows)
{
    Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes head;
    for (const uint32_t side : {width, height})
        for (int k = 3; k >= 0; --k) head.push_back(static_cast<uint8_t>(side >> (8 * k)));
    head.insert(head.end(), {depth, 0, 0, 0, 0});
    chunk(out, "IHDR", head);
    chunk(out, "IDAT", packed(row, rows));
    chunk(out, "IEND", {});
    return out;
}

}  // namespace claque::testing

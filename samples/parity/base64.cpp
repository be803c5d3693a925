#include "samples/parity/base64.h"

#include <cstdint>

namespace parity
{

std::string base64(const std::vector<unsigned char> &bytes)
{
    static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t have = bytes.size() - i;
        const uint32_t bits = uint32_t{bytes[i]} << 16 | (have > 1 ? uint32_t{bytes[i + 1]} << 8 : 0) |
                              (have > 2 ? uint32_t{bytes[i + 2]} : 0);
        out += letters[bits >> 18];
        out += letters[bits >> 12 & 63];
        out += have > 1 ? letters[bits >> 6 & 63] : '=';
        out += have > 2 ? letters[bits & 63] : '=';
    }
    return out;
}

}  // namespace parity

#include "samples/parity/npy.h"

#include <cstring>

#include "samples/parity/npy_header.h"

namespace parity
{
namespace
{

constexpr size_t most_header_bytes = 65536;  // NumPy's own are about 128

size_t little_endian(const unsigned char *p, size_t bytes)
{
    size_t value = 0;
    for (size_t i = 0; i < bytes; ++i) value |= size_t{p[i]} << (8 * i);
    return value;
}

size_t size_of(const std::string &type) { return static_cast<size_t>(type[2] - '0'); }

std::string numpy_name(const std::string &type)
{
    return type == "<f4" ? "np.float32" : type == "|u1" ? "np.uint8" : type == "<u2" ? "np.uint16" : "np.uint32";
}

void expect_type(const NpyHeader &header, const std::string &name, const std::string &type)
{
    if (header.type != type)
        throw Unreadable(name + " holds '" + header.type.substr(0, 32) + "', and '" + type + "' is expected: .astype(" +
                         numpy_name(type) + ") before saving");
    if (header.fortran_order && header.shape.size() > 1)
        throw Unreadable(name + " is in Fortran order: np.ascontiguousarray before saving");
}

// The number of values in the shape; stops at more than a file here can hold.
size_t count_of(const NpyHeader &header, const std::string &name, size_t most)
{
    size_t count = 1;
    for (const size_t side : header.shape) {
        if (side != 0 && count > most / side)
            throw Unreadable(name + " is cut short: its header promises more than its " + std::to_string(most) +
                             " values");
        count *= side;
    }
    return count;
}

}  // namespace

Array read_npy(const std::vector<unsigned char> &file, const std::string &name, const std::string &type)
{
    constexpr size_t magic_bytes = 6;
    if (file.size() < 10 || std::memcmp(file.data(), "\x93NUMPY", magic_bytes) != 0)
        throw Unreadable(name + " is not a NumPy array: it does not begin as one");
    const int version = file[magic_bytes];
    if (version < 1 || version > 3)
        throw Unreadable(name + " is in version " + std::to_string(version) + " of NumPy's format; 1 to 3 can be read");
    const size_t length_bytes = version == 1 ? 2 : 4, start = 8 + length_bytes;
    const size_t length = file.size() < start ? most_header_bytes + 1 : little_endian(&file[8], length_bytes);
    if (length > most_header_bytes || length > file.size() - start)
        throw Unreadable(name + " is cut short: it ends inside its header");
    const NpyHeader header = npy_header(std::string(file.begin() + static_cast<std::ptrdiff_t>(start),
                                                    file.begin() + static_cast<std::ptrdiff_t>(start + length)),
                                        name);
    expect_type(header, name, type);
    const size_t have = file.size() - start - length, count = count_of(header, name, have / size_of(type));
    if (have != count * size_of(type))
        throw Unreadable(name + " has " + std::to_string(have) + " bytes of values, and its header promises " +
                         std::to_string(count * size_of(type)));
    Array out{header.type, header.shape, {}};
    out.bytes.assign(file.begin() + static_cast<std::ptrdiff_t>(start + length), file.end());
    return out;
}

template <class Value>
std::vector<Value> Array::as() const
{
    // The supported machines are little-endian, as the arrays are.
    std::vector<Value> out(bytes.size() / sizeof(Value));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
}

template std::vector<float> Array::as() const;
template std::vector<uint8_t> Array::as() const;
template std::vector<uint16_t> Array::as() const;
template std::vector<uint32_t> Array::as() const;

}  // namespace parity

#include "samples/labels/npz.h"

#include <zlib.h>

#include "samples/scenes/check.h"

namespace labels
{
namespace
{

void add(std::string &out, uint32_t value, int bytes)
{
    for (int shift = 0; shift < 8 * bytes; shift += 8) out += static_cast<char>(value >> shift & 255);
}

struct Entry {
    std::string name;
    uint32_t crc, size, offset;
};

// What the header before a file and its entry in the directory have in common. Dates are the earliest that there is.
std::string common(const Entry &entry)
{
    std::string out;
    add(out, 20, 2), add(out, 0, 2), add(out, 0, 2), add(out, 0, 2), add(out, 0x21, 2);
    add(out, entry.crc, 4), add(out, entry.size, 4), add(out, entry.size, 4);
    add(out, static_cast<uint32_t>(entry.name.size()), 2), add(out, 0, 2);
    return out;
}

}  // namespace

std::string npz(const std::vector<std::pair<std::string, std::string>> &arrays)
{
    std::string file, directory;
    for (const auto &[name, array] : arrays) {
        if (file.size() + array.size() > 0xffffffffu - 65536)
            throw scenes::Failure("an archive of labels would be larger than 4 GiB, which its format cannot hold");
        const Entry entry = {name + ".npy",
                             static_cast<uint32_t>(crc32(0, reinterpret_cast<const Bytef *>(array.data()),
                                                         static_cast<uInt>(array.size()))),
                             static_cast<uint32_t>(array.size()), static_cast<uint32_t>(file.size())};
        file += "PK\x03\x04" + common(entry) + entry.name + array;
        directory += std::string("PK\x01\x02") + std::string("\x14\x00", 2) + common(entry);
        add(directory, 0, 2), add(directory, 0, 2), add(directory, 0, 2), add(directory, 0, 4);
        add(directory, entry.offset, 4);
        directory += entry.name;
    }
    const uint32_t at = static_cast<uint32_t>(file.size());
    file += directory + "PK\x05\x06";
    add(file, 0, 4);
    add(file, static_cast<uint32_t>(arrays.size()), 2), add(file, static_cast<uint32_t>(arrays.size()), 2);
    add(file, static_cast<uint32_t>(directory.size()), 4), add(file, at, 4), add(file, 0, 2);
    return file;
}

}  // namespace labels

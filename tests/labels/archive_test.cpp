// Archives of arrays, read from the description of ZIP files.
#include <cstring>
#include <map>

#include <gtest/gtest.h>
#include <zlib.h>

#include "samples/io/npy.h"
#include "samples/labels/npz.h"
#include "samples/parity/npy.h"

namespace
{

uint32_t number_at(const std::string &file, size_t at, size_t bytes)
{
    uint32_t out = 0;
    for (size_t k = 0; k < bytes; ++k)
        out |= static_cast<uint32_t>(static_cast<unsigned char>(file.at(at + k))) << (8 * k);
    return out;
}

// Follows the directory at the end, as archivers do.
std::map<std::string, std::string> files_in(const std::string &archive)
{
    std::map<std::string, std::string> out;
    const size_t end = archive.size() - 22;
    EXPECT_EQ(number_at(archive, end, 4), 0x06054b50u);
    size_t at = number_at(archive, end + 16, 4);
    for (uint32_t k = 0; k < number_at(archive, end + 10, 2); ++k) {
        EXPECT_EQ(number_at(archive, at, 4), 0x02014b50u);
        const uint32_t crc = number_at(archive, at + 16, 4), size = number_at(archive, at + 24, 4),
                       name_size = number_at(archive, at + 28, 2), offset = number_at(archive, at + 42, 4);
        const std::string name = archive.substr(at + 46, name_size);
        EXPECT_EQ(number_at(archive, offset, 4), 0x04034b50u);
        const size_t data = offset + 30 + number_at(archive, offset + 26, 2) + number_at(archive, offset + 28, 2);
        out[name] = archive.substr(data, size);
        EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef *>(out[name].data()), size), crc) << name;
        at += 46 + name_size;
    }
    EXPECT_EQ(at, end);
    return out;
}

TEST(Archive, HoldsArraysThatNumPysFormatDescribes)
{
    const std::vector<float> values = {1, 2.5f, -3, 4, 5, 6};
    const std::vector<uint16_t> small = {7, 8};
    const std::string archive = labels::npz({{"a", io::npy("<f4", {2, 3}, values)}, {"b", io::npy("<u2", {2}, small)}});
    const std::map<std::string, std::string> files = files_in(archive);
    ASSERT_EQ(files.size(), 2u);
    const auto array = [&](const char *name, const char *type) {
        const std::string &file = files.at(name);
        return parity::read_npy(std::vector<unsigned char>(file.begin(), file.end()), name, type);
    };
    EXPECT_EQ(array("a.npy", "<f4").shape, (std::vector<size_t>{2, 3}));
    EXPECT_EQ(array("a.npy", "<f4").as<float>(), values);
    EXPECT_EQ(array("b.npy", "<u2").as<uint16_t>(), small);
    EXPECT_THROW(array("b.npy", "<f4"), parity::Unreadable);
    EXPECT_EQ((files.at("a.npy").size() - 4 * values.size()) % 64, 0u);
}

TEST(Archive, IsTheSameForTheSameArrays)
{
    const auto made = [] { return labels::npz({{"a", io::npy("<u2", {1}, std::vector<uint16_t>{3})}}); };
    EXPECT_EQ(made(), made());
}

}  // namespace

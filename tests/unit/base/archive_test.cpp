// Archives and headers of the files that the library writes itself.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "lib/base/file_header.h"

namespace claque::base
{

namespace
{

constexpr FileForm form = {{'c', 'l', 'a', 'q', 'u', 'e', 'X', 0x1a}, 7, "a saved test"};

struct Contents {
    std::string name;
    double number = 0;
    int16_t below = 0;
    bool yes = false;
    std::vector<uint32_t> list;
};

template <class Archive, class T>
void walk(Archive &a, T &contents)
{
    a.text(contents.name);
    a.value(contents.number), a.value(contents.below), a.flag(contents.yes);
    a.array(contents.list, 4, [&](auto &v) { a.value(v); });
}

std::pmr::vector<uint8_t> file_of(const Contents &contents)
{
    std::pmr::vector<uint8_t> bytes = {1, 2, 3};  // what is there already stays
    append_file(form, bytes, [&](auto &archive) { walk(archive, contents); });
    EXPECT_EQ(bytes[0] + bytes[1] + bytes[2], 6);
    bytes.erase(bytes.begin(), bytes.begin() + 3);
    return bytes;
}

// The message of a refusal, or "" if the bytes are read.
std::string read(const std::pmr::vector<uint8_t> &bytes, Contents &out)
{
    try {
        ArchiveReader<> archive = open_file(form, bytes.data(), bytes.size());
        walk(archive, out);
        archive.end();
    } catch (const Error &error) {
        EXPECT_EQ(error.status(), CLQ_FORMAT);
        return error.what();
    }
    return "";
}

std::string refusal(const std::pmr::vector<uint8_t> &bytes)
{
    Contents out;
    return read(bytes, out);
}

// The same bytes with the hash that they should have.
std::pmr::vector<uint8_t> forged(std::pmr::vector<uint8_t> bytes)
{
    const size_t size = bytes.size() - file_header_bytes;
    const auto header = file_header(form, size, fnv(fnv_start, bytes.data() + file_header_bytes, size));
    std::copy(header.begin(), header.end(), bytes.begin());
    return bytes;
}

Contents example()
{
    Contents contents{"a name", std::nextafter(0.1, 1.0), -2, true, {}};
    for (uint32_t i = 0; i < 1000; ++i) contents.list.push_back(i * 0x01010101u);  // longer than the writer's buffer
    return contents;
}

}  // namespace

TEST(Archive, WhatIsWrittenIsReadBitForBit)
{
    const Contents contents = example();
    Contents out;
    ASSERT_EQ(read(file_of(contents), out), "");
    EXPECT_EQ(out.name, contents.name);
    EXPECT_EQ(out.number, contents.number);
    EXPECT_EQ(out.below, -2);
    EXPECT_TRUE(out.yes);
    EXPECT_EQ(out.list, contents.list);
}

TEST(Archive, NumbersAreLittleEndianOnEveryMachine)
{
    std::pmr::vector<uint8_t> bytes;
    ArraySink sink(bytes);
    ArchiveWriter<uint64_t> archive(sink);
    archive.value(uint32_t(0x04030201)), archive.value(1.0f), archive.count(5);
    archive.flush();
    EXPECT_EQ(bytes, (std::pmr::vector<uint8_t>{1, 2, 3, 4, 0, 0, 0x80, 0x3f, 5, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Archive, EveryCutIsRefused)
{
    const std::pmr::vector<uint8_t> whole = file_of({"cut", 1, 1, false, {1, 2, 3}});
    for (size_t size = 0; size < whole.size(); ++size) {
        const std::pmr::vector<uint8_t> cut(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
        EXPECT_NE(refusal(cut), "") << size;
        if (size >= file_header_bytes) EXPECT_NE(refusal(forged(cut)), "") << size;
    }
}

TEST(Archive, EveryChangedByteIsRefused)
{
    const std::pmr::vector<uint8_t> whole = file_of({"changed", 1, 1, false, {1, 2, 3}});
    for (size_t i = 0; i < whole.size(); ++i) {
        std::pmr::vector<uint8_t> changed = whole;
        changed[i] ^= 0x10;
        EXPECT_NE(refusal(changed), "") << i;
    }
}

TEST(Archive, RefusalsNameTheSubjectAndTheNumbers)
{
    const std::pmr::vector<uint8_t> whole =
        file_of({"", 0, 0, false, {}});  // text 4, number 8, below 2, flag 1, list 4
    EXPECT_EQ(refusal({whole.begin(), whole.begin() + 10}), "10 bytes that are not a saved test");
    std::pmr::vector<uint8_t> bytes = whole;
    bytes[8] = 9;
    EXPECT_EQ(refusal(bytes), "a saved test of version 9: this library reads version 7");
    bytes = whole;
    bytes.push_back(0);
    EXPECT_EQ(refusal(bytes), "a saved test is 20 bytes long, but its header says 19");
    EXPECT_EQ(refusal(forged(bytes)), "a saved test has 1 bytes too many");
    bytes = whole;
    bytes[file_header_bytes + 14] = 2;
    EXPECT_EQ(refusal(bytes), "a saved test has been changed since it was saved: its hash differs");
    EXPECT_EQ(refusal(forged(bytes)), "a saved test holds 2 where yes or no is due");
    bytes = whole;
    bytes[file_header_bytes + 15] = 1;
    EXPECT_EQ(refusal(forged(bytes)), "a saved test announces 1 elements in 0 bytes");
}

TEST(Archive, AnAnnouncedCountAllocatesNoMoreThanTheBytesCanFill)
{
    std::pmr::vector<uint8_t> bytes = file_of({"", 0, 0, false, {1, 2}});
    bytes[file_header_bytes + 15] = 3;
    EXPECT_EQ(refusal(forged(bytes)), "a saved test announces 3 elements in 8 bytes");
}

}  // namespace claque::base

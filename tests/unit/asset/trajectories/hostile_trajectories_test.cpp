// Bytes that are meant to do harm, or that something went wrong with: whatever comes of them, only base::Error may, and
// the memory stays in proportion.
#include <algorithm>

#include "../heap_meter.h"
#include "fixture.h"
#include "lib/base/hash.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t megabyte = 1 << 20;

// Reads, or is refused with a sentence; the caller's fault it is only where the file lacks something.
bool is_read(const Bytes &bytes, const asset::TrajectoryOptions &options)
{
    const Refusal refusal = refusal_of(bytes, options);
    if (refusal.status == CLQ_OK) return true;
    EXPECT_TRUE(refusal.status == CLQ_FORMAT || refusal.status == CLQ_LIMIT || refusal.status == CLQ_ARGUMENT ||
                refusal.status == CLQ_UNSUPPORTED)
        << refusal.text;
    EXPECT_FALSE(refusal.text.empty());
    return false;
}

asset::TrajectoryOptions given(const Written &file)
{
    asset::TrajectoryOptions options = file.options;
    options.format = file.format;
    return options;
}

uint64_t allowed_for(uint64_t bytes) { return 64 * bytes + 16 * megabyte; }

TEST(HostileTrajectories, FilesThatAreCutAtAnyByteAreReadOrRefused)
{
    for (const Written &file : written_files()) {
        SCOPED_TRACE(file.name);
        const bool large = file.bytes.size() > 6000;
        for (size_t size = 0; size < file.bytes.size(); size += large ? 61 : 1) {
            const Bytes cut(file.bytes.begin(), file.bytes.begin() + static_cast<std::ptrdiff_t>(size));
            is_read(cut, given(file));
            is_read(cut, file.options);
        }
    }
}

TEST(HostileTrajectories, FilesWithTurnedBitsAreReadOrRefused)
{
    uint64_t read = 0, refused = 0;
    for (const Written &file : written_files()) {
        SCOPED_TRACE(file.name);
        for (uint64_t run = 0; run < 300; ++run) {
            Bytes bytes = file.bytes;
            uint64_t thrown = 0;
            const auto below = [&](uint64_t limit) { return base::hash(run, thrown++, base::Purpose::pick) % limit; };
            for (uint64_t n = 1 + below(4); n > 0; --n) {
                uint8_t &byte = bytes[below(bytes.size())];
                if (below(3) == 0) byte = static_cast<uint8_t>("0123456789-.e{}<> \n\"';,"[below(23)]);
                else byte ^= static_cast<uint8_t>(1u << below(8));
            }
            ++(is_read(bytes, given(file)) ? read : refused);
        }
    }
    EXPECT_GT(read, 300u);
    EXPECT_GT(refused, 300u);
}

TEST(HostileTrajectories, ManyPeopleOfOneRowTakeAMultipleOfTheirBytes)
{
    std::string text;
    for (int i = 0; i < 100000; ++i) text += std::to_string(i) + " 1 1 1\n";
    const Bytes bytes = bytes_of_text(text);
    asset::TrajectoryOptions options = of_table("id,time,x,y");
    uint32_t people = 0;
    EXPECT_LE(peak_heap_bytes([&] { people = read_bytes(bytes, options).facts.person_count; }),
              allowed_for(bytes.size()) - 16 * megabyte);
    EXPECT_EQ(people, 100000u);
}

TEST(HostileTrajectories, AMillionShortRowsTakeAMultipleOfTheirBytes)
{
    // In descending order of time, so that all are sorted, with jumps between all.
    std::string text;
    for (int i = 1000000; i > 0; --i) {
        text += "1 ", text += std::to_string(i), text += i % 2 ? " 1 1\n" : " 9 99\n";
    }
    const Bytes bytes = bytes_of_text(text);
    asset::TrajectoryOptions options = of_table("id,time,x,y");
    uint32_t people = 0;
    EXPECT_LE(peak_heap_bytes([&] { people = read_bytes(bytes, options).facts.person_count; }),
              allowed_for(bytes.size()) - 16 * megabyte);
    EXPECT_EQ(people, 1000000u);
}

TEST(HostileTrajectories, TheCallersLimitOfMemoryHolds)
{
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "1 " + std::to_string(i) + " 1 1\n";
    asset::TrajectoryOptions options = of_table("id,time,x,y");
    options.memory_limit_bytes = megabyte;
    const Bytes bytes = bytes_of_text(text);
    Refusal refusal;
    EXPECT_LE(peak_heap_bytes([&] { refusal = refusal_of(bytes, options); }), 3 * megabyte);
    EXPECT_EQ(refusal.status, CLQ_LIMIT) << refusal.text;
}

TEST(HostileTrajectories, ALineOfManyColumnsTakesAMultipleOfItsBytes)
{
    for (const char separator : {',', ' ', ';'}) {
        std::string line(2 * megabyte, separator);
        for (size_t i = 0; i < line.size(); i += 2) line[i] = '1';
        const Bytes bytes = bytes_of_text(line + "\n");
        EXPECT_LE(peak_heap_bytes([&] { is_read(bytes, of_table("id,time,x,y")); }), megabyte);
    }
}

#ifdef CLAQUE_HAS_Z

TEST(HostileTrajectories, GzipThatUnpacksToTooMuchIsRefused)
{
    const Bytes bomb = packed(Bytes(64 * megabyte, ' '));
    ASSERT_LT(bomb.size(), megabyte);
    for (const clq_trajectory_format format : {CLQ_TRAJECTORY_AUTO, CLQ_TRAJECTORY_CROWDIT, CLQ_TRAJECTORY_SUMO}) {
        asset::TrajectoryOptions options;
        options.format = format;
        Refusal refusal;
        EXPECT_LE(peak_heap_bytes([&] { refusal = refusal_of(bomb, options); }), 64 * 200 * bomb.size());
        EXPECT_NE(refusal.status, CLQ_OK);
        if (format == CLQ_TRAJECTORY_CROWDIT) {
            EXPECT_EQ(refusal.status, CLQ_LIMIT);
            EXPECT_NE(refusal.text.find("unpack to more than 200 times"), std::string::npos) << refusal.text;
        }
    }
}

TEST(HostileTrajectories, GzipOfSeveralMembersIsReadAndOneThatEndsEarlyIsRefused)
{
    const Bytes first = packed(bytes_of_text("time,pedID,posX,posY\n0,a,0,0\n"));
    Bytes all = first;
    const Bytes second = packed(bytes_of_text("1,a,1,0\n"));
    all.insert(all.end(), second.begin(), second.end());
    EXPECT_EQ(read_bytes(all).samples.size(), 2u);
    all.resize(all.size() - 3);
    const Refusal early = refusal_of(all);
    EXPECT_EQ(early.status, CLQ_FORMAT);
    EXPECT_NE(early.text.find("the gzip data end early"), std::string::npos) << early.text;
    Bytes damaged = first;
    damaged[damaged.size() - 6] ^= 1;  // of the checksum
    EXPECT_NE(refusal_of(damaged).text.find("the gzip data are damaged"), std::string::npos);
}

#endif

TEST(HostileTrajectories, JsonOfPathfinderInsideEachOtherWithoutEndIsRefused)
{
    std::string text = "{\"1\":{\"1.0\":";
    for (int i = 0; i < 200000; ++i) text += "{\"position\":";
    asset::TrajectoryOptions options;
    options.format = CLQ_TRAJECTORY_PATHFINDER_JSON;
    const Refusal refusal = refusal_of(bytes_of_text(text), options);
    EXPECT_EQ(refusal.status, CLQ_LIMIT);
    EXPECT_NE(refusal.text.find("nested more than 128 deep"), std::string::npos) << refusal.text;
}

TEST(HostileTrajectories, JsonNestedWithoutEndIsRefused)
{
    for (const char *begin : {"{\"1\": {\"1.0\": {\"tags\": ", "{\"track\": "}) {
        for (const char *deeper : {"[", "{\"a\":"}) {
            std::string text = begin;
            for (int i = 0; i < 10000; ++i) text += deeper;
            const Refusal refusal = refusal_of(bytes_of_text(text));
            EXPECT_EQ(refusal.status, CLQ_LIMIT) << refusal.text;
        }
    }
}

TEST(HostileTrajectories, JsonOfManyValuesTakesAMultipleOfItsBytes)
{
    std::string text = "{\"1\": {";
    for (int i = 0; i < 60000; ++i) text += "\"" + std::to_string(i) + "\":{\"position\":{\"x\":1,\"y\":0}},";
    const Bytes bytes = bytes_of_text(text + "\"0\":[" + std::string(300000, ',') + "]}}");
    const Bytes good = bytes_of_text(text + "\"0\":{}}}");
    EXPECT_LE(peak_heap_bytes([&] { is_read(bytes, {}); }), 24 * bytes.size());
    uint64_t samples = 0;
    EXPECT_LE(peak_heap_bytes([&] { samples = read_bytes(good).facts.sample_count; }), 24 * good.size());
    EXPECT_EQ(samples, 60000u);
}

#ifdef CLAQUE_HAS_SQLITE3

TEST(HostileTrajectories, DamagedDatabasesAreReadOrRefused)
{
    const Bytes whole = database_of(jupedsim_statements(2));
    uint64_t read = 0, refused = 0;
    for (uint64_t run = 0; run < 3000; ++run) {
        Bytes bytes = whole;
        uint64_t thrown = 0;
        const auto below = [&](uint64_t limit) { return base::hash(run, thrown++, base::Purpose::pick) % limit; };
        // Heads of pages and of the file, where structure is.
        for (uint64_t n = 1 + below(3); n > 0; --n) {
            const size_t page = below(bytes.size() / 4096) * 4096;
            bytes[page + below(below(2) ? 120 : 4096)] = static_cast<uint8_t>(below(256));
        }
        ++(is_read(bytes, {}) ? read : refused);
    }
    EXPECT_GT(read, 100u);
    EXPECT_GT(refused, 100u);
}

// Interior pages whose children are all one leaf: 4 kB of rows look like millions.
TEST(HostileTrajectories, PagesThatAreMetAgainAndAgainAreRefused)
{
    std::vector<std::string> statements = jupedsim_statements(3);
    statements.back() =
        "WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r WHERE i < 200000) INSERT INTO "
        "trajectory_data SELECT i, 1, 0.0, 0.0 FROM r";
    statements.erase(statements.begin() + 3);  // the index
    Bytes bytes = database_of(statements);
    constexpr size_t page_bytes = 4096;
    const auto number = [&](size_t at) { return size_t(bytes[at]) << 8 | bytes[at + 1]; };
    // The child of every cell, and the one behind the last cell.
    const auto lead = [&](size_t page, size_t child) {
        std::vector<size_t> pointers{page + 8};
        for (size_t cell = 0; cell < number(page + 3); ++cell) pointers.push_back(page + number(page + 12 + 2 * cell));
        for (const size_t at : pointers)
            for (size_t k = 0; k < 4; ++k)
                bytes[at + k] = static_cast<uint8_t>((child / page_bytes + 1) >> (8 * (3 - k)));
    };
    // Interior pages of tables have type 5, leaves 13. The root of the table is the one that was made first.
    std::vector<size_t> interior, leaves;
    for (size_t page = page_bytes; page < bytes.size(); page += page_bytes) {
        if (bytes[page] == 5) interior.push_back(page);
        if (bytes[page] == 13) leaves.push_back(page);
    }
    ASSERT_GE(interior.size(), 2u);
    ASSERT_GE(leaves.size(), 4u);
    const size_t full = *std::max_element(interior.begin(), interior.end(),
                                          [&](size_t a, size_t b) { return number(a + 3) < number(b + 3); });
    size_t child = leaves.back();
    for (size_t level = 1; level < 4; ++level) {
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(full), page_bytes,
                    bytes.begin() + static_cast<std::ptrdiff_t>(leaves[level]));
        lead(leaves[level], child);
        child = leaves[level];
    }
    for (const size_t page : interior) lead(page, child);
    Refusal refusal;
    EXPECT_LE(peak_heap_bytes([&] { refusal = refusal_of(bytes); }), allowed_for(bytes.size()));
    EXPECT_TRUE(refusal.status == CLQ_FORMAT || refusal.status == CLQ_LIMIT) << refusal.text;
    EXPECT_TRUE(refusal.text.find("takes more steps than its size allows") != std::string::npos ||
                refusal.text.find("more than 40 times what the file holds") != std::string::npos)
        << refusal.text;
}

#endif

}  // namespace
}  // namespace claque::testing

// Records that are cut off, changed or made up: refused with a sentence, or played up to the cut.
#include <algorithm>

#include "lib/record/format.h"
#include "tests/api/record_fixture.h"

namespace
{

using claque::record::Kind;
using records::Bytes;
using records::Player;
using records::Recording;
using records::Shown;

class BrokenRecords : public testing::Test
{
protected:
    TestWorld world_;
};

// Offsets of the blocks, and the end.
std::vector<size_t> blocks_of(const Bytes &bytes)
{
    std::vector<size_t> out;
    for (size_t at = claque::record::file_header_bytes; at < bytes.size();) {
        out.push_back(at);
        uint32_t size = 0;
        for (int i = 0; i < 4; ++i) size |= uint32_t(bytes[at + size_t(i)]) << (8 * i);
        at += claque::record::block_header_bytes + size;
    }
    out.push_back(bytes.size());
    return out;
}

TEST_F(BrokenRecords, ThatAreCutOffPlayUpToTheCut)
{
    const Recording run = records::run(world_, 30, 11, 1000);
    const std::vector<size_t> blocks = blocks_of(run.bytes);
    size_t played = 0, refused = 0;
    for (size_t length = 1; length < run.bytes.size(); ++length) {
        const bool at_block = std::any_of(blocks.begin(), blocks.end(),
                                          [&](size_t block) { return length >= block && length - block < 20; });
        if (!at_block && length % 97 != 0) continue;
        const Bytes cut(run.bytes.begin(), run.bytes.begin() + static_cast<long>(length));
        clq_record *record = nullptr;
        if (clq_record_load(world_.context, cut.data(), cut.size(), &record) == CLQ_FORMAT) {
            ++refused;
            EXPECT_LT(length, blocks[1]) << "the first state is there: " << clq_last_error();
            continue;
        }
        ASSERT_NE(record, nullptr) << clq_last_error();
        clq_record_destroy(record);
        Player player(world_, cut);
        const clq_record_info info = player.info();
        EXPECT_FALSE(info.whole);
        // A piece for each update: all steps whose piece is there, and no other.
        const auto whole = std::upper_bound(blocks.begin(), blocks.end(), length) - blocks.begin() - 1;
        EXPECT_EQ(info.step_count, std::min<uint64_t>(30, static_cast<uint64_t>(whole) - 1)) << length << " bytes";
        Shown seen;
        if (info.step_count > 0) player.show(info.step_count - 1, seen);
        if (info.step_count > 0) {
            EXPECT_EQ(seen.lists[0], run.shown.lists[info.step_count - 1]);
        }
        ++played;
    }
    EXPECT_GT(played, 300u);
    EXPECT_GT(refused, 30u);
}

TEST_F(BrokenRecords, WithAChangedByteAreRefused)
{
    const Recording run = records::run(world_, 8, 12);
    Bytes bytes = run.bytes;
    const std::vector<size_t> blocks = blocks_of(bytes);
    for (size_t at = 0; at < bytes.size(); at += at % 5 == 0 && at > blocks[1] ? 3 : 1)
        for (const uint8_t bit : {uint8_t(1u << (at % 8)), uint8_t(0xff)}) {
            bytes[at] ^= bit;
            clq_record *record = nullptr;
            EXPECT_EQ(clq_record_load(world_.context, bytes.data(), bytes.size(), &record), CLQ_FORMAT)
                << "byte " << at;
            clq_record_destroy(record);
            bytes[at] ^= bit;
        }
    // A piece that is missing, twice, or moved; and bytes after the end.
    for (size_t k = 1; k + 1 < blocks.size(); ++k) {
        const auto begin = bytes.begin();
        Bytes lacks(begin, begin + long(blocks[k])), twice(begin, begin + long(blocks[k + 1]));
        lacks.insert(lacks.end(), begin + long(blocks[k + 1]), bytes.end());
        twice.insert(twice.end(), begin + long(blocks[k]), bytes.end());
        clq_record *record = nullptr;
        if (k + 2 < blocks.size()) {
            EXPECT_EQ(clq_record_load(world_.context, lacks.data(), lacks.size(), &record), CLQ_FORMAT) << k;
        }
        EXPECT_EQ(clq_record_load(world_.context, twice.data(), twice.size(), &record), CLQ_FORMAT) << k;
    }
    bytes.push_back(0);
    clq_record *record = nullptr;
    EXPECT_EQ(clq_record_load(world_.context, bytes.data(), bytes.size(), &record), CLQ_FORMAT);
    EXPECT_NE(std::string(clq_last_error()).find("1 bytes after its end"), std::string::npos) << clq_last_error();
}

// Entries of any kind with any fields under right checksums, after the first block of a good record.
Bytes with_entry(const Bytes &first_block, Kind kind, const Bytes &fields)
{
    namespace format = claque::record;
    Bytes contents(format::entry_header_bytes), out = first_block;
    saved::put(contents, 0, fields.size() + 1, 4);
    contents[4] = static_cast<uint8_t>(kind);
    contents.insert(contents.end(), fields.begin(), fields.end());
    Bytes header(format::block_header_bytes);
    const auto size = static_cast<uint32_t>(contents.size());
    const uint64_t checksum = format::checksum_of(contents.data(), size, 1);
    saved::put(header, 0, size, 4);
    saved::put(header, 4, format::check_of_header(size, checksum, 1), 4);
    saved::put(header, 8, checksum, 8);
    out.insert(out.end(), header.begin(), header.end());
    out.insert(out.end(), contents.begin(), contents.end());
    return out;
}

TEST_F(BrokenRecords, WithEntriesOfAnyKindAreRefusedOrHarmless)
{
    const Recording run = records::run(world_, 2, 13);
    const Bytes first(run.bytes.begin(), run.bytes.begin() + static_cast<long>(blocks_of(run.bytes)[1]));
    size_t played = 0, refused = 0;
    for (unsigned kind = 0; kind < 256; ++kind)
        for (uint64_t seed = 0; seed < (kind < 60 ? 60 : 2); ++seed) {
            Bytes fields(mixed(kind, seed) % 120);
            for (size_t i = 0; i < fields.size(); ++i) {
                const uint64_t bits = mixed(kind * 1000 + seed, i);
                fields[i] = static_cast<uint8_t>(bits % 3 ? bits % 4 / 3 : bits >> 8);
            }
            const Bytes bytes = with_entry(first, static_cast<Kind>(kind), fields);
            clq_record *record = nullptr;
            if (clq_record_load(world_.context, bytes.data(), bytes.size(), &record) != CLQ_OK) {
                ++refused;
                continue;
            }
            const clq_status given = clq_record_set_templates(record, world_.templates, 2);
            clq_crowd *crowd = nullptr;
            ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK);
            world_.set_up(crowd);
            if (given == CLQ_OK) {
                const clq_status status = clq_record_play(record, crowd, 1e9);
                EXPECT_TRUE(status == CLQ_OK || status == CLQ_FORMAT || status == CLQ_ARGUMENT) << clq_last_error();
                ++(status == CLQ_OK ? played : refused);
                EXPECT_EQ(clq_crowd_update(crowd, 1, nullptr, 0), CLQ_OK) << clq_last_error();
                // It is a good crowd, whatever has happened.
                const Bytes saved = saved::save(crowd);
                EXPECT_EQ(clq_crowd_restore(crowd, saved.data(), saved.size(), world_.templates, 2), CLQ_OK)
                    << "kind " << kind << ": " << clq_last_error();
            }
            clq_crowd_destroy(crowd);
            clq_record_destroy(record);
        }
    EXPECT_GT(played, 20u);
    EXPECT_GT(refused, 1000u);
}

TEST_F(BrokenRecords, NameWhatIsWrong)
{
    const Recording run = records::run(world_, 2, 13);
    const Bytes first(run.bytes.begin(), run.bytes.begin() + static_cast<long>(blocks_of(run.bytes)[1]));
    const auto problem = [&](Kind kind, const Bytes &fields) {
        const Bytes bytes = with_entry(first, kind, fields);
        clq_record *record = nullptr;
        if (clq_record_load(world_.context, bytes.data(), bytes.size(), &record) != CLQ_OK)
            return std::string(clq_last_error());
        Player player(world_, bytes);
        clq_record_destroy(record);
        EXPECT_EQ(clq_record_play(player.record, player.crowd, 1e9), CLQ_FORMAT);
        return std::string(clq_last_error());
    };
    const auto has = [](const std::string &text, const char *part) {
        return text.find(part) != std::string::npos ? "" : text;
    };
    const Bytes stranger = {99, 0, 0, 0, 7, 0, 0, 0};
    EXPECT_EQ(has(problem(Kind::actor_destroy, stranger), "the entry at byte "), "");
    EXPECT_EQ(has(problem(Kind::actor_destroy, {1, 2}), "ends 2 bytes too early"), "");
    EXPECT_EQ(has(problem(Kind::after_calls, {}), "an entry of kind 52, which this library does not know"), "");
    EXPECT_EQ(has(problem(Kind::crowd_def, {}), "or a second one"), "");
    EXPECT_EQ(has(problem(Kind::step, {0, 0, 0, 0, 0, 0, 0xf0, 0x7f}), "has no time"), "");
    Bytes group(1 + 44 + 8, 0);  // nowhere
    group[45] = 77, group[49] = 1;
    EXPECT_EQ(has(problem(Kind::group_create, group), "the recorded call made group {77, 1}; here it is"), "");
    Bytes track(40, 0);
    track[0] = 9;
    EXPECT_EQ(has(problem(Kind::track, track), "names locomotion 9, and has"), "");
}

}  // namespace

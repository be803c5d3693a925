// Each rule of a record's index, on both sides of its bound: a possible index is opened, an impossible one is refused
// with its fault. Blocks are read when they are played, so the tests leave them out.
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>

#include "lib/base/archive.h"
#include "lib/record/index.h"
#include "tests/api/record_fixture.h"

namespace
{

namespace format = claque::record;
using format::Kind;
using records::Bytes;
using records::number_in;

constexpr uint64_t first_block = format::file_header_bytes;

void add_entry(Bytes &to, Kind kind, const Bytes &fields)
{
    const size_t at = to.size();
    to.resize(at + format::entry_header_bytes);
    saved::put(to, at, fields.size() + 1, 4);
    to[at + 4] = static_cast<uint8_t>(kind);
    to.insert(to.end(), fields.begin(), fields.end());
}

// The parts of an index, and the place of its block in the end.
struct Forged {
    format::Index index{std::pmr::get_default_resource()};
    uint64_t at = 416;      // the place of the index: 26 headers of blocks, 32 steps
    uint32_t blocks = 3;    // before it
    bool described = true;  // the definition of the crowd follows
};

class RecordIndex : public testing::Test
{
protected:
    RecordIndex()
    {
        const Bytes bytes = records::run(world_, 2, 5).bytes;
        const size_t begin = format::file_header_bytes + format::block_header_bytes;
        const auto first = bytes.begin() + long(begin);
        EXPECT_EQ(static_cast<Kind>(bytes[begin + 4]), Kind::crowd_def);
        crowd_def_.assign(first, first + 4 + long(number_in(bytes, begin, 4)));
    }
    // Three steps after its two states, which follow three tracks.
    static Forged good()
    {
        Forged out;
        out.index.step_count = 3, out.index.call_count = 9, out.index.end_s = 7;
        out.index.tracks = {20, 50, 60};
        out.index.states = {{40, first_block, 0, 0, 1, 0, 2}, {200, 150, 1, 2, 4, 2, 1}};
        out.index.runs = {{0, 1}, {2, 1}, {1, 2}};
        return out;
    }
    Bytes record_of(const Forged &forged) const
    {
        std::pmr::vector<uint8_t> fields;
        claque::base::ArraySink sink(fields);
        claque::base::ArchiveWriter<> writer(sink);
        format::walk_index(writer, forged.index);
        writer.flush();
        if (forged.described) fields.insert(fields.end(), crowd_def_.begin(), crowd_def_.end());
        Bytes contents, end(format::end_bytes), out(format::magic, format::magic + 8);
        add_entry(contents, Kind::index, Bytes(fields.begin(), fields.end()));
        saved::put(end, 0, forged.at, 8);
        saved::put(end, 8, forged.blocks, 4);
        add_entry(contents, Kind::end, end);
        out.resize(forged.at + format::block_header_bytes);
        saved::put(out, 8, format::version, 4);
        const auto size = static_cast<uint32_t>(contents.size());
        const uint64_t checksum = format::checksum_of(contents.data(), size, forged.blocks);
        saved::put(out, forged.at, size, 4);
        saved::put(out, forged.at + 4, format::check_of_header(size, checksum, forged.blocks), 4);
        saved::put(out, forged.at + 8, checksum, 8);
        out.insert(out.end(), contents.begin(), contents.end());
        return out;
    }
    // The refusal; "" if it is opened.
    std::string said(const Forged &forged)
    {
        const Bytes bytes = record_of(forged);
        clq_record *record = nullptr;
        const clq_status status = clq_record_open(world_.context, bytes.data(), bytes.size(), &record);
        clq_record_destroy(record);
        if (status == CLQ_OK) return "";
        EXPECT_EQ(status, CLQ_FORMAT);
        return clq_last_error();
    }
    using Change = std::function<void(Forged &)>;
    void opens(const Change &change, int line)
    {
        Forged forged = good();
        change(forged);
        EXPECT_EQ(said(forged), "") << "line " << line;
    }
    void refuses(const std::string &fault, const Change &change, int line)
    {
        Forged forged = good();
        change(forged);
        const std::string found = said(forged);
        EXPECT_NE(found.find("the index of a record " + fault), std::string::npos)
            << "line " << line << ": " << found << "\nand not: " << fault;
    }

    // Zeros follow each piece of memory: numbers that an index may hold stand behind the end of its lists.
    static clq_context_def zeros_behind()
    {
        clq_context_def def = clq_context_def_init();
        def.allocator.allocate = [](void *, size_t size, size_t alignment) {
            const size_t unit = std::max(alignment, alignof(std::max_align_t)), whole = (size / unit + 1) * unit + 64;
            void *memory = std::aligned_alloc(unit, (whole + unit - 1) / unit * unit);
            return memory ? std::memset(memory, 0, whole) : nullptr;
        };
        def.allocator.release = [](void *, void *memory, size_t, size_t) { std::free(memory); };
        return def;
    }

    const clq_context_def context_ = zeros_behind();
    TestWorld world_{&context_};
    Bytes crowd_def_;  // an entry
};

#define OPENS(...) opens([](Forged &f) { __VA_ARGS__; }, __LINE__)
#define REFUSES(fault, ...) \
    refuses(                \
        fault, [](Forged &f) { __VA_ARGS__; }, __LINE__)

TEST_F(RecordIndex, ThatIsGoodIsOpened)
{
    const Bytes bytes = record_of(good());
    clq_record *record = nullptr;
    ASSERT_EQ(clq_record_open(world_.context, bytes.data(), bytes.size(), &record), CLQ_OK) << clq_last_error();
    clq_record_info info = clq_record_info_init();
    ASSERT_EQ(clq_record_get_info(record, &info), CLQ_OK);
    EXPECT_EQ(info.step_count, 3u);
    EXPECT_EQ(info.call_count, 9u);
    EXPECT_EQ(info.state_count, 2u);
    EXPECT_EQ(info.track_count, 3u);
    EXPECT_EQ(info.start_s, 1);
    EXPECT_EQ(info.end_s, 7);
    EXPECT_TRUE(info.whole);
    clq_record_destroy(record);
    REFUSES("lacks the definition of the crowd", f.described = false);
}

// Memory is proportional to the bytes of a record: no block is shorter than its header, no step than its time.
TEST_F(RecordIndex, HasNoMoreBlocksAndStepsThanBytes)
{
    const char *const fault = "has more blocks or steps than bytes";
    OPENS(f.blocks = 26);
    REFUSES(fault, f.blocks = 27);
    OPENS(f.index.step_count = 32);
    REFUSES(fault, f.index.step_count = 33);
}

TEST_F(RecordIndex, BeginsWithAStateAtTheFirstBlock)
{
    const char *const fault = "has no first state";
    REFUSES(fault, f.index.states.clear());
    REFUSES(fault, f.index.states[0].block = 1);
    REFUSES(fault, f.index.states[0].block_at = 15);
    REFUSES(fault, f.index.states[0].block_at = 17);
    REFUSES(fault, f.index.states[0].steps_before = 1);
}

TEST_F(RecordIndex, HasALastTimeNotBeforeItsFirst)
{
    const char *const fault = "has no last time";
    OPENS(f.index.end_s = 1);
    for (const double end_s : {0.999, HUGE_VAL, -HUGE_VAL, double(NAN)})
        refuses(
            fault, [=](Forged &f) { f.index.end_s = end_s; }, __LINE__);
    // Without steps any time will do that is a number.
    const auto without_steps = [](Forged &f, double end_s) {
        f.index.step_count = 0, f.index.end_s = end_s;
        f.index.states.resize(1);
        f.index.states[0].earliest_s = HUGE_VAL;
    };
    opens([&](Forged &f) { without_steps(f, -3); }, __LINE__);
    for (const double end_s : {HUGE_VAL, -HUGE_VAL, double(NAN)})
        refuses(
            fault, [&](Forged &f) { without_steps(f, end_s); }, __LINE__);
}

TEST_F(RecordIndex, HasItsTracksInTheRecordAndInOrder)
{
    const char *const fault = "has a track that is not in it";
    OPENS(f.index.tracks = {17, 18, 415});
    REFUSES(fault, f.index.tracks[0] = 16);
    REFUSES(fault, f.index.tracks[2] = 416);
    REFUSES(fault, f.index.tracks[1] = 20);
    REFUSES(fault, f.index.tracks[2] = 49);
}

TEST_F(RecordIndex, HasItsStatesInTheRecord)
{
    const char *const fault = "has a state that is not in it";
    OPENS(f.index.states[1].block = 2);
    REFUSES(fault, f.index.states[1].block = 3);
    OPENS(f.index.states[0].at = 17);
    REFUSES(fault, f.index.states[0].at = 16);
    OPENS(f.index.states[1].at = 151);
    REFUSES(fault, f.index.states[1].at = 150);
    OPENS(f.index.states[1].at = 415);
    REFUSES(fault, f.index.states[1].at = 416);
    OPENS(f.index.states[1].steps_before = 3, f.index.states[1].earliest_s = HUGE_VAL);
    REFUSES(fault, f.index.states[1].steps_before = 4, f.index.states[1].earliest_s = HUGE_VAL);
}

// A state that no step follows has no time, which is the latest of all.
TEST_F(RecordIndex, HasATimeForEachStateThatAStepFollows)
{
    const char *const fault = "has a state without a time";
    REFUSES(fault, f.index.states[1].steps_before = 3);
    for (const double time_s : {HUGE_VAL, -HUGE_VAL, double(NAN)})
        refuses(
            fault, [=](Forged &f) { f.index.states[1].earliest_s = time_s; }, __LINE__);
    for (const double time_s : {-HUGE_VAL, double(NAN)})
        refuses(
            fault,
            [=](Forged &f) {
                f.index.states.resize(1);
                f.index.step_count = 0, f.index.states[0].earliest_s = time_s;
            },
            __LINE__);
    OPENS(f.index.states[1].steps_before = 3, f.index.states[1].earliest_s = HUGE_VAL);
}

TEST_F(RecordIndex, HasTracksForEachStateOnceAndInOrder)
{
    const char *const fault = "has a state with other tracks";
    REFUSES(fault, f.index.states[0].first_run = 1);
    for (const uint32_t first : {1u, 3u})
        refuses(
            fault, [=](Forged &f) { f.index.states[1].first_run = first, f.index.states[1].runs = 0; }, __LINE__);
    REFUSES(fault, f.index.states[0].runs = 3, f.index.runs[2] = {2, 1}, f.index.runs[1] = {1, 1},
            f.index.states[1].first_run = 3);
    OPENS(f.index.states[1].runs = 0);
    // A run ends where the next one may begin, and with the last track.
    OPENS(f.index.runs[0] = {0, 2});
    REFUSES(fault, f.index.runs[0] = {0, 3});
    REFUSES(fault, f.index.runs[1] = {2, 2});
    REFUSES(fault, f.index.runs[2] = {1, 0xffffffffu});
}

TEST_F(RecordIndex, HasItsStatesInOrder)
{
    const char *const fault = "has states out of order";
    const auto in_one_block = [](Forged &f, uint64_t at, uint32_t block, uint64_t block_at) {
        f.index.states[1].at = at, f.index.states[1].block = block, f.index.states[1].block_at = block_at;
    };
    opens([&](Forged &f) { in_one_block(f, 41, 0, 16); }, __LINE__);
    refuses(
        fault, [&](Forged &f) { in_one_block(f, 40, 0, 16); }, __LINE__);
    refuses(
        fault, [&](Forged &f) { in_one_block(f, 200, 1, 16); }, __LINE__);
    refuses(
        fault, [&](Forged &f) { in_one_block(f, 200, 0, 150); }, __LINE__);
    refuses(
        fault, [&](Forged &f) { in_one_block(f, 200, 1, 15); }, __LINE__);
    // A later block that stands before, and an earlier one that stands behind.
    const auto third = [](Forged &f, uint32_t block, uint64_t block_at) {
        f.index.states.push_back({300, block_at, block, 2, 4, 3, 0});
    };
    opens([&](Forged &f) { third(f, 2, 250); }, __LINE__);
    refuses(
        fault, [&](Forged &f) { third(f, 2, 149); }, __LINE__);
    refuses(
        fault, [&](Forged &f) { third(f, 0, 250); }, __LINE__);
    OPENS(f.index.states[1].steps_before = 0);
    refuses(
        fault,
        [&](Forged &f) {
            third(f, 2, 250);
            f.index.states[2].steps_before = 1;
        },
        __LINE__);
    OPENS(f.index.states[1].earliest_s = 1);
    REFUSES(fault, f.index.states[1].earliest_s = 0.999);
}

}  // namespace

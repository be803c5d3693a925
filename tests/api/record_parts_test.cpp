// Records that are opened by their index show what those show that are read at once, and read what they show.
#include <algorithm>
#include <cmath>
#include <thread>

#include "lib/record/format.h"
#include "tests/api/record_fixture.h"

namespace
{

namespace format = claque::record;
using records::Bytes;
using records::number_in;
using records::Player;
using records::Recording;
using records::Shown;

constexpr uint32_t steps = 1500;

class RecordsInParts : public testing::Test
{
protected:
    // Gives a block that was changed right checksums.
    static void seal(Bytes &bytes, size_t block, uint64_t number)
    {
        const auto size = static_cast<uint32_t>(number_in(bytes, block, 4));
        const uint64_t checksum = format::checksum_of(bytes.data() + block + format::block_header_bytes, size, number);
        saved::put(bytes, block + 4, format::check_of_header(size, checksum, number), 4);
        saved::put(bytes, block + 8, checksum, 8);
    }

    TestWorld world_;
    Recording run_ = records::run(world_, steps, 21, 1500);
};

// Those of a small world, in which a state is a few parts of a hundred of the record.
TEST_F(RecordsInParts, ShowAnyStepAsThoseThatAreReadAtOnce)
{
    const Player whole(world_, run_.bytes);
    ASSERT_GT(whole.info().state_count, 15u);
    for (const uint64_t order : {1u, 7u, 89u, 1499u}) {
        Player parts(world_, run_.bytes, clq_record_open);
        for (uint64_t i = 0; i<steps; i += order> 1 ? 9 : 1) {
            Shown seen;
            const uint64_t step = i * order % steps;
            parts.show(step, seen);
            ASSERT_EQ(seen.lists[0], run_.shown.lists[step]) << "step " << step << ", order " << order;
            ASSERT_EQ(seen.crowds[0], run_.shown.crowds[step]) << "step " << step << ", order " << order;
        }
        ASSERT_EQ(clq_record_play_step(parts.record, parts.crowd, steps), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(parts.crowd), run_.last_hash);
    }
}

TEST_F(RecordsInParts, SayOfThemselvesWhatThoseSayThatAreReadAtOnce)
{
    const Player whole(world_, run_.bytes), parts(world_, run_.bytes, clq_record_open);
    const clq_record_info a = whole.info(), b = parts.info();
    EXPECT_TRUE(b.whole);
    EXPECT_EQ(b.template_count, a.template_count);
    EXPECT_EQ(b.track_count, a.track_count);
    EXPECT_EQ(b.step_count, a.step_count);
    EXPECT_EQ(b.call_count, a.call_count);
    EXPECT_EQ(b.state_count, a.state_count);
    EXPECT_EQ(b.start_s, a.start_s);
    EXPECT_EQ(b.end_s, a.end_s);
    EXPECT_EQ(std::string(clq_record_get_template_name(parts.record, 1)),
              clq_record_get_template_name(whole.record, 1));
}

// The clock of the run goes back: times come more than once.
TEST_F(RecordsInParts, HaveTheSameStepAtATime)
{
    Player whole(world_, run_.bytes), parts(world_, run_.bytes, clq_record_open);
    const uint64_t times = 300;
    for (uint64_t i = 0; i < times; ++i) {
        const double time_s = -1 + 90 * double(i * 77 % times) / times;
        ASSERT_EQ(clq_record_play(whole.record, whole.crowd, time_s), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_record_play(parts.record, parts.crowd, time_s), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_get_hash(parts.crowd), clq_crowd_get_hash(whole.crowd)) << time_s;
    }
}

// A clock that begins again: the parts of the first pass have times that come later too.
TEST_F(RecordsInParts, HaveTheLastPassOfAClockThatWentBack)
{
    clq_crowd *crowd = world_.new_crowd();
    world_.set_up(crowd);
    const std::vector<clq_actor> actors = world_.fill(crowd, 20, 1);
    Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes, 100);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK);
    std::vector<clq_transform> places(actors.size(), clq_transform_init());
    constexpr uint32_t pass = 100;
    std::vector<uint64_t> hashes;
    for (uint32_t step = 0; step < 2 * pass; ++step) {
        for (clq_transform &place : places) place.position[0] = step;
        ASSERT_EQ(clq_crowd_set_transforms(crowd, actors.data(), places.data(), static_cast<uint32_t>(places.size())),
                  CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd, step < pass ? step : step - pass + 40, nullptr, 0), CLQ_OK);
        hashes.push_back(clq_crowd_get_hash(crowd));
    }
    ASSERT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK);
    Player parts(world_, bytes, clq_record_open);
    ASSERT_TRUE(parts.opened()) << clq_last_error();
    ASSERT_GT(parts.info().state_count, 5u);
    for (uint32_t k = 0; k < pass + 39; ++k) {
        const uint32_t time_s = k * 50 % (pass + 39);  // no two that follow each other lie near
        ASSERT_EQ(clq_record_play(parts.record, parts.crowd, time_s + 0.5), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(parts.crowd), hashes[time_s < 40 ? time_s : time_s + pass - 40]) << time_s;
    }
    for (uint32_t step = 0; step < 2 * pass; ++step) {
        ASSERT_EQ(clq_record_play_step(parts.record, parts.crowd, step), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(parts.crowd), hashes[step]) << step;
    }
}

TEST_F(RecordsInParts, AreReadWhereTheyArePlayed)
{
    EXPECT_EQ(Player(world_, run_.bytes).info().read_bytes, run_.bytes.size());
    Player parts(world_, run_.bytes, clq_record_open);
    const uint64_t states = parts.info().state_count, index = parts.info().read_bytes;
    EXPECT_LT(index, run_.bytes.size() / 10) << "the index alone";
    // The largest part: a state, the calls after it, and one step more; besides the tracks.
    const uint64_t part = 4 * run_.bytes.size() / states;
    Shown seen;
    parts.show(steps / 2, seen);
    const uint64_t one = parts.info().read_bytes;
    EXPECT_GT(one, index);
    EXPECT_LT(one, index + part);
    parts.show(steps / 2, seen);
    parts.show(steps / 2 - 1, seen), parts.show(steps / 2, seen);
    EXPECT_LT(parts.info().read_bytes, index + 2 * part) << "what was read stays";
    Player tenth(world_, run_.bytes, clq_record_open);
    for (uint32_t step = steps / 2; step < steps / 2 + steps / 10; ++step) tenth.show(step, seen);
    EXPECT_LT(tenth.info().read_bytes, index + 2 * part + run_.bytes.size() / 10);
}

TEST_F(RecordsInParts, ArePlayedByThreadsSideBySide)
{
    Player parts(world_, run_.bytes, clq_record_open);
    const auto play = [&](uint64_t seed, std::vector<uint64_t> &out) {
        clq_crowd *crowd = nullptr;
        if (clq_crowd_create(world_.context, nullptr, &crowd) != CLQ_OK) return;
        for (uint64_t i = 0; i < 40; ++i) {
            const uint64_t step = mixed(seed, i) % steps;
            clq_record_info info = clq_record_info_init();
            double time_s = 0;
            EXPECT_EQ(clq_record_get_info(parts.record, &info), CLQ_OK) << clq_last_error();
            EXPECT_EQ(clq_record_get_time(parts.record, step, &time_s), CLQ_OK) << clq_last_error();
            if (clq_record_play_step(parts.record, crowd, step) == CLQ_OK) out.push_back(clq_crowd_get_hash(crowd));
        }
        clq_crowd_destroy(crowd);
    };
    std::vector<uint64_t> seen[3];
    std::vector<std::thread> threads;
    for (uint64_t k = 0; k < 3; ++k) threads.emplace_back([&, k] { play(k, seen[k]); });
    for (std::thread &thread : threads) thread.join();
    for (uint64_t k = 0; k < 3; ++k) {
        std::vector<uint64_t> alone;
        play(k, alone);
        EXPECT_EQ(seen[k], alone);
        EXPECT_EQ(alone.size(), 40u);
    }
}

TEST_F(RecordsInParts, ThatWereCutOffOrAreOldAreReadAtOnce)
{
    Bytes cut(run_.bytes.begin(), run_.bytes.end() - 1), old = run_.bytes;
    old[8] = 1;
    for (const Bytes &bytes : {cut, old}) {
        Player parts(world_, bytes, clq_record_open);
        ASSERT_TRUE(parts.opened()) << clq_last_error();
        EXPECT_EQ(parts.info().read_bytes, bytes.size());
        Shown seen;
        parts.show(steps - 1, seen);
        EXPECT_EQ(seen.lists[0], run_.shown.lists[steps - 1]);
    }
}

// Whatever a byte becomes: a step is shown as it was, or refused, and the crowd stays good.
TEST_F(RecordsInParts, WithAChangedByteShowNothingElse)
{
    size_t refused_first = 0, refused_later = 0, unharmed = 0;
    Bytes bytes = run_.bytes;
    for (size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 400) {
        bytes[at] ^= uint8_t(1u << at % 8);
        Player parts(world_, bytes, clq_record_open);
        bool refused = !parts.opened();
        refused_first += refused;
        for (uint64_t step = 0; step < steps && !refused; step += 40) {
            const clq_status status = clq_record_play_step(parts.record, parts.crowd, step);
            refused = status != CLQ_OK;
            if (refused) {
                EXPECT_EQ(status, CLQ_FORMAT) << clq_last_error();
            } else {
                ASSERT_EQ(clq_crowd_get_hash(parts.crowd), run_.shown.crowds[step]) << "byte " << at;
            }
            if (refused) ++refused_later;
        }
        unharmed += !refused;
        bytes[at] ^= uint8_t(1u << at % 8);
    }
    EXPECT_GT(refused_first, 0u);
    EXPECT_GT(refused_later, 300u);
    EXPECT_LT(unharmed, 20u) << "blocks after the last step";
}

// A part is read when it is played. The templates that it names have to be there, as in a record that is read at once.
TEST_F(RecordsInParts, WithAStateOfATemplateThatIsNotThereAreRefusedWhereTheyArePlayed)
{
    Bytes bytes = run_.bytes;
    size_t at = format::file_header_bytes + format::block_header_bytes;
    while (static_cast<format::Kind>(bytes[at + 4]) != format::Kind::state) at += 4 + number_in(bytes, at, 4);
    ASSERT_EQ(number_in(bytes, at + 5, 4), 2u) << "templates";
    saved::put(bytes, at + 5 + 4, 2, 4);
    seal(bytes, format::file_header_bytes, 0);
    Player parts(world_, bytes, clq_record_open);
    ASSERT_TRUE(parts.opened()) << clq_last_error();
    EXPECT_EQ(clq_record_play_step(parts.record, parts.crowd, 0), CLQ_FORMAT);
    EXPECT_STREQ(clq_last_error(), "clq_record_play_step: a record names template 2, and has 2 before");
}

// An index of any content under right checksums.
TEST_F(RecordsInParts, WithAnyIndexAreRefusedOrHarmless)
{
    const size_t end = run_.bytes.size(), block = number_in(run_.bytes, end - 12, 8),
                 begin = block + format::block_header_bytes;
    const auto number = static_cast<uint32_t>(number_in(run_.bytes, end - 4, 4)),
               size = static_cast<uint32_t>(end - begin);
    size_t refused = 0, played = 0;
    for (uint64_t seed = 0; seed < 3000; ++seed) {
        Bytes bytes = run_.bytes;
        for (uint64_t k = 0; k <= mixed(seed, 1) % 3; ++k) {
            const size_t at = begin + mixed(seed, 10 + k) % size, other = begin + mixed(seed, 20 + k) % (size - 8);
            const uint64_t kind = mixed(seed, 30 + k) % 4;
            // A byte, a small change, or the number of another place.
            if (kind == 0) bytes[at] = static_cast<uint8_t>(mixed(seed, 40 + k));
            else if (kind == 1) ++bytes[at];
            else if (kind == 2) --bytes[at];
            else
                for (size_t i = 0; i < 8 && at + i < end; ++i) bytes[at + i] = run_.bytes[other + i];
        }
        seal(bytes, block, number);
        clq_record *record = nullptr;
        if (clq_record_open(world_.context, bytes.data(), end, &record) != CLQ_OK) {
            ++refused;
            continue;
        }
        clq_crowd *crowd = nullptr;
        ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK);
        world_.set_up(crowd);
        const clq_status given = clq_record_set_templates(record, world_.templates, 2);
        for (uint64_t k = 0; k < 4 && given == CLQ_OK; ++k) {
            const clq_status status = clq_record_play_step(record, crowd, mixed(seed, 50 + k) % steps);
            EXPECT_TRUE(status == CLQ_OK || status == CLQ_FORMAT || status == CLQ_ARGUMENT) << clq_last_error();
            EXPECT_EQ(clq_crowd_update(crowd, 1, nullptr, 0), CLQ_OK) << clq_last_error();
            ++(status == CLQ_OK ? played : refused);
        }
        clq_crowd_destroy(crowd);
        clq_record_destroy(record);
    }
    EXPECT_GT(refused, 1000u);
    EXPECT_GT(played, 1000u);
}

}  // namespace

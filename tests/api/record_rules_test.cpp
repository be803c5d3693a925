// The rules of records: times, states, tracks, what is missing.
#include <algorithm>
#include <cmath>

#include "tests/api/record_fixture.h"

namespace
{

using records::Bytes;
using records::Recording;

class RecordRules : public testing::Test
{
protected:
    TestWorld world_;
};

TEST_F(RecordRules, HaveTheLastStepAtOrBeforeATime)
{
    clq_crowd *crowd = world_.new_crowd();
    Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK) << clq_last_error();
    clq_actor_def actor = clq_actor_def_init();
    actor.tmpl = world_.templates[1];
    clq_actor made;
    std::vector<uint64_t> hashes;
    for (const double time_s : {1.0, 2.0, 3.0, 1.5, 2.5}) {
        ASSERT_EQ(clq_actor_create(crowd, &actor, &made), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd, time_s, nullptr, 0), CLQ_OK);
        hashes.push_back(clq_crowd_get_hash(crowd));
    }
    ASSERT_EQ(clq_actor_create(crowd, &actor, &made), CLQ_OK);
    hashes.push_back(clq_crowd_get_hash(crowd));
    ASSERT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK);

    clq_record *record = nullptr;
    ASSERT_EQ(clq_record_load(world_.context, bytes.data(), bytes.size(), &record), CLQ_OK) << clq_last_error();
    EXPECT_STREQ(clq_record_get_template_name(record, 0), "plain");
    EXPECT_STREQ(clq_record_get_template_name(record, 1), "");
    ASSERT_EQ(clq_record_set_templates(record, world_.templates, 2), CLQ_OK) << clq_last_error();
    clq_record_info info = clq_record_info_init();
    ASSERT_EQ(clq_record_get_info(record, &info), CLQ_OK);
    EXPECT_EQ(info.start_s, 1);
    EXPECT_EQ(info.end_s, 3);
    EXPECT_EQ(info.step_count, 5u);
    EXPECT_EQ(info.call_count, 6u);
    EXPECT_TRUE(info.whole);
    clq_crowd *played = world_.new_crowd();
    const std::pair<double, size_t> expected[] = {{-9, 0},  {0, 0},   {1, 0},   {1.4, 0}, {1.5, 3}, {2, 3},
                                                  {2.4, 3}, {2.5, 4}, {2.6, 5}, {99, 5},  {1.2, 0}};
    for (const auto &[time_s, step] : expected) {
        ASSERT_EQ(clq_record_play(record, played, time_s), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(played), hashes[step]) << time_s << " s";
    }
    EXPECT_EQ(clq_record_play(record, played, NAN), CLQ_ARGUMENT);
    clq_record_destroy(record);
}

// An interval of calls between two states is as long as the first state or key_bytes, and one step.
TEST_F(RecordRules, HaveAStateForAsManyBytesAsItHas)
{
    clq_crowd *crowd = world_.new_crowd();
    world_.set_up(crowd);
    std::vector<clq_actor> actors = world_.fill(crowd, 20, 1);
    const uint64_t state_bytes = saved::save(crowd).size();
    Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes, 100);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK);
    std::vector<clq_transform> places(actors.size(), clq_transform_init());
    const auto count = static_cast<uint32_t>(actors.size());
    clq_recording_info info = clq_recording_info_init();
    uint64_t states = 0, last = bytes.size(), widest = 0, narrowest = ~uint64_t(0), step_bytes = 0;
    for (uint32_t step = 0; step < 200; ++step) {
        const uint64_t before = bytes.size();
        ASSERT_EQ(clq_crowd_set_transforms(crowd, actors.data(), places.data(), count), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd, step, nullptr, 0), CLQ_OK);
        ASSERT_EQ(clq_crowd_get_recording(crowd, &info), CLQ_OK);
        if (info.key_states == states) {
            step_bytes = bytes.size() - before;
            continue;
        }
        const uint64_t between = before - last;
        if (states > 0) widest = std::max(widest, between), narrowest = std::min(narrowest, between);
        states = info.key_states, last = bytes.size();
    }
    EXPECT_GT(states, 5u);
    EXPECT_LE(widest, state_bytes + 2 * step_bytes + 100);
    EXPECT_GE(narrowest + step_bytes, state_bytes);
    EXPECT_LE(bytes.size(), 2.1 * 200 * double(step_bytes)) << "states are at most as large as the calls";
    ASSERT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK);
}

TEST_F(RecordRules, WriteATrackOnceWhenAnActorFirstFollowsIt)
{
    clq_crowd *crowd = world_.new_crowd();
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = world_.templates[0];
    clq_actor actors[3];
    for (clq_actor &actor : actors) ASSERT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    Bytes bytes;
    const clq_recording_def to = records::recording_to(bytes);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &to), CLQ_OK);
    clq_recording_info info = clq_recording_info_init();
    const auto tracks = [&] {
        EXPECT_EQ(clq_crowd_get_recording(crowd, &info), CLQ_OK);
        return info.tracks;
    };
    EXPECT_EQ(tracks(), 0u) << "that the crowd knows them does not matter";
    // A track that is made during the recording, and that the host gives up at once.
    clq_track *young = nullptr;
    ASSERT_EQ(Walker::track(world_.locomotion, 77, &young), CLQ_OK);
    ASSERT_EQ(clq_actor_follow_track(crowd, actors[0], young, 0), CLQ_OK);
    clq_track_destroy(young);
    EXPECT_EQ(tracks(), 1u);
    ASSERT_EQ(clq_actor_follow_track(crowd, actors[1], world_.tracks[0], 0), CLQ_OK);
    ASSERT_EQ(clq_actor_follow_track(crowd, actors[2], world_.tracks[0], 1), CLQ_OK);
    EXPECT_EQ(tracks(), 2u);
    ASSERT_EQ(clq_crowd_update(crowd, 2, nullptr, 0), CLQ_OK);
    const uint64_t hash = clq_crowd_get_hash(crowd);
    ASSERT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK);

    clq_record *record = nullptr;
    ASSERT_EQ(clq_record_load(world_.context, bytes.data(), bytes.size(), &record), CLQ_OK);
    ASSERT_EQ(clq_record_set_templates(record, world_.templates, 1), CLQ_OK) << clq_last_error();
    clq_record_info read = clq_record_info_init();
    ASSERT_EQ(clq_record_get_info(record, &read), CLQ_OK);
    EXPECT_EQ(read.track_count, 2u);
    clq_crowd *played = nullptr;
    ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &played), CLQ_OK);
    ASSERT_EQ(clq_record_play(record, played, 2), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_get_hash(played), hash);
    clq_record_destroy(record);  // the crowd keeps the tracks
    EXPECT_EQ(clq_crowd_update(played, 2.5, nullptr, 0), CLQ_OK);
    EXPECT_EQ(clq_crowd_destroy(played), CLQ_OK);
}

// As a host that decides while it records makes them: each piece is given up once it is followed.
TEST_F(RecordRules, HaveThePiecesOfATrackThatIsMadeMeanwhile)
{
    clq_crowd *crowd = nullptr, *played = nullptr;
    ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK);
    ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &played), CLQ_OK);
    clq_view *view = world_.new_view(crowd, 0), *other = world_.new_view(played, 0);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = world_.templates[0];
    clq_actor actor;
    ASSERT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    Bytes bytes;
    const clq_recording_def to = records::recording_to(bytes, 100);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &to), CLQ_OK);
    std::vector<clq_track_point> points;
    for (int i = 0; i < 200; ++i) points.push_back({0.1 * i, {std::sin(0.05 * i), 0, -2 - 0.1 * i}, NAN});
    clq_track *last = nullptr;
    std::vector<uint64_t> lists;
    for (int piece = 0; piece < 12; ++piece) {
        clq_track_def track = clq_track_def_init();
        track.points = points.data(), track.point_count = 200;
        track.previous = last, track.end_s = piece + 2.0;
        clq_track *made = nullptr;
        ASSERT_EQ(clq_track_create(world_.locomotion, &track, &made), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_actor_follow_track(crowd, actor, made, 0), CLQ_OK) << clq_last_error();
        clq_track_destroy(last);
        last = made;
        ASSERT_EQ(clq_crowd_release_tracks(crowd, nullptr), CLQ_OK);
        for (int k = 0; k < 4; ++k) {
            ASSERT_EQ(clq_crowd_update(crowd, piece + 0.25 * k, &view, 1), CLQ_OK);
            lists.push_back(clq_view_get_hash(view));
        }
    }
    clq_track_destroy(last);
    clq_recording_info info = clq_recording_info_init();
    ASSERT_EQ(clq_crowd_end_recording(crowd, &info), CLQ_OK);
    EXPECT_EQ(info.tracks, 12u);
    EXPECT_GT(info.key_states, 5u);
    clq_record *record = nullptr;
    for (const auto opening : {clq_record_load, clq_record_open}) {
        clq_record_destroy(record);
        ASSERT_EQ(opening(world_.context, bytes.data(), bytes.size(), &record), CLQ_OK);
        ASSERT_EQ(clq_record_set_templates(record, world_.templates, 1), CLQ_OK) << clq_last_error();
        for (const uint32_t first : {0u, 17u, 5u})
            for (uint32_t step = first; step < lists.size(); step += 1 + first) {
                ASSERT_EQ(clq_record_play_step(record, played, step), CLQ_OK) << clq_last_error();
                ASSERT_EQ(clq_crowd_update(played, 0.25 * step, &other, 1), CLQ_OK);
                EXPECT_EQ(clq_view_get_hash(other), lists[step]) << step;
                if (step % 7 == 0) {
                    ASSERT_EQ(clq_crowd_release_tracks(played, nullptr), CLQ_OK);
                }
            }
    }
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
    clq_record_destroy(record);
    EXPECT_EQ(clq_crowd_update(played, 3, &other, 1), CLQ_OK) << "it holds the pieces that it shows";
    EXPECT_EQ(clq_crowd_destroy(played), CLQ_OK);
}

TEST_F(RecordRules, AreRefusedWhereSomethingIsMissing)
{
    const Recording run = records::run(world_, 10, 3);
    const auto says = [](const char *sentence) {
        return std::string(clq_last_error()).find(sentence) != std::string::npos ? "" : clq_last_error();
    };
    clq_record *record = nullptr;
    ASSERT_EQ(clq_record_load(world_.context, run.bytes.data(), run.bytes.size(), &record), CLQ_OK);
    clq_crowd *crowd = nullptr;
    ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK);
    EXPECT_EQ(clq_record_play(record, crowd, 0), CLQ_ARGUMENT);
    EXPECT_STREQ(says("has no templates yet"), "");
    EXPECT_EQ(clq_record_set_templates(record, world_.templates, 1), CLQ_ARGUMENT);
    EXPECT_STREQ(says("template 'plain' of the recorded crowd is not among those given"), "");
    ASSERT_EQ(clq_record_set_templates(record, world_.templates, 2), CLQ_OK);
    EXPECT_EQ(clq_record_set_templates(record, world_.templates, 2), CLQ_ARGUMENT);
    EXPECT_STREQ(says("has its templates already"), "");
    EXPECT_EQ(clq_record_play(record, crowd, 0), CLQ_ARGUMENT);
    EXPECT_STREQ(says("mechanism 6 of the saved crowd is the host's own"), "");
    EXPECT_STREQ(says("clq_record_lend_mechanism lends one"), "");
    EXPECT_EQ(clq_record_play_step(record, crowd, 11), CLQ_ARGUMENT);
    EXPECT_STREQ(says("step 11 does not exist: the record has 10"), "");
    TestWorld abroad;
    EXPECT_EQ(clq_record_play(record, abroad.new_crowd(), 0), CLQ_ARGUMENT);
    EXPECT_STREQ(says("of another context"), "");
    Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK);
    EXPECT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_ARGUMENT);
    EXPECT_STREQ(says("recorded already"), "");
    EXPECT_EQ(clq_record_play(record, crowd, 0), CLQ_ARGUMENT);
    EXPECT_STREQ(says("is recorded itself"), "");
    ASSERT_EQ(clq_crowd_end_recording(crowd, nullptr), CLQ_OK);
    clq_recording_info info = clq_recording_info_init();
    EXPECT_EQ(clq_crowd_end_recording(crowd, &info), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_recording(crowd, &info), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
    clq_record_destroy(record);
}

TEST_F(RecordRules, EndWithTheirCrowd)
{
    clq_crowd *crowd = nullptr;
    ASSERT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK);
    Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes);
    ASSERT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK);
    ASSERT_EQ(clq_crowd_update(crowd, 1, nullptr, 0), CLQ_OK);
    ASSERT_EQ(clq_crowd_destroy(crowd), CLQ_OK);
    clq_record *record = nullptr;
    ASSERT_EQ(clq_record_load(world_.context, bytes.data(), bytes.size(), &record), CLQ_OK);
    clq_record_info info = clq_record_info_init();
    ASSERT_EQ(clq_record_get_info(record, &info), CLQ_OK);
    EXPECT_TRUE(info.whole);
    EXPECT_EQ(info.step_count, 1u);
    clq_record_destroy(record);
}

}  // namespace

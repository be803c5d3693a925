// Every call that changes a crowd is recorded, or named here with the reason why it is not.
#include "tests/api/record_calls.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/patterns.h"

namespace
{

using records::Recorded;
using records::Stage;

// Calls that take a crowd, or a view of it, to change it, and are not recorded.
const std::map<std::string, std::string> not_recorded = {
    {"clq_actor_get_node", "changes scratch memory only"},
    {"clq_actor_set_hooks", "callbacks are code of the host"},
    {"clq_crowd_add_track", "a track is recorded when an actor first follows it"},
    {"clq_crowd_begin_recording", "makes the record"},
    {"clq_crowd_destroy", "ends the record"},
    {"clq_crowd_end_recording", "ends the record"},
    {"clq_crowd_get_events", "changes scratch memory only"},
    {"clq_crowd_release_tracks", "what an actor follows stays"},
    {"clq_crowd_reset_bands", "statistics are not what a crowd shows"},
    {"clq_crowd_set_ground", "callbacks are code of the host"},
    {"clq_crowd_set_step_clock", "callbacks are code of the host"},
    {"clq_record_play", "refused for a crowd that is recorded"},
    {"clq_record_play_step", "refused for a crowd that is recorded"},
    {"clq_renderer_draw", "draws"},
    {"clq_renderer_draw_shadows", "draws"},
    {"clq_renderer_draw_visibility", "draws"},
    {"clq_scene_create", "scenes belong to the host that asks"},
    {"clq_stage_apply", "makes calls that are recorded"},
    {"clq_stage_restore", "makes tracks known, as clq_crowd_add_track"},
    {"clq_view_create", "views belong to the host that looks"},
    {"clq_view_destroy", "views belong to the host that looks"},
    {"clq_view_set_camera", "views belong to the host that looks"},
    {"clq_view_set_cull_scale", "views belong to the host that looks"},
    {"clq_view_set_height", "views belong to the host that looks"},
    {"clq_view_set_tile", "views belong to the host that looks"},
    {"clq_view_set_shadow", "views belong to the host that looks"},
};

// Functions of the headers that may change a crowd or a view: those that take one which is not const.
std::set<std::string> declared()
{
    std::set<std::string> out;
    const std::string call = R"(CLQ_API\s[^;(]*?\b(clq_\w+)\(([^;]*)\);)";
    for (const auto &header : std::filesystem::directory_iterator(CLAQUE_SOURCE_DIR "/include/claque")) {
        std::stringstream text;
        text << std::ifstream(header.path()).rdbuf();
        for (const patterns::Match &found : patterns::matches(call, text.str())) {
            std::stringstream arguments(found[2]);
            for (std::string one; std::getline(arguments, one, ',');)
                if (one.find("clq_crowd *") != std::string::npos || one.find("clq_view *") != std::string::npos)
                    if (one.find("const") == std::string::npos && one.find("**") == std::string::npos)
                        out.insert(found[1]);
        }
    }
    return out;
}

TEST(RecordTable, HoldsEveryCallThatChangesACrowd)
{
    std::set<std::string> listed;
    for (const Recorded &one : records::recorded_calls()) EXPECT_TRUE(listed.insert(one.first).second) << one.first;
    for (const auto &one : not_recorded) EXPECT_TRUE(listed.insert(one.first).second) << one.first;
    EXPECT_GT(declared().size(), 50u);
    std::vector<std::string> missing, extra;
    const std::set<std::string> all = declared();
    std::set_difference(all.begin(), all.end(), listed.begin(), listed.end(), std::back_inserter(missing));
    std::set_difference(listed.begin(), listed.end(), all.begin(), all.end(), std::back_inserter(extra));
    EXPECT_EQ(missing, std::vector<std::string>()) << "record it (docs/records.md), or say here why it is not";
    EXPECT_EQ(extra, std::vector<std::string>()) << "no header has such a call";
}

TEST(RecordedCalls, EachMakeTheSameWhenTheyArePlayed)
{
    for (const auto &[name, run] : records::recorded_calls()) {
        Stage stage;
        records::Bytes bytes;
        const clq_recording_def def = records::recording_to(bytes);
        ASSERT_EQ(clq_crowd_begin_recording(stage.crowd, &def), CLQ_OK) << clq_last_error();
        const uint64_t before = clq_crowd_get_hash(stage.crowd);
        EXPECT_EQ(run(stage), CLQ_OK) << name << ": " << clq_last_error();
        clq_recording_info info = clq_recording_info_init();
        ASSERT_EQ(clq_crowd_end_recording(stage.crowd, &info), CLQ_OK) << clq_last_error();
        EXPECT_GT(info.calls + info.steps, 0u) << name;
        // The test's templates have one texture set.
        const bool keeps =
            name == "clq_crowd_update" || name == "clq_crowd_restore" || name == "clq_actor_set_texture_set";
        EXPECT_EQ(clq_crowd_get_hash(stage.crowd) == before, keeps) << name << " is a change that can be seen";

        records::Player player(stage.world, bytes);
        ASSERT_TRUE(player.opened()) << name << ": " << clq_last_error();
        ASSERT_EQ(clq_record_play(player.record, player.crowd, 100), CLQ_OK) << name << ": " << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(player.crowd), clq_crowd_get_hash(stage.crowd)) << name;
        EXPECT_EQ(player.info().call_count + player.info().state_count - 1, info.calls) << name;
    }
}

TEST(RecordedCalls, ThatFailAreNotRecorded)
{
    Stage stage;
    records::Bytes bytes;
    const clq_recording_def def = records::recording_to(bytes);
    ASSERT_EQ(clq_crowd_begin_recording(stage.crowd, &def), CLQ_OK);
    const clq_actor stale = {99, 1};
    const clq_transform place = clq_transform_init();
    const clq_play play = {99, 0, 1, 0};
    clq_actor made;
    EXPECT_EQ(clq_actor_destroy(stage.crowd, stale), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_play(stage.crowd, stage.actor, &play), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_set_transforms(stage.crowd, &stale, &place, 1), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_clone(stage.crowd, stale, nullptr, 1, &made), CLQ_STALE_ID);
    EXPECT_EQ(clq_crowd_restore(stage.crowd, "no", 2, stage.world.templates, 2), CLQ_FORMAT);
    EXPECT_EQ(clq_crowd_update(stage.crowd, 1.0 / 0.0, nullptr, 0), CLQ_ARGUMENT);
    clq_recording_info info = clq_recording_info_init();
    ASSERT_EQ(clq_crowd_end_recording(stage.crowd, &info), CLQ_OK);
    EXPECT_EQ(info.calls + info.steps, 0u);
}

}  // namespace

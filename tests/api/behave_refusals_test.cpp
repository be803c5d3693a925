// Invalid definitions, attachments and commands of mechanisms, each with its message.
#include <cmath>

#include "tests/api/behave_api.h"

TEST_F(BehaveApi, RefusesDefsByTheirFirstBrokenRule)
{
    using Def = clq_mechanism_def;
    refused(CLQ_MECHANISM_BLINK, "tmpl is NULL", [](Def &d) { d.tmpl = nullptr; });
    refused(CLQ_MECHANISM_BLINK, "no actor of the crowd uses tmpl", [this](Def &d) { d.tmpl = other_; });
    refused(CLQ_MECHANISM_BLINK, "kind is 6", [](Def &d) { d.kind = static_cast<clq_mechanism_kind>(6); });
    refused(CLQ_MECHANISM_BLINK, "level_m[1] is 10", [](Def &d) { d.level_m[0] = 20, d.level_m[1] = 10; });
    refused(CLQ_MECHANISM_BLINK, "level_m[2] is 5", [](Def &d) { d.level_m[2] = 5; });
    refused(CLQ_MECHANISM_BLINK, "off_m is -3", [](Def &d) { d.off_m = -3; });
    Def old = def(CLQ_MECHANISM_BLINK);
    old.struct_bytes = 12;
    clq_mechanism out;
    EXPECT_EQ(clq_crowd_add_mechanism(crowd_, &old, &out), CLQ_STRUCT_SIZE);
    EXPECT_EQ(clq_crowd_add_mechanism(nullptr, &old, &out), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_add_mechanism(crowd_, nullptr, &out), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_add_mechanism(crowd_, &old, nullptr), CLQ_ARGUMENT);
}

TEST_F(BehaveApi, RefusesInvalidGazes)
{
    using Def = clq_mechanism_def;
    refused(CLQ_MECHANISM_GAZE, "names no degree of freedom",
            [](Def &d) { d.gaze.neck_yaw = d.gaze.neck_pitch = CLQ_NONE; });
    refused(CLQ_MECHANISM_GAZE, "eye_yaw is degree of freedom 3, which does not exist: there are 3",
            [](Def &d) { d.gaze.eye_yaw[1] = 3; });
    refused(CLQ_MECHANISM_GAZE, "spine_pitch is degree of freedom 2 'shift', which is no rotation",
            [](Def &d) { d.gaze.spine_pitch = shift; });
    refused(CLQ_MECHANISM_GAZE, "neck_share is 1.5", [](Def &d) { d.gaze.neck_share = 1.5f; });
    refused(CLQ_MECHANISM_GAZE, "spine_share is nan", [](Def &d) { d.gaze.spine_share = NAN; });
    refused(CLQ_MECHANISM_GAZE, "coordinate 2 of eyes", [](Def &d) { d.gaze.eyes[2] = INFINITY; });
    refused(CLQ_MECHANISM_GAZE, "turn_s is -1", [](Def &d) { d.gaze.turn_s = -1; });
    refused(CLQ_MECHANISM_GAZE, "wander_s is inf", [](Def &d) { d.gaze.wander_s = INFINITY; });
    refused(CLQ_MECHANISM_GAZE, "wander_yaw_rad is 4", [](Def &d) { d.gaze.wander_yaw_rad = 4; });
    refused(CLQ_MECHANISM_GAZE, "wander_pitch_rad is -0.1", [](Def &d) { d.gaze.wander_pitch_rad = -0.1f; });
}

TEST_F(BehaveApi, RefusesInvalidFaces)
{
    using Def = clq_mechanism_def;
    const clq_dof_value far = {turn, 2}, unknown = {3, 0}, twice[2] = {{turn, 0}, {turn, 1}}, no_number = {turn, NAN};
    const clq_dof_pose shapes[5] = {{1, &far}, {1, &unknown}, {2, twice}, {1, &no_number}, {1, nullptr}};
    const char *sentences[5] = {"puts degree of freedom 1 'turn' at 2: its range is -1 to 1",
                                "names degree of freedom 3, which does not exist: there are 3 in template",
                                "names degree of freedom 1 'turn' twice", "at nan", "NULL with a count of 1"};
    for (int i = 0; i < 5; ++i) {
        refused(CLQ_MECHANISM_EXPRESSION, sentences[i], [&](Def &d) { d.expression.poses = &shapes[i]; });
        refused(CLQ_MECHANISM_BLINK, sentences[i], [&](Def &d) { d.blink.closed = shapes[i]; });
        refused(CLQ_MECHANISM_PHRASE, sentences[i], [&](Def &d) { d.phrase.poses = &shapes[i]; });
    }
    const clq_dof_pose empty = {0, nullptr};
    refused(CLQ_MECHANISM_EXPRESSION, "none of 1 poses", [&](Def &d) { d.expression.poses = &empty; });
    refused(CLQ_MECHANISM_EXPRESSION, "pose_count is 0", [](Def &d) { d.expression.pose_count = 0; });
    refused(CLQ_MECHANISM_EXPRESSION, "poses is NULL", [](Def &d) { d.expression.poses = nullptr; });
    refused(CLQ_MECHANISM_EXPRESSION, "hold_s is 0", [](Def &d) { d.expression.hold_s = 0; });
    refused(CLQ_MECHANISM_EXPRESSION, "blend_s is 3: 0 to 2", [](Def &d) { d.expression.blend_s = 3; });
    refused(CLQ_MECHANISM_BLINK, "closed lids", [](Def &d) { d.blink.closed.count = 0; });
    refused(CLQ_MECHANISM_BLINK, "close_s is 0", [](Def &d) { d.blink.close_s = 0; });
    refused(CLQ_MECHANISM_BLINK, "period_s is 0.1", [](Def &d) { d.blink.period_s = 0.1f; });
}

TEST_F(BehaveApi, RefusesInvalidPhrasesClipsAndHosts)
{
    using Def = clq_mechanism_def;
    const clq_phrase_key late[1] = {{1, 0}}, back[2] = {{0, 0}, {0, 0}}, unknown[1] = {{0, 1}};
    refused(CLQ_MECHANISM_PHRASE, "key_count is 0", [](Def &d) { d.phrase.key_count = 0; });
    refused(CLQ_MECHANISM_PHRASE, "keys is NULL", [](Def &d) { d.phrase.keys = nullptr; });
    refused(CLQ_MECHANISM_PHRASE, "key 0 of the phrase is at 1 s", [&](Def &d) { d.phrase.keys = late; });
    refused(CLQ_MECHANISM_PHRASE, "key 1 of the phrase is at 0 s",
            [&](Def &d) { d.phrase.keys = back, d.phrase.key_count = 2; });
    refused(CLQ_MECHANISM_PHRASE, "key 0 of the phrase names pose 1, which does not exist: there are 1",
            [&](Def &d) { d.phrase.keys = unknown; });
    const clq_phrase_key two[2] = {{0, 0}, {1.5f, CLQ_NONE}};
    refused(CLQ_MECHANISM_PHRASE, "length_s is 1: a finite number of at least 1.5",
            [&](Def &d) { d.phrase.keys = two, d.phrase.key_count = 2; });
    refused(CLQ_MECHANISM_PHRASE, "length_s is 0", [](Def &d) { d.phrase.length_s = 0; });
    refused(CLQ_MECHANISM_PHRASE, "pause_s", [](Def &d) { d.phrase.pause_s = NAN; });
    refused(CLQ_MECHANISM_PHRASE, "blend_s is -1", [](Def &d) { d.phrase.blend_s = -1; });
    const uint32_t clip = 1;
    refused(CLQ_MECHANISM_IDLE, "clip_count is 0", [](Def &d) { d.idle.clip_count = 0; });
    refused(CLQ_MECHANISM_IDLE, "clips is NULL", [](Def &d) { d.idle.clips = nullptr; });
    refused(CLQ_MECHANISM_IDLE, "clip 1 does not exist: there are 1", [&](Def &d) { d.idle.clips = &clip; });
    refused(CLQ_MECHANISM_IDLE, "slot_s is 0", [](Def &d) { d.idle.slot_s = 0; });
    refused(CLQ_MECHANISM_HOST, "run of the host's mechanism is NULL", [](Def &d) { d.host.run = nullptr; });
    refused(CLQ_MECHANISM_HOST, "never off", [](Def &d) { d.host.has_memory = 1, d.off_m = 10; });
}

TEST_F(BehaveApi, RefusesInvalidPaths)
{
    using Def = clq_root_path_def;
    refused("1 positions", [](Def &d) { d.count = 1; });
    refused("positions is NULL", [](Def &d) { d.positions = nullptr; });
    refused("both", [this](Def &d) { d.times_s = times_; });
    refused("duration_s is 0", [](Def &d) { d.duration_s = 0; });
    refused("bank is not finite", [](Def &d) { d.bank = NAN; });
    refused("max_bank_rad is -1", [](Def &d) { d.max_bank_rad = -1; });
    positions_[4] = INFINITY;
    refused("coordinate 1 of position 1 of the path is inf", [](Def &) {});
    positions_[4] = 0;
    const auto table = [this](Def &d) { d.times_s = times_, d.rotations_xyzw = rotations_; };
    rotations_[7] = 1;
    refused("key 1 of the path has a rotation of length 1.41421", table);
    rotations_[7] = 0, times_[2] = 1;
    refused("key 2 of the path is at 1 s", table);
    times_[2] = 5;
    refused("key 2 of the path is at 5 s: they ascend from 0 to at most duration_s, 4", table);
    times_[2] = 4;
    refused("key 2 of the path ends the lap at 4 s, and is not where key 0 is", table);
}

TEST_F(BehaveApi, RefusesAttachmentsAndCommandsOfMissingMechanisms)
{
    const clq_mechanism blink = add(def(CLQ_MECHANISM_BLINK)), gaze = add(def(CLQ_MECHANISM_GAZE)),
                        expression = add(def(CLQ_MECHANISM_EXPRESSION)), phrase = add(def(CLQ_MECHANISM_PHRASE));
    const clq_actor no_one = {7, 1};
    const clq_mechanism_attachment good = {blink, 0, 0, 0}, unknown = {{9}, 0, 0, 0}, none = {{0}, 0, 0, 0},
                                   bad = {blink, NAN, 0, 0};
    const double point[3] = {0, 0, 0};
    EXPECT_EQ(clq_actor_attach_mechanism(crowd_, no_one, &good), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_detach_mechanism(crowd_, no_one, blink), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_gaze(crowd_, no_one, gaze, point, 0), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_express(crowd_, no_one, expression, 0, 0), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_say(crowd_, no_one, phrase, 0), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_attach_mechanism(crowd_, actor_, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_attach_mechanism(crowd_, actor_, &unknown), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("mechanism 9 does not exist: the crowd has 4"), std::string::npos)
        << clq_last_error();
    EXPECT_EQ(clq_actor_attach_mechanism(crowd_, actor_, &none), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_attach_mechanism(crowd_, actor_, &bad), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_detach_mechanism(crowd_, actor_, blink), CLQ_OK)
        << "detaching a mechanism that is not attached is ignored";
    EXPECT_EQ(clq_actor_detach_mechanism(crowd_, actor_, {9}), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_gaze(crowd_, actor_, gaze, point, 0), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("mechanism 2 is not attached"), std::string::npos) << clq_last_error();
    ASSERT_EQ(attach_mechanism(gaze), CLQ_OK);
    ASSERT_EQ(attach_mechanism(expression), CLQ_OK);
    EXPECT_EQ(clq_actor_say(crowd_, actor_, gaze, 0), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_gaze(crowd_, actor_, gaze, point, NAN), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_express(crowd_, actor_, expression, 1, 0), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("pose 1 does not exist: the expression has 1"), std::string::npos)
        << clq_last_error();
    EXPECT_EQ(clq_actor_express(crowd_, actor_, expression, CLQ_NONE, 0), CLQ_OK);
    const clq_root_path_play motion = {{1}, 1, 0, 0}, still = {{0}, 1, 0, 0}, infinite = {{0}, INFINITY, 0, 0};
    EXPECT_EQ(clq_actor_play_root_path(crowd_, actor_, &motion), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_play_root_path(crowd_, actor_, &infinite), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_play_root_path(crowd_, no_one, &still), CLQ_STALE_ID);
    EXPECT_EQ(clq_actor_play_root_path(crowd_, actor_, nullptr), CLQ_ARGUMENT);
}

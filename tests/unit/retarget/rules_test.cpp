// What cannot be retargeted is refused on the far side of each limit alone, and what is lost is named.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/retarget/joints.h"
#include "lib/retarget/retarget.h"
#include "rigs.h"

namespace claque::testing
{
namespace
{

model::Rig who_dances()
{
    model::Rig rig = rig_of(person(1, 0));
    add_motion(rig, "dance", 9, 1);  // 0.8 s
    return rig;
}

// The refusal of clips of the dancer for a person with a tail and a cloth; "" if they are added.
std::string said(const std::function<void(retarget::Options &)> &change, const model::Rig &source = who_dances())
{
    std::vector<Bone> bones = person(1, 0);
    bones.push_back({"tail", "hips", {0, 0, -0.1f}});
    bones.push_back({"cloth", "hips", {0.1f, -0.1f, 0.1f}});
    model::Rig target = rig_of(bones);
    retarget::Options options;
    options.mode = retarget::Mode::motion;
    change(options);
    try {
        retarget::add_clips(target, source, options);
        return "";
    } catch (const base::Error &error) {
        EXPECT_TRUE(target.clips.empty() && target.channels.empty() && target.times.empty() && target.values.empty());
        return error.what();
    }
}

void expect_refused(const std::string &sentence, const std::function<void(retarget::Options &)> &change,
                    const model::Rig &source = who_dances())
{
    const std::string found = said(change, source);
    EXPECT_NE(found.find(sentence), std::string::npos) << "'" << found << "' and not '" << sentence << "'";
}

}  // namespace

TEST(RetargetRules, OfFollowers)
{
    const auto follow = [](const char *joint, const char *leader, double share) {
        return [=](retarget::Options &options) { options.followers = {{joint, leader, share}}; };
    };
    for (const double share : {0.0, 1.0}) EXPECT_EQ(said(follow("cloth", "leg.l", share)), "");
    for (const double share : {-0.001, 1.001, double(NAN)})
        expect_refused("'cloth' follows with a share of", follow("cloth", "leg.l", share));
    expect_refused("'nose' cannot follow 'leg.l': it is not a joint of the character", follow("nose", "leg.l", 0.5));
    expect_refused("'leg.r' cannot follow 'leg.l': it is bound itself", follow("leg.r", "leg.l", 0.5));
    expect_refused("'cloth' cannot follow 'nose', which is not bound", follow("cloth", "nose", 0.5));
    expect_refused("'cloth' cannot follow 'tail', which is not bound", follow("cloth", "tail", 0.5));
}

TEST(RetargetRules, OfRatesAndRanges)
{
    using O = retarget::Options;
    const auto set = [](double O::*member, double value) { return [=](O &options) { options.*member = value; }; };
    for (const double rate : {1.0, 1000.0}) EXPECT_EQ(said(set(&O::rate_hz, rate)), "");
    for (const double rate : {0.999, 1000.1, double(NAN)}) expect_refused("keys per second", set(&O::rate_hz, rate));
    EXPECT_EQ(said(set(&O::close_s, 0)), "");
    for (const double bad : {-1e-9, double(NAN)}) {
        expect_refused("the time to close clips", set(&O::close_s, bad));
        expect_refused("the range of the clips", set(&O::start_s, bad));
    }
    const auto range = [](double from, double to) {
        return [=](O &options) { options.start_s = from, options.end_s = to; };
    };
    EXPECT_EQ(said(range(0.5, 0.5)), "");
    expect_refused("the range of the clips is 0.5 s to 0.4 s", range(0.5, 0.4));
    const double length = double(who_dances().clips[0].duration_s);
    EXPECT_EQ(said(range(length, 2)), "") << "its last pose";
    expect_refused("clip 'dance' is 0.8 s long: nothing is left of it from 0.9 s on", range(0.9, 2));
    model::Rig still = who_dances();
    still.clips[0].duration_s = 0;
    EXPECT_EQ(said(range(0.9, 2), still), "") << "a pose is all of its clip";
    model::Rig endless = who_dances();
    endless.clips[0].duration_s = 20000;
    expect_refused("clip 'dance' would have 2e+07 keys", set(&O::rate_hz, 1000), endless);
    expect_refused(
        "there are no clips to add", [](O &) {}, rig_of(person(1, 0)));
}

TEST(RetargetRules, NameUpToTwelveJointsThatAreLost)
{
    for (const int lost : {1, 2, 12, 13}) {
        std::vector<Bone> bones = person(1, 0);
        static const char *const names[] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m"};
        std::string listed;
        for (int i = 0; i < lost; ++i) {
            bones.push_back({names[i], "hips", {0, 0.1f, 0}});
            if (i < 12) listed += (i ? ", " : " ") + std::string(names[i]);
        }
        model::Rig source = rig_of(bones), target = rig_of(person(1, 0));
        add_motion(source, "dance", 5, 1);
        const retarget::Report report = retarget::add_clips(target, source, {});
        ASSERT_EQ(report.warnings.size(), 1u);
        EXPECT_EQ(report.warnings[0], std::to_string(lost) + (lost == 1 ? " joint" : " joints") +
                                          " of the clips not in the character:" + listed + (lost > 12 ? " ..." : ""));
    }
}

TEST(RetargetRules, NameTheMapWhereMostJointsAreNotBound)
{
    model::Rig source = rig_of(person(1, 0)), target = rig_of(person(1, 0));
    add_motion(source, "dance", 4, 1);
    for (uint32_t i = 4; i < target.node_count(); ++i) target.node_names[i] = "x" + target.node_names[i];
    const retarget::Report report = retarget::add_clips(target, source, {});
    ASSERT_EQ(report.joint_count, 4u);
    EXPECT_NE(report.warnings.at(0).find("; a joint map (--map of the command"), std::string::npos);
}

// A joint moves if one key of one of its channels is off its rest by more than a ten-thousandth.
TEST(RetargetRules, MovesAreThoseOfKeysThatLeaveTheRest)
{
    using Target = model::ChannelTarget;
    for (const Target target : {Target::translation, Target::rotation, Target::scale})
        for (const bool cubic : {false, true})
            for (int number = 0; number < (target == Target::rotation ? 4 : 3); ++number)
                for (const float off : {0.0f, 0.5e-4f, -0.5e-4f, 2e-4f, -2e-4f}) {
                    model::Rig rig = rig_of(person(1, 0));
                    rig.rest[3].translation = {0.5f, 0.25f, -0.5f};
                    rig.times = {0, 1};
                    model::Channel channel;
                    channel.node = 3, channel.target = target, channel.key_count = 2;
                    if (cubic) channel.interpolation = model::Interpolation::cubic_spline;
                    std::vector<float> rest = {0.5f, 0.25f, -0.5f};
                    if (target == Target::scale) rest = {1, 1, 1};
                    if (target == Target::rotation) rest = {0, 0, 0, -1};  // the same turn
                    channel.component_count = static_cast<uint32_t>(rest.size());
                    std::vector<float> last = rest;
                    last[size_t(number)] += off;
                    const std::vector<float> tangent(rest.size(), 7);
                    for (const std::vector<float> &key : {rest, last}) {
                        if (cubic) rig.values.insert(rig.values.end(), tangent.begin(), tangent.end());
                        rig.values.insert(rig.values.end(), key.begin(), key.end());
                        if (cubic) rig.values.insert(rig.values.end(), tangent.begin(), tangent.end());
                    }
                    rig.channels.push_back(channel);
                    EXPECT_EQ(retarget::moves(rig, 3), std::fabs(off) > 1e-4f)
                        << int(target) << ", " << cubic << ", " << number << ", " << off;
                    EXPECT_FALSE(retarget::moves(rig, 2));
                }
}

TEST(RetargetRules, ClipsOfItsOwnStayAndNewOnesAreAsInAnEmptyCharacter)
{
    for (const retarget::Mode mode : {retarget::Mode::channels, retarget::Mode::motion}) {
        model::Rig fresh = rig_of(person(1, 0)), full = rig_of(person(1, 0)), before = rig_of(person(1, 0));
        for (model::Rig *rig : {&full, &before}) add_motion(*rig, "own", 5, 1, 0.3f);
        retarget::Options options;
        options.mode = mode;
        retarget::add_clips(fresh, who_dances(), options);
        retarget::add_clips(full, who_dances(), options);
        retarget::add_clips(full, who_dances(), options);
        ASSERT_EQ(full.clips.size(), 3u);
        const uint32_t keys = fresh.channels[0].key_count;
        for (uint32_t k = 0; k < keys; ++k) {
            const Posed wanted = posed(fresh, 0, k), own = posed(before, 0, k);
            for (uint32_t i = 0; i < full.node_count(); ++i) {
                EXPECT_EQ(posed(full, 0, k).places[i], own.places[i]) << k;
                for (const uint32_t clip : {1u, 2u}) EXPECT_EQ(posed(full, clip, k).places[i], wanted.places[i]) << k;
            }
        }
        for (uint32_t c = 0; c < fresh.clips[0].channel_count; ++c)
            for (const uint32_t clip : {1u, 2u}) {
                const model::Channel &a = fresh.channels[c], &b = full.channels[full.clips[clip].first_channel + c];
                ASSERT_EQ(a.key_count, b.key_count);
                for (uint32_t k = 0; k < keys; ++k)
                    ASSERT_EQ(fresh.times[a.first_time + k], full.times[b.first_time + k]);
            }
        EXPECT_EQ(full.clips[1].duration_s, fresh.clips[0].duration_s);
        EXPECT_EQ(full.clip_names[2], "dance.2");
    }
}

}  // namespace claque::testing

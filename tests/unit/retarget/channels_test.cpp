// Retargeting by channels between compatible skeletons: results, refusals and messages.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/asset/file.h"
#include "lib/asset/gltf.h"
#include "lib/base/error.h"
#include "lib/retarget/retarget.h"
#include "rigs.h"
#include "tests/support/written_characters.h"

namespace claque::testing
{
namespace
{

std::string refusal(model::Rig &target, const model::Rig &source, const retarget::Options &options)
{
    try {
        retarget::add_clips(target, source, options);
    } catch (const base::Error &error) {
        return error.what();
    }
    return "added";
}

model::Rig dancer()
{
    model::Rig rig = rig_of(person(1, 0));
    add_motion(rig, "dance", 9, 1);
    return rig;
}

model::Model real(const std::string &name)
{
    const std::string path = written::path_of(name, CLAQUE_ASSETS_DIR);
    const std::vector<uint8_t> bytes = asset::read_file(path, 1u << 30);
    asset::LoadOptions options;
    options.base_folder = path.substr(0, path.rfind('/'));
    return asset::load_gltf(bytes.data(), bytes.size(), options);
}

bool has_assets()
{
    try {
        asset::read_file(std::string(CLAQUE_ASSETS_DIR) + "/inventory.json", 1u << 30);
        return true;
    } catch (const base::Error &) {
        return false;
    }
}

}  // namespace

TEST(Channels, OfACompatibleSkeletonAreCopiedToTheBit)
{
    model::Rig source = dancer();
    source.channels[3].interpolation = model::Interpolation::step;
    model::Rig target = rig_of(person(1, 0));
    const retarget::Report report = retarget::add_clips(target, source, {});
    EXPECT_EQ(report.mode, retarget::Mode::channels);
    EXPECT_TRUE(report.warnings.empty());
    ASSERT_EQ(target.channels.size(), source.channels.size());
    EXPECT_EQ(target.times.size(), 9u);
    for (const model::Channel &c : target.channels) {
        const auto same = [&](const model::Channel &o) { return o.node == c.node && o.target == c.target; };
        const auto other = std::find_if(source.channels.begin(), source.channels.end(), same);
        ASSERT_NE(other, source.channels.end());
        EXPECT_EQ(other->interpolation, c.interpolation);
        for (uint32_t i = 0; i < 9u * c.component_count; ++i)
            EXPECT_EQ(target.values[c.first_value + i], source.values[other->first_value + i]);
    }
}

TEST(Channels, KeepTheirMarkers)
{
    model::Rig source = dancer();
    add_motion(source, "other", 9, 1);
    source.markers = {{0, 0.1f}, {0, 0.6f}, {1, 0.3f}};
    for (const char *name : {"left", "right", "other"}) source.marker_names.emplace_back(name);
    model::Rig target = rig_of(person(1, 0));
    add_motion(target, "own", 5, 1);
    target.markers = {{0, 0.2f}};
    target.marker_names.emplace_back("own");
    retarget::Options options;
    options.clips = {"other", "dance"};
    const retarget::Report report = retarget::add_clips(target, source, options);
    EXPECT_EQ(report.clips, (std::vector<uint32_t>{1, 0}));
    ASSERT_EQ(target.markers.size(), 4u);
    EXPECT_EQ(target.markers[1].clip, 1u);
    EXPECT_STREQ(target.marker_names[1].c_str(), "other");
    EXPECT_EQ(target.markers[3].clip, 2u);
    EXPECT_EQ(target.markers[3].time_s, 0.6f);
    EXPECT_STREQ(target.marker_names[3].c_str(), "right");
    // Cutting a range removes the markers outside it; times count from its start.
    model::Rig cut = rig_of(person(1, 0));
    options.clips = {"dance"}, options.mode = retarget::Mode::motion, options.start_s = 0.5;
    retarget::add_clips(cut, source, options);
    ASSERT_EQ(cut.markers.size(), 1u);
    EXPECT_NEAR(cut.markers[0].time_s, 0.1f, 1e-6f);
    EXPECT_STREQ(cut.marker_names[0].c_str(), "right");
}

TEST(Channels, AreNotTakenWhereTheRestPosesDifferByMoreThanALittle)
{
    model::Rig lower_arms = rig_of(person(1, 10)), larger = rig_of(person(1.1f, 0)), nearly = rig_of(person(1.001f, 0));
    EXPECT_EQ(retarget::add_clips(lower_arms, dancer(), {}).mode, retarget::Mode::motion);
    EXPECT_EQ(retarget::add_clips(larger, dancer(), {}).mode, retarget::Mode::motion);
    EXPECT_EQ(retarget::add_clips(nearly, dancer(), {}).mode, retarget::Mode::channels);
    // The allowance grows with the skeleton, not with its distance from the origin.
    model::Rig source = dancer(), far = rig_of(person(1, 0));
    source.rest[0].translation.y = far.rest[0].translation.y = 50;
    far.rest[far.find_node("foot.l")].translation.z += 0.03f;
    EXPECT_EQ(retarget::add_clips(far, source, {}).mode, retarget::Mode::motion);
    retarget::Options part;
    part.end_s = 0.5;
    EXPECT_EQ(retarget::add_clips(nearly, dancer(), part).mode, retarget::Mode::motion);
}

namespace
{

// A person under an armature that turns it; `scale` of the offsets below the hips.
model::Rig under_armature(float scale)
{
    std::vector<Bone> bones = {{"armature", "", {0, 0, 0}}};
    for (Bone bone : person(1, 0)) {
        if (!*bone.parent) {
            bone.parent = "armature";
            bone.offset = glm::vec3(0, 0, 1);  // under the armature's rotation: (0, 1, 0)
        }
        bones.push_back(bone);
    }
    model::Rig rig = rig_of(bones);
    rig.rest[0].rotation = axis_turn({1, 0, 0}, -1.57079633f);
    rig.rest[1].rotation = axis_turn({1, 0, 0}, 1.57079633f);
    for (size_t i = 2; i < rig.rest.size(); ++i) rig.rest[i].translation *= scale;
    return rig;
}

// Each key becomes three numbers of each component: a tangent, the value, another tangent. With `ends` they are keys of
// their own instead, at the ends of the tangents.
model::Rig in_splines(model::Rig rig, bool ends)
{
    model::Array<float> values;
    for (model::Channel &channel : rig.channels) {
        const float *from = rig.values.data() + channel.first_value;
        channel.first_value = static_cast<uint32_t>(values.size());
        for (uint32_t k = 0; k < channel.key_count; ++k, from += channel.component_count)
            for (int part = 0; part < 3; ++part)
                for (uint32_t i = 0; i < channel.component_count; ++i) {
                    const float tangent = part == 1 ? 0 : 0.25f * std::sin(float(5 * k + 3 * i) + float(part));
                    values.push_back(part == 1 || ends ? from[i] + tangent : tangent);
                }
        if (ends) channel.key_count *= 3;
        else channel.interpolation = model::Interpolation::cubic_spline;
    }
    rig.values = values;
    if (!ends) return rig;
    const uint32_t count = static_cast<uint32_t>(rig.times.size());
    rig.times.clear();
    for (uint32_t k = 0; k < 3 * count; ++k) rig.times.push_back(0.1f * static_cast<float>(k));
    return rig;
}

}  // namespace

TEST(Channels, UnderOtherAxesShowTheSame)
{
    model::Rig smaller = under_armature(0.5f), target = under_armature(1);
    const model::Rig source = dancer();
    ASSERT_EQ(retarget::add_clips(smaller, source, {}).mode, retarget::Mode::motion) << "not compatible";
    ASSERT_EQ(retarget::add_clips(target, source, {}).mode, retarget::Mode::channels);
    for (uint32_t k = 0; k < 9; ++k)
        for (const char *name : {"hips", "head", "hand.l", "foot.r"})
            EXPECT_LT(glm::distance(posed(source, 0, k).of(source, name), posed(target, 0, k).of(target, name)), 1e-5);
}

TEST(Channels, OfSplinesHaveTheTangentsOfTheirEnds)
{
    for (const bool other_axes : {false, true}) {
        const model::Rig splines = in_splines(dancer(), false), ends = in_splines(dancer(), true);
        const auto target = [&] { return other_axes ? under_armature(1) : rig_of(person(1, 0)); };
        model::Rig found = target(), wanted = target();
        ASSERT_EQ(retarget::add_clips(found, splines, {}).mode, retarget::Mode::channels);
        ASSERT_EQ(retarget::add_clips(wanted, ends, {}).mode, retarget::Mode::channels);
        model::check(found);
        ASSERT_EQ(found.channels.size(), wanted.channels.size());
        EXPECT_EQ(found.values.size(), splines.values.size()) << "and nothing else is copied";
        for (size_t c = 0; c < found.channels.size(); ++c) {
            const model::Channel &channel = found.channels[c], &keys = wanted.channels[c];
            ASSERT_EQ(channel.interpolation, model::Interpolation::cubic_spline);
            ASSERT_EQ(channel.node, keys.node);
            const uint32_t width = channel.component_count;
            for (uint32_t n = 0; n < 3 * channel.key_count * width; ++n) {
                const uint32_t part = n / width % 3, value = n - part * width + width;  // of the same component
                const float end = wanted.values[keys.first_value + n], middle = wanted.values[keys.first_value + value];
                EXPECT_NEAR(found.values[channel.first_value + n], part == 1 ? middle : end - middle, 1e-5f)
                    << "channel " << c << ", number " << n << ", " << other_axes;
            }
        }
    }
}

namespace
{

// All clips of one file are copied to a character of another; `shown` looks the same there, within `distance`.
void expect_moved(const char *clips_file, const char *character_file, const char *shown, uint32_t fewest_joints,
                  const std::vector<const char *> &joints, const std::vector<uint32_t> &keys, double distance)
{
    const model::Model clips = real(clips_file);
    model::Model character = real(character_file);
    const uint32_t before = static_cast<uint32_t>(character.rig.clips.size());
    const retarget::Report report = retarget::add_clips(character.rig, clips.rig, {});
    EXPECT_EQ(report.mode, retarget::Mode::channels);
    EXPECT_EQ(report.clip_count, clips.rig.clips.size());
    EXPECT_GE(report.joint_count, fewest_joints);
    model::check(character.rig);
    const uint32_t clip = clips.rig.find_clip(shown);
    const model::Rig &source = clips.rig, &target = character.rig;
    ASSERT_LT(clip, clips.rig.clips.size());
    for (const uint32_t key : keys)
        for (const char *name : joints)
            EXPECT_LT(glm::distance(posed(source, clip, key).of(source, name),
                                    posed(target, before + clip, key).of(target, name)),
                      distance)
                << name;
}

}  // namespace

TEST(Channels, OfAFileOfClipsAloneMoveACharacterOfAnotherFile)
{
    if (!has_assets()) GTEST_SKIP() << "no characters in " << CLAQUE_ASSETS_DIR;
    expect_moved("clips-only/kaykit/Med_Simulation.glb", "humanoids/kaykit/Barbarian.glb", "Rig_Medium|Waving", 23,
                 {"hips", "head", "hand.l", "hand.r", "foot.l", "toes.r"}, {0, 7, 20}, 0.004);
}

TEST(Channels, OfAWrittenFileOfClipsAloneMoveWrittenCharacters)
{
    for (const char *character : {"WrittenPerson.glb", "WrittenSkins.glb", "WrittenQuantised.glb"})
        expect_moved("WrittenClips.glb", character, "bow", 16, {"hips", "head", "hand.l", "hand.r", "foot.l", "shin.r"},
                     {0, 1, 2, 3}, 1e-5);
}

TEST(AddClips, ReportsUnboundJointsAndRefusesIfNoneIsBound)
{
    std::vector<Bone> bones = person(1, 0);
    bones.push_back({"tail", "hips", {0, 0, -0.1f}});
    model::Rig source = rig_of(bones);
    add_motion(source, "dance", 4, 1);
    model::Rig target = rig_of(person(1, 0));
    const retarget::Report report = retarget::add_clips(target, source, {});
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_EQ(report.warnings[0], "1 joint of the clips not in the character: tail");

    model::Rig stranger = rig_of({{"a", "", {0, 0, 0}}, {"b", "a", {0, 1, 0}}});
    EXPECT_NE(refusal(stranger, source, {}).find("none of the 16 joints"), std::string::npos);
    EXPECT_NE(refusal(stranger, source, {}).find("a joint map (--map of the command"), std::string::npos);
    EXPECT_TRUE(stranger.clips.empty() && stranger.channels.empty() && stranger.values.empty());

    retarget::Options map;
    map.joints = {{"hips", "a"}, {"spine", "b"}, {"nose", "b"}, {"head", "c"}};
    EXPECT_EQ(retarget::add_clips(stranger, source, map).warnings.size(), 2u);
    map.joints.push_back({"head", "b"});
    EXPECT_NE(refusal(stranger, source, map).find("binds joint 'b' to both 'spine' and 'head'"), std::string::npos);
}

TEST(AddClips, TakesClipsByNameAndNumbersNamesThatAreTaken)
{
    model::Rig source = dancer();
    add_motion(source, "walk", 5, 1);
    model::Rig target = rig_of(person(1, 0));
    retarget::Options options;
    options.clips = {"walk"};
    options.prefix = "cmu ";
    retarget::add_clips(target, source, options);
    const retarget::Report again = retarget::add_clips(target, source, options);
    ASSERT_EQ(target.clips.size(), 2u);
    EXPECT_EQ(target.clip_names[0], "cmu walk");
    EXPECT_EQ(target.clip_names[1], "cmu walk.2");
    EXPECT_EQ(again.warnings.size(), 1u);
    options.clips = {"run"};
    EXPECT_NE(refusal(target, source, options).find("no clip 'run' among the 2"), std::string::npos);
    options.clips.clear();
    options.rate_hz = 0.5;
    EXPECT_NE(refusal(target, source, options).find("1 to 1000"), std::string::npos);
    EXPECT_EQ(target.clips.size(), 2u);
}

}  // namespace claque::testing

// BVH files: what is read, by a second evaluation of their channels, and what is refused, by line.
#include "lib/asset/bvh.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "assets.h"
#include "lib/base/hash.h"

namespace claque::testing
{
namespace
{

model::Model load_bvh(const std::string &text, double unit_m = 1)
{
    asset::LoadOptions options;
    options.motion_unit_m = unit_m;
    return asset::load_bvh(reinterpret_cast<const uint8_t *>(text.data()), text.size(), options);
}

std::string refusal(const std::string &text)
{
    try {
        load_bvh(text);
    } catch (const base::Error &error) {
        return error.what();
    }
    return "loaded";
}

const std::string head = "HIERARCHY\nROOT hip\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition ";
const std::string order = "Zrotation Xrotation Yrotation\n";
const std::string rest =
    "JOINT knee\n{\nOFFSET 0 -4 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 -3 1\n"
    "}\n}\n}\n";
const std::string motion = "MOTION\nFrames: 2\nFrame Time: 0.04\n1 2 3 10 20 30 40 50 60\n4 5 6 11 21 31 41 51 61\n";
const std::string small = head + order + rest + motion;

glm::dmat4 turn(char axis, double degrees)
{
    return glm::rotate(glm::dmat4(1), degrees * 3.14159265358979323846 / 180,
                       glm::dvec3(axis == 'X', axis == 'Y', axis == 'Z'));
}

glm::quat rotation_at(const model::Rig &rig, uint32_t node, uint32_t key)
{
    for (const model::Channel &c : rig.channels)
        if (c.node == node && c.target == model::ChannelTarget::rotation) {
            const float *v = rig.values.data() + c.first_value + 4 * key;
            return glm::quat(v[3], v[0], v[1], v[2]);
        }
    return glm::quat(0, 0, 0, 0);
}

glm::vec3 place_at(const model::Rig &rig, uint32_t node, uint32_t key)
{
    for (const model::Channel &c : rig.channels)
        if (c.node == node && c.target == model::ChannelTarget::translation) {
            const float *v = rig.values.data() + c.first_value + 3 * key;
            return glm::vec3(v[0], v[1], v[2]);
        }
    return glm::vec3(-1e9f);
}

TEST(Bvh, JointsOffsetsAndFramesBecomeARigAndOneClip)
{
    const model::Model model = load_bvh(small);
    ASSERT_EQ(model.rig.node_count(), 3u);
    EXPECT_EQ(model.rig.node_names[1], "knee");
    EXPECT_EQ(model.rig.node_names[2], "knee end");
    EXPECT_EQ(model.rig.parents[2], 1u);
    EXPECT_EQ(model.rig.rest[2].translation, glm::vec3(0, -3, 1));
    ASSERT_EQ(model.rig.clips.size(), 1u);
    EXPECT_EQ(model.rig.clips[0].channel_count, 3u);
    EXPECT_FLOAT_EQ(model.rig.clips[0].duration_s, 0.04f);
    EXPECT_EQ(place_at(model.rig, 0, 1), glm::vec3(4, 5, 6));
    EXPECT_TRUE(model.parts.empty());
    EXPECT_TRUE(model.warnings.empty());
}

TEST(Bvh, RotationsActInTheOrderThatTheFileLists)
{
    for (const std::string axes : {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
        std::string listed;
        glm::dmat4 wanted(1);
        const double degrees[] = {-130, 47, 261};
        for (size_t k = 0; k < 3; ++k) {
            listed += std::string(1, axes[k]) + "rotation ";
            wanted = wanted * turn(axes[k], degrees[k]);
        }
        const model::Model model =
            load_bvh(head + listed + "\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0 -130 47 261\n");
        const glm::dmat3 made = glm::mat3_cast(glm::dquat(rotation_at(model.rig, 0, 0)));
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) EXPECT_NEAR(made[c][r], wanted[c][r], 1e-6) << axes;
    }
}

TEST(Bvh, PositionsOfAnyJointStandInThePlaceOfItsOffset)
{
    const model::Model model = load_bvh(
        "HIERARCHY ROOT a { OFFSET 1 2 3 CHANNELS 0 JOINT b { OFFSET 4 5 6 CHANNELS 2 Zposition Xposition } }\n"
        "MOTION Frames: 1 Frame Time: 0 7 8");
    EXPECT_EQ(place_at(model.rig, 1, 0), glm::vec3(8, 5, 7));
    EXPECT_EQ(model.rig.rest[1].translation, glm::vec3(4, 5, 6));
}

TEST(Bvh, SeveralRootsNamesWithBlanksAndAllLineEndsAreRead)
{
    std::string text =
        "hierarchy\nRoot Left Hand {\nOffset 0 0 0\nChannels 1 XROTATION\n}\nROOT other\n{\nOFFSET +1 0 0\nCHANNELS "
        "0\n}\n"
        "MOTION\nFrames : 2\nFrame Time : .5\n90\n1e1\n";
    const model::Model unix = load_bvh(text);
    EXPECT_EQ(unix.rig.node_names[0], "Left Hand");
    EXPECT_EQ(unix.rig.parents[1], model::none);
    for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, 1, '\r');
    const model::Model dos = load_bvh("\xef\xbb\xbf" + text);
    EXPECT_EQ(dos.rig.node_names[0], "Left Hand");
    EXPECT_EQ(rotation_at(dos.rig, 0, 1), rotation_at(unix.rig, 0, 1));
}

std::string utf16(const std::string &text, bool big)
{
    std::string out = big ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text) out += big ? std::string{'\0', c} : std::string{c, '\0'};
    return out;
}

TEST(Bvh, MayBeUtf16WithAByteOrderMark)
{
    const model::Rig plain = load_bvh(small).rig;
    for (const bool big : {false, true}) {
        const std::string text = utf16(small, big);
        ASSERT_TRUE(asset::is_bvh(reinterpret_cast<const uint8_t *>(text.data()), text.size()));
        const model::Rig rig = load_bvh(text).rig;
        EXPECT_EQ(rig.values, plain.values);
        EXPECT_EQ(rig.node_names, plain.node_names);
        EXPECT_EQ(load_bvh(text + "x").rig.values, plain.values) << "half a character is left out";
    }
    // A letter of Greek, one of Chinese, one above 16 bits and half a pair, low byte first.
    std::string odd = utf16(head + order, false);
    odd.replace(odd.find(utf16("hip", false).substr(2)), 6,
                std::string("\xb1\x03\x2d\x4e\x3c\xd8\x00\xdf\x00\xd8", 10));
    const std::string rest_of_it = utf16(rest + motion, false).substr(2);
    EXPECT_EQ(load_bvh(odd + rest_of_it).rig.node_names[0], "\xce\xb1\xe4\xb8\xad\xf0\x9f\x8c\x80\xef\xbf\xbd");
}

TEST(Bvh, LinesThatBeginWithASharpAreNoPartOfIt)
{
    const std::string with =
        "# made by hand\n  # twice\n" + head + order + "# { not a brace\n" + rest + "#\n" + motion + "# the end";
    ASSERT_TRUE(asset::is_bvh(reinterpret_cast<const uint8_t *>(with.data()), with.size()));
    const model::Model model = load_bvh(with);
    EXPECT_EQ(model.rig.values, load_bvh(small).rig.values);
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_NE(refusal("# one\n#two\nHIERARCHY\nROOT a\n{\nOFFSET 0 0 x\n").find("line 6"), std::string::npos);
    std::string sharp = small;
    sharp.replace(sharp.find("hip"), 3, "h#1");
    EXPECT_EQ(load_bvh(sharp).rig.node_names[0], "h#1");
}

TEST(Bvh, TheUnitScalesOffsetsAndPlaces)
{
    const model::Model model = load_bvh(small, 0.25);
    EXPECT_EQ(model.rig.rest[1].translation, glm::vec3(0, -1, 0));
    EXPECT_EQ(place_at(model.rig, 0, 0), glm::vec3(0.25f, 0.5f, 0.75f));
}

TEST(Bvh, RefusalsSayWhereAndWhat)
{
    const auto expect = [](const std::string &text, const char *sentence) {
        EXPECT_NE(refusal(text).find(sentence), std::string::npos)
            << "'" << refusal(text) << "' lacks '" << sentence << "'";
    };
    expect("", "line 1: HIERARCHY is wanted instead of the file's end");
    expect("HIERARCHY\nMOTION\nFrames: 0\n", "there is no ROOT before MOTION");
    expect("HIERARCHY\nROOT\n{", "line 2: a joint has no name");
    expect("HIERARCHY\nROOT a\n{\n}\n", "line 4: 'a' has no OFFSET");
    expect("HIERARCHY\nROOT a\n{\nOFFSET 0 zero 0\n", "line 4: an offset is 'zero' instead of a number");
    expect("HIERARCHY\nROOT a\n{\nOFFSET 0 1e99 0\n", "line 4: an offset of 1e+99 is too far away");
    expect("HIERARCHY\nROOT a\n{\nOFFSET 0 nan 0\n", "'nan' instead of a number");
    expect(head + "Wrotation", "line 5: channel 4 of 'hip' is none of");
    expect(head + "Xposition", "'hip' has Xposition twice");
    expect("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 7", "a number of channels is 7");
    expect("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nEnd Site\n{\nCHANNELS 3\n", "line 7: OFFSET or } is wanted");
    expect(head + order + rest + "MOTION\nFrames: 2\nFrame Time: 0\n", "a frame takes 0 s: 0.0001 to 60 is wanted");
    expect(head + order + rest + "MOTION\nFrames: 1.5\n", "a number of frames is 1.5");
    expect(small.substr(0, small.size() - 4), "the file ends where a number is wanted");
    expect(small.substr(0, small.find("4 5 6")), "the file ends after 1 of 2 frames");
    expect(head + order + rest + "MOTION\nFrames: 1000000\nFrame Time: 0.1\n",
           "more than 40 times what the file holds");
}

TEST(Bvh, WhatIsOddButUsableIsAWarning)
{
    EXPECT_EQ(load_bvh(small + "1 2 3").warnings.size(), 1u);
    const model::Model empty = load_bvh(head + order + rest + "MOTION\nFrames: 0\nFrame Time: 0\n");
    EXPECT_EQ(empty.warnings.size(), 1u);
    EXPECT_TRUE(empty.rig.clips.empty());
    EXPECT_EQ(load_bvh("HIERARCHY ROOT a\n{OFFSET 0 0 0 CHANNELS 0 JOINT a\n{OFFSET 0 0 0 CHANNELS 0}}MOTION Frames: 1 "
                       "Frame Time: 1")
                  .warnings.size(),
              1u);
}

TEST(Bvh, NestingAsDeepAsTheLimitIsReadAndDeeperIsRefused)
{
    std::string text = "HIERARCHY\nROOT r\n{OFFSET 0 1 0 CHANNELS 0\n", close = "}";
    for (int i = 0; i < 12000; ++i)
        text += "JOINT j" + std::to_string(i) + "\n{OFFSET 0 1 0 CHANNELS 0\n", close += "}";
    EXPECT_NE(refusal(text + close + "MOTION Frames: 0 Frame Time: 0").find("more than 10000 joints"),
              std::string::npos);
}

TEST(Bvh, RealMotionCaptureIsRead)
{
    CLAQUE_NEEDS_ASSETS();
    const struct {
        const char *name;
        uint32_t nodes, frames;
    } files[] = {{"02_01", 38, 343}, {"01_01", 38, 2752}, {"cmu_12_01_walk", 38, 524}, {"bvhio-example", 23, 2}};
    for (const auto &file : files) {
        const Bytes bytes = read_asset("mocap/" + std::string(file.name) + ".bvh");
        ASSERT_TRUE(asset::is_bvh(bytes.data(), bytes.size()));
        const model::Model model = asset::load_bvh(bytes.data(), bytes.size(), asset::LoadOptions());
        EXPECT_EQ(model.rig.node_count(), file.nodes) << file.name;
        EXPECT_EQ(model.rig.times.size(), file.frames);
        EXPECT_TRUE(model.warnings.empty());
    }
}

TEST(Bvh, AWrittenWalkIsRead)
{
    const Bytes bytes = read_asset("WrittenWalk.bvh");
    ASSERT_TRUE(asset::is_bvh(bytes.data(), bytes.size()));
    const model::Model model = asset::load_bvh(bytes.data(), bytes.size(), asset::LoadOptions());
    EXPECT_EQ(model.rig.node_count(), 25u + 5u);  // with the ends of hands, feet and head
    EXPECT_EQ(model.rig.times.size(), 126u);
    EXPECT_FLOAT_EQ(model.rig.times.back(), 125 * 0.02f);
    EXPECT_TRUE(model.warnings.empty());
}

void expect_loaded_or_refused_by_bvh(const Bytes &whole, uint64_t runs)
{
    uint64_t loaded = 0, refused = 0;
    for (uint64_t run = 0; run < runs; ++run) {
        Bytes bytes = whole;
        uint64_t thrown = 0;
        const auto below = [&](uint64_t limit) { return base::hash(run, thrown++, base::Purpose::pick) % limit; };
        for (uint64_t n = 1 + below(4); n > 0; --n) {
            const size_t at = below(bytes.size());
            if (below(3) == 0) bytes[at] = static_cast<uint8_t>(below(256));
            else if (below(2) == 0) bytes[at] = static_cast<uint8_t>("0123456789-.e{} \n"[below(17)]);
            else if (below(2) == 0) bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), '9');
            else bytes.resize(at + 1);
        }
        try {
            asset::load_bvh(bytes.data(), bytes.size(), asset::LoadOptions());
            ++loaded;
        } catch (const base::Error &error) {
            EXPECT_NE(error.status(), CLQ_ARGUMENT) << run << ": " << error.what();
            ++refused;
        }
    }
    EXPECT_GT(loaded, runs / 40);
    EXPECT_GT(refused, 3 * runs / 40);
}

TEST(Bvh, DamagedFilesLoadOrAreRefusedAndNothingElse)
{
    CLAQUE_NEEDS_ASSETS();
    expect_loaded_or_refused_by_bvh(read_asset("mocap/bvhio-example.bvh"), 4000);
}

TEST(Bvh, ADamagedWrittenWalkLoadsOrIsRefusedAndNothingElse)
{
    // Two of its frames: most of the damage then meets joints.
    const Bytes bytes = read_asset("WrittenWalk.bvh");
    std::string text(bytes.begin(), bytes.end());
    text.replace(text.find("Frames: 126"), 11, "Frames: 2");
    size_t end = text.find("Frame Time");
    for (int line = 0; line < 3; ++line) end = text.find('\n', end) + 1;
    text.resize(end);
    expect_loaded_or_refused_by_bvh(Bytes(text.begin(), text.end()), 2000);
}

}  // namespace
}  // namespace claque::testing

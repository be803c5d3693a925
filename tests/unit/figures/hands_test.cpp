// Hands in clips: their required poses, and no intersections.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "puppet.h"

using puppet::citizen;
using puppet::clip;
using puppet::frame_s;
using puppet::frames;
using puppet::node;
using puppet::pose;
using puppet::Posed;
using puppet::vec3;

namespace
{

bool moved_by(size_t vertex, std::initializer_list<const char *> bones)
{
    for (const char *bone : bones)
        if (puppet::owner(vertex) == node(bone)) return true;
    return false;
}
bool left_hand(size_t v) { return moved_by(v, {"hand_l", "fingers_l", "fingertips_l"}); }
bool right_hand(size_t v) { return moved_by(v, {"hand_r", "fingers_r", "fingertips_r"}); }
bool any_hand(size_t v) { return left_hand(v) || right_hand(v) || moved_by(v, {"thumb_l", "thumb_r"}); }

// From one palm to the other along x, without thumbs; negative: they intersect.
float between_palms(const Posed &p)
{
    float left = 1e9f, right = -1e9f;
    for (size_t v = 0; v < p.vertices.size(); ++v) {
        if (left_hand(v)) left = std::min(left, p.vertices[v].x);
        if (right_hand(v)) right = std::max(right, p.vertices[v].x);
    }
    return left - right;
}

// A rounded rod inside the body.
struct Capsule {
    const char *name;
    vec3 from, to;
    float radius;
};
float depth(const Capsule &c, vec3 p)
{
    const vec3 line = c.to - c.from;
    const float t = std::clamp(glm::dot(p - c.from, line) / glm::dot(line, line), 0.0f, 1.0f);
    return c.radius - glm::distance(p, c.from + line * t);
}

// Capsules well inside skin and cloth: anything inside them is an error.
std::vector<Capsule> flesh(const Posed &p)
{
    const auto on = [&p](const char *bone, vec3 offset) { return p.joints[node(bone)] + p.world[node(bone)] * offset; };
    std::vector<Capsule> all;
    for (const float side : {1.0f, -1.0f}) {
        all.push_back(
            {"belly", on("pelvis", {side * 0.05f, 0.02f, 0}), on("spine_upper", {side * 0.05f, 0, 0}), 0.085f});
        all.push_back(
            {"chest", on("spine_upper", {side * 0.05f, 0, 0}), on("chest", {side * 0.06f, 0.10f, 0}), 0.090f});
        all.push_back({"thigh", p.joints[node(side > 0 ? "thigh_l" : "thigh_r")],
                       p.joints[node(side > 0 ? "shin_l" : "shin_r")], 0.048f});
    }
    all.push_back({"skull", on("head", {0, 0.06f, 0.01f}), on("head", {0, 0.12f, 0}), 0.075f});
    all.push_back({"neck", p.joints[node("neck")], p.joints[node("head")], 0.045f});
    return all;
}

// Height of a point over the cloth below it; a large number if there is none.
float over_lap(const Posed &p, vec3 point)
{
    const auto &part = citizen().parts[0];
    float nearest = 1e9f;
    for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        std::array<vec3, 3> t;
        bool cloth = true;
        for (size_t k = 0; k < 3; ++k) {
            const size_t v = part.indices[i + k];
            cloth &= moved_by(v, {"skirt_front_l", "skirt_front_r"});
            t[k] = p.vertices[v];
        }
        const float area = (t[1].x - t[0].x) * (t[2].z - t[0].z) - (t[2].x - t[0].x) * (t[1].z - t[0].z);
        if (!cloth || std::fabs(area) < 1e-8f) continue;
        const float u = ((point.x - t[0].x) * (t[2].z - t[0].z) - (t[2].x - t[0].x) * (point.z - t[0].z)) / area;
        const float w = ((t[1].x - t[0].x) * (point.z - t[0].z) - (point.x - t[0].x) * (t[1].z - t[0].z)) / area;
        if (u < 0 || w < 0 || u + w > 1) continue;
        const float height = point.y - (t[0].y + u * (t[1].y - t[0].y) + w * (t[2].y - t[0].y));
        if (std::fabs(height) < std::fabs(nearest)) nearest = height;
    }
    return nearest;
}

class AnyClip : public testing::TestWithParam<const char *>
{
};

class Applause : public testing::TestWithParam<const char *>
{
};

}  // namespace

TEST_P(AnyClip, KeepsHandsOutOfBodyAndHead)
{
    const uint32_t c = clip(GetParam());
    for (int k = 0; k <= frames(c); ++k) {
        const Posed p = pose(c, float(k) * frame_s);
        const auto body = flesh(p);
        for (size_t v = 0; v < p.vertices.size(); ++v) {
            if (!any_hand(v)) continue;
            for (const Capsule &part : body) ASSERT_LT(depth(part, p.vertices[v]), 0) << part.name << " at frame " << k;
        }
    }
}

TEST_P(AnyClip, KeepsForearmsOutOfBodyAndThighs)
{
    const uint32_t c = clip(GetParam());
    for (int k = 0; k <= frames(c); ++k) {
        const Posed p = pose(c, float(k) * frame_s);
        const auto body = flesh(p);
        for (const char *side : {"l", "r"}) {
            const vec3 elbow = p.joints[node(std::string("forearm_") + side)];
            const vec3 wrist = p.joints[node(std::string("hand_") + side)];
            for (const float share : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
                for (const Capsule &part : body)
                    ASSERT_LT(depth(part, elbow + (wrist - elbow) * share), -0.020f)
                        << part.name << " at frame " << k << ", " << share << " along the forearm";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Citizen, AnyClip, testing::ValuesIn(puppet::clip_names),
                         [](const auto &clip_info) { return std::string(clip_info.param); });

TEST_P(Applause, HasPalmsMeetWithoutPassingThroughEachOther)
{
    const uint32_t c = clip(GetParam());
    float nearest = 1e9f, widest = 0;
    int meetings = 0;
    bool met = false;
    for (int k = 0; k <= 4 * frames(c); ++k) {
        const float gap = between_palms(pose(c, float(k) * frame_s / 4));
        nearest = std::min(nearest, gap);
        widest = std::max(widest, gap);
        meetings += gap < 0.03f && !met;
        met = gap < (met ? 0.05f : 0.03f);
    }
    EXPECT_LT(nearest, 0.03f);
    EXPECT_GT(nearest, -0.01f);
    EXPECT_GE(meetings, 6);
    EXPECT_GT(widest, 0.12f) << "the hands must part: clapping, not praying";
}

INSTANTIATE_TEST_SUITE_P(Citizen, Applause, testing::Values("applaud", "sit_applaud", "stand_applaud"),
                         [](const auto &clip_info) { return std::string(clip_info.param); });

TEST(Hands, LieOnTheThighsWhileSittingStill)
{
    const Posed p = pose(clip("sit"), 0);
    float left = 1e9f, right = 1e9f, deepest = 1e9f;
    for (size_t v = 0; v < p.vertices.size(); ++v) {
        if (!any_hand(v)) continue;
        const float height = over_lap(p, p.vertices[v]);
        if (left_hand(v)) left = std::min(left, height);
        if (right_hand(v)) right = std::min(right, height);
        deepest = std::min(deepest, height);
    }
    EXPECT_LT(left, 0.020f);
    EXPECT_LT(right, 0.020f);
    EXPECT_GT(deepest, -0.020f);
}
TEST(Hands, RiseAboveTheHeadInTurnWhenCheering)
{
    const uint32_t c = clip("cheer");
    bool left_first = false, right_first = false;
    for (int k = 0; k < frames(c); ++k) {
        const Posed p = pose(c, float(k) * frame_s);
        const float l = p.joints[node("hand_l")].y, r = p.joints[node("hand_r")].y;
        EXPECT_GT(std::max(l, r), 1.75f);
        left_first |= l > r + 0.1f;
        right_first |= r > l + 0.1f;
    }
    EXPECT_TRUE(left_first && right_first);
}

TEST(Hands, RiseAboveTheHeadWhenCheeringOrWavingFromTheSeat)
{
    for (const char *name : {"sit_cheer", "sit_wave", "stand_wave"}) {
        const uint32_t c = clip(name);
        const Posed p = pose(c, 0.5f * float(frames(c)) * frame_s);
        float highest = 0;
        for (size_t v = 0; v < p.vertices.size(); ++v)
            if (any_hand(v)) highest = std::max(highest, p.vertices[v].y);
        EXPECT_GT(highest, p.joints[node("head")].y + 0.16f) << name;
    }
}

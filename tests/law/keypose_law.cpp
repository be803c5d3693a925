// Key-poses (S3): keeping them changes the cost of a frame, never what it shows; no actor is skinned twice.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/scene.h"
#include "support/second_evaluation.h"

namespace claque
{

using namespace testing_support;
using animcache::KeyPoseMode;
using animcache::Mode;
using animcache::VertexFormat;

namespace
{

SceneDef with(KeyPoseMode mode)
{
    SceneDef def;
    def.settings.caches.key_poses.bands[0] = {0, mode};
    def.settings.caches.key_poses.band_count = 1;
    return def;
}

// Each key-pose mode in a distance band of its own.
SceneDef rings()
{
    SceneDef def;
    animcache::KeyPoseSettings &settings = def.settings.caches.key_poses;
    settings.bands[0] = {0, KeyPoseMode::skinned};
    settings.bands[1] = {6, KeyPoseMode::individual};
    settings.bands[2] = {15, KeyPoseMode::interpolated};
    settings.bands[3] = {35, KeyPoseMode::intermittent};
    settings.band_count = 4;
    return def;
}

std::vector<uint64_t> walk_key_poses(const SceneDef &def, const base::Jobs &jobs = base::Jobs())
{
    Scene scene(def);
    scene.add_view(glm::dvec3(20, 5, -40), glm::dvec3(0, 0, -30));
    std::vector<uint64_t> out;
    double t = 3;
    for (int i = 0; i < 30; ++i) {
        t += i == 12 ? 1000 : i == 20 ? -995.5 : i > 25 ? -1.0 / 60 : 1.0 / 30;
        scene.look(0, glm::dvec3(0.3 * i, 1.7, i >= 15 && i < 18 ? 30 : 0), glm::dvec3(i % 9 - 4, 1, -20));
        out.push_back(scene.update(t, jobs));
    }
    return out;
}

// Floats of 24 bits, in products over up to four nodes of coordinates below 4, and library slerps within 1e-5 of exact
// ones; tests/reference allows the same of a character's size, which is about 2 here.
constexpr double pose_tolerance = 1e-4;

// From the second evaluation at this time of the clip: the positions, and the normals of vertices with one influence,
// as the library blends normals of several otherwise. A key of the clip may round to either side of the time.
double farthest_from(const draw::Item &item, const model::Level &level, const reference::Character &character,
                     uint32_t clip, double time_s)
{
    double least = HUGE_VAL;
    for (const double beside : {0.0, -1e-6, 1e-6}) {
        const reference::Shape shape = reference::evaluate(character, clip, time_s + beside);
        double most = 0;
        const auto differ = [&](const reference::Vec3 &wanted, const float *is) {
            const reference::Vec3 v = {double(is[0]), double(is[1]), double(is[2])};
            most = std::max(most, reference::length(wanted - v));
        };
        for (uint32_t v = 0; v < level.vertex_count; ++v) {
            const uint32_t from = v < level.source_count ? v : level.copies[v - level.source_count];
            differ(shape.positions[from], item.vertices.positions + 3 * size_t(v));
            if (from >= level.runs[0].count) continue;
            const float *n = item.vertices.normals + 3 * size_t(v);  // of any length
            const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            const float unit[3] = {n[0] / length, n[1] / length, n[2] / length};
            differ(shape.normals[from], unit);
        }
        least = std::min(least, most);
    }
    return least;
}

const SceneDef kinds[] = {with(KeyPoseMode::intermittent), with(KeyPoseMode::interpolated), rings()};

}  // namespace

TEST(KeyPoseLaw, ThePictureDoesNotDependOnHowManyKeyPosesAreKept)
{
    std::set<std::vector<uint64_t>> different;
    for (const SceneDef &kind : kinds)
        for (const VertexFormat vertex_format : {VertexFormat::floats, VertexFormat::packed}) {
            SceneDef def = kind;
            def.settings.caches.vertex_format = vertex_format;
            const std::vector<uint64_t> all = walk_key_poses(def);
            EXPECT_GT(std::set<uint64_t>(all.begin(), all.end()).size(), 25u) << "the individuals must move";
            different.insert(all);
            for (const uint32_t most : {0u, 1u, 2u, 7u, 20u}) {
                def.settings.caches.key_poses.max_kept = most;
                EXPECT_EQ(walk_key_poses(def), all) << most << " kept";
            }
            for (const uint64_t budget : {0u, 30000u, 200000u}) {
                def.settings.caches.key_poses.budget_bytes = budget;
                EXPECT_EQ(walk_key_poses(def), all) << budget << " bytes";
            }
        }
    EXPECT_EQ(different.size(), 6u) << "the key-pose modes must show different poses";
}

TEST(KeyPoseLaw, ThePictureDoesNotDependOnOtherCachesNorOnThreads)
{
    for (const SceneDef &kind : kinds) {
        SceneDef def = kind;
        def.settings.caches.key_poses.max_kept = 5;
        const std::vector<uint64_t> all = walk_key_poses(def);
        for (const Mode mode : {Mode::full, Mode::animation, Mode::none})
            for (const uint64_t budget : {uint64_t(0), uint64_t(60000), uint64_t(1) << 30}) {
                def.settings.caches.mode = mode;
                def.settings.caches.budget_bytes = budget;
                EXPECT_EQ(walk_key_poses(def), all) << "mode " << int(mode) << ", " << budget << " bytes";
            }
        Threads threads(4);
        EXPECT_EQ(walk_key_poses(def, threads.jobs()), all);
    }
}

TEST(KeyPoseLaw, NoKeyPoseIsSkinnedTwiceInAFrameWhateverTheNumberOfViews)
{
    for (const KeyPoseMode mode : {KeyPoseMode::intermittent, KeyPoseMode::interpolated}) {
        SceneDef def = with(mode);
        def.actors = 300;
        Scene scene(def);
        for (int more = 0; more < 3; ++more) scene.add_view(glm::dvec3(more, 3, 5), glm::dvec3(0, 0, -30));
        scene.update(3);
        const frame::Stats &stats = scene.frame.stats();
        const auto &key_poses = stats.key_poses;
        size_t listed = 0;
        std::set<const float *> memory;
        for (const auto &view : scene.views) {
            listed += view->list.items.size();
            for (const draw::Item &item : view->list.items) memory.insert(item.vertices.positions);
        }
        ASSERT_GT(key_poses.requested, 100u);
        EXPECT_EQ(key_poses.served, key_poses.requested);
        EXPECT_EQ(key_poses.updated, key_poses.wanted) << "the first update makes each key-pose once";
        EXPECT_LT(key_poses.wanted, 2 * key_poses.requested);
        EXPECT_GT(listed, 2 * stats.visible) << "several views must show them";
        EXPECT_EQ(stats.on_demand, 0u);
        // Each vertex array was made once: those of key-poses, and those of actors between two key-poses or without a
        // clip.
        if (mode == KeyPoseMode::intermittent) {
            EXPECT_LT(memory.size(), stats.visible);
            EXPECT_EQ(memory.size(), key_poses.updated + stats.skinned);
        } else {
            EXPECT_EQ(memory.size(), stats.skinned) << "each individual blended once";
        }
        scene.update(3);
        EXPECT_EQ(scene.frame.stats().key_poses.updated, 0u);
        EXPECT_EQ(scene.frame.stats().skinned, 0u);
    }
}

TEST(KeyPoseLaw, WhatIsShownIsTheNearestKeyPose)
{
    Scene scene(with(KeyPoseMode::intermittent));
    scene.update(7.3);
    uint32_t checked = 0, with_neighbours = 0;
    for (const draw::Item &item : scene.views[0]->list.items) {
        const crowd::Play &play = scene.crowd.play_of(item.actor_index);
        if (play.clip == model::none) continue;
        const model::Level &level = item.tmpl->levels[item.level];
        const model::Clip &clip = item.tmpl->rig.clips[play.clip];
        const reference::Character character = character_of(*item.tmpl, level);
        const double length = double(clip.duration_s), intervals = std::max(1.0, std::round(length * 15));
        const double shown_s = scene.frame.visibility(scene.crowd, item.actor_index).shown_s;
        const double along = double(play.phase_s) + double(play.speed) * (shown_s - play.start_s);
        const double key = length > 0 ? std::floor((along / length - std::floor(along / length)) * intervals + 0.5) : 0;
        const auto at = [&](double number) { return double(clip.start_s) + length * number / intervals; };
        EXPECT_LT(farthest_from(item, level, character, play.clip, at(key)), pose_tolerance) << item.actor_index;
        ++checked;
        for (const double other : {key - 1, key + 1})
            if (other >= 0 && other <= intervals && length > 0)
                with_neighbours += farthest_from(item, level, character, play.clip, at(other)) > 100 * pose_tolerance;
    }
    EXPECT_GT(checked, 20u);
    EXPECT_GT(with_neighbours, 20u) << "the key-poses beside those shown must be others";
}

TEST(KeyPoseLaw, TheLeastRecentlyUsedKeyPoseIsEvictedAndAWantedOneStays)
{
    SceneDef def = with(KeyPoseMode::intermittent);
    def.actors = 200;
    def.settings.caches.key_poses.max_kept = 12;
    Scene scene(def);
    uint64_t updates = 0, served = 0, requested = 0;
    for (int i = 0; i < 60; ++i) {
        scene.update(3 + i / 60.0);
        const auto &key_poses = scene.frame.stats().key_poses;
        EXPECT_LE(key_poses.held, 12u * 4) << "12 for each of two levels of two templates";
        EXPECT_LE(key_poses.updated, key_poses.wanted);
        if (i > 0) updates += key_poses.updated;
        served += key_poses.served, requested += key_poses.requested;
    }
    EXPECT_GT(served, requested / 4);
    EXPECT_LT(served, requested) << "the memory must not hold all";
    EXPECT_LT(updates, 59u * 48 / 2) << "key-poses that are still wanted are not made again";
}

TEST(KeyPoseLaw, ActorsMovedByMoreThanOneClipKeepTheirOwnCache)
{
    Scene scene(with(KeyPoseMode::intermittent));
    scene.update(4);
    uint32_t without_clip = 0;
    for (const draw::Item &item : scene.views[0]->list.items)
        without_clip += scene.crowd.play_of(item.actor_index).clip == model::none;
    const frame::Stats &stats = scene.frame.stats();
    ASSERT_GT(without_clip, 0u);
    EXPECT_EQ(stats.key_poses.requested + without_clip, stats.visible);
    EXPECT_EQ(stats.skinned, without_clip);
}

}  // namespace claque

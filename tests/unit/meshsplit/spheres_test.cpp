// The Sklsroot Bsphere holds every vertex of every pose and is little larger than necessary (S0 4.1).
#include "meshsplit/spheres.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/pose/pose.h"
#include "models.h"

namespace claque::test
{

namespace
{

// An arm of two joints along x; the second turns from -90 to 90 degrees about z in a second, the first swings out.
model::Model arm(model::Interpolation how)
{
    model::Model m = empty_model();
    m.rig.parents.push_back(0);
    m.rig.rest.push_back(math::Trs());
    m.rig.rest[1].translation = glm::vec3(2, 0, 0);
    m.rig.node_names.emplace_back("elbow");
    math::Affine back;
    back.set_column(3, glm::vec3(-2, 0, 0));
    m.rig.palette.push_back({1, back});
    model::Part part = sheet_part(8, 2);
    for (size_t v = 0; v < part.positions.size(); ++v) {
        part.positions[v].x *= 4;
        part.joints[v] = part.positions[v].x > 2 ? 1 : 0;
    }
    part.material = model::none;
    m.parts.push_back(part);
    m.rig.clips.push_back({0, 2, 0, 1});
    m.rig.clip_names.emplace_back("wave");
    m.rig.times = {0, 0.5f, 1};
    const float h = std::sqrt(0.5f);
    m.rig.values = {0, 0, -h, h, 0, 0, 0, 1, 0, 0, h, h, 0, 0, 0, 0, 1, 0, 0, -3, 0};
    m.rig.channels.push_back({1, model::ChannelTarget::rotation, how, 4, 0, 3, 0});
    m.rig.channels.push_back({0, model::ChannelTarget::translation, how, 3, 0, 3, 12});
    return m;
}

// Every vertex at many times, posed by lib/pose directly.
template <class Body>
void each_position(const model::Template &tmpl, const Body &body)
{
    pose::Workspace workspace(tmpl.rig);
    const model::Level &level = tmpl.levels[0];
    for (int step = 0; step <= 3001; ++step) {
        const auto palette = step > 3000 ? workspace.pose(model::none, 0) : workspace.pose(0, step / 3000.0);
        for (const model::InfluenceRun &run : level.runs)
            for (uint32_t v = 0; v < run.count; ++v) {
                const float *p = &level.positions[3 * (run.first + v)];
                glm::dvec3 at(0);
                for (uint32_t i = 0; i < run.influences; ++i) {
                    const uint32_t k = run.first_influence + v * run.influences + i;
                    at += double(level.weights[k]) *
                          glm::dvec3(math::transform_point(palette[level.joints[k]], {p[0], p[1], p[2]}));
                }
                body(at);
            }
    }
}

void expect_snug(const model::Template &tmpl, double slack)
{
    double reach = 0;
    glm::dvec3 low(1e9), high(-1e9);
    each_position(tmpl, [&](const glm::dvec3 &p) {
        reach = std::max(reach, glm::distance(p, glm::dvec3(tmpl.sklsroot.centre)));
        low = glm::min(low, p), high = glm::max(high, p);
    });
    EXPECT_LE(reach, double(tmpl.sklsroot.radius));
    EXPECT_LE(double(tmpl.sklsroot.radius), reach * (1 + slack));
    // No sphere that holds two points is smaller than half their distance; the box's longest side is such a bound.
    const glm::dvec3 size = high - low;
    EXPECT_GE(double(tmpl.sklsroot.radius), 0.5 * std::max({size.x, size.y, size.z}));
    EXPECT_LE(double(tmpl.sklsroot.radius), 0.55 * glm::length(size)) << "far from the smallest";
}

}  // namespace

TEST(Spheres, HoldEveryVertexOfATurningArmWithinAPercent)
{
    expect_snug(*built(arm(model::Interpolation::linear)), 0.01);
}

TEST(Spheres, HoldPosesThatJump) { expect_snug(*built(arm(model::Interpolation::step)), 0.01); }

TEST(Spheres, AStillModelGetsTheSphereOfItsMesh)
{
    model::Model m = empty_model();
    m.parts.push_back(sheet_part(3, 3));
    m.parts[0].material = model::none;
    const auto tmpl = built(m);
    EXPECT_NEAR(tmpl->sklsroot.radius, std::sqrt(0.5), 0.01);
    EXPECT_NEAR(tmpl->sklsroot.centre.x, 0.5, 0.01);
}

TEST(Spheres, HoldMorphTargetsAtTheirWeights)
{
    model::Model m = empty_model();
    m.parts.push_back(sheet_part(1, 1));
    m.parts[0].material = model::none;
    m.rig.morph_sets.push_back({0, 0, 1});
    m.rig.rest_weights = {0};
    m.parts[0].morph_set = 0;
    m.parts[0].morphs.resize(1);
    m.parts[0].morphs[0].positions.assign(4, glm::vec3(0, 0, 5));
    m.rig.clips.push_back({0, 1, 0, 1});
    m.rig.clip_names.emplace_back("grow");
    m.rig.times = {0, 1};
    m.rig.values = {0, 2};
    m.rig.channels.push_back({0, model::ChannelTarget::morph_weights, model::Interpolation::linear, 1, 0, 2, 0});
    const auto tmpl = built(m);
    EXPECT_NEAR(tmpl->sklsroot.centre.z, 5, 0.05);
    EXPECT_GE(tmpl->sklsroot.radius, std::sqrt(25.5f));
    EXPECT_LE(tmpl->sklsroot.radius, std::sqrt(25.5f) * 1.01f);
}

TEST(Spheres, HoldWhatBulgesOutBetweenTwoPoses)
{
    model::Model m = empty_model();
    m.parts.push_back(sheet_part(1, 1));
    m.parts[0].material = model::none;
    for (auto &p : m.parts[0].positions) p = p * 0.1f + glm::vec3(2, 0, 0);
    // A distant object on the other side, so that the sphere's centre lies behind the axis of rotation.
    m.rig.parents.push_back(model::none);
    m.rig.rest.push_back(math::Trs());
    m.rig.node_names.emplace_back("still");
    m.rig.palette.push_back({1, math::Affine()});
    m.parts.push_back(m.parts[0]);
    for (auto &p : m.parts[1].positions) p = (p - glm::vec3(2, 0, 0)) + glm::vec3(-2, -3.46f, 0);
    m.parts[1].joints.assign(4, 1);
    m.rig.clips.push_back({0, 1, 0, 1 / 60.0f});
    m.rig.clip_names.emplace_back("whirl");
    m.rig.times = {0, 1 / 60.0f};
    m.rig.values = {0, 0, 0, 1, 0, 0, std::sqrt(0.75f), 0.5f};  // 120 degrees about z
    m.rig.channels.push_back({0, model::ChannelTarget::rotation, model::Interpolation::linear, 4, 0, 2, 0});
    const auto tmpl = built(m);
    pose::Workspace workspace(tmpl->rig);
    const model::Level &level = tmpl->levels[0];
    for (int step = 0; step <= 100; ++step) {
        const auto palette = workspace.pose(0, step / 6000.0);
        for (uint32_t v = 0; v < level.source_count; ++v) {
            const float *p = &level.positions[3 * v];
            const glm::vec3 at = math::transform_point(palette[level.joints[v]], {p[0], p[1], p[2]});
            ASSERT_LE(glm::distance(at, tmpl->sklsroot.centre), tmpl->sklsroot.radius) << step;
        }
    }
}

// A small sheet on a long arm turns about z within one step, and a still one lies on the other side, so that the centre
// of the sphere is far behind the axis: whichever of the two poses is nearer, and on either side of the farthest point.
TEST(Spheres, HoldTheWholeArcBetweenAnyTwoPoses)
{
    for (const float away : {4.0f, 20.0f})
        for (int from = -175; from <= 175; from += 10)
            for (const int turn : {-110, -90, -50, 50, 90, 110}) {
                model::Model m = empty_model();
                m.parts.push_back(sheet_part(1, 1));
                m.parts[0].material = model::none;
                m.rig.parents.push_back(model::none);
                m.rig.rest.push_back(math::Trs());
                m.rig.node_names.emplace_back("still");
                m.rig.palette.push_back({1, math::Affine()});
                m.parts.push_back(m.parts[0]);
                for (auto &p : m.parts[0].positions) p = p * 0.02f + glm::vec3(-2, 0, 0);
                for (auto &p : m.parts[1].positions) p = p * 0.02f + glm::vec3(-away, 0, 0);
                m.parts[1].joints.assign(4, 1);
                m.rig.clips.push_back({0, 1, 0, 1 / 60.0f});
                m.rig.clip_names.emplace_back("whirl");
                m.rig.times = {0, 1 / 60.0f};
                for (const int degrees : {from, from + turn}) {
                    const float half = 0.5f * 0.01745329f * float(degrees + 180);
                    m.rig.values.insert(m.rig.values.end(), {0.0f, 0.0f, std::sin(half), std::cos(half)});
                }
                m.rig.channels.push_back({0, model::ChannelTarget::rotation, model::Interpolation::linear, 4, 0, 2, 0});
                const auto tmpl = built(m);
                const model::Level &level = tmpl->levels[0];
                pose::Workspace workspace(tmpl->rig);
                for (int step = 0; step <= 30; ++step) {
                    const auto palette = workspace.pose(0, step / 1800.0);
                    for (uint32_t v = 0; v < level.source_count; ++v) {
                        const float *p = &level.positions[3 * v];
                        const glm::vec3 at = math::transform_point(palette[level.joints[v]], {p[0], p[1], p[2]});
                        ASSERT_LE(glm::distance(at, tmpl->sklsroot.centre), tmpl->sklsroot.radius)
                            << from << " to " << from + turn << " at " << step;
                    }
                }
            }
}

TEST(Spheres, ClipsAreLookedAtAtTheirKeysAndSixtyTimesASecond)
{
    const model::Model m = arm(model::Interpolation::linear);
    const auto times = meshsplit::sample_times(m.rig, 0);
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), 1);
    for (size_t i = 1; i < times.size(); ++i) {
        EXPECT_GT(times[i], times[i - 1]);
        EXPECT_LE(times[i] - times[i - 1], 1 / 60.0 + 1e-9);
    }
    EXPECT_NE(std::find(times.begin(), times.end(), 0.5), times.end());
}

}  // namespace claque::test

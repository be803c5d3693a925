// The spheres of actors that blend clips (S2 3.3), compared with blends of all kinds: they hold every vertex and node,
// and where a blend stretches a character as no clip does, they are hardly larger than that.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "reach_ascent.h"
#include "reach_rigs.h"
#include "reach_sampling.h"

namespace claque::test
{

namespace
{

void expect_held(const model::Template &tmpl, uint32_t count)
{
    const glm::dvec3 centre(tmpl.sklsroot.centre);
    for (const float added : {0.0f, 1.0f, 3.5f, model::max_additive_weight}) {
        SCOPED_TRACE(added);
        const Sampled found = sample_blends(tmpl, centre, count, added);
        EXPECT_LE(found.vertex, double(tmpl.blend_radius.at(added)));
        EXPECT_GT(found.vertex, 0);
        for (size_t n = 0; n < found.node.size(); ++n) {
            EXPECT_LE(found.node[n], double(tmpl.blend_reach[n].distance.at(added)) * (1 + 1e-6) + 1e-6) << n;
            EXPECT_LE(found.stretch[n], double(tmpl.blend_reach[n].scale.at(added)) * (1 + 1e-6)) << n;
        }
    }
}

// Three links of a metre, folded at rest. One clip rotates the whole continuously; each other clip unfolds one joint,
// so that only a blend is ever straight.
model::Model folded()
{
    model::Model m;
    m.name = "folded";
    const float fold = 2.8f;
    const auto about_x = [](float angle) { return glm::quat(std::cos(angle / 2), std::sin(angle / 2), 0, 0); };
    for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t node = add_node(m, i == 0 ? model::none : i - 1, {0, i == 0 ? 0 : 1, 0}, "link");
        if (i > 0) m.rig.rest[node].rotation = about_x(i == 1 ? fold : -fold);
        add_box(m, node, {0, 0.5f, 0}, {0.05f, 0.5f, 0.05f});
    }
    const auto add_clip = [&](const char *name, uint32_t node, const std::vector<glm::quat> &turns) {
        m.rig.clips.push_back({uint32_t(m.rig.channels.size()), 1, 0, float(turns.size() - 1)});
        m.rig.clip_names.emplace_back(name);
        m.rig.channels.push_back({node, model::ChannelTarget::rotation, model::Interpolation::linear, 4,
                                  uint32_t(m.rig.times.size()), uint32_t(turns.size()), uint32_t(m.rig.values.size())});
        for (size_t k = 0; k < turns.size(); ++k) {
            m.rig.times.push_back(float(k));
            for (const float x : {turns[k].x, turns[k].y, turns[k].z, turns[k].w}) m.rig.values.push_back(x);
        }
    };
    std::vector<glm::quat> round;
    for (int k = 0; k <= 8; ++k) round.push_back(about_x(0.78539816f * float(k)));
    add_clip("round", 0, round);
    add_clip("unfold 1", 1, {about_x(fold), about_x(0)});
    add_clip("unfold 2", 2, {about_x(-fold), about_x(0)});
    return m;
}

}  // namespace

TEST(ReachBlends, ThatNoClipShowsStayInTheirSpheres)
{
    for (FreeModel &free : free_models()) {
        SCOPED_TRACE(free.name);
        expect_held(*built(std::move(free.model), 64), 400);
    }
}

TEST(ReachBlends, OfBuiltInPeopleStayInTheirSpheres)
{
    const auto tmpl = built(figures::citizen(), 64);
    expect_held(*tmpl, 1500);
    const Sampled alone = sample_reach(*tmpl, glm::dvec3(tmpl->sklsroot.centre), 1000);
    EXPECT_LT(alone.vertex, double(tmpl->blend_radius.base));
}

TEST(ReachBlends, ThatUnfoldFoldedClipsAreHeldTightly)
{
    const auto tmpl = built(folded(), 64);
    expect_held(*tmpl, 3000);
    // Rotating, with each joint unfolded by its own clip.
    const float first[3] = {0, 1, 0}, second[3] = {0, 0, 1};
    pose::Layer layers[3];
    for (uint32_t i = 0; i < 3; ++i) layers[i].clip = i, layers[i].time_s = 1;
    layers[1].mask = first, layers[2].mask = second;
    double farthest = 0;
    for (int k = 0; k < 160; ++k) {
        layers[0].time_s = 0.05 * k;
        farthest = std::max(farthest, sample_layers(*tmpl, glm::dvec3(tmpl->sklsroot.centre), {layers, 3}).vertex);
    }
    EXPECT_LE(farthest, double(tmpl->blend_radius.base));
    EXPECT_GT(farthest, 1.2 * double(tmpl->sklsroot.radius))
        << "otherwise no blend would leave the sphere of the clips";
    EXPECT_GT(farthest, 0.88 * double(tmpl->blend_radius.base)) << "the test would not notice too small a sphere";
}

}  // namespace claque::test

// Frames are the same long after the start and far from the origin.
#include <set>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "support/scene.h"

namespace claque
{

using namespace testing_support;

TEST(FrameLaw, TenMillionSecondsLaterNothingHasDrifted)
{
    SceneDef def;
    def.actors = 1;
    def.settings.caches.period = {0, 0, 1, 2};
    Scene early(def), late(def);
    crowd::Play play;
    play.clip = clip_walk;
    const double length = early.templates[0]->rig.clips[clip_walk].duration_s;
    const double later = length * 9e6;  // about 1e7 s, a whole number of clips
    std::set<std::vector<float>> shapes;
    for (int i = 0; i < 50; ++i) {
        crowd::play(early.crowd, early.ids[0], play);
        crowd::play(late.crowd, late.ids[0], play);
        early.update(i * 0.02);
        late.update(later + i * 0.02);
        const model::Level &level = early.templates[0]->levels[0];
        const float *a = early.views[0]->list.items[0].vertices.positions;
        const float *b = late.views[0]->list.items[0].vertices.positions;
        for (uint32_t k = 0; k < 3 * level.vertex_count; ++k) ASSERT_NEAR(a[k], b[k], 2e-6) << i;
        shapes.insert(std::vector<float>(a, a + 3 * size_t(level.vertex_count)));
    }
    EXPECT_EQ(shapes.size(), 50u) << "the individual must move";
}

// The same with ticks, at every distance: what is shown then is the clip at the tick, which is no more than one period
// old.
TEST(FrameLaw, TenMillionSecondsLaterTheTicksAreInStep)
{
    SceneDef def, every_frame;
    def.actors = every_frame.actors = 1;
    every_frame.settings.caches.period = {0, 0, 1, 2};
    Scene early(every_frame), late(def);
    crowd::Play play;
    play.clip = clip_walk;
    const double later = early.templates[0]->rig.clips[clip_walk].duration_s * 9e6;
    std::set<float> periods;
    for (int i = 0; i < 60; ++i) {
        crowd::Transform place;
        place.position = glm::dvec3(0, 0, -5 - 0.9 * i);
        for (Scene *scene : {&early, &late}) {
            crowd::set_transforms(scene->crowd, &scene->ids[0], &place, 1);
            crowd::play(scene->crowd, scene->ids[0], play);
        }
        const double now_s = later + 1 + i * 0.037;
        late.update(now_s);
        const frame::ActorVisibility seen = late.frame.visibility(late.crowd, 0);
        ASSERT_TRUE(seen.visible);
        periods.insert(seen.period_s);
        ASSERT_LE(seen.shown_s, now_s);
        ASSERT_GT(seen.shown_s, now_s - double(seen.period_s) - 1e-8);
        early.update(seen.shown_s - later);
        const draw::Item &a = early.views[0]->list.items[0], &b = late.views[0]->list.items[0];
        ASSERT_EQ(a.level, b.level);
        const uint32_t numbers = 3 * early.templates[0]->levels[a.level].vertex_count;
        for (uint32_t k = 0; k < numbers; ++k) ASSERT_NEAR(a.vertices.positions[k], b.vertices.positions[k], 2e-6) << i;
    }
    EXPECT_GT(periods.size(), 8u) << "too few rates are tried";
}

TEST(FrameLaw, FarFromTheOriginTheSameSceneIsVisible)
{
    SceneDef far;
    far.origin = glm::dvec3(1e6, -2e6, 3e6);
    Scene here, there(far);
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 eye(0.013 * i, 1.7, 0.007 * i);
        here.look(0, eye, glm::dvec3(0, 1, -30)), there.look(0, eye, glm::dvec3(0, 1, -30));
        here.update(1 + i / 60.0), there.update(1 + i / 60.0);
        const auto &a = here.views[0]->list.items, &b = there.views[0]->list.items;
        ASSERT_EQ(a.size(), b.size());
        ASSERT_GT(a.size(), 40u);
        for (size_t k = 0; k < a.size(); ++k) {
            ASSERT_EQ(a[k].actor_index, b[k].actor_index);
            for (int m = 0; m < 16; ++m) ASSERT_NEAR(a[k].model_view[m], b[k].model_view[m], 1e-5);
        }
    }
}

}  // namespace claque

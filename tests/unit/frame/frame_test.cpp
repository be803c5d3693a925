#include "lib/frame/frame.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "tests/law/support/scene.h"

namespace claque::frame
{

using namespace testing_support;

TEST(Camera, LooksAtItsTargetWithUpUp)
{
    const Camera camera = look_at(glm::dvec3(3, 2, 5), glm::dvec3(-1, 4, -2), glm::vec3(0, 1, 0), 1, 1.5f, 0.1f, 100);
    const auto to_eye = [&](glm::dvec3 world) { return camera.rotation * glm::vec3(world - camera.eye); };
    const glm::vec3 target = to_eye(glm::dvec3(-1, 4, -2));
    EXPECT_NEAR(target.x, 0, 1e-6);
    EXPECT_NEAR(target.y, 0, 1e-6);
    EXPECT_NEAR(target.z, -std::sqrt(16.0 + 4 + 49), 1e-5);
    const glm::vec3 above = to_eye(glm::dvec3(-1, 5, -2));
    EXPECT_NEAR(above.x, 0, 1e-6);
    EXPECT_GT(above.y, 0);
    EXPECT_NEAR(camera.projection[5], 1 / std::tan(0.5), 1e-6);
    EXPECT_NEAR(camera.projection[0], 1 / std::tan(0.5) / 1.5, 1e-6);
    const float z = -0.1f;
    EXPECT_NEAR((camera.projection[10] * z + camera.projection[14]) / -z, -1, 1e-5);  // the near plane
}

TEST(Camera, LooksInEveryDirection)
{
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && z == 0) continue;
                const glm::dvec3 target(x, y, z);
                const Camera camera = look_at(glm::dvec3(0), target, glm::vec3(0, 1, 0), 1, 1, 1, 2);
                const glm::vec3 seen = camera.rotation * glm::vec3(target);
                EXPECT_NEAR(seen.x, 0, 1e-6) << x << y << z;
                EXPECT_NEAR(seen.y, 0, 1e-6) << x << y << z;
                EXPECT_LT(seen.z, 0) << x << y << z;
            }
}

TEST(Camera, RefusesWhatIsNoPerspective)
{
    const auto refused = [](glm::dvec3 target, glm::vec3 up, float fov, float z_near) {
        try {
            look_at(glm::dvec3(0), target, up, fov, 1, z_near, 10);
        } catch (const base::Error &error) {
            return error.status() == CLQ_ARGUMENT;
        }
        return false;
    };
    EXPECT_TRUE(refused(glm::dvec3(0), glm::vec3(0, 1, 0), 1, 1));
    EXPECT_TRUE(refused(glm::dvec3(0, 5, 0), glm::vec3(0, 1, 0), 1, 1));
    EXPECT_TRUE(refused(glm::dvec3(1, 0, 0), glm::vec3(0, 1, 0), 4, 1));
    EXPECT_TRUE(refused(glm::dvec3(1, 0, 0), glm::vec3(0, 1, 0), 1, 0));
    EXPECT_FALSE(refused(glm::dvec3(1, 0, 0), glm::vec3(0, 1, 0), 1, 1));
}

TEST(Cull, KeepsEveryActorWithAVertexInside)
{
    SceneDef def;
    def.actors = 150;
    Scene all(def), some(def);
    // Vertices of all individuals, from eyes that together see all of them.
    all.look(0, glm::dvec3(0, 0, 200), glm::dvec3(0, 0, 0));
    uint32_t left_out = 0;
    for (int turn = 0; turn < 24; ++turn) {
        const double a = turn * 0.2618;
        some.look(0, glm::dvec3(0, 1, -20), glm::dvec3(std::sin(a), 1, -20 + std::cos(a)));
        some.update(2);
        all.views[0]->camera.projection[0] = all.views[0]->camera.projection[5] = 0.01f;
        all.update(2);
        ASSERT_EQ(all.views[0]->list.items.size(), 150u);
        std::set<uint32_t> seen;
        for (const draw::Item &item : some.views[0]->list.items) seen.insert(item.actor_index);
        left_out += 150 - uint32_t(seen.size());
        for (const draw::Item &item : some.views[0]->list.items) EXPECT_TRUE(item.vertices.positions);
        // All vertices of a culled individual are outside one common plane of the frustum.
        for (const draw::Item &item : all.views[0]->list.items) {
            if (seen.count(item.actor_index)) continue;
            const crowd::Transform &transform = all.crowd.transform_of(item.actor_index);
            const Camera &camera = some.views[0]->camera;
            const float *p = item.vertices.positions;
            for (uint32_t v = 0; v < item.tmpl->levels[item.level].vertex_count; ++v, p += 3) {
                const glm::dvec3 world =
                    transform.position +
                    glm::dvec3(transform.orientation * (glm::vec3(p[0], p[1], p[2]) * transform.scale));
                const glm::vec3 e = camera.rotation * glm::vec3(world - camera.eye);
                const float w = -e.z;
                EXPECT_FALSE(std::fabs(camera.projection[0] * e.x) <= w && std::fabs(camera.projection[5] * e.y) <= w &&
                             w >= 0.1f);
            }
        }
    }
    EXPECT_GT(left_out, 500u);
}

TEST(List, IsByTemplateThenFrontToBackInBandsThenByRow)
{
    Scene scene;
    crowd::Transform transform;
    transform.position = glm::dvec3(0, 1.7, -9);
    for (const uint32_t row : {10u, 13u, 16u})
        crowd::set_transforms(scene.crowd, &scene.ids[row], &transform, 1);  // at one distance
    scene.update(1);
    const auto &items = scene.views[0]->list.items;
    ASSERT_GT(items.size(), 20u);
    const auto rank = [&](const draw::Item &item) {
        int doublings = 0;
        const float part = std::frexp(item.eye_distance_m, &doublings);  // [0.5, 1)
        const int band = 8 * doublings + static_cast<int>(16 * part);
        return std::make_tuple(item.tmpl == scene.templates[1].get(), band, item.actor_index);
    };
    for (size_t i = 1; i < items.size(); ++i) EXPECT_LT(rank(items[i - 1]), rank(items[i]));
    for (const draw::Item &item : items) {
        EXPECT_EQ(item.mirrored, scene.crowd.transform_of(item.actor_index).scale < 0);
        const uint8_t *rgb = scene.crowd.zone_rgb(item.actor_index);
        ASSERT_EQ(item.zone_rgb != nullptr, rgb != nullptr);
        EXPECT_TRUE(!rgb || std::equal(rgb, rgb + 3 * item.tmpl->zone_count(), item.zone_rgb));
        EXPECT_TRUE(!rgb || item.zone_rgb != rgb) << "the host may change those before it draws";
    }
}

TEST(List, DistancesInItemsAreMetres)
{
    SceneDef def;
    def.settings.caches.metres_per_unit = 0.01f;
    Scene scene(def);
    crowd::Transform transform;
    transform.position = glm::dvec3(0, 1.7, -9);
    crowd::set_transforms(scene.crowd, &scene.ids[0], &transform, 1);
    scene.update(1);
    for (const draw::Item &item : scene.views[0]->list.items)
        EXPECT_TRUE(item.actor_index != 0 || std::fabs(item.eye_distance_m - 0.09f) < 1e-6f);
}

TEST(Update, RefusesTimesAndCamerasThatAreNotFiniteAndChangesNothing)
{
    Scene scene;
    const uint64_t before = scene.update(1);
    EXPECT_EQ(scene.try_update(NAN).code, CLQ_ARGUMENT);
    scene.views[0]->camera.projection[5] = INFINITY;
    EXPECT_EQ(scene.try_update(2).code, CLQ_ARGUMENT);
    scene.views[0]->camera = Camera();
    scene.views[0]->camera.rotation = glm::quat(0, 0, 0, 0);
    EXPECT_EQ(scene.try_update(2).code, CLQ_ARGUMENT);
    EXPECT_EQ(scene.hash(), before);
}

TEST(Update, WorksWithoutActorsAndWithoutViews)
{
    SceneDef def;
    def.actors = 0;
    Scene none(def), unseen;
    none.update(1);
    EXPECT_TRUE(none.views[0]->list.items.empty());
    unseen.views.clear();
    unseen.update(1);
    EXPECT_EQ(unseen.frame.stats().visible, 0u);
}

TEST(Seen, VisibilityBelongsToThePresentOwnerOfARow)
{
    Scene scene;
    scene.update(1);
    uint32_t row = 0;
    while (!scene.frame.visibility(scene.crowd, row).visible) ++row;
    crowd::destroy(scene.crowd, scene.ids[row]);
    const crowd::Id id = crowd::create(scene.crowd, *scene.templates[0], {}, {}, 1);
    ASSERT_EQ(id.index1, row + 1);
    EXPECT_FALSE(scene.frame.visibility(scene.crowd, row).visible);
    EXPECT_FALSE(scene.frame.visibility(scene.crowd, 100000).visible);
}

TEST(Seen, ActorsOutOfViewForAWhileDoNotFreeze)
{
    Scene scene, steady;
    scene.update(1);
    scene.look(0, glm::dvec3(0, 1.7, 60), glm::dvec3(0, 1, 90));  // looks away
    for (int i = 0; i < 50; ++i) scene.update(1 + i * 0.1);
    EXPECT_EQ(scene.frame.stats().animated, 0u);
    scene.look(0, glm::dvec3(0, 1.7, 0), glm::dvec3(0, 1, -30));
    EXPECT_EQ(scene.update(7), steady.update(7));
}

}  // namespace claque::frame

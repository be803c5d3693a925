// What actors have besides clips: attached objects, ground, shadows and copies (S0 4.3, 7.1).
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "lib/frame/node_matrix.h"
#include "tests/actors/robot.h"

using namespace actors;

namespace
{

double length(const glm::dvec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

glm::dvec3 times(const double (&m)[16], const glm::dvec3 &p)
{
    glm::dvec3 out;
    for (int r = 0; r < 3; ++r) out[r] = m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r];
    return out;
}

double flat_at_two(void *, const double *) { return 2; }
double slope(void *, const double *p) { return 0.1 * p[0]; }

}  // namespace

TEST(Attached, ObjectsEnlargeTheSpheresAndLetThemShrinkAgain)
{
    World world;
    const crowd::Id id = world.add({0, 0, 0});
    const crowd::Extent before = world.crowd.extent_of(0);
    const model::Sphere lance{glm::vec3(0.4f, 1.5f, 0), 1.6f};
    const crowd::Id held = crowd::attach(world.crowd, id, hand_left, lance);
    const crowd::Id small = crowd::attach(world.crowd, id, head, {glm::vec3(0, 0.1f, 0), 0.05f});
    const crowd::Extent with = world.crowd.extent_of(0);
    EXPECT_GT(with.sklsroot, before.sklsroot + 1);
    EXPECT_GE(with.refpoint, with.sklsroot);

    // The sphere holds the object in every pose: in those of the clip and with the arms at any angle.
    world.look({0, 1, 8}, {0, 1, 0});
    const glm::dvec3 centre(world.tmpl->sklsroot.centre);
    double farthest = 0;
    for (int k = 0; k < 200; ++k) {
        world.update(0.017 * k);
        double m[16];
        frame::node_world_matrix(world.crowd, world.frame, 0, hand_left, 0.017 * k, m);
        farthest = std::max(farthest, length(times(m, glm::dvec3(lance.centre)) - centre) + double(lance.radius));
    }
    EXPECT_LE(farthest, double(with.sklsroot));

    crowd::detach(world.crowd, held);
    EXPECT_LT(world.crowd.extent_of(0).sklsroot, before.sklsroot + 0.3f);
    crowd::detach(world.crowd, small);
    EXPECT_EQ(world.crowd.extent_of(0).sklsroot, before.sklsroot);
    EXPECT_EQ(world.crowd.extent_of(0).refpoint, before.refpoint);
    EXPECT_THROW(crowd::detach(world.crowd, held), base::Error);
}

TEST(Attached, AnObjectInViewKeepsItsActorAlive)
{
    World world;
    const crowd::Id id = world.add({0, 0, 0});
    world.look({0, 30, 60}, {0, 30, 0}, 0.4f);
    world.update(0);
    EXPECT_EQ(world.frame.stats().passed_sklsroot, 0u);
    crowd::attach(world.crowd, id, hand_right, {glm::vec3(0, 20, 0), 10});
    world.update(0);
    EXPECT_EQ(world.frame.stats().passed_sklsroot, 1u);
}

TEST(Nodes, AreWhereTheirVerticesAre)
{
    World world;
    const crowd::Id id = world.add({5, 0, -3}, 0.7f);
    world.look({5, 1, 5}, {5, 1, -3});
    for (int k = 0; k < 40; ++k) {
        world.update(0.031 * k);
        const frame::ActorVisibility seen = world.seen(id);
        ASSERT_TRUE(seen.visible);
        double shown[16], exact[16];
        frame::node_world_matrix(world.crowd, world.frame, 0, arm_left, std::nan(""), shown);
        frame::node_world_matrix(world.crowd, world.frame, 0, arm_left, seen.shown_s, exact);
        for (int i = 0; i < 16; ++i) EXPECT_EQ(shown[i], exact[i]) << i;
        // The first vertex of the arm's box is a corner of that box in the node's frame.
        const model::Level &level = world.tmpl->levels[0];
        const draw::Item &item = world.views[0]->list.items[0];
        double nearest = 1e9;
        const glm::dvec3 corner = times(shown, {0.6, 0.07, 0.07});
        for (uint32_t v = 0; v < level.source_count; ++v) {
            const float *p = item.vertices.positions + 3 * v;
            const glm::dvec3 at = glm::dvec3(5, 0, -3) + glm::dvec3(turned(0.7f) * glm::vec3(p[0], p[1], p[2]));
            nearest = std::min(nearest, length(at - corner));
        }
        EXPECT_LT(nearest, 1e-5);
    }
}

TEST(Shadows, CastersAreUpdatedByTheirSweptSphereAndNotDrawn)
{
    World world;
    world.add({0, 12, 0});
    frame::View &view = world.look({0, 1, 10}, {0, 0, 0}, 0.5f);
    world.update(0);
    EXPECT_EQ(view.list.items.size(), 0u);
    view.shadow = glm::vec3(1, -12, 0);
    world.update(0);
    ASSERT_EQ(view.list.items.size(), 1u);
    EXPECT_TRUE(view.list.items[0].shadow_only);
    EXPECT_TRUE(world.seen(world.ids[0]).visible);
    view.shadow = glm::vec3(40, -12, 0);
    world.update(0);
    EXPECT_EQ(view.list.items.size(), 1u) << "the sphere crosses the view on its way";
    view.shadow = glm::vec3(0, 12, 0);
    world.update(0);
    EXPECT_EQ(view.list.items.size(), 0u);
}

// Its sphere crosses the frustum's edge, but none of its parts does: its shadow may be in the picture all the same.
TEST(Shadows, CastersWithNoPartInViewAreUpdatedWhereTheirSphereReachesIn)
{
    World world;
    world.add({0, 0, 0});
    frame::View &view = world.look({0, 1, 10}, {0, 1, 0}, 0.5f, 1);
    uint32_t beside = 0;
    for (int step = 0; step < 200; ++step) {
        view.camera.eye.x = 2 + 0.02 * step;
        view.shadow = glm::vec3(0);
        world.update(step);
        const bool is_seen = !view.list.items.empty();
        view.shadow = glm::vec3(0, -1e-6f, 0);
        world.update(step);
        if (view.list.items.empty()) continue;
        EXPECT_EQ(view.list.items[0].shadow_only, !is_seen) << view.camera.eye.x;
        if (!is_seen) EXPECT_EQ(view.list.items[0].parts, ~uint64_t(0));
        beside += !is_seen;
    }
    EXPECT_GT(beside, 3u);
}

TEST(Ground, CarriesActorsThatFollowItWithinItsReach)
{
    World world;
    const crowd::Id follows = world.add({0, 0, 0}), stays = world.add({2, 0, 0}), far = world.add({-2, 0, 0});
    crowd::follow_ground(world.crowd, follows, 3, 3);
    crowd::follow_ground(world.crowd, far, 0.5f, 3);
    crowd::set_ground(world.crowd, flat_at_two, nullptr);
    world.look({0, 2, 9}, {0, 2, 0});
    world.update(0);
    crowd::Transform root;
    ASSERT_TRUE(world.frame.root_of(world.crowd, 0, root));
    EXPECT_EQ(root.position.y, 2);
    ASSERT_TRUE(world.frame.root_of(world.crowd, stays.index1 - 1, root));
    EXPECT_EQ(root.position.y, 0);
    ASSERT_TRUE(world.frame.root_of(world.crowd, far.index1 - 1, root));
    EXPECT_EQ(root.position.y, 0.5);
    EXPECT_EQ(world.crowd.extent_of(0).slack, 3.0f);

    crowd::Transform place;
    place.position = {10, 0, 0};
    crowd::set_ground(world.crowd, slope, nullptr);
    crowd::set_transforms(world.crowd, &follows, &place, 1);
    world.views[0]->camera = frame::look_at({10, 2, 9}, {10, 1, 0}, glm::vec3(0, 1, 0), 1, 1.3f, 0.1f, 100);
    world.update(0.1);
    ASSERT_TRUE(world.frame.root_of(world.crowd, 0, root));
    EXPECT_DOUBLE_EQ(root.position.y, 1);
}

TEST(Clones, StartEqualToTheirOriginalAndThenDiverge)
{
    World world;
    const crowd::Id id = world.add({0, 0, 0}, 0.3f, 11);
    const float red[3] = {1, 0, 0}, blue[3] = {0, 0, 1};
    crowd::set_colours(world.crowd, id, red, 1);
    crowd::set_priority(world.crowd, id, 0.25f);
    crowd::follow_ground(world.crowd, id, 1, 2);
    crowd::Transform group_place;
    group_place.position = {1, 0, -4};
    const crowd::Id group = crowd::create_group(world.crowd, group_place);
    crowd::join(world.crowd, id, group, nullptr);
    const crowd::Id attached = crowd::attach(world.crowd, id, head, {glm::vec3(0), 5});
    (void)attached;

    crowd::Transform place;
    place.position = {2, 0, 0};
    const crowd::Id twin = crowd::clone(world.crowd, id, &place, 11);
    const uint32_t row = twin.index1 - 1;
    EXPECT_EQ(world.crowd.group_of(row), world.crowd.group_of(0));
    EXPECT_EQ(world.crowd.group(0).members, 2u);
    EXPECT_EQ(world.crowd.extent_of(row).priority, 0.25f);
    EXPECT_EQ(world.crowd.extent_of(row).slack, 2.0f);
    EXPECT_LT(world.crowd.extent_of(row).sklsroot, world.crowd.extent_of(0).sklsroot)
        << "attached objects are not copied";
    EXPECT_EQ(world.crowd.zone_rgb(row)[0], 255);
    crowd::set_colours(world.crowd, id, blue, 1);
    EXPECT_EQ(world.crowd.zone_rgb(row)[0], 255);
    crowd::destroy(world.crowd, id);
    world.look({2, 1, 6}, {2, 1, -4});
    world.update(0.3);
    EXPECT_EQ(world.views[0]->list.items.size(), 1u);
}

TEST(Clones, OfOneSeedShowTheSamePose)
{
    // Every pose at the time of the update: the ticks of two individuals differ.
    frame::Settings settings;
    settings.caches.period.near_s = settings.caches.period.far_s = 0;
    World world(settings);
    const crowd::Id id = world.add({-1, 0, 0}, 0, 5);
    crowd::Transform place;
    place.position = {1, 0, 0};
    crowd::clone(world.crowd, id, &place, 5);
    world.look({0, 1, 3}, {0, 1, 0}, 1.4f);
    world.frame.reset_bands();
    for (const double time_s : {0.0, 0.3, 0.71}) {
        world.update(time_s);
        ASSERT_EQ(world.views[0]->list.items.size(), 2u);
        const draw::Vertices a = world.views[0]->list.items[0].vertices, b = world.views[0]->list.items[1].vertices;
        const uint32_t count = world.tmpl->levels[world.views[0]->list.items[0].level].vertex_count;
        for (uint32_t i = 0; i < 3 * count; ++i) ASSERT_EQ(a.positions[i], b.positions[i]) << time_s << " s, " << i;
    }
}

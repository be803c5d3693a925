// The three cull phases with behaviour between them, compared with the traditional order of work (S0 4.2).
#include <cmath>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "tests/actors/robot.h"

using namespace actors;

namespace
{

// The calls of the host's mechanism, in order.
struct Calls {
    std::vector<clq_behaviour_call> made;
    static void run(void *user, const clq_behaviour_call *call, clq_dof_writer *)
    {
        static_cast<Calls *>(user)->made.push_back(*call);
    }
};

uint32_t add_host(World &world, Calls &calls, bool memory)
{
    crowd::HostMechanism host;
    host.run = Calls::run, host.user = &calls, host.memory = memory;
    crowd::Mechanism mechanism;
    mechanism.kind = host;
    mechanism.tmpl = world.tmpl.get();
    return world.crowd.behaviours().add(std::move(mechanism), {});
}

uint32_t add_gaze(World &world)
{
    crowd::Gaze gaze;
    gaze.neck_yaw = neck_yaw, gaze.neck_pitch = neck_pitch, gaze.spine_yaw = chest_yaw;
    gaze.wander_s = 1.5f;
    gaze.eyes = {0, 1.8f, 0.1f};
    crowd::Mechanism mechanism;
    mechanism.kind = gaze;
    mechanism.tmpl = world.tmpl.get();
    const uint32_t written[] = {neck_yaw, neck_pitch, chest_yaw};
    return world.crowd.behaviours().add(std::move(mechanism), base::Span<const uint32_t>(written, 3));
}

uint32_t add_circle(World &world, float radius)
{
    crowd::RootPath path(std::pmr::get_default_resource());
    for (int k = 0; k < 8; ++k)
        path.positions.push_back(glm::vec3(radius * std::cos(0.7853982f * float(k)), 0.5f * float(k % 3),
                                           radius * std::sin(0.7853982f * float(k))));
    path.duration_s = 6, path.bank = 0.5f, path.max_bank = 0.6f;
    path.reach = behave::reach_of(path);
    return world.crowd.behaviours().add(std::move(path));
}

// 150 robots within 80 m on all sides of the eye: some follow a path, some are in groups, all have a gaze mechanism.
void populate(World &world)
{
    const uint32_t gaze = add_gaze(world), circle = add_circle(world, 4);
    std::vector<crowd::Id> groups;
    for (uint32_t g = 0; g < 3; ++g) {
        crowd::Transform place;
        place.position = {20.0 * g - 20, 0, -25};
        place.orientation = turned(float(g));
        groups.push_back(crowd::create_group(world.crowd, place));
    }
    for (uint32_t i = 0; i < 150; ++i) {
        const double angle = 6.2831853 * random_unit(1, i), away = 2 + 78 * random_unit(2, i);
        const crowd::Id id =
            world.add({away * std::sin(angle), 0, away * std::cos(angle)}, float(6 * random_unit(3, i)), i);
        if (i % 2 == 0) crowd::attach_mechanism(world.crowd, id, {gaze, model::none, 0, 0, 0, model::none});
        if (i % 3 == 0) crowd::play_root_path(world.crowd, id, {circle, 1, float(6 * random_unit(4, i)), 0});
        if (i % 5 == 0) crowd::join(world.crowd, id, groups[i % 3], nullptr);
        if (i % 7 == 0) crowd::set_priority(world.crowd, id, 0.8f);
    }
}

frame::Settings traditional()
{
    frame::Settings settings;
    settings.cull = frame::Cull::traditional;
    return settings;
}

}  // namespace

TEST(Phases, TraditionalModeDrawsTheSameLists)
{
    World actor, all(traditional());
    for (World *world : {&actor, &all}) {
        populate(*world);
        world->look({0, 1.7, 0}, {0, 1, -30});
        world->look({0, 30, 40}, {0, 0, 0}, 0.5f);
    }
    for (int frame = 0; frame < 60; ++frame) {
        const double time_s = frame * 0.07 + (frame > 40 ? -2 : 0);
        actor.update(time_s);
        all.update(time_s);
        ASSERT_EQ(actor.views[0]->list.items.size(), all.views[0]->list.items.size()) << frame;
        ASSERT_EQ(actor.hash(), all.hash()) << frame;
    }
    EXPECT_LT(actor.frame.stats().passed_sklsroot, 120u);
    EXPECT_EQ(all.frame.stats().passed_refpoint, 150u);
}

TEST(Phases, EachPhaseLeavesFewerAndBehaviourRunsForTheseAlone)
{
    World world;
    populate(world);
    Calls calls;
    const uint32_t host = add_host(world, calls, false);
    for (const crowd::Id id : world.ids)
        crowd::attach_mechanism(world.crowd, id, {host, model::none, 1, 0, 0, model::none});
    world.look({0, 1.7, 0}, {0, 1, -30});
    world.update(1);
    const frame::Stats &stats = world.frame.stats();
    EXPECT_LT(stats.passed_refpoint, stats.tested);
    EXPECT_LT(stats.passed_sklsroot, stats.passed_refpoint);
    EXPECT_LE(stats.visible, stats.passed_sklsroot);
    EXPECT_GT(stats.visible, 5u);
    EXPECT_LT(stats.crossing, stats.passed_sklsroot);
    // The mechanism is not called for a level in which all nodes that it writes are deactivated.
    uint32_t articulated = 0;
    for (const crowd::Id id : world.ids) articulated += world.seen(id).visible && world.seen(id).level < 2;
    EXPECT_GE(calls.made.size(), articulated);
    EXPECT_LE(calls.made.size(), stats.passed_sklsroot);
    EXPECT_EQ(stats.behaviour.calls[5], calls.made.size());
    EXPECT_EQ(stats.roots_placed, stats.passed_refpoint);
    for (const clq_behaviour_call &call : calls.made) {
        EXPECT_EQ(call.visible, 1);
        EXPECT_LE(call.time_s, 1.0);
        EXPECT_NEAR(double(call.eye_distance_m),
                    double(world.seen({call.actor.index1, call.actor.generation}).distance), 1e-4);
    }
    // The mechanism is not called for an actor that is not due.
    calls.made.clear();
    world.update(1);
    EXPECT_EQ(calls.made.size(), 0u);
}

TEST(Phases, AMechanismWithMemoryRunsInEveryUpdateForEveryActorInOrderInBothModes)
{
    World actor, all(traditional());
    Calls calls[2];
    World *worlds[2] = {&actor, &all};
    for (int w = 0; w < 2; ++w) {
        populate(*worlds[w]);
        const uint32_t host = add_host(*worlds[w], calls[w], true);
        for (size_t i = 0; i < worlds[w]->ids.size(); i += 4)
            crowd::attach_mechanism(worlds[w]->crowd, worlds[w]->ids[i], {host, model::none, 1, 0, 0, model::none});
        worlds[w]->look({0, 1.7, 0}, {0, 1, -30});
        for (int frame = 0; frame < 3; ++frame) worlds[w]->update(0.01 * frame);
    }
    ASSERT_EQ(calls[0].made.size(), 3u * 38u);
    ASSERT_EQ(calls[1].made.size(), calls[0].made.size());
    for (size_t i = 0; i < calls[0].made.size(); ++i) {
        const clq_behaviour_call &a = calls[0].made[i], &b = calls[1].made[i];
        EXPECT_EQ(a.actor.index1, b.actor.index1);
        EXPECT_EQ(a.level, b.level);
        EXPECT_EQ(a.time_s, b.time_s);
        EXPECT_EQ(a.eye_distance_m, b.eye_distance_m);
        EXPECT_EQ(a.visible, 0);
        if (i % 38 > 0) {
            EXPECT_GT(a.actor.index1, calls[0].made[i - 1].actor.index1);
        }
    }
    EXPECT_EQ(actor.hash(), all.hash());
}

TEST(Phases, TheRefpointBsphereHoldsTheSklsrootBsphereWhereverTheRootGoes)
{
    World world;
    const uint32_t circle = add_circle(world, 6);
    const crowd::Id id = world.add({3, 1, -2}, 0.4f);
    crowd::play_root_path(world.crowd, id, {circle, 1.3f, 0.2f, 0});
    const crowd::Extent &extent = world.crowd.extent_of(0);
    const model::Sphere &sklsroot = world.tmpl->sklsroot;
    double farthest = 0;
    for (int k = 0; k < 2000; ++k) {
        const crowd::Transform root = behave::root_transform_at(world.crowd, 0, 0.0123 * k);
        const glm::dvec3 centre = root.position + glm::dvec3(root.orientation * sklsroot.centre);
        farthest = std::max(farthest, std::sqrt(centre.x * centre.x + centre.y * centre.y + centre.z * centre.z) +
                                          double(sklsroot.radius));
    }
    EXPECT_LE(farthest, double(extent.refpoint));
    EXPECT_GE(farthest * 1.25, double(extent.refpoint)) << "it is not needlessly large";
    crowd::play_root_path(world.crowd, id, {});
    EXPECT_LT(world.crowd.extent_of(0).refpoint, extent.refpoint + 1e-6f);
    EXPECT_LT(world.crowd.extent_of(0).refpoint, 4.0f);
}

TEST(Phases, AnActorThatReturnsIntoViewIsAtItsClock)
{
    World seen_always, away;
    for (World *world : {&seen_always, &away}) populate(*world);
    seen_always.look({0, 1.7, 0}, {0, 1, -30});
    away.look({0, 1.7, 0}, {0, 1, 30});
    for (int frame = 0; frame < 20; ++frame) {
        seen_always.update(frame * 0.1);
        away.update(frame * 0.1);
    }
    away.views[0]->camera = seen_always.views[0]->camera;
    seen_always.update(2.05);
    away.update(2.05);
    EXPECT_EQ(seen_always.hash(), away.hash());
}

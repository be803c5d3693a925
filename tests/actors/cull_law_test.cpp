// No phase of culling loses what a camera sees (S0 4.2). Cameras are aimed so that the outermost vertex of an actor, a
// group or a part is just inside one plane of the frustum, and all else of it outside. The reference is a crowd in
// traditional mode, seen whole by another camera, whose vertices are tested one by one.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "lib/math/eye_transform.h"
#include "meshsplit/build.h"
#include "tests/actors/aim.h"
#include "tests/actors/ball.h"
#include "tests/actors/robot.h"

using namespace actors;

namespace
{

// Sphere for which a camera is aimed.
enum class Phase { refpoint, sklsroot, group, part };

// Every pose at the time of the update, at the finest level, so that it does not depend on the camera.
frame::Settings exact(frame::Cull cull)
{
    frame::Settings settings;
    settings.cull = cull;
    settings.caches.mode = animcache::Mode::none;
    settings.caches.period.near_s = settings.caches.period.far_s = 0;
    settings.lod_scale = 0;
    return settings;
}

double ground_height(void *, const double *p) { return 1.5 * std::sin(p[0]) + 1.5; }

uint32_t add_circle(World &world)
{
    crowd::RootPath path(std::pmr::get_default_resource());
    path.flight = false, path.duration_s = 5;
    for (int k = 0; k <= 64; ++k) {
        const float angle = 6.2831853f * float(k) / 64;
        path.times_s.push_back(5 * float(k) / 64);
        path.positions.push_back(3.0f * glm::vec3(std::cos(angle), 0, std::sin(angle)));
        path.rotations.push_back(turned(-angle));
    }
    path.reach = behave::reach_of(path);
    return world.crowd.behaviours().add(std::move(path));
}

crowd::Transform random_transform(uint32_t i, uint32_t round)
{
    crowd::Transform transform;
    for (uint32_t k = 0; k < 3; ++k)
        transform.position[k] = (k == 1 ? 10 : 60) * (random_unit(20 + k, 1000 * round + i) - 0.5);
    transform.orientation = turned(float(6 * random_unit(23, 1000 * round + i)));
    transform.scale = float(0.4 + 1.4 * random_unit(24, 1000 * round + i)) * (i % 6 == 5 ? -1.0f : 1.0f);
    return transform;
}

// 60 actors; those of some kinds follow a path, the ground or a group.
struct Crowds {
    explicit Crowds(const model::Model &model) : all(exact(frame::Cull::traditional)), culled(exact(frame::Cull::actor))
    {
        for (World *world : {&all, &culled}) {
            world->tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
            meshsplit::build(model, meshsplit::BuildOptions(), *world->tmpl);
            for (uint32_t i = 0; i < 60; ++i) world->add({0, 0, 0}, 0, i);
        }
        all.look({0, 0, 500}, {0, 0, 0}, 1.0f, 1.3f);
        culled.look({0, 0, 500}, {0, 0, 0});
        move(0);
    }

    // Two groups of five, and one group for each of the last ten.
    void group()
    {
        for (World *world : {&all, &culled})
            for (uint32_t g = 0; g < 12; ++g) {
                const crowd::Id group = crowd::create_group(world->crowd, random_transform(g, 999));
                for (uint32_t i = 0; i < (g < 2 ? 5u : 1u); ++i) {
                    crowd::Transform inner = random_transform(g < 2 ? 5 * g + i : 48 + g, 0);
                    inner.position = inner.position * 0.05;
                    crowd::join(world->crowd, world->ids[g < 2 ? 5 * g + i : 48 + g], group, &inner);
                }
            }
    }
    void follow_paths()
    {
        for (World *world : {&all, &culled}) {
            const uint32_t circle = add_circle(*world);
            for (uint32_t i = 0; i < 60; ++i)
                crowd::play_root_path(world->crowd, world->ids[i], {circle, 1, float(5 * random_unit(25, i)), 0});
        }
    }
    void follow_ground()
    {
        for (World *world : {&all, &culled}) {
            crowd::set_ground(world->crowd, ground_height, nullptr);
            for (const crowd::Id id : world->ids) crowd::follow_ground(world->crowd, id, 2, 2);
        }
    }
    // Gives a third of the actors without a group new places.
    void move(uint32_t round)
    {
        for (World *world : {&all, &culled})
            for (uint32_t i = round % 3; i < 60; i += 3) {
                const crowd::Transform place = random_transform(i, round);
                if (world->crowd.group_of(i) == model::none)
                    crowd::set_transforms(world->crowd, &world->ids[i], &place, 1);
            }
    }

    World all, culled;
};

// The vertices of every actor in the world, in double, and the part of each.
struct Seen {
    std::vector<glm::dvec3> vertices[60];
    std::vector<uint32_t> parts[60];
};

uint32_t part_at(const model::Level &level, const model::Surface &surface, uint32_t offset)
{
    const uint32_t parts = static_cast<uint32_t>(level.parts.size());
    if (parts == 1) return 0;
    const uint32_t *firsts = surface.part_offsets.data() + surface.part_offsets.size() - (parts + 1);
    uint32_t part = 0;
    while (firsts[part + 1] <= offset) ++part;
    return part;
}

Seen see_all(World &world)
{
    Seen seen;
    for (const draw::Item &item : world.views[0]->list.items) {
        crowd::Transform root;
        EXPECT_TRUE(world.frame.root_of(world.crowd, item.actor_index, root));
        const model::Level &level = item.tmpl->levels[item.level];
        const glm::dmat3 turn = math::rotation_of(root.orientation);
        for (const model::Surface &surface : level.surfaces)
            for (uint32_t i = 0; i < surface.fused.count; ++i) {
                const float *p = item.vertices.positions + 3 * level.indices[surface.fused.first + i];
                seen.vertices[item.actor_index].push_back(root.position +
                                                          turn * (glm::dvec3(p[0], p[1], p[2]) * double(root.scale)));
                seen.parts[item.actor_index].push_back(part_at(level, surface, i));
            }
    }
    return seen;
}

struct Ball {
    glm::dvec3 centre;
    double radius;
};

// What the phase tests for an actor, from the numbers that the crowd keeps.
Ball tested(World &world, uint32_t row, Phase phase)
{
    const crowd::Crowd &crowd = world.crowd;
    const crowd::Extent &extent = crowd.extent_of(row);
    const crowd::Transform place = crowd.world_transform_of(row);
    if (phase != Phase::sklsroot)
        return {place.position, std::fabs(double(place.scale)) * double(extent.refpoint) + double(extent.slack)};
    crowd::Transform root;
    EXPECT_TRUE(world.frame.root_of(crowd, row, root));
    const glm::dvec3 centre(world.tmpl->sklsroot.centre);
    return {root.position + math::rotation_of(root.orientation) * (centre * double(root.scale)),
            std::fabs(double(root.scale)) * double(extent.sklsroot)};
}

// Aims 300 cameras. Returns the largest share of a sphere's radius at which a vertex was: a radius smaller than that
// loses an actor here.
double hold(Crowds &crowds, Phase phase)
{
    double farthest_share = 0;
    for (uint32_t k = 0; k < 300; ++k) {
        crowds.move(k / 4);
        const double time_s = 0.031 * k;
        crowds.all.update(time_s);
        EXPECT_EQ(crowds.all.views[0]->list.items.size(), 60u);
        const Seen seen = see_all(crowds.all);
        const uint32_t row = phase == Phase::group ? 50 + k % 10 : static_cast<uint32_t>(60 * random_unit(30, k));
        const uint32_t part = seen.parts[row][static_cast<size_t>(random_unit(31, k) * double(seen.parts[row].size()))];
        const Ball ball = tested(crowds.all, row, phase);
        // Towards the vertex farthest from the middle of the sphere; for a part, in any direction.
        glm::dvec3 out = random_direction(k);
        double farthest = -1;
        size_t outermost = 0;
        for (size_t v = 0; v < seen.vertices[row].size(); ++v) {
            if (phase == Phase::part && seen.parts[row][v] != part) continue;
            const glm::dvec3 way = seen.vertices[row][v] - ball.centre;
            const double distance = phase == Phase::part ? along(way, out) + 1000 : std::sqrt(along(way, way));
            if (distance > farthest) farthest = distance, outermost = v;
        }
        const glm::dvec3 corner = seen.vertices[row][outermost];
        if (phase != Phase::part) {
            out = (corner - ball.centre) / farthest;
            farthest_share = std::max(farthest_share, farthest / ball.radius);
        }
        crowds.culled.views[0]->camera = aimed(k, corner, out, 1e-3 * ball.radius);
        crowds.culled.update(time_s);
        uint64_t parts[60] = {0};
        for (const draw::Item &item : crowds.culled.views[0]->list.items) parts[item.actor_index] = item.parts;
        const Camera camera(crowds.culled.views[0]->camera);
        EXPECT_TRUE(camera.sees(corner)) << "camera " << k << " is not aimed";
        for (uint32_t r = 0; r < 60; ++r)
            for (size_t v = 0; v < seen.vertices[r].size(); ++v)
                if (!(parts[r] >> seen.parts[r][v] & 1) && camera.sees(seen.vertices[r][v])) {
                    ADD_FAILURE() << "camera " << k << " sees part " << seen.parts[r][v] << " of actor " << r
                                  << ", which is not drawn";
                    return farthest_share;
                }
    }
    return farthest_share;
}

}  // namespace

TEST(CullLaw, TheRefpointBsphereLosesNoActorOnARootPath)
{
    Crowds crowds(ball_model(glm::vec3(0)));
    crowds.follow_paths();
    EXPECT_GT(hold(crowds, Phase::refpoint), 0.98);
}

TEST(CullLaw, TheRefpointBsphereLosesNoActorThatFollowsTheGround)
{
    Crowds crowds(ball_model(glm::vec3(0)));
    crowds.follow_ground();
    EXPECT_GT(hold(crowds, Phase::refpoint), 0.98);
}

TEST(CullLaw, TheRefpointBsphereLosesNoActorWhoseSklsrootBsphereIsBesideIt)
{
    Crowds crowds(ball_model({0.7f, 1.2f, -0.4f}));
    EXPECT_GT(hold(crowds, Phase::refpoint), 0.98);
}

TEST(CullLaw, TheSklsrootBsphereLosesNoActor)
{
    Crowds beside(ball_model({0.7f, 1.2f, -0.4f}));
    EXPECT_GT(hold(beside, Phase::sklsroot), 0.98);
    Crowds swinging(swing_model());
    EXPECT_GT(hold(swinging, Phase::sklsroot), 0.98);
}

TEST(CullLaw, TheGroupBsphereLosesNoActor)
{
    Crowds crowds(ball_model(glm::vec3(0)));
    crowds.group();
    EXPECT_GT(hold(crowds, Phase::group), 0.98);
}

TEST(CullLaw, ACullScaleNarrowsTheFrustumToItsShareOfThePicture)
{
    World world;
    frame::View &view = world.look({0, 0, 50}, {0, 0, 0}, 1.5707963f, 1);  // half the picture is 50 m at the actors
    const crowd::Id inside = world.add({20, 0, 0}), outside = world.add({0, 30, 0});
    for (const float scale : {1.0f, 0.5f, 1.0f}) {
        view.cull_scale = scale;
        world.update(0);
        EXPECT_TRUE(world.seen(inside).visible) << scale;
        EXPECT_EQ(world.seen(outside).visible, scale == 1) << scale;
    }
}

TEST(CullLaw, NoPhaseLosesARobotOrOneOfItsParts)
{
    Crowds crowds(robot_model());
    crowds.follow_paths();
    crowds.group();
    const double share = hold(crowds, Phase::sklsroot);
    RecordProperty("share", std::to_string(share));
    EXPECT_GT(share, 0.98);
    hold(crowds, Phase::part);
}

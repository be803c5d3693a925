// S0's Tables 2 and 3 hold in `hundred_actors` at any time, by the library's counters; both ways of culling show the
// same.
#include <algorithm>

#include <gtest/gtest.h>

#include "samples/cost/scene.h"
#include "samples/scenes/scene.h"

namespace
{

using namespace scenes;

constexpr double hundred_times_s[] = {0.0, 2.0, 2.04, 5.3, 11.7, 26.0, 1000.5};
const cost::Scene table_2;

CrowdOptions crowd_options(clq_cull_mode cull = CLQ_CULL_ACTOR, float lod_scale = 1)
{
    CrowdOptions c;
    c.count = 100;
    c.cull = cull;
    c.lod_scale = lod_scale;
    return c;
}

struct Seen {
    clq_crowd_stats stats = clq_crowd_stats_init();
    clq_view_stats view = clq_view_stats_init();
    uint64_t hash = 0;
};

// The scene before its own camera at 1024 x 768, without drawing.
class Watched
{
public:
    explicit Watched(const CrowdOptions &crowd_options)
    {
        scene_ = make_scene("hundred_actors", library_, crowd_options, {});
        clq_view *made = nullptr;
        check(clq_view_create(scene_->crowd(), &made));
        view_.reset(made);
        check(clq_view_set_height(made, 768));
    }

    Seen at(double time_s)
    {
        scene_->place(time_s);
        const clq_camera camera = scene_->camera(Shot::overview, 4.0 / 3.0, time_s);
        check(clq_view_set_camera(view_.get(), &camera));
        clq_view *views[] = {view_.get()};
        check(clq_crowd_update(scene_->crowd(), time_s, views, 1));
        Seen seen;
        check(clq_crowd_get_stats(scene_->crowd(), &seen.stats));
        check(clq_view_get_stats(view_.get(), &seen.view));
        seen.hash = clq_view_get_hash(view_.get());
        return seen;
    }

    Scene &scene() { return *scene_; }

private:
    Library library_ = Library(2);
    std::unique_ptr<Scene> scene_;
    Own<clq_view> view_;
};

TEST(HundredActors, EightyPassTheFirstPhaseAndSixtyTheSecondAtAnyTime)
{
    for (const uint64_t seed : {1u, 2u, 40u}) {
        CrowdOptions c = crowd_options();
        c.seed = seed;
        Watched watched(c);
        for (const double time_s : hundred_times_s) {
            const clq_crowd_stats s = watched.at(time_s).stats;
            EXPECT_EQ(s.tested, 100u);
            EXPECT_EQ(s.passed_refpoint, static_cast<uint32_t>(table_2.pass_first_cull())) << seed << " at " << time_s;
            EXPECT_EQ(s.passed_sklsroot, static_cast<uint32_t>(table_2.pass_second_cull())) << seed << " at " << time_s;
            EXPECT_EQ(s.crossing, static_cast<uint32_t>(table_2.root_crossing())) << seed << " at " << time_s;
        }
    }
}

// The scene's first two actors are C3.2.
void send_away(Watched &watched, size_t first, size_t count)
{
    const std::vector<clq_actor> actors = watched.scene().actors();
    for (size_t i = first; i < first + count; ++i) check(clq_actor_destroy(watched.scene().crowd(), actors[i]));
}

TEST(HundredActors, OneSphereSettlesActorsWhollyInsideOrOutsideThoughTheirSklsrootBsphereCrosses)
{
    Watched watched(crowd_options());
    send_away(watched, 0, 2);
    for (const double time_s : hundred_times_s) {
        const Seen seen = watched.at(time_s);
        EXPECT_EQ(seen.stats.crossing, static_cast<uint32_t>(table_2.internal_decided)) << time_s;
        EXPECT_EQ(seen.stats.sphere_tests, 98u + 78u + 8u) << time_s;
        EXPECT_EQ(seen.view.parts_left_out, 0u) << time_s;
        // Three of C3.1 are outside, five inside.
        EXPECT_EQ(seen.stats.visible, 58u - 3u) << time_s;
    }
}

TEST(HundredActors, EachOfTheTwoOthersHasPartsInsideAndPartsOutside)
{
    for (const size_t other : {0u, 1u}) {
        Watched watched(crowd_options());
        send_away(watched, other, 1);
        for (const double time_s : hundred_times_s) {
            const Seen seen = watched.at(time_s);
            EXPECT_EQ(seen.stats.visible, 59u - 3u) << time_s;
            EXPECT_GT(seen.view.parts_left_out, 0u) << time_s;
            EXPECT_LT(seen.view.parts_left_out, 40u) << time_s;
        }
    }
}

TEST(HundredActors, EachHasTheNodesDegreesOfFreedomAndSpheresOfTable3)
{
    Watched watched(crowd_options());
    clq_template_info dragon = clq_template_info_init();
    check(clq_template_get_info(watched.scene().templates()[0], &dragon));
    EXPECT_EQ(dragon.node_count, static_cast<uint32_t>(table_2.nodes_per_actor));
    EXPECT_EQ(dragon.dof_count, 2 * dragon.node_count);
    uint32_t nodes[3] = {};
    ASSERT_EQ(dragon.level_count, 3u);
    for (uint32_t i = 0; i < 3; ++i) {
        clq_level_info level = clq_level_info_init();
        check(clq_template_get_level(watched.scene().templates()[0], i, &level));
        nodes[i] = level.node_count;
    }
    EXPECT_EQ(nodes[0], 40u);
    EXPECT_EQ(nodes[1], 20u);
    EXPECT_EQ(nodes[2], 10u);
    for (const double time_s : hundred_times_s) {
        const clq_crowd_stats s = watched.at(time_s).stats;
        EXPECT_EQ(s.spheres_built, s.crossing * static_cast<uint64_t>(table_2.spheres_per_actor)) << time_s;
        EXPECT_EQ(s.matrices_needed, s.passed_sklsroot * 40 * table_2.nodes_kept) << time_s;
    }
}

TEST(HundredActors, EveryDegreeOfFreedomIsWritten)
{
    // The first actor's writes are those that are missing without it. A mouth at rest is not written.
    Watched all(crowd_options()), without(crowd_options());
    send_away(without, 0, 1);
    uint64_t most = 0;
    for (const double time_s : hundred_times_s)
        most = std::max(most, all.at(time_s).stats.dof_writes - without.at(time_s).stats.dof_writes);
    EXPECT_EQ(most, 80u);
}

TEST(HundredActors, TraditionalCullingTestsEveryActorAndShowsTheSame)
{
    Watched actor(crowd_options(CLQ_CULL_ACTOR)), traditional(crowd_options(CLQ_CULL_TRADITIONAL)),
        finest(crowd_options(CLQ_CULL_TRADITIONAL, 0));
    for (const double time_s : hundred_times_s) {
        const Seen a = actor.at(time_s), t = traditional.at(time_s), f = finest.at(time_s);
        EXPECT_EQ(a.hash, t.hash) << time_s;
        EXPECT_EQ(t.stats.passed_refpoint, 100u);
        EXPECT_EQ(t.stats.roots_placed, 100u);
        EXPECT_GT(t.stats.matrices_needed, a.stats.matrices_needed);
        EXPECT_EQ(f.stats.matrices_needed, 4000u);
        EXPECT_EQ(f.stats.spheres_built, 8000u);
    }
}

TEST(HundredActors, OnlySpheresOfPartsNeedMatrixProductsWhereOpenglDoesTheRest)
{
    CrowdOptions c = crowd_options(CLQ_CULL_ACTOR);
    const clq_crowd_stats vertices = Watched(c).at(2).stats;
    EXPECT_EQ(vertices.products_tracked, vertices.products);
    c.rigid_mode = CLQ_RIGID_MATRICES;
    const clq_crowd_stats matrices = Watched(c).at(2).stats;
    EXPECT_EQ(matrices.products_tracked, matrices.crossing * 40u);
    // Includes the three of C3.1 that only their spheres show to be outside.
    EXPECT_EQ(matrices.products, 1200u);
    c.cull = CLQ_CULL_TRADITIONAL;
    const clq_crowd_stats everybody = Watched(c).at(2).stats;
    EXPECT_EQ(everybody.products_tracked, everybody.products);
}

TEST(HundredActors, AnotherNumberOfActorsIsRefused)
{
    Library library(1);
    CrowdOptions c;
    c.count = 40;
    try {
        make_scene("hundred_actors", library, c, {});
        FAIL() << "40 actors were accepted";
    } catch (const Failure &failure) {
        EXPECT_NE(std::string(failure.what()).find("40 were requested"), std::string::npos) << failure.what();
    }
}

}  // namespace

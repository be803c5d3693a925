#include "tests/api/fuzz_world.h"

#include <algorithm>
#include <cmath>

namespace fuzz
{

double Random::odd(double low, double high, uint32_t rare)
{
    if (!one_in(rare)) return in(low, high);
    const double out[] = {0, -0.0, -1, 1e-310, 1e-40, 1e6, -1e9, 3e38, -1e300, 1.7e308, HUGE_VAL, -HUGE_VAL, NAN};
    return out[below(sizeof out / sizeof *out)];
}

uint32_t Random::index(uint32_t n, uint32_t rare)
{
    if (n && !one_in(rare)) return below(n);
    const uint32_t out[] = {n, n + 1, 0x7fffffff, 0xfffffffe, 0xffffffff};
    return out[below(5)];
}

World::World(uint64_t seed, const Options &options)
    : options_(options), random_(seed, options.choices), test_world_(options.context), seed_(seed)
{
    // One template with parts in distance bands and a tip that is deactivated; one of rigid parts for GL's matrix
    // stack.
    far_def_.def.name = "far", rigid_def_.def.name = "rigid";
    far_def_.nodes[1].deactivation_m = 25;
    far_parts_[0] = far_parts_[1] = far_def_.parts[0];
    far_parts_[0].lod_max_m = far_parts_[1].lod_min_m = 12;
    far_def_.def.part_count = 2, far_def_.def.parts = far_parts_;
    far_def_.def.dof_count = 3, far_def_.def.dofs = test_world_.dofs;
    rigid_def_.parts[0].influence_count = 0, rigid_def_.parts[0].node = 1;
    rigid_def_.def.joint_count = 0;
    templates_[0] = test_world_.templates[0], templates_[1] = test_world_.templates[1];
    EXPECT_EQ(test_world_.make(far_def_.def, &templates_[2]), CLQ_OK) << clq_last_error();
    EXPECT_EQ(test_world_.make(rigid_def_.def, &templates_[3]), CLQ_OK) << clq_last_error();

    clq_crowd_def def = clq_crowd_def_init();
    def.cache = static_cast<clq_cache_mode>(random_.below(3));
    const uint64_t budgets[] = {0, 1, 3000, 20000, 200000};
    def.cache_budget_bytes = budgets[random_.below(5)];
    if (random_.one_in(3)) def.period_near_s = def.period_far_s = 0;
    def.cull = static_cast<clq_cull_mode>(random_.one_in(4));
    def.rigid_mode = static_cast<clq_rigid_mode>(random_.one_in(2));
    def.lod_hysteresis = random_.one_in(2) ? 0.3f : 0;
    def.lod_scale = static_cast<float>(random_.in(0, 2));
    def.vertex_format = static_cast<clq_vertex_format>(random_.below(2));
    def.key_poses = any_key_poses();
    if (!random_.one_in(3)) live(def);
    is_packed_ = def.vertex_format == CLQ_VERTEX_PACKED;
    crowd_ = test_world_.new_crowd(&def);
    stranger_ = test_world_.new_crowd();
    test_world_.set_up(stranger_);
    strange_view_ = test_world_.new_view(stranger_, 0);
    new_renderer();
}

World::~World()
{
    EXPECT_EQ(clq_renderer_destroy(renderer_), CLQ_OK) << clq_last_error();
    stub_gl::expect_balance();
    clq_template_destroy(templates_[2]);
    clq_template_destroy(templates_[3]);
}

// A clock that never goes back; with a budget where the crowd keeps poses.
void World::live(clq_crowd_def &def)
{
    def.clock = CLQ_CLOCK_LIVE;
    if (def.cache == CLQ_CACHE_NONE || def.cull == CLQ_CULL_TRADITIONAL) return;
    def.update_budget = update_budget_ = random_.below(5);
    if (!random_.one_in(3)) return;
    def.update_budget_ms = static_cast<float>(random_.in(0, 5));
    def.now_user = &now_s_;
    def.now_s = [](void *user) { return *static_cast<double *>(user) += 1e-3; };
}

clq_key_poses World::any_key_poses()
{
    clq_key_poses out = clq_key_poses_init();
    out.band_count = random_.below(CLQ_KEY_POSE_BAND_MAX + 1);
    float from_m = random_.one_in(2) ? 0.0f : static_cast<float>(random_.in(1, 5));
    for (uint32_t i = 0; i < out.band_count; ++i) {
        out.bands[i] = {from_m, static_cast<clq_key_pose_mode>(random_.below(4))};
        from_m += static_cast<float>(random_.in(1, 20));
    }
    out.rate_hz = static_cast<float>(random_.in(0.5, 120));
    const uint32_t kept[] = {0, 1, 5, 256};
    out.max_kept = kept[random_.below(4)];
    const uint64_t budgets[] = {0, 1, 3000, 200000};
    out.budget_bytes = key_pose_bytes_ = budgets[random_.below(4)];
    return out;
}

void World::run()
{
    const struct {
        uint32_t share;
        Step step;
    } steps[] = {{10, &World::create},
                 {5, &World::destroy},
                 {5, &World::clone},
                 {6, &World::place},
                 {4, &World::play},
                 {4, &World::colours},
                 {2, &World::priority},
                 {4, &World::attach},
                 {3, &World::detach},
                 {2, &World::hooks},
                 {3, &World::new_group},
                 {1, &World::end_group},
                 {3, &World::move_group},
                 {6, &World::join},
                 {3, &World::add_mechanism},
                 {2, &World::add_path},
                 {9, &World::attach_mechanism},
                 {2, &World::detach_mechanism},
                 {6, &World::command},
                 {2, &World::ground},
                 {4, &World::move_root},
                 {1, &World::new_view},
                 {1, &World::end_view},
                 {3, &World::look},
                 {10, &World::update},
                 {6, &World::draw},
                 {2, &World::draw_shadows},
                 {2, &World::draw_visibility},
                 {3, &World::ask_list},
                 {4, &World::ask},
                 {2, &World::save},
                 {2, &World::restore},
                 {2, &World::nonsense},
                 {2, &World::describe_play},
                 {8, &World::blend},
                 {3, &World::watch},
                 {5, &World::follow},
                 {2, &World::new_scene},
                 {1, &World::end_scene},
                 {5, &World::tell_scene},
                 {4, &World::ask_scene},
                 {4, &World::ask_places}};
    uint32_t all = 0;
    for (const auto &each : steps) all += each.share;
    const bool chosen_by_bytes = options_.choices.size > 0;
    if (options_.records) record();
    for (step_ = 0; step_ < options_.steps && !testing::Test::HasFailure(); ++step_) {
        if (chosen_by_bytes && random_.choices_left() == 0) break;
        uint32_t choice = random_.below(all);
        const auto *chosen = steps;
        while (choice >= chosen->share) choice -= chosen++->share;
        (this->*chosen->step)();
        check();
    }
    if (options_.records && !testing::Test::HasFailure()) replay();
}

void World::judge(const char *name, clq_status status, uint64_t print_before)
{
    ++(status == CLQ_OK ? good_ : bad_);
    if (status == CLQ_OK) return;
    EXPECT_EQ(clq_crowd_get_hash(crowd_), print_before)
        << name << " failed and changed something; seed " << seed_ << ", step " << step_ << ": " << clq_last_error();
    EXPECT_NE(std::string(clq_last_error()).find(name), std::string::npos)
        << name << " failed and said " << clq_last_error() << "; seed " << seed_ << ", step " << step_;
    EXPECT_TRUE(options_.before || status != CLQ_OUT_OF_MEMORY) << name << " seed " << seed_ << ", step " << step_;
}

// Compares what the host knows with the crowd.
void World::check()
{
    const auto where = [&] { return "seed " + std::to_string(seed_) + ", step " + std::to_string(step_); };
    EXPECT_EQ(clq_crowd_get_actor_count(crowd_), known_.actors.size()) << where();
    clq_actor_info info = clq_actor_info_init();
    if (!known_.gone.empty()) {
        const clq_actor gone = known_.gone[random_.below(static_cast<uint32_t>(known_.gone.size()))];
        EXPECT_EQ(clq_actor_get_info(crowd_, gone, &info), CLQ_STALE_ID) << where();
    }
    if (!known_.actors.empty()) {
        const Known::Actor &one = known_.actors[random_.below(static_cast<uint32_t>(known_.actors.size()))];
        ASSERT_EQ(clq_actor_get_info(crowd_, one.id, &info), CLQ_OK) << where() << clq_last_error();
        EXPECT_EQ(info.group.index1, one.group.index1) << where();
        EXPECT_EQ(info.group.generation, one.group.generation) << where();
        EXPECT_EQ(info.tmpl, one.tmpl) << where();
        EXPECT_TRUE(std::isfinite(info.transform.scale) && info.transform.scale != 0) << where();
        for (const double x : info.transform.position) EXPECT_TRUE(std::isfinite(x)) << where();
        EXPECT_GE(info.refpoint_radius, info.sklsroot_radius) << where();
    }
    clq_group_info group = clq_group_info_init();
    if (!known_.gone_groups.empty()) {
        const clq_group gone = known_.gone_groups[random_.below(static_cast<uint32_t>(known_.gone_groups.size()))];
        EXPECT_EQ(clq_group_get_info(crowd_, gone, &group), CLQ_STALE_ID) << where();
    }
    if (!known_.groups.empty()) {
        const clq_group one = known_.groups[random_.below(static_cast<uint32_t>(known_.groups.size()))];
        ASSERT_EQ(clq_group_get_info(crowd_, one, &group), CLQ_OK) << where();
        const auto in_it = [&](const Known::Actor &actor) { return actor.group.index1 == one.index1; };
        EXPECT_EQ(group.member_count, std::count_if(known_.actors.begin(), known_.actors.end(), in_it)) << where();
    }
}

clq_actor World::person()
{
    const uint32_t choice = random_.below(20);
    if (choice == 0 && !known_.gone.empty())
        return known_.gone[random_.below(static_cast<uint32_t>(known_.gone.size()))];
    if (choice == 1) return {random_.index(60), random_.index(4)};
    if (known_.actors.empty()) return {0, 0};
    return known_.actors[random_.below(static_cast<uint32_t>(known_.actors.size()))].id;
}

clq_group World::any_group()
{
    const uint32_t choice = random_.below(20);
    if (choice == 0 && !known_.gone_groups.empty())
        return known_.gone_groups[random_.below(static_cast<uint32_t>(known_.gone_groups.size()))];
    if (choice == 1) return {random_.index(60), random_.index(4)};
    if (known_.groups.empty()) return {0, 0};
    return known_.groups[random_.below(static_cast<uint32_t>(known_.groups.size()))];
}

clq_transform World::any_place()
{
    clq_transform place;
    place.position[0] = random_.odd(-20, 20, 60), place.position[1] = random_.odd(-2, 2, 60);
    place.position[2] = random_.odd(-50, 10, 60);
    const double half = random_.in(-3, 3);
    for (float &x : place.orientation_xyzw) x = 0;
    place.orientation_xyzw[1] = static_cast<float>(std::sin(half));
    place.orientation_xyzw[3] = static_cast<float>(std::cos(half));
    if (random_.one_in(40)) place.orientation_xyzw[random_.below(4)] = random_.oddf(-1, 1, 2);
    place.scale = random_.oddf(0.1, 3, 40);
    return place;
}

void World::leave(clq_group group)
{
    for (Known::Actor &actor : known_.actors)
        if (actor.group.index1 == group.index1 && actor.group.generation == group.generation) actor.group = {0, 0};
}

}  // namespace fuzz

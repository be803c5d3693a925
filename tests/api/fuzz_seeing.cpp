// Random calls about views, updates, queries and saved states, and calls with null arguments.
#include <algorithm>
#include <cmath>

#include "tests/api/calls.h"
#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::new_view()
{
    if (views_.size() > 3) return;
    clq_view *made = nullptr;
    if (call("clq_view_create", [&] { return clq_view_create(crowd_, &made); })) views_.push_back(made);
}

void World::end_view()
{
    if (views_.empty()) {
        EXPECT_EQ(clq_view_destroy(nullptr), CLQ_OK);
        return;
    }
    const uint32_t which = random_.below(static_cast<uint32_t>(views_.size()));
    clq_view_destroy(views_[which]);
    views_.erase(views_.begin() + which);
}

void World::look()
{
    if (views_.empty()) return;
    clq_view *view = views_[random_.below(static_cast<uint32_t>(views_.size()))];
    clq_camera camera;
    const double eye[3] = {random_.odd(-20, 20), random_.odd(0, 5), random_.odd(0, 20)};
    const double target[3] = {random_.odd(-20, 20), random_.odd(0, 5), random_.odd(-20, 0)};
    const float up[3] = {0, random_.oddf(1, 1), 0};
    if (call("clq_camera_look_at", [&] {
            return api_test::look_at(&camera, eye, target, up, random_.oddf(0.3, 2), random_.oddf(0.5, 2),
                                     random_.oddf(0.1, 1), random_.oddf(20, 200));
        })) {
        if (random_.one_in(20)) camera.projection[random_.below(16)] = random_.oddf(-1, 1, 2);
        if (random_.one_in(20)) camera.rotation_xyzw[random_.below(4)] = random_.oddf(-1, 1, 2);
        call("clq_view_set_camera", [&] { return clq_view_set_camera(view, &camera); });
    }
    const float fall[3] = {random_.oddf(-3, 3), random_.oddf(-3, 0), random_.oddf(-3, 3)}, none[3] = {0, 0, 0};
    call("clq_view_set_shadow", [&] { return clq_view_set_shadow(view, random_.one_in(2) ? none : fall); });
    call("clq_view_set_height", [&] { return clq_view_set_height(view, random_.oddf(0, 2000)); });
    const bool divided = random_.one_in(8);
    const float low = divided ? random_.oddf(0, 0.5) : 0, high = divided ? random_.oddf(0.5, 1) : 1;
    const float tile[4] = {low, 0, high, 1};
    call("clq_view_set_tile", [&] { return clq_view_set_tile(view, tile); });
    call("clq_view_set_cull_scale", [&] { return clq_view_set_cull_scale(view, random_.oddf(0.4, 1)); });
}

void World::update()
{
    time_s_ += random_.one_in(12) ? random_.in(-20, 20) : 0.03;
    const double time_s = random_.odd(time_s_, time_s_, 25);
    std::vector<clq_view *> views;
    for (clq_view *view : views_)
        if (!random_.one_in(4)) views.push_back(view);
    const uint32_t asked = static_cast<uint32_t>(views.size());
    const uint64_t print = clq_crowd_get_hash(crowd_);
    bool good = std::isfinite(time_s);
    if (random_.one_in(30)) {
        clq_view *wrong[] = {nullptr, strange_view_, views.empty() ? nullptr : views[0]};
        views.push_back(wrong[random_.below(3)]);
        good = false;
    }
    const uint32_t count = static_cast<uint32_t>(views.size());
    bool refused = false;
    const bool done = call("clq_crowd_update", [&] {
        const clq_status status = clq_crowd_update(crowd_, time_s, views.data(), count);
        refused = status == CLQ_OUT_OF_MEMORY;
        return status;
    });
    EXPECT_EQ(done, good && !refused) << "seed " << seed_ << ", step " << step_ << ": " << clq_last_error();
    EXPECT_EQ(clq_crowd_get_hash(crowd_), print) << "an update must not change what a host has set";
    if (!done) return;
    if (options_.records) step_hashes_.push_back(print);
    expect_kept_budgets();
    for (uint32_t v = 0; v < asked; ++v) {
        clq_view_stats stats = clq_view_stats_init();
        ASSERT_EQ(clq_view_get_stats(views[v], &stats), CLQ_OK);
        EXPECT_LE(stats.visible, known_.actors.size());
        expect_format(views[v], stats.visible);
        const uint64_t hash = clq_view_get_hash(views[v]);
        EXPECT_EQ(clq_view_get_hash(views[v]), hash) << "seed " << seed_ << ", step " << step_;
    }
}

// What an update may renew and keep.
void World::expect_kept_budgets()
{
    clq_crowd_stats stats = clq_crowd_stats_init();
    ASSERT_EQ(clq_crowd_get_stats(crowd_, &stats), CLQ_OK);
    EXPECT_EQ(stats.due, stats.animated + stats.deferred) << "seed " << seed_ << ", step " << step_;
    if (update_budget_ > 0) {
        EXPECT_LE(stats.animated, update_budget_ + stats.over_budget) << "seed " << seed_ << ", step " << step_;
    }
    clq_key_pose_stats keys = clq_key_pose_stats_init();
    ASSERT_EQ(clq_crowd_get_key_pose_stats(crowd_, &keys), CLQ_OK);
    EXPECT_LE(keys.served, keys.requested) << "seed " << seed_ << ", step " << step_;
    if (key_pose_bytes_ > 0) {
        EXPECT_LE(keys.bytes, key_pose_bytes_) << "seed " << seed_ << ", step " << step_;
    }
    deferred_ += stats.deferred, key_posed_ += keys.requested;
}

// Vertices are in the crowd's format, or left out.
void World::expect_format(const clq_view *view, uint32_t visible)
{
    if (visible == 0) return;
    clq_drawn_arrays arrays = clq_drawn_arrays_init();
    ASSERT_EQ(clq_view_get_arrays(view, random_.below(visible), &arrays), CLQ_OK) << clq_last_error();
    EXPECT_TRUE(is_packed_ ? !arrays.positions : !arrays.packed_positions) << "seed " << seed_ << ", step " << step_;
    packed_ += arrays.packed_positions != nullptr;
}

void World::ask()
{
    const clq_actor id = person();
    double matrix[16];
    const double time_s = random_.odd(-9, 9, 4);
    call("clq_actor_get_node", [&] { return clq_actor_get_node(crowd_, id, random_.index(2), time_s, matrix); });
    clq_crowd_stats stats = clq_crowd_stats_init();
    ASSERT_TRUE(call("clq_crowd_get_stats", [&] { return clq_crowd_get_stats(crowd_, &stats); }));
    EXPECT_EQ(stats.actor_count, known_.actors.size());
    EXPECT_LE(stats.cache_bytes, stats.cache_budget_bytes);
    if (random_.one_in(5)) call("clq_crowd_reset_bands", [&] { return clq_crowd_reset_bands(crowd_); });
}

void World::save()
{
    if (random_.one_in(6)) {
        const auto refuse = [](void *, const void *, size_t) { return 1; };
        call("clq_crowd_save", [&] { return clq_crowd_save(crowd_, refuse, nullptr); });
    }
    bytes_ = saved::save(crowd_);
    known_then_ = known_;
}

void World::restore()
{
    if (bytes_.empty()) return;
    saved::Bytes bytes = bytes_;
    uint32_t count = 4;
    const uint32_t choice = random_.below(6);
    if (choice == 0)
        bytes[random_.below(static_cast<uint32_t>(bytes.size()))] ^= static_cast<uint8_t>(1u << random_.below(8));
    if (choice == 1) bytes.resize(random_.below(static_cast<uint32_t>(bytes.size())));
    if (choice == 2) count = random_.below(4);
    clq_template *given[4] = {templates_[0], templates_[1], templates_[2], templates_[3]};
    std::rotate(given, given + random_.below(count ? count : 1), given + count);
    const bool mine = choice > 2;
    bool refused = false;
    const bool done = call("clq_crowd_restore", [&] {
        const clq_status status =
            clq_crowd_restore(crowd_, bytes.empty() ? nullptr : bytes.data(), bytes.size(), given, count);
        refused = status == CLQ_OUT_OF_MEMORY;
        return status;
    });
    // The only valid reason is a host mechanism that this state no longer has.
    const bool lacks = std::string(clq_last_error()).find("the host's own") != std::string::npos;
    if (mine) {
        EXPECT_TRUE(done || refused || lacks) << "seed " << seed_ << ", step " << step_ << ": " << clq_last_error();
    }
    if (choice < 2) {
        EXPECT_FALSE(done) << "seed " << seed_ << ", step " << step_;
    }
    if (!done) return;
    known_ = known_then_;
    EXPECT_EQ(saved::save(crowd_), bytes_) << "seed " << seed_ << ", step " << step_;
}

void World::nonsense()
{
    const clq_actor a = person();
    const clq_transform place = any_place();
    clq_actor made;
    clq_mechanism mechanism;
    clq_root_path path;
    clq_group group;
    clq_actor_info info = clq_actor_info_init();
    const float centre[3] = {0, 0, 0};
    const uint32_t huge = 0xffffffffu;
    const std::pair<const char *, clq_status> calls[] = {
        {"create", clq_actor_create(crowd_, nullptr, &made)},
        {"create", clq_actor_create(nullptr, nullptr, nullptr)},
        {"destroy", clq_actor_destroy(nullptr, a)},
        {"clone", clq_actor_clone(crowd_, a, &place, 1, nullptr)},
        {"place", clq_crowd_set_transforms(crowd_, nullptr, nullptr, huge)},
        {"play", clq_actor_play(crowd_, a, nullptr)},
        {"colours", clq_actor_set_colours(crowd_, a, nullptr, huge)},
        {"draw", clq_actor_randomise_colours(crowd_, a, nullptr, huge)},
        {"attach", clq_actor_attach(crowd_, a, nullptr, nullptr)},
        {"attach", api_test::attach(crowd_, a, huge, centre, 1, nullptr)},
        {"group", clq_group_create(crowd_, &place, nullptr)},
        {"mechanism", clq_crowd_add_mechanism(crowd_, nullptr, &mechanism)},
        {"path", clq_crowd_add_root_path(crowd_, nullptr, &path)},
        {"use", clq_actor_attach_mechanism(crowd_, a, nullptr)},
        {"move", clq_actor_play_root_path(crowd_, a, nullptr)},
        {"update", clq_crowd_update(crowd_, 0, nullptr, huge)},
        {"info", clq_actor_get_info(crowd_, a, nullptr)},
        {"info", clq_group_get_info(crowd_, group = any_group(), nullptr)},
        {"node", clq_actor_get_node(crowd_, a, huge, 0, nullptr)},
        {"view", clq_view_create(nullptr, nullptr)},
        {"save", clq_crowd_save(crowd_, nullptr, nullptr)},
        {"restore", clq_crowd_restore(crowd_, nullptr, 0, nullptr, huge)},
        {"restore", clq_crowd_restore(crowd_, "claqueC", 7, nullptr, huge)},
        {"restore", clq_crowd_restore(crowd_, "claqueC", 7, nullptr, 0)},
        {"stats", clq_crowd_get_stats(crowd_, nullptr)},
    };
    for (const auto &[name, status] : calls)
        EXPECT_NE(status, CLQ_OK) << name << ", seed " << seed_ << ", step " << step_;
    EXPECT_EQ(clq_actor_get_info(stranger_, a, &info), a.index1 == 1 && a.generation == 1 ? CLQ_OK : CLQ_STALE_ID);
    clq_dof_write(nullptr, 0, NAN, 1);
}

}  // namespace fuzz

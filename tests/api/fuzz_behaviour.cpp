// Random calls about behaviour: valid and invalid definitions, attachments, commands, root paths and the ground.
#include <cmath>

#include "tests/api/fuzz_world.h"

namespace fuzz
{

clq_dof_pose World::any_shape()
{
    const uint32_t count = random_.below(3);
    if (used_values_ + count > sizeof values_ / sizeof *values_) return {0, nullptr};
    clq_dof_value *first = values_ + used_values_;
    for (uint32_t i = 0; i < count; ++i)
        values_[used_values_++] = {random_.one_in(30) ? random_.index(3, 1) : (i + 2) % 3, random_.oddf(0, 0.2, 60)};
    return {count, first};
}

void World::add_mechanism()
{
    if (known_.mechanisms > 30) return;
    used_values_ = 0;
    const uint32_t kind = random_.index(6, 40);
    clq_mechanism_def def = test_world_.mechanism(kind < 6 ? kind : 0);
    def.kind = static_cast<clq_mechanism_kind>(kind);
    def.tmpl = random_.one_in(40) ? nullptr : templates_[random_.one_in(3) ? random_.below(4) : 2 * random_.below(2)];
    if (random_.one_in(3)) def.level_m[0] = random_.oddf(0, 20, 10), def.level_m[1] = random_.oddf(20, 40, 10);
    if (random_.one_in(3) && kind != CLQ_MECHANISM_HOST) def.off_m = random_.oddf(0, 100, 10);
    uint32_t *turns[] = {def.gaze.eye_yaw,   def.gaze.eye_yaw + 1, def.gaze.eye_pitch,  def.gaze.eye_pitch + 1,
                         &def.gaze.neck_yaw, &def.gaze.neck_pitch, &def.gaze.spine_yaw, &def.gaze.spine_pitch};
    for (uint32_t *turn : turns)
        if (random_.one_in(4)) *turn = random_.one_in(12) ? random_.index(3, 1) : random_.below(2);
    def.gaze.wander_s = random_.oddf(0, 3), def.gaze.turn_s = random_.oddf(0, 1),
    def.gaze.neck_share = random_.oddf(0, 1);
    const clq_dof_pose shapes[3] = {any_shape(), any_shape(), any_shape()};
    if (random_.one_in(2)) {
        def.expression.pose_count = def.phrase.pose_count = random_.below(4);
        def.expression.poses = def.phrase.poses = shapes;
        def.blink.closed = shapes[0];
    }
    def.expression.hold_s = random_.oddf(0.1, 4), def.expression.blend_s = random_.oddf(0, 0.05);
    def.blink.period_s = random_.oddf(1, 4), def.blink.close_s = random_.oddf(0.1, 0.5);
    const clq_phrase_key keys[3] = {{random_.oddf(0, 0, 30), random_.index(2)},
                                    {random_.oddf(0.1, 0.5), random_.index(2)},
                                    {random_.oddf(0.5, 1), CLQ_NONE}};
    def.phrase.key_count = random_.below(4), def.phrase.keys = keys, def.phrase.length_s = random_.oddf(1, 2);
    def.phrase.pause_s = random_.oddf(-1, 2), def.phrase.blend_s = random_.oddf(0, 0.5);
    const uint32_t clips[2] = {random_.index(1), random_.index(1)};
    def.idle.clip_count = random_.below(3), def.idle.clips = clips, def.idle.slot_s = random_.oddf(0.1, 3);
    def.host.has_memory = random_.one_in(2);
    if (random_.one_in(60)) def.host.run = nullptr;
    clq_mechanism made;
    if (!call("clq_crowd_add_mechanism", [&] { return clq_crowd_add_mechanism(crowd_, &def, &made); })) return;
    EXPECT_EQ(made.index1, ++known_.mechanisms);
}

void World::add_path()
{
    if (known_.paths > 15) return;
    float positions[15], rotations[20], times[5];
    const uint32_t count = random_.one_in(20) ? random_.below(2) : 2 + random_.below(4);
    for (float &x : positions) x = random_.oddf(-4, 4, 150);
    for (uint32_t i = 0; i < 5; ++i) {
        const double half = random_.in(-2, 2);
        times[i] = static_cast<float>(i) * 0.3f + random_.oddf(0, 0, 60);
        rotations[4 * i] = rotations[4 * i + 2] = random_.oddf(0, 0, 60);
        rotations[4 * i + 1] = static_cast<float>(std::sin(half)),
                          rotations[4 * i + 3] = static_cast<float>(std::cos(half));
    }
    clq_root_path_def def = clq_root_path_def_init();
    def.count = count, def.positions = positions;
    if (random_.one_in(2)) def.rotations_xyzw = rotations, def.times_s = times;
    if (random_.one_in(30)) def.times_s = nullptr;
    def.duration_s = random_.oddf(1.5, 6), def.bank = random_.oddf(-1, 1), def.max_bank_rad = random_.oddf(0, 2);
    clq_root_path made;
    if (call("clq_crowd_add_root_path", [&] { return clq_crowd_add_root_path(crowd_, &def, &made); })) {
        EXPECT_EQ(made.index1, ++known_.paths);
    }
}

void World::attach_mechanism()
{
    const clq_actor id = person();
    const clq_mechanism_attachment attach_mechanism = {any_mechanism(), random_.oddf(-1, 1), random_.oddf(-3, 3),
                                                       random_.odd(-9, 9)};
    call("clq_actor_attach_mechanism", [&] { return clq_actor_attach_mechanism(crowd_, id, &attach_mechanism); });
}

void World::detach_mechanism()
{
    const clq_actor id = person();
    const clq_mechanism mechanism = any_mechanism();
    call("clq_actor_detach_mechanism", [&] { return clq_actor_detach_mechanism(crowd_, id, mechanism); });
}

void World::command()
{
    const clq_actor id = person();
    const clq_mechanism mechanism = any_mechanism();
    const double at_s = random_.odd(-5, 30);
    const double point[3] = {random_.odd(-9, 9), random_.odd(-9, 9), random_.odd(-9, 9)};
    const bool free = random_.one_in(4);
    // One definition of each of three kinds: the one of the mechanism's kind is accepted, the others are refused.
    call("clq_actor_gaze", [&] { return clq_actor_gaze(crowd_, id, mechanism, free ? nullptr : point, at_s); });
    const uint32_t shape = free ? CLQ_NONE : random_.index(2);
    call("clq_actor_express", [&] { return clq_actor_express(crowd_, id, mechanism, shape, at_s); });
    call("clq_actor_say", [&] { return clq_actor_say(crowd_, id, mechanism, at_s); });
}

void World::ground()
{
    const auto hill = [](void *, const double p[3]) { return p[0] > 15 ? NAN : p[0] < -15 ? HUGE_VAL : 0.1 * p[2]; };
    const bool none = random_.one_in(3);
    if (random_.one_in(4))
        call("clq_crowd_set_ground", [&] { return clq_crowd_set_ground(crowd_, none ? nullptr : +hill, nullptr); });
    const clq_actor id = person();
    const float up = none ? 0 : random_.oddf(0, 2), down = none ? 0 : random_.oddf(0, 2);
    call("clq_actor_follow_ground", [&] { return clq_actor_follow_ground(crowd_, id, up, down); });
}

void World::move_root()
{
    const clq_actor id = person();
    const clq_root_path_play motion = {
        {random_.index(known_.paths + 1)}, random_.oddf(-2, 2), random_.oddf(-2, 2), random_.odd(-9, 9)};
    call("clq_actor_play_root_path", [&] { return clq_actor_play_root_path(crowd_, id, &motion); });
}

}  // namespace fuzz

#include "tests/api/record_fixture.h"

namespace records
{

namespace
{

double slope(void *, const double point[3]) { return 0.05 * point[2]; }

void note(Shown &out, clq_crowd *crowd, clq_view *view, double time_s)
{
    ASSERT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
    out.times.push_back(time_s);
    out.lists.push_back(clq_view_get_hash(view));
    out.crowds.push_back(clq_crowd_get_hash(crowd));
}

// Of the clock, which jumps now and then.
double time_of(uint32_t step) { return 0.05 * step + (step % 37 > 30 ? 5 : 0); }

}  // namespace

Recording run(TestWorld &world, uint32_t steps, uint64_t seed, uint64_t key_bytes)
{
    Recording out;
    clq_crowd *crowd = world.new_crowd();
    world.set_up(crowd);
    std::vector<clq_actor> actors = world.fill(crowd, 10, seed), then = actors;
    clq_view *view = world.new_view(crowd, 0);
    EXPECT_EQ(clq_crowd_set_ground(crowd, slope, nullptr), CLQ_OK);
    const clq_recording_def def = recording_to(out.bytes, key_bytes);
    EXPECT_EQ(clq_crowd_begin_recording(crowd, &def), CLQ_OK) << clq_last_error();
    for (clq_actor actor : world.fill(crowd, 5, seed + 1)) actors.push_back(actor);
    Bytes state;
    for (uint32_t step = 0; step < steps; ++step) {
        for (uint32_t k = 0; k < step % 4; ++k) world.happen(crowd, actors, seed, 4 * step + k);
        if (step == steps / 3) state = saved::save(crowd), then = actors;
        if (step == steps / 2) {
            EXPECT_EQ(clq_crowd_restore(crowd, state.data(), state.size(), world.templates, 2), CLQ_OK)
                << clq_last_error();
            actors = then;
        }
        note(out.shown, crowd, view, time_of(step));
    }
    world.happen(crowd, actors, seed, 4 * steps);
    out.last_hash = clq_crowd_get_hash(crowd);
    EXPECT_EQ(clq_crowd_end_recording(crowd, &out.info), CLQ_OK) << clq_last_error();
    return out;
}

Player::Player(TestWorld &world, const Bytes &bytes, Opening opening) : world_(world)
{
    if (opening(world.context, bytes.data(), bytes.size(), &record) != CLQ_OK) return;
    EXPECT_EQ(clq_record_set_templates(record, world.templates, 2), CLQ_OK) << clq_last_error();
    const clq_host_mechanism_def lent = {world.mechanism(TestWorld::host).host.run, nullptr, false};
    EXPECT_EQ(clq_record_lend_mechanism(record, {TestWorld::host + 1}, &lent), CLQ_OK) << clq_last_error();
    clq_crowd_def def = clq_crowd_def_init();
    EXPECT_EQ(clq_record_get_crowd_def(record, &def), CLQ_OK);
    EXPECT_EQ(clq_crowd_create(world.context, &def, &crowd), CLQ_OK) << clq_last_error();
    view = world.new_view(crowd, 0);
    EXPECT_EQ(clq_crowd_set_ground(crowd, slope, nullptr), CLQ_OK);
}

Player::~Player()
{
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK) << clq_last_error();
    clq_record_destroy(record);
}

clq_record_info Player::info() const
{
    clq_record_info out = clq_record_info_init();
    EXPECT_EQ(clq_record_get_info(record, &out), CLQ_OK) << clq_last_error();
    return out;
}

void Player::show(uint64_t step, Shown &out)
{
    double time_s = 0;
    ASSERT_EQ(clq_record_play_step(record, crowd, step), CLQ_OK) << "step " << step << ": " << clq_last_error();
    ASSERT_EQ(clq_record_get_time(record, step, &time_s), CLQ_OK);
    note(out, crowd, view, time_s);
}

}  // namespace records

#include "tests/soak/people.h"

#include <cmath>

#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"

namespace soak
{
namespace
{

constexpr size_t fewest = 40, most = 60, most_groups = 6, most_attachments = 12, most_views = 3;

double share(uint64_t bits, int shift) { return static_cast<double>(bits >> shift & 1023) / 1023; }

clq_transform place_of(uint64_t bits)
{
    clq_transform place = clq_transform_init();
    place.position[0] = 20 * share(bits, 8) - 10, place.position[2] = -30 * share(bits, 18) - 1;
    const double half_turn = 3 * share(bits, 28);
    place.orientation_xyzw[1] = static_cast<float>(std::sin(half_turn));
    place.orientation_xyzw[3] = static_cast<float>(std::cos(half_turn));
    return place;
}

clq_camera camera_of(uint64_t bits)
{
    clq_camera camera;
    const double eye[3] = {10 * share(bits, 0) - 5, 1 + 2 * share(bits, 10), 4 * share(bits, 20)};
    const double target[3] = {10 * share(bits, 30) - 5, 1, -10};
    const float up[3] = {0, 1, 0};
    EXPECT_EQ(api_test::look_at(&camera, eye, target, up, 0.9f, 1, 0.1f, 200), CLQ_OK);
    return camera;
}

template <class T>
T take(std::vector<T> &from, uint64_t lot)
{
    const size_t which = lot % from.size();
    const T taken = from[which];
    from[which] = from.back();
    from.pop_back();
    return taken;
}

}  // namespace

People::People(TestWorld &world, uint64_t seed) : world_(world), seed_(seed)
{
    build();
    world_.set_up(crowd);
    for (uint64_t i = 0; i < 50; ++i) come_or_go(mixed(seed, i) & ~uint64_t(1));
    known.cameras = {mixed(seed, 1)};
    follow_cameras();
}

People::People(TestWorld &world, const People &others, const std::vector<uint8_t> &saved)
    : known(others.known), world_(world), seed_(others.seed_)
{
    build();
    // The host's own mechanism is lent by a crowd that has it; those of a saved crowd name templates.
    world_.set_up(crowd);
    EXPECT_EQ(clq_crowd_restore(crowd, saved.data(), saved.size(), templates, 2), CLQ_OK) << clq_last_error();
    follow_cameras();
}

People::~People()
{
    EXPECT_EQ(clq_crowd_destroy(crowd), CLQ_OK) << clq_last_error();
    for (clq_template *tmpl : templates) clq_template_destroy(tmpl);
}

void People::build()
{
    EXPECT_EQ(clq_template_build(world_.context, &world_.with_dofs.def, &templates[0]), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_template_build(world_.context, &world_.plain.def, &templates[1]), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_crowd_create(world_.context, nullptr, &crowd), CLQ_OK) << clq_last_error();
    for (int k = 0; k < 2; ++k) world_.templates[k] = templates[k];  // what its set_up() uses
}

void People::follow_cameras()
{
    while (views.size() > known.cameras.size()) {
        EXPECT_EQ(clq_view_destroy(views.back()), CLQ_OK) << clq_last_error();
        views.pop_back();
    }
    while (views.size() < known.cameras.size()) {
        clq_view *view = nullptr;
        EXPECT_EQ(clq_view_create(crowd, &view), CLQ_OK) << clq_last_error();
        views.push_back(view);
    }
    for (size_t i = 0; i < views.size(); ++i) {
        const clq_camera camera = camera_of(known.cameras[i]);
        EXPECT_EQ(clq_view_set_camera(views[i], &camera), CLQ_OK) << clq_last_error();
    }
}

// A call may be refused (an id that is stale by now, no free row): for the same reason in each run.
void People::note(clq_status status)
{
    ++known.commands;
    known.refused += status != CLQ_OK;
    EXPECT_TRUE(status != CLQ_OUT_OF_MEMORY && status != CLQ_BUSY) << clq_last_error();
}

void People::come_or_go(uint64_t bits)
{
    const bool comes = known.actors.size() < fewest || (known.actors.size() < most && bits % 2 == 0);
    if (!comes) {
        note(clq_actor_destroy(crowd, take(known.actors, bits >> 20)));
        return;
    }
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = templates[bits >> 50 & 1];
    def.transform = place_of(bits);
    def.play.clip = 0, def.play.phase_s = static_cast<float>(share(bits, 40));
    def.seed = bits;
    clq_actor made = {0, 0};
    note(clq_actor_create(crowd, &def, &made));
    known.actors.push_back(made);
    note(clq_actor_randomise_colours(crowd, made, nullptr, 0));
}

void People::group(uint64_t bits)
{
    const clq_transform place = place_of(bits >> 3);
    if (known.groups.size() < 2 || (known.groups.size() < most_groups && bits % 3 == 0)) {
        clq_group made = {0, 0};
        note(clq_group_create(crowd, &place, &made));
        known.groups.push_back(made);
        return;
    }
    const clq_group one = known.groups[(bits >> 8) % known.groups.size()];
    const clq_actor person = known.actors[(bits >> 16) % known.actors.size()];
    switch (bits / 3 % 4) {
        case 0:
            for (const clq_actor actor : known.actors) {  // a group that has members stays
                clq_actor_info info = clq_actor_info_init();
                if (clq_actor_get_info(crowd, actor, &info) == CLQ_OK && info.group.index1 == one.index1)
                    note(clq_actor_join(crowd, actor, {0, 0}, &place));
            }
            note(clq_group_destroy(crowd, one));
            for (size_t i = 0; i < known.groups.size(); ++i)
                if (known.groups[i].index1 == one.index1) known.groups.erase(known.groups.begin() + long(i--));
            break;
        case 1:
            note(clq_group_set_transform(crowd, one, &place));
            break;
        case 2:
            note(clq_group_set_enabled(crowd, one, bits >> 40 & 1));
            break;
        default:
            note(clq_actor_join(crowd, person, one, &place));
    }
}

void People::play(uint64_t bits, double time_s)
{
    const clq_actor person = known.actors[(bits >> 16) % known.actors.size()];
    const clq_play clip = {0, time_s, 0.5f + static_cast<float>(share(bits, 30)), 0};
    clq_fade_def fade = clq_fade_def_init();
    fade.play = clip;
    clq_layer_def layer = clq_layer_def_init();
    layer.play = clip, layer.loops = 3, layer.kind = bits & 1 ? CLQ_LAYER_ADD : CLQ_LAYER_REPLACE;
    switch (bits % 5) {
        case 0:
            note(clq_actor_play(crowd, person, &clip));
            break;
        case 1:
            note(api_test::fade_to(crowd, person, fade, time_s, 0.6f, CLQ_CURVE_INERTIAL));
            break;
        case 2:
            note(clq_actor_add_layer(crowd, person, &layer, nullptr));
            break;
        case 3:
            note(clq_actor_set_watched(crowd, person, bits >> 40 & 1));
            break;
        default:
            fade.gait = {1}, fade.share = static_cast<float>(share(bits, 40));
            note(api_test::fade_to(crowd, person, fade, time_s, 1, CLQ_CURVE_SMOOTH));
    }
}

void People::behave(uint64_t bits, double time_s)
{
    const clq_actor person = known.actors[(bits >> 16) % known.actors.size()];
    const uint32_t kind = static_cast<uint32_t>(bits >> 40) % 6 + 1;
    const clq_mechanism_attachment attachment = {{kind}, 0.5f, static_cast<float>(share(bits, 30)), time_s};
    const clq_root_path_play path = {{static_cast<uint32_t>(bits >> 50) % 3}, 1, 0, time_s};
    const double point[3] = {10 * share(bits, 20), 1, -5};
    switch (bits % 6) {
        case 0:
            note(clq_actor_attach_mechanism(crowd, person, &attachment));
            break;
        case 1:
            note(clq_actor_detach_mechanism(crowd, person, {kind}));
            break;
        case 2:
            note(clq_actor_gaze(crowd, person, {TestWorld::gaze + 1}, bits & 64 ? point : nullptr, time_s));
            break;
        case 3:
            note(clq_actor_express(crowd, person, {TestWorld::expression + 1}, bits >> 6 & 1, time_s));
            break;
        case 4:
            note(clq_actor_say(crowd, person, {TestWorld::phrase + 1}, time_s));
            break;
        default:
            note(clq_actor_play_root_path(crowd, person, &path));
    }
}

void People::change(uint64_t bits)
{
    clq_actor &person = known.actors[(bits >> 16) % known.actors.size()];
    const clq_transform place = place_of(bits >> 5);
    const float centre[3] = {0, 0.3f, 0};
    clq_attachment attached = {0, 0};
    clq_actor twin = {0, 0};
    switch (bits % 6) {
        case 0:
            note(clq_crowd_set_transforms(crowd, &person, &place, 1));
            break;
        case 1:
            note(clq_actor_set_priority(crowd, person, static_cast<float>(share(bits, 30))));
            break;
        case 2:
            note(clq_actor_follow_ground(crowd, person, 1, 0.5f));
            break;
        case 3:
            if (known.attachments.size() >= most_attachments)
                note(clq_actor_detach(crowd, take(known.attachments, bits)));
            note(api_test::attach(crowd, person, 1, centre, static_cast<float>(share(bits, 30)), &attached));
            known.attachments.push_back(attached);
            break;
        case 4:
            note(clq_actor_clone(crowd, person, &place, bits, &twin));
            note(clq_actor_destroy(crowd, person));
            person = twin;
            break;
        default:
            if (known.cameras.size() > 1 && bits >> 30 & 1) known.cameras.pop_back();
            else if (known.cameras.size() < most_views && bits >> 31 & 1) known.cameras.push_back(bits);
            else known.cameras[0] = bits;
            follow_cameras();
    }
}

void People::happen(uint64_t step)
{
    const uint64_t bits = mixed(seed_ ^ 0x50a8, step), more = mixed(bits, step);
    const double time_s = step_s * static_cast<double>(step);
    switch (bits % 5) {
        case 0:
            return come_or_go(more);
        case 1:
            return group(more);
        case 2:
            return play(more, time_s);
        case 3:
            return behave(more, time_s);
        default:
            return change(more);
    }
}

void People::update(uint64_t step)
{
    EXPECT_EQ(
        clq_crowd_update(crowd, step_s * static_cast<double>(step), views.data(), static_cast<uint32_t>(views.size())),
        CLQ_OK)
        << clq_last_error();
}

uint64_t People::hash() const
{
    uint64_t all = clq_crowd_get_hash(crowd);
    for (const clq_view *view : views) all = mixed(all, clq_view_get_hash(view));
    return all;
}

std::vector<uint8_t> People::save() const { return saved::save(crowd); }

}  // namespace soak

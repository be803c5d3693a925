// A crowd for the calls of busy_calls.h.
#include "tests/api/busy_calls.h"
#include "tests/api/calls.h"
#include "tests/api/stub_gl.h"

namespace busy
{

namespace
{

clq_colour_map *new_map(clq_context *context)
{
    const clq_palette_entry entry = clq_palette_entry_init();
    clq_zone_colours zones[2] = {};
    zones[0].zone = "cloth", zones[1].zone = "skin";
    for (clq_zone_colours &zone : zones) zone.palette_count = 1, zone.palette = &entry;
    clq_colour_class one = {};
    one.name = "one", one.zone_count = 2, one.zones = zones;
    clq_colour_map_def def = clq_colour_map_def_init();
    def.class_count = 1, def.classes = &one;
    clq_colour_map *map = nullptr;
    EXPECT_EQ(clq_colour_map_create(context, &def, &map), CLQ_OK) << clq_last_error();
    return map;
}

}  // namespace

void Busy::SetUp()
{
    objects_.world = &world_;
    objects_.crowd = world_.new_crowd();
    world_.set_up(objects_.crowd);
    actors_ = world_.fill(objects_.crowd, 40, 5);
    objects_.actor = add_actor();
    ASSERT_EQ(clq_group_create(objects_.crowd, nullptr, &objects_.group), CLQ_OK);
    const float centre[3] = {0, 0, 0};
    ASSERT_EQ(api_test::attach(objects_.crowd, objects_.actor, 0, centre, 1, &objects_.attachment), CLQ_OK);
    objects_.view = world_.new_view(objects_.crowd, 0);
    objects_.scene = new_scene(objects_.crowd, objects_.actor);
    clq_recording_def recording = clq_recording_def_init();
    recording.write = [](void *, const void *, size_t) { return 0; };
    ASSERT_EQ(clq_crowd_begin_recording(objects_.crowd, &recording), CLQ_OK) << clq_last_error();
    objects_.map = new_map(world_.context);
    objects_.renderer = stub_gl::new_renderer(world_);
    ASSERT_EQ(clq_crowd_update(objects_.crowd, 1, &objects_.view, 1), CLQ_OK) << clq_last_error();
}

void Busy::TearDown()
{
    EXPECT_EQ(clq_renderer_destroy(objects_.renderer), CLQ_OK) << clq_last_error();
    clq_colour_map_destroy(objects_.map);
}

// In the middle of the picture, with the mechanisms that the calls name.
clq_actor Busy::add_actor()
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = world_.templates[0];
    def.transform.position[2] = -2;
    def.play.clip = 0;
    clq_actor made = {0, 0};
    EXPECT_EQ(clq_actor_create(objects_.crowd, &def, &made), CLQ_OK) << clq_last_error();
    for (uint32_t kind = 1; kind <= 4; ++kind) {
        const clq_mechanism_attachment attachment = {{kind}, 0, 0, 0};
        EXPECT_EQ(clq_actor_attach_mechanism(objects_.crowd, made, &attachment), CLQ_OK) << clq_last_error();
    }
    EXPECT_EQ(clq_actor_follow_ground(objects_.crowd, made, 1, 1), CLQ_OK);
    return made;
}

}  // namespace busy

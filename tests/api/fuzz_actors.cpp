// Random calls that create and destroy actors, attached objects and groups.
#include <algorithm>

#include "tests/api/calls.h"
#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::create()
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = random_.one_in(40) ? nullptr : templates_[random_.below(4)];
    def.transform = any_place();
    def.play = {random_.one_in(3) ? CLQ_NONE : random_.index(1), random_.odd(-9, 9), random_.oddf(-2, 2),
                random_.oddf(0, 1)};
    def.seed = random_.number();
    if (random_.one_in(50)) def.struct_bytes = random_.index(200, 3);
    if (known_.actors.size() > 45) return;
    clq_actor made = {77, 78};
    if (call("clq_actor_create", [&] { return clq_actor_create(crowd_, &def, &made); }))
        known_.actors.push_back({made, {0, 0}, def.tmpl});
    else EXPECT_EQ(made.index1, 77u) << "written only on CLQ_OK";
}

void World::destroy()
{
    const clq_actor id = person();
    if (!call("clq_actor_destroy", [&] { return clq_actor_destroy(crowd_, id); })) return;
    const auto is = [&](const Known::Actor &a) { return a.id.index1 == id.index1 && a.id.generation == id.generation; };
    known_.actors.erase(std::find_if(known_.actors.begin(), known_.actors.end(), is));
    known_.gone.push_back(id);
}

void World::clone()
{
    const clq_actor id = person();
    const clq_transform place = any_place();
    const clq_transform *wanted = random_.one_in(3) ? nullptr : &place;
    if (known_.actors.size() > 45) return;
    clq_actor made = {77, 78};
    if (!call("clq_actor_clone", [&] { return clq_actor_clone(crowd_, id, wanted, random_.number(), &made); })) return;
    for (const Known::Actor &a : known_.actors)
        if (a.id.index1 == id.index1) {
            known_.actors.push_back({made, a.group, a.tmpl});
            return;
        }
}

void World::place()
{
    clq_actor ids[5];
    clq_transform places[5];
    const uint32_t count = random_.below(6);
    for (uint32_t i = 0; i < count; ++i) ids[i] = person(), places[i] = any_place();
    call("clq_crowd_set_transforms", [&] { return clq_crowd_set_transforms(crowd_, ids, places, count); });
    float speeds[5];
    for (float &speed : speeds) speed = random_.oddf(0, 4);
    call("clq_crowd_set_speeds", [&] { return clq_crowd_set_speeds(crowd_, ids, speeds, count); });
}

void World::play()
{
    const clq_play play = {random_.one_in(3) ? CLQ_NONE : random_.index(1), random_.odd(-9, 9), random_.oddf(-2, 2),
                           random_.oddf(0, 1)};
    const clq_actor id = person();
    call("clq_actor_play", [&] { return clq_actor_play(crowd_, id, &play); });
}

void World::colours()
{
    float rgb[9];
    for (float &x : rgb) x = random_.oddf(0, 1, 60);
    clq_hsb_range ranges[3];
    for (clq_hsb_range &range : ranges)
        range = {random_.oddf(0, 360, 60), random_.oddf(0, 360, 60), random_.oddf(0, 1, 60),
                 random_.oddf(0, 1, 60),   random_.oddf(0, 1, 60),   random_.oddf(0, 1, 60)};
    const clq_actor id = person();
    const uint32_t zones = random_.one_in(8) ? random_.below(4) : 2;
    if (random_.one_in(2)) call("clq_actor_set_colours", [&] { return clq_actor_set_colours(crowd_, id, rgb, zones); });
    else
        call("clq_actor_randomise_colours",
             [&] { return clq_actor_randomise_colours(crowd_, id, zones ? ranges : nullptr, zones); });
}

void World::priority()
{
    const clq_actor id = person();
    const float priority = random_.oddf(0, 1, 8);
    call("clq_actor_set_priority", [&] { return clq_actor_set_priority(crowd_, id, priority); });
}

void World::attach()
{
    const clq_actor id = person();
    const float centre[3] = {random_.oddf(-1, 1), random_.oddf(-1, 1), random_.oddf(-1, 1)};
    clq_attachment made = {77, 78};
    const bool wants = !random_.one_in(5);
    if (call("clq_actor_attach",
             [&] {
                 return api_test::attach(crowd_, id, random_.index(2), centre, random_.oddf(0, 2),
                                         wants ? &made : nullptr);
             }) &&
        wants)
        known_.objects.push_back(made);
}

void World::detach()
{
    clq_attachment id = {random_.index(20), random_.index(4)};
    if (!known_.objects.empty() && !random_.one_in(8))
        id = known_.objects[random_.below(static_cast<uint32_t>(known_.objects.size()))];
    if (call("clq_actor_detach", [&] { return clq_actor_detach(crowd_, id); })) {
        EXPECT_EQ(clq_actor_detach(crowd_, id), CLQ_STALE_ID) << "seed " << seed_ << ", step " << step_;
    }
}

void World::hooks()
{
    const clq_actor_hooks hooks = {[](void *, clq_actor) { return false; }, [](void *, clq_actor) {}, this};
    const clq_actor id = person();
    const bool none = random_.one_in(3);
    call("clq_actor_set_hooks", [&] { return clq_actor_set_hooks(crowd_, id, none ? nullptr : &hooks); });
}

void World::new_group()
{
    if (known_.groups.size() > 6) return;
    const clq_transform place = any_place();
    const bool anywhere = random_.one_in(4);
    clq_group made;
    if (call("clq_group_create", [&] { return clq_group_create(crowd_, anywhere ? nullptr : &place, &made); }))
        known_.groups.push_back(made);
}

void World::end_group()
{
    const clq_group group = any_group();
    if (!call("clq_group_destroy", [&] { return clq_group_destroy(crowd_, group); })) return;
    leave(group);
    known_.gone_groups.push_back(group);
    const auto is = [&](const clq_group &g) { return g.index1 == group.index1 && g.generation == group.generation; };
    known_.groups.erase(std::find_if(known_.groups.begin(), known_.groups.end(), is));
}

void World::move_group()
{
    const clq_group group = any_group();
    const clq_transform place = any_place();
    if (random_.one_in(3))
        call("clq_group_set_enabled", [&] { return clq_group_set_enabled(crowd_, group, !random_.one_in(3)); });
    else call("clq_group_set_transform", [&] { return clq_group_set_transform(crowd_, group, &place); });
    const float speed = random_.oddf(0, 4);
    call("clq_group_set_speed", [&] { return clq_group_set_speed(crowd_, group, speed); });
}

void World::join()
{
    const clq_actor id = person();
    const clq_group group = random_.one_in(4) ? clq_group{0, 0} : any_group();
    const clq_transform place = any_place();
    const bool stays = random_.one_in(2);
    if (!call("clq_actor_join", [&] { return clq_actor_join(crowd_, id, group, stays ? nullptr : &place); })) return;
    for (Known::Actor &actor : known_.actors)
        if (actor.id.index1 == id.index1) actor.group = group;
}

}  // namespace fuzz

// Random calls about who is there: actors, what they hold, groups.
#include <algorithm>

#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::create()
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = lots_.one_in(40) ? nullptr : templates_[lots_.below(4)];
    def.place = any_place();
    def.play = {lots_.one_in(3) ? CLQ_NONE : lots_.index(1), lots_.odd(-9, 9), lots_.oddf(-2, 2), lots_.oddf(0, 1)};
    def.seed = lots_.number();
    if (lots_.one_in(50)) def.struct_bytes = lots_.index(200, 3);
    if (known_.actors.size() > 45) return;
    clq_actor made = {77, 78};
    if (call("clq_actor_create", [&] { return clq_actor_create(crowd_, &def, &made); }))
        known_.actors.push_back({made, {0, 0}, def.tmpl});
    else EXPECT_EQ(made.index1, 77u) << "written only on CLQ_OK";
}

void World::destroy()
{
    const clq_actor id = who();
    if (!call("clq_actor_destroy", [&] { return clq_actor_destroy(crowd_, id); })) return;
    const auto is = [&](const Known::Actor &a) { return a.id.index1 == id.index1 && a.id.generation == id.generation; };
    known_.actors.erase(std::find_if(known_.actors.begin(), known_.actors.end(), is));
    known_.gone.push_back(id);
}

void World::clone()
{
    const clq_actor id = who();
    const clq_place place = any_place();
    const clq_place *wanted = lots_.one_in(3) ? nullptr : &place;
    if (known_.actors.size() > 45) return;
    clq_actor made = {77, 78};
    if (!call("clq_actor_clone", [&] { return clq_actor_clone(crowd_, id, wanted, lots_.number(), &made); })) return;
    for (const Known::Actor &a : known_.actors)
        if (a.id.index1 == id.index1) {
            known_.actors.push_back({made, a.group, a.tmpl});
            return;
        }
}

void World::place()
{
    clq_actor ids[5];
    clq_place places[5];
    const uint32_t count = lots_.below(6);
    for (uint32_t i = 0; i < count; ++i) ids[i] = who(), places[i] = any_place();
    call("clq_crowd_place", [&] { return clq_crowd_place(crowd_, ids, places, count); });
}

void World::play()
{
    const clq_play play = {lots_.one_in(3) ? CLQ_NONE : lots_.index(1), lots_.odd(-9, 9), lots_.oddf(-2, 2),
                           lots_.oddf(0, 1)};
    const clq_actor id = who();
    call("clq_actor_play", [&] { return clq_actor_play(crowd_, id, &play); });
}

void World::colours()
{
    float rgb[9];
    for (float &x : rgb) x = lots_.oddf(0, 1, 60);
    clq_hsb_range ranges[3];
    for (clq_hsb_range &range : ranges)
        range = {lots_.oddf(0, 360, 60), lots_.oddf(0, 360, 60), lots_.oddf(0, 1, 60),
                 lots_.oddf(0, 1, 60),   lots_.oddf(0, 1, 60),   lots_.oddf(0, 1, 60)};
    const clq_actor id = who();
    const uint32_t zones = lots_.one_in(8) ? lots_.below(4) : 2;
    if (lots_.one_in(2)) call("clq_actor_set_colours", [&] { return clq_actor_set_colours(crowd_, id, rgb, zones); });
    else
        call("clq_actor_draw_colours",
             [&] { return clq_actor_draw_colours(crowd_, id, zones ? ranges : nullptr, zones); });
}

void World::priority()
{
    const clq_actor id = who();
    const float priority = lots_.oddf(0, 1, 8);
    call("clq_actor_set_priority", [&] { return clq_actor_set_priority(crowd_, id, priority); });
}

void World::attach()
{
    const clq_actor id = who();
    const float centre[3] = {lots_.oddf(-1, 1), lots_.oddf(-1, 1), lots_.oddf(-1, 1)};
    clq_attached made = {77, 78};
    const bool wants = !lots_.one_in(5);
    if (call("clq_actor_attach",
             [&] {
                 return clq_actor_attach(crowd_, id, lots_.index(2), centre, lots_.oddf(0, 2), wants ? &made : nullptr);
             }) &&
        wants)
        known_.objects.push_back(made);
}

void World::detach()
{
    clq_attached id = {lots_.index(20), lots_.index(4)};
    if (!known_.objects.empty() && !lots_.one_in(8))
        id = known_.objects[lots_.below(static_cast<uint32_t>(known_.objects.size()))];
    if (call("clq_actor_detach", [&] { return clq_actor_detach(crowd_, id); })) {
        EXPECT_EQ(clq_actor_detach(crowd_, id), CLQ_STALE_ID) << "seed " << seed_ << ", step " << step_;
    }
}

void World::hooks()
{
    const clq_actor_hooks hooks = {[](void *, clq_actor) { return 0; }, [](void *, clq_actor) {}, this};
    const clq_actor id = who();
    const bool none = lots_.one_in(3);
    call("clq_actor_set_hooks", [&] { return clq_actor_set_hooks(crowd_, id, none ? nullptr : &hooks); });
}

void World::new_group()
{
    if (known_.groups.size() > 6) return;
    const clq_place place = any_place();
    const bool anywhere = lots_.one_in(4);
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
    const clq_place place = any_place();
    if (lots_.one_in(3)) call("clq_group_enable", [&] { return clq_group_enable(crowd_, group, !lots_.one_in(3)); });
    else call("clq_group_place", [&] { return clq_group_place(crowd_, group, &place); });
}

void World::join()
{
    const clq_actor id = who();
    const clq_group group = lots_.one_in(4) ? clq_group{0, 0} : any_group();
    const clq_place place = any_place();
    const bool stays = lots_.one_in(2);
    if (!call("clq_actor_join", [&] { return clq_actor_join(crowd_, id, group, stays ? nullptr : &place); })) return;
    for (Known::Actor &actor : known_.actors)
        if (actor.id.index1 == id.index1) actor.group = group;
}

}  // namespace fuzz

#include "tests/staged/staged_world.h"

#include "tests/unit/stage/held_tasks.h"

namespace staged_test
{

using namespace scenes;

Scenario evacuation(uint32_t citizens, uint32_t workers)
{
    Scenario scenario = load_scenario(std::string(CLAQUE_SOURCE_DIR) + "/samples/scenarios/evacuation.toml");
    scenario.stage->agents.at(0).count = citizens;
    scenario.stage->agents.at(1).count = workers;
    return scenario;
}

Own<clq_view> view_of(clq_crowd *crowd, const Scene &scene)
{
    clq_view *made = nullptr;
    check(clq_view_create(crowd, &made));
    const clq_camera camera = scene.camera(Shot::overview, 1.5, 0);
    check(clq_view_set_camera(made, &camera));
    return Own<clq_view>(made);
}

uint64_t shown(clq_crowd *crowd, clq_view *view, double time_s)
{
    check(clq_crowd_update(crowd, time_s, &view, 1));
    return clq_view_get_hash(view);
}

World::World(const Scenario &scenario, int threads, bool flows_apart, uint64_t seed)
    : library(threads), apart(flows_apart)
{
    CrowdOptions options;
    options.seed = seed;
    staged::StageOptions stage;
    stage.apart = apart;
    scene = staged::make_staged(library, options, scenario, stage);
    view = view_of(scene->crowd(), *scene);
}

World::~World()
{
    if (!apart) expect_no_lost_task(run().handle());
}

uint64_t World::show(double time_s)
{
    scene->place(time_s);
    return shown(scene->crowd(), view.get(), time_s);
}

}  // namespace staged_test

// Runs of scenarios whose people decide, without pictures.
#pragma once

#include <gtest/gtest.h>

#include "samples/stage/staged_scene.h"

namespace staged_test
{

// samples/scenarios/evacuation.toml with fewer people.
scenes::Scenario evacuation(uint32_t citizens, uint32_t workers);

struct World {
    World(const scenes::Scenario &scenario, int threads, bool apart, uint64_t seed = 1);
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    // Shows a frame; returns the hash of its draw list, as a camera above sees it.
    uint64_t show(double time_s);
    staged::Run &run() { return scene->run(); }

    scenes::Library library;
    std::unique_ptr<staged::StagedScene> scene;
    scenes::Own<clq_view> view;
    const bool apart;  // the flow of decisions has a thread of its own
};

// The hash of what a view of everything sees.
scenes::Own<clq_view> view_of(clq_crowd *crowd, const scenes::Scene &scene);
uint64_t shown(clq_crowd *crowd, clq_view *view, double time_s);

}  // namespace staged_test

// The navigation of a run: what people walk on, with doors.
#pragma once

#include <claque/navigation.h>

#include <memory>

#include "samples/stage/setting.h"

namespace staged
{

struct DestroyStage {
    void operator()(clq_navigation *p) const { clq_navigation_destroy(p); }
    void operator()(clq_stage *p) const { clq_stage_destroy(p); }
};
using OwnNavigation = std::unique_ptr<clq_navigation, DestroyStage>;
using OwnStage = std::unique_ptr<clq_stage, DestroyStage>;

// Null where the scenario has no ground. Throws Failure with the place in the scenario.
OwnNavigation make_navigation(const Setting &setting, const scenes::Staging &stage);

// Moves a place where agents may appear to the ground's height; `navigation` may be null. False: no ground is there.
bool put_on_ground(const Setting &setting, const clq_navigation *navigation, const scenes::ScenarioAgents &agents,
                   std::array<double, 3> &place);

}  // namespace staged

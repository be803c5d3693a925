// A run as a scene: its times are reached one after the other, and never go back.
#pragma once

#include "samples/stage/flows.h"

namespace staged
{

struct StageOptions {
    bool apart = false;  // decisions in a thread of their own
    RunOptions run;
};

class StagedScene : public scenes::Scene
{
public:
    virtual Run &run() = 0;
    // Waits until no more is decided for what was shown so far.
    virtual void rest() = 0;
    virtual double behind_s() = 0;  // as Flows
    virtual double kept_s() = 0;
    // Run::save and Run::restore, with both flows at rest.
    virtual std::vector<uint8_t> save() = 0;
    virtual void restore(const std::vector<uint8_t> &bytes) = 0;
};

// `scenario` is copied. Throws Failure.
std::unique_ptr<StagedScene> make_staged(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
                                         const scenes::Scenario &scenario, const StageOptions &options);

// For draw_stages_with: one picture, after all that was decided before it.
std::unique_ptr<scenes::Scene> make_scenario(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
                                             const scenes::Scenario &scenario);

}  // namespace staged

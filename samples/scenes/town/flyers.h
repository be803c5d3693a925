// The flyers over the town (S0 7.1): each has a path, a gaze, a face, eyelids and phrases of its own.
#pragma once

#include <array>

#include "samples/scenes/scene_crowd.h"

namespace scenes::town
{

class Flyers
{
public:
    // `middle`: centre of the cylinder that they fly in. Heights are above y = 0.
    Flyers(Library &library, const CrowdOptions &crowd_options, const std::array<double, 3> &middle);

    const SceneCrowd &cast() const { return scene_crowd_; }
    std::vector<clq_template *> templates() const { return {template_}; }

private:
    void describe_mechanisms();
    void describe_paths();
    void enter(uint32_t number, const std::array<double, 3> &middle);
    uint32_t dof(const char *name) const;

    uint64_t seed_;
    SceneCrowd scene_crowd_;
    clq_template *template_;
    std::vector<clq_mechanism> mechanisms_;
    std::vector<clq_root_path> paths_;
};

}  // namespace scenes::town

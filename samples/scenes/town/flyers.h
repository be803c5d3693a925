// Those who fly over the town (S0 7.1): each with a way, a gaze, a face, eyelids and phrases of its own.
#pragma once

#include "samples/scenes/cast.h"

#include <array>

namespace scenes::town
{

class Flyers
{
public:
    // `middle`: of the cylinder that they fly in. Heights are above y = 0.
    Flyers(Library &library, const Casting &casting, const std::array<double, 3> &middle);

    const Cast &cast() const { return cast_; }
    std::vector<clq_template *> templates() const { return {template_}; }

private:
    void describe_mechanisms();
    void describe_ways();
    void enter(uint32_t who, const std::array<double, 3> &middle);
    uint32_t dof(const char *name) const;

    uint64_t seed_;
    Cast cast_;
    clq_template *template_;
    std::vector<clq_mechanism> mechanisms_;
    std::vector<clq_root_path> ways_;
};

}  // namespace scenes::town

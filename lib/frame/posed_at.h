// What one actor shows at any time: its exact pose then, which no tick rounds and no cache keeps.
#pragma once

#include "lib/frame/frame.h"

namespace claque::frame
{

// Its Skeleton Root in the world, not moved by the ground.
crowd::Transform root_at(const crowd::Crowd &crowd, uint32_t row, double time_s);

class PosedAt
{
public:
    PosedAt(const model::Template &tmpl, std::pmr::memory_resource *memory);  // throws std::bad_alloc

    // Evaluates all nodes of an actor of this template.
    //   level      of the template: mechanisms do as much as they do there
    //   distance   to the eye, metres
    void pose(const crowd::Crowd &crowd, uint32_t row, const model::Level &level, behave::MechanismLevels levels,
              double time_s, float distance_m);
    const math::Columns &node(uint32_t node) const { return globals_[node]; }

    // The level's vertices in this pose, copies included: 3 a vertex. Valid until the next call.
    const float *skin(const model::Level &level);  // throws std::bad_alloc

private:
    const model::Template &tmpl_;
    std::pmr::vector<math::Trs> locals_;
    std::pmr::vector<math::Columns> globals_;
    std::pmr::vector<math::Affine> palette_;  // and one more that kernels may read
    std::pmr::vector<float> weights_, dofs_, scratch_, skinning_, positions_;
};

}  // namespace claque::frame

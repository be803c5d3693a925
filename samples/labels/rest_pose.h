// A template in its rest pose, in a crowd of its own.
#pragma once

#include <claque/claque.h>

#include <array>
#include <vector>

#include "samples/scenes/library.h"

namespace labels
{

class RestPose
{
public:
    RestPose(scenes::Library &library, const clq_template *tmpl);

    std::array<double, 16> node(uint32_t node) const;
    // x, y and z of all vertices of the finest level.
    std::vector<float> vertices() const;

private:
    scenes::Own<clq_crowd> crowd_;
    clq_actor actor_ = {};
};

}  // namespace labels

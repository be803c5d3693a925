// What the frames of a script cost.
#pragma once

#include <string>
#include <vector>

#include "samples/view/model.h"

namespace view
{

class Rates
{
public:
    void add(double frame_s, const Model &model);
    // `processes`: that drew the picture, of which some `ended` early.
    std::string json(const std::string &gl, int processes, uint32_t ended) const;

private:
    std::vector<double> frame_ms_, update_ms_, surroundings_ms_, crowd_ms_, interface_ms_, interface_gl_ms_;
};

}  // namespace view

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
    std::string json(const std::string &gl) const;

private:
    std::vector<double> frame_ms_, update_ms_, surroundings_ms_, crowd_ms_, interface_ms_, interface_gl_ms_;
};

}  // namespace view

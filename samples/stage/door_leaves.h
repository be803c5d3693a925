// Closed doors, as they are drawn.
#pragma once

#include <functional>

#include "samples/scenes/geometry.h"
#include "samples/scenes/scenario/staging.h"

namespace staged
{

class DoorLeaves
{
public:
    explicit DoorLeaves(const std::vector<scenes::ScenarioDoor> &doors);
    void draw(const scenes::Gl &gl, const std::function<bool(size_t)> &is_open) const;

private:
    std::vector<scenes::Geometry> leaves_;
};

}  // namespace staged

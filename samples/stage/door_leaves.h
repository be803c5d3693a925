// Closed doors, as they are drawn.
#pragma once

#include <functional>
#include <optional>

#include "samples/scenes/geometry.h"
#include "samples/scenes/scenario/staging.h"

namespace staged
{

// A crowd knows its doors, so that its records show them: each is a group without members that is enabled while the
// door is open. They are the first groups of the crowd, in the order of the doors.
void add_doors(clq_crowd *crowd, const std::vector<scenes::ScenarioDoor> &doors);
void set_open(clq_crowd *crowd, size_t door, bool open);
std::optional<bool> is_open(const clq_crowd *crowd, size_t door);  // none: the crowd does not know it

class DoorLeaves
{
public:
    explicit DoorLeaves(const std::vector<scenes::ScenarioDoor> &doors);
    void draw(const scenes::Gl &gl, const std::function<bool(size_t)> &is_open) const;

private:
    std::vector<scenes::Geometry> leaves_;
};

}  // namespace staged

// The root paths of dragons round their Reference Points (S0 3, 4.1), as paths of a crowd.
#pragma once

#include "samples/scenes/check.h"
#include "samples/scenes/hundred/spots.h"

namespace scenes::hundred
{

class DragonPaths
{
public:
    explicit DragonPaths(clq_crowd *crowd);
    void send(clq_actor actor, PathKind way, uint64_t number) const;

private:
    clq_crowd *crowd_;
    clq_root_path paths_[static_cast<size_t>(PathKind::count)];
};

// The library's spheres for an actor on each path.
Spheres spheres_of(clq_context *context, clq_template *dragon);

}  // namespace scenes::hundred

// What draws the picture of a view in place of its own world.
#pragma once

#include "samples/view/input.h"
#include "samples/view/model.h"

namespace view
{

class World;

class Painter
{
public:
    virtual ~Painter() = default;

    // A frame begins, with this input.
    virtual void begin(const Input &input, const Model &model) = 0;
    // The world was updated, and the panels are complete. `fingerprint`: Session::fingerprint(). Throws std::exception.
    virtual void paint(World &world, Model &model, uint64_t fingerprint) = 0;
    // The context was lost, and what was done to single people with it.
    virtual void renew() = 0;
};

}  // namespace view

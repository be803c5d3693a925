// Contact shadows of people on the stone: soft dark patches on the seat, on the step under the feet and on the riser
// behind the legs, each a blended picture of a shadow. They are aligned with the seat and end at its edge.
#pragma once

#include <optional>

#include "samples/scenes/blocks.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/texture.h"

namespace scenes
{

class ContactShadows
{
public:
    ContactShadows(const std::vector<Seat> &seats, const std::vector<Sitter> &sitters);

    void prepare(const Gl &gl);
    // Draws those that meet `cull` (null: all) over the current picture, with the view set. Leaves
    // blending off and lighting on.
    void draw(const Gl &gl, const Eye &eye, const Frustum *cull) const;

private:
    Blocks patches_;
    std::optional<Texture> image_;
};

}  // namespace scenes

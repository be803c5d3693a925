// Where people touch the stone: soft dark patches on the seat, on the step under the feet and on the riser behind the
// legs, a blended picture of a shadow each. They lie square to the seat and end at its edge.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/texture.h"

#include <optional>

namespace scenes
{

class ContactShadows
{
public:
    ContactShadows(const std::vector<Seat> &seats, const std::vector<Sitter> &sitters);

    void prepare(const Gl &gl);
    // On top of what is drawn, with the view set. Leaves blending off and lighting on.
    void draw(const Gl &gl) const;

private:
    void lay(const Seat &seat, float scale);

    Geometry patches_;
    std::optional<Texture> image_;
};

}  // namespace scenes

// The surroundings of the people: a paved circle with a colonnade, under a sky. Its geometry serves all contexts;
// pictures belong to one context each.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/light.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/texture.h"

namespace multichannel
{

class Forum
{
public:
    static constexpr double radius_m = 24;  // of the colonnade, round the origin

    Forum();
    static scenes::Daylight light();

    // Belongs to the context that is current at construction.
    class Pictures
    {
    public:
        explicit Pictures(const scenes::Gl &gl);

    private:
        friend class Forum;
        scenes::Texture flagstones_, plaster_;
        scenes::Shadows shadows_;
    };

    // Draws into a cleared picture and leaves the lights on. Paints a shadow for each transform of `people`.
    void draw(const scenes::Gl &gl, const scenes::Eye &eye, Pictures &pictures,
              const std::vector<clq_transform> &people) const;

private:
    void pave();
    void build_colonnade();

    scenes::Sky sky_;
    scenes::Geometry ground_, stone_;
};

}  // namespace multichannel

// What stands round the people: a paved round with a colonnade, under a sky. Its shapes serve every context; pictures belong
// to one each.
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

    // Of the context that is current when it is made.
    class Pictures
    {
    public:
        explicit Pictures(const scenes::Gl &gl);

    private:
        friend class Forum;
        scenes::Texture flagstones_, plaster_;
        scenes::Shadows shadows_;
    };

    // Into a cleared picture; leaves the lights on. A shadow for everybody at `people`.
    void draw(const scenes::Gl &gl, const scenes::Eye &eye, Pictures &pictures,
              const std::vector<clq_transform> &people) const;

private:
    void pave();
    void build_colonnade();

    scenes::Sky sky_;
    scenes::Geometry ground_, stone_;
};

}  // namespace multichannel

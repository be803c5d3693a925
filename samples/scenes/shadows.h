// Soft shadows on level ground: one blended quad for each person, lying away from the sun. It is a picture of a
// shadow, not a projected one; movements of the arms do not show in it.
#pragma once

#include <claque/crowd.h>

#include <optional>

#include "samples/scenes/geometry.h"
#include "samples/scenes/light.h"
#include "samples/scenes/texture.h"

namespace scenes
{

class Shadows
{
public:
    void prepare(const Gl &gl);
    // For other renderers: the quads' picture, and the quads of the people, four vertices each. A quad is a
    // parallelogram with u from the first corner to the second and v to the fourth.
    static Image picture();
    const Geometry &people() const { return people_; }
    void release() { image_.reset(); }

    // position[1] is the height of the ground there. height_m and width_m are of a person of scale 1.
    void cast(const std::vector<clq_transform> &places, Vec3 to_sun, float height_m, float width_m);
    // A dark rim round an object on the ground; of one that moves, for `more` of draw().
    void ring(float x, float y, float z, float half_x, float half_z) { ring(rims_, x, y, z, half_x, half_z); }
    static void ring(Geometry &rims, float x, float y, float z, float half_x, float half_z);
    // Draws over the current picture; the view must be set. Leaves blending off.
    void draw(const Gl &gl) const { draw(gl, Geometry()); }
    // `more`: other patches that show the blot, u [0.5, 1].
    void draw(const Gl &gl, const Geometry &more) const;

    static constexpr float darkness = 0.58f;

private:
    void lay(const std::vector<clq_transform> &places, size_t i, Vec3 to_sun, float height_m, float width_m);

    std::optional<Texture> image_;
    Geometry people_, rims_;
};

}  // namespace scenes

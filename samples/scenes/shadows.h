// Soft shadows on level ground: one blended quad a person, lying away from the sun. A picture of a shadow, not a cast
// one; what people do with their arms does not show in it.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/light.h"
#include "samples/scenes/texture.h"

#include <claque/crowd.h>

#include <optional>

namespace scenes
{

class Shadows
{
public:
    void prepare(const Gl &gl);
    // For who draws them otherwise: what quads show, and those of the people, four vertices each: a parallelogram, u
    // from the first corner to the second, v to the fourth.
    static Image picture();
    const Geometry &people() const { return people_; }
    void release() { image_.reset(); }

    // Who stands where: position[1] is the ground there. height_m and width_m are of a person of scale 1.
    void cast(const std::vector<clq_transform> &places, Vec3 to_sun, float height_m, float width_m);
    // A dark rim round something that stands on the ground.
    void ring(float x, float y, float z, float half_x, float half_z);
    // On top of what is drawn; the view must be set. Leaves blending off.
    void draw(const Gl &gl) const { draw(gl, Geometry()); }
    // `more`: patches of others that show the blot, u [0.5, 1].
    void draw(const Gl &gl, const Geometry &more) const;

    static constexpr float darkness = 0.58f;

private:
    void lay(const std::vector<clq_transform> &places, size_t i, Vec3 to_sun, float height_m, float width_m);

    std::optional<Texture> image_;
    Geometry people_, rims_;
};

}  // namespace scenes

// A small town in the country, for crowds that stand, drive and fly in and over it (S0 7: "Performer Town"; the design
// is our own). A host would keep scenery like this in its scenegraph, so it comes in pieces that can be culled one by
// one.
#pragma once

#include <memory>

#include "samples/scenes/light.h"
#include "samples/scenes/texture.h"
#include "samples/scenes/town/clouds.h"
#include "samples/scenes/town/houses.h"
#include "samples/scenes/town/landmarks.h"
#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/terrain.h"
#include "samples/scenes/town/trees.h"

namespace scenes::town
{

class Town
{
public:
    explicit Town(uint64_t seed, Trade trade = Trade::ordinary);

    // Metres; the ground as it is drawn.
    double height(double x, double z) const { return terrain_.height(x, z); }
    Trade trade() const { return trade_; }
    const Plan &plan() const { return plan_; }
    const Terrain &terrain() const { return terrain_; }
    const std::vector<House> &houses() const { return houses_; }
    const std::vector<Tree> &trees() const { return trees_; }
    const Pieces &pieces() const { return pieces_; }
    const Clouds &sky() const { return sky_; }
    // For other renderers: the picture of a layer; its size is 0 for layers of colours alone.
    Image picture(SurfaceKind layer) const;
    static Daylight light();

    // Loads textures into the current context, which must be current again when the town is destroyed.
    void prepare(const Gl &gl);
    // The lights and the haze of everything that is drawn here.
    static void set_light(const Gl &gl, const Eye &eye);
    // Draws the pieces that meet `cull` (null: all), then the sky, in the light that is set, and leaves it set. Returns
    // the number of triangles sent.
    size_t draw(const Gl &gl, const Eye &eye, const Frustum *cull = nullptr) const;

private:
    uint64_t seed_;
    Trade trade_;
    Plan plan_;
    Terrain terrain_;
    std::vector<House> houses_;
    std::vector<Tree> trees_;
    Pieces pieces_;
    Clouds sky_;
    std::array<std::unique_ptr<Texture>, surface_kind_count> pictures_;
    mutable Pieces::Choice chosen_;
};

}  // namespace scenes::town

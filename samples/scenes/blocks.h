// Scenery cut into blocks, so that a picture costs only what it shows: blocks outside the camera's frustum are left
// out, and the others are drawn the nearest first, so that GL paints few pixels twice. Far blocks may have a form of
// few triangles without a texture, which software GL fills several times as fast.
#pragma once

#include <utility>
#include <vector>

#include "samples/scenes/frustum.h"
#include "samples/scenes/light.h"
#include "samples/scenes/parts.h"

namespace scenes
{

class Blocks
{
public:
    Blocks() = default;
    // Each triangle belongs to the cube of block_m metres that has its centre.
    Blocks(const Geometry &whole, float block_m);
    // The same for parts. From far_m metres on, those that have a coarse form are drawn in it, in the colours that
    // `light` and the texture's mean give it.
    struct Far {
        float from_m;
        Daylight light;
        Rgb texel;  // the texture's mean
    };
    Blocks(const Parts &parts, float block_m, const Far &far);

    using Span = Parts::Span;
    struct Block {
        Vec3 low, high;       // of all its vertices
        Sphere sphere;        // round them
        Span near, any, far;  // fine forms of what has a coarse one, and of what has none; coarse forms
    };
    const std::vector<Block> &all() const { return blocks_; }
    const Geometry &fine() const { return fine_; }
    const Geometry &coarse() const { return coarse_; }

    // The indices of the blocks that meet a frustum (null: all), the nearest to the eye first. Equal calls give equal
    // lists.
    struct Choice {
        std::vector<uint32_t> fine, coarse;
        std::vector<std::pair<double, uint32_t>> order;  // of the blocks, by distance
    };
    void choose(const Frustum *cull, const double (&eye)[3], Choice &choice) const;
    // Near blocks have the texture and the lights that are set, far ones their own colours. Call it with lighting on;
    // textures may be off afterwards.
    void draw(const Gl &gl, const Eye &eye, const Frustum *cull) const;

private:
    Geometry fine_, coarse_;
    std::vector<Block> blocks_;
    float far_m_ = 1e30f;
    // Of the last picture. A scene draws from one thread at a time.
    mutable Choice chosen_;
};

}  // namespace scenes

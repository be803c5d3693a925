// Clips of written characters: channels of every path and interpolation.
#pragma once

#include <string>
#include <vector>

#include "tests/support/gltf_maker.h"
#include "tests/support/written_shapes.h"

namespace claque::testing
{

using Four = std::array<float, 4>;

// A turn about an axis of any length, as x, y, z, w.
Four turn(const Triple &axis, float degrees);

// So many times from `first` on, `step` apart.
std::vector<float> times_from(float first, float step, size_t count);

// Rotations by these angles in degrees about one axis, in a row.
std::vector<float> turns(const Triple &axis, const std::vector<float> &degrees);

// The keys of a CUBICSPLINE channel: each value of `width` numbers between two tangents, which are made of the values
// beside it and of `bend`.
std::vector<float> with_tangents(const std::vector<float> &values, size_t width, float bend);

class ClipMaker
{
public:
    ClipMaker(Maker &maker, const char *name) : maker_(maker)
    {
        animation_ = {{"name", name}, {"channels", Json::array()}, {"samplers", Json::array()}};
    }
    // The animation is part of the file once this is called.
    void finish() { maker_.add("animations", animation_); }

    // `path` as in glTF; `type` is that of the values, SCALAR for weights.
    void add(int node, const char *path, const char *interpolation, const std::vector<float> &times,
             const std::vector<float> &values);
    // The same with any accessor as output.
    void add(int node, const char *path, const char *interpolation, const std::vector<float> &times, int output);

private:
    Maker &maker_;
    Json animation_;
};

}  // namespace claque::testing

// What a material says of light besides its base colour: emission, and whether light acts on it at all.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lib/asset/json_view.h"
#include "lib/model/model.h"

namespace claque::asset
{

struct Light {
    bool unlit = false;                         // KHR_materials_unlit, which leaves out emission
    std::array<float, 3> emission = {0, 0, 0};  // factor times strength, encoded, in [0, 1]
    JsonView texture;                           // that multiplies the emission; absent: none

    bool emits() const { return emission[0] > 0 || emission[1] > 0 || emission[2] > 0; }
};

Light read_light(const JsonView &material);

// Adds the extensions that change how the material looks and are not shown to `names`, each once.
void note_unseen_looks(const JsonView &material, std::vector<std::string> &names);

// Whether all texels have nearly one colour; `out` is its mean, in [0, 1].
bool has_one_colour(const model::Image &image, std::array<float, 3> &out);

// The least and the largest alpha of the image, in [0, 1].
struct AlphaExtent {
    float least = 1, most = 1;
};
AlphaExtent alpha_extent_of(const model::Image &image);

}  // namespace claque::asset

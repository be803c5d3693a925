// Tests if a triangle can be sampled GL_LINEAR without mixing zones.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "lib/model/template.h"

namespace claque::passes
{

// For one texture in all its sets.
class LinearFootprint
{
public:
    explicit LinearFootprint(const model::Texture &texture);

    // True if all texels that GL_LINEAR can use for any point of the closed triangle have one key, the same in each
    // set, and no hole. False for triangles that wrap more than a few times.
    bool has_one_zone(const glm::vec2 (&uv)[3]) const;

    // Luminance [0, 255] of the first set at a point, sampled both ways.
    double nearest(glm::vec2 uv) const;
    double linear(glm::vec2 uv) const;

private:
    struct Shown {
        uint32_t width, height;
        const model::Array<uint8_t> *rgba;
    };
    bool one_zone(const Shown &shown, const glm::vec2 (&uv)[3], int &key) const;
    bool row_has_one_zone(const Shown &shown, int64_t row, double low, double high, int &key) const;
    size_t texel(const Shown &shown, int64_t x, int64_t y) const;
    double luminance(const Shown &shown, int64_t x, int64_t y) const;

    const model::Texture &texture_;
    std::vector<Shown> shown_;
};

}  // namespace claque::passes

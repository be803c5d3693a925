// A range of hue, saturation and brightness filled evenly for the eye: three numbers in [0, 1) to a place in it, such that
// where the numbers are uniform the colours are uniform in OKLab.
//
// How much of OKLab a piece of the range fills is tabulated at nodes and taken to be linear between them; the numbers are then
// put through the inverses of what hue takes of the whole, saturation at that hue, brightness at both. Near numbers give near
// colours, which rejection would not: zones that are alike depend on it.
#pragma once

#include <memory_resource>
#include <vector>

#include "lib/math/hsb.h"
#include "lib/model/model.h"

namespace claque::crowd
{

struct Hsb {
    double hue_deg, saturation, brightness;
};
inline void rgb_of(const Hsb &at, double out_rgb[3])
{
    math::hsb_to_rgb(at.hue_deg, at.saturation, at.brightness, out_rgb);
}

class OklabSampler
{
public:
    OklabSampler(std::pmr::memory_resource *memory, const model::HsbRange &range);
    Hsb at(const double u[3]) const;  // each [0, 1)

private:
    struct Axis {
        double first = 0, width = 0;
        uint32_t nodes = 1;
        double value_at(double share) const { return first + share * width; }
    };
    const float *column(uint32_t hue, uint32_t saturation) const
    {
        return density_.data() + (hue * axes_[1].nodes + saturation) * axes_[2].nodes;
    }

    Axis axes_[3];  // hue, saturation, cube root of brightness
    double min_brightness_, max_brightness_;
    std::pmr::vector<float> density_;       // [hue][saturation][brightness]
    std::pmr::vector<float> marginals_[2];  // summed over brightness; and over saturation too
};

}  // namespace claque::crowd

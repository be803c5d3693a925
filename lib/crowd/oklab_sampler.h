// Samples a range of hue, saturation and brightness uniformly in OKLab: maps three numbers in [0, 1) to a colour, such
// that uniform numbers give colours of uniform perceived density.
//
// The OKLab volume per cell of the range is tabulated at nodes and linear between them. The numbers go through the
// inverse marginal distributions: of hue, of saturation at that hue, of brightness at both. Near numbers give near
// colours, which rejection sampling would not; linked zones depend on that.
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

#include "samples/parity/flip.h"

#include <algorithm>
#include <cmath>

#include "samples/parity/flip_filters.h"

namespace parity
{
namespace
{

using flip::Colour;

struct Opponent {
    std::array<Map<float>, 3> channels;
};

Opponent opponent_of(const Map<Colour> &linear)
{
    Opponent out;
    for (Map<float> &channel : out.channels) channel = Map<float>(linear.width, linear.height);
    for (size_t i = 0; i < linear.values.size(); ++i) {
        const Colour o = flip::opponent_of(linear.values[i]);
        for (size_t c = 0; c < 3; ++c) out.channels[c].values[i] = o[c];
    }
    return out;
}

// The picture as the eye perceives it from that distance, in a perceptually uniform space.
Map<Colour> perceived(const Opponent &opponent, double pixels_per_degree)
{
    Opponent seen;
    for (size_t c = 0; c < 3; ++c)
        seen.channels[c] = flip::seen(opponent.channels[c], static_cast<flip::Channel>(c), pixels_per_degree);
    Map<Colour> out(seen.channels[0].width, seen.channels[0].height);
    for (size_t i = 0; i < out.values.size(); ++i) {
        Colour linear = flip::linear_of_opponent(
            {seen.channels[0].values[i], seen.channels[1].values[i], seen.channels[2].values[i]});
        for (float &v : linear) v = std::clamp(v, 0.0f, 1.0f);
        out.values[i] = flip::hunt_lab_of(linear);
    }
    return out;
}

// 4.1.3: to the power of 0.7, then the lower 0.4 of the possible range spread over [0, 0.95].
float colour_difference(const Colour &a, const Colour &b, float largest)
{
    const float difference = std::pow(flip::hyab(a, b), 0.7f), knee = 0.4f * largest;
    return difference < knee ? 0.95f / knee * difference : 0.95f + (difference - knee) / (largest - knee) * 0.05f;
}

struct Features {
    Map<float> edges, points;  // lengths of gradients
};

Map<float> lengths(const Map<float> &x, const Map<float> &y)
{
    Map<float> out = x;
    for (size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    return out;
}

Features features_of(const Map<float> &achromatic, const flip::FeatureKernels &k)
{
    Map<float> grey = achromatic;
    for (float &v : grey.values) v = (v + 16) / 116;
    return {lengths(flip::filtered(grey, k.edge, k.blur), flip::filtered(grey, k.blur, k.edge)),
            lengths(flip::filtered(grey, k.point, k.blur), flip::filtered(grey, k.blur, k.point))};
}

Map<Colour> linear_of(const Picture &p)
{
    Map<Colour> out(p.width, p.height);
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] = flip::linear_of(&p.rgb[3 * i]);
    return out;
}

}  // namespace

double pixels_per_degree(double distance_m, double width_m, double width_px)
{
    return distance_m * (width_px / width_m) * (3.14159265358979323846 / 180);
}

Map<float> flip_map(const Map<Colour> &linear_reference, const Map<Colour> &linear_result, double pixels_per_degree)
{
    const Opponent a = opponent_of(linear_reference), b = opponent_of(linear_result);
    const Map<Colour> seen_a = perceived(a, pixels_per_degree), seen_b = perceived(b, pixels_per_degree);
    const flip::FeatureKernels kernels = flip::feature_kernels(pixels_per_degree);
    const Features of_a = features_of(a.channels[0], kernels), of_b = features_of(b.channels[0], kernels);
    const float largest = flip::largest_difference();
    Map<float> out(linear_reference.width, linear_reference.height);
    for (size_t i = 0; i < out.values.size(); ++i) {
        const float colour = colour_difference(seen_a.values[i], seen_b.values[i], largest);
        const float edges = std::fabs(of_a.edges.values[i] - of_b.edges.values[i]);
        const float points = std::fabs(of_a.points.values[i] - of_b.points.values[i]);
        const float feature = std::sqrt(std::max(edges, points) / std::sqrt(2.0f));
        out.values[i] = std::pow(colour, 1 - std::min(feature, 1.0f));
    }
    return out;
}

Map<float> flip_map(const Picture &reference, const Picture &result, double pixels_per_degree)
{
    return flip_map(linear_of(reference), linear_of(result), pixels_per_degree);
}

double mean_of(const Map<float> &map)
{
    double sum = 0;
    for (const float v : map.values) sum += double(v);
    return map.values.empty() ? 0 : sum / static_cast<double>(map.values.size());
}

}  // namespace parity

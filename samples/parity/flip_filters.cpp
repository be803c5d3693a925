#include "samples/parity/flip_filters.h"

#include <algorithm>
#include <cmath>

namespace parity::flip
{
namespace
{

constexpr double pi = 3.14159265358979323846;

// a sqrt(pi / b) exp(-pi^2 d^2 / b) with d in degrees: the table of 4.1.1. Achromatic and red-green have one term.
struct Term {
    double a, b;
};
struct Sensitivity {
    std::array<Term, 2> terms;
    int count;
};
constexpr Sensitivity sensitivities[3] = {
    {{{{1, 0.0047}, {0, 0}}}, 1}, {{{{1, 0.0053}, {0, 0}}}, 1}, {{{{34.1, 0.04}, {13.5, 0.025}}}, 2}};
constexpr double widest = 0.04;  // of all b

// Three standard deviations of the widest kernel, for all channels.
int reach(double pixels_per_degree)
{
    return static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
}

// Along one axis, normalised to a sum of 1. sum: the sum before that.
Kernel gaussian(double b, double pixels_per_degree, double &sum)
{
    const int radius = reach(pixels_per_degree);
    std::vector<double> weights;
    sum = 0;
    for (int x = -radius; x <= radius; ++x) {
        const double degrees = x / pixels_per_degree;
        weights.push_back(std::exp(-pi * pi * degrees * degrees / b));
        sum += weights.back();
    }
    Kernel out;
    for (const double w : weights) out.push_back(static_cast<float>(w / sum));
    return out;
}

Kernel signs_summing_to_one(const std::vector<double> &weights)
{
    double positive = 0, negative = 0;
    for (const double w : weights) (w > 0 ? positive : negative) += std::fabs(w);
    Kernel out;
    for (const double w : weights)
        out.push_back(static_cast<float>(w > 0 ? w / positive : negative > 0 ? w / negative : 0));
    return out;
}

int clamped(int i, int size) { return std::clamp(i, 0, size - 1); }

}  // namespace

Map<float> filtered(const Map<float> &in, const Kernel &rows, const Kernel &columns)
{
    const int across = static_cast<int>(rows.size()) / 2, down = static_cast<int>(columns.size()) / 2;
    Map<float> wide(in.width, in.height), out(in.width, in.height);
    std::vector<float> row(static_cast<size_t>(in.width + 2 * across));
    for (int y = 0; y < in.height; ++y) {
        for (int x = -across; x < in.width + across; ++x)
            row[static_cast<size_t>(x + across)] = in.at(clamped(x, in.width), y);
        float *to = &wide.values[wide.index(0, y)];
        for (size_t k = 0; k < rows.size(); ++k)
            for (int x = 0; x < in.width; ++x) to[x] += rows[k] * row[static_cast<size_t>(x) + k];
    }
    for (int y = 0; y < in.height; ++y) {
        float *to = &out.values[out.index(0, y)];
        for (size_t k = 0; k < columns.size(); ++k) {
            const float *from = &wide.values[wide.index(0, clamped(y - down + static_cast<int>(k), in.height))];
            for (int x = 0; x < in.width; ++x) to[x] += columns[k] * from[x];
        }
    }
    return out;
}

Map<float> seen(const Map<float> &in, Channel channel, double pixels_per_degree)
{
    const Sensitivity &s = sensitivities[channel];
    // A Gaussian in the plane is one along x times one along y; each term has its share of the sum over the plane.
    std::array<double, 2> volumes = {};
    std::array<Kernel, 2> kernels;
    for (int i = 0; i < s.count; ++i) {
        const Term &term = s.terms[static_cast<size_t>(i)];
        double sum = 0;
        kernels[static_cast<size_t>(i)] = gaussian(term.b, pixels_per_degree, sum);
        volumes[static_cast<size_t>(i)] = term.a * std::sqrt(pi / term.b) * sum * sum;
    }
    Map<float> out(in.width, in.height);
    for (size_t i = 0; i < static_cast<size_t>(s.count); ++i) {
        const float share = static_cast<float>(volumes[i] / (volumes[0] + volumes[1]));
        const Map<float> part = filtered(in, kernels[i], kernels[i]);
        for (size_t p = 0; p < out.values.size(); ++p) out.values[p] += share * part.values[p];
    }
    return out;
}

FeatureKernels feature_kernels(double pixels_per_degree)
{
    constexpr double line_degrees = 0.082;  // trough to trough
    const double deviation = 0.5 * line_degrees * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    std::vector<double> blur, edge, point;
    for (int x = -radius; x <= radius; ++x) {
        const double g = std::exp(-x * x / (2 * deviation * deviation));
        blur.push_back(g);
        edge.push_back(-x * g);
        point.push_back((x * x / (deviation * deviation) - 1) * g);
    }
    return {signs_summing_to_one(blur), signs_summing_to_one(edge), signs_summing_to_one(point)};
}

}  // namespace parity::flip

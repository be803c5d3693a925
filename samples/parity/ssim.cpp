#include "samples/parity/ssim.h"

#include <array>
#include <cmath>

namespace parity
{
namespace
{

using Weights = std::array<double, ssim_window>;

Weights gaussian()
{
    Weights w = {};
    double sum = 0;
    for (int i = 0; i < ssim_window; ++i) {
        const double x = (i - ssim_window / 2) / 1.5;
        w[static_cast<size_t>(i)] = std::exp(-x * x / 2);
        sum += w[static_cast<size_t>(i)];
    }
    for (double &v : w) v /= sum;
    return w;
}

Map<double> luma(const Picture &p)
{
    Map<double> out(p.width, p.height);
    for (size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = 0.299 * p.rgb[3 * i] + 0.587 * p.rgb[3 * i + 1] + 0.114 * p.rgb[3 * i + 2];
    return out;
}

Map<double> product(const Map<double> &a, const Map<double> &b)
{
    Map<double> out = a;
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] *= b.values[i];
    return out;
}

// Weighted means of all whole windows: smaller than the picture by ten columns and rows.
Map<double> means(const Map<double> &in, const Weights &w)
{
    Map<double> rows(in.width - ssim_window + 1, in.height), out(rows.width, in.height - ssim_window + 1);
    for (int y = 0; y < rows.height; ++y)
        for (int x = 0; x < rows.width; ++x)
            for (int k = 0; k < ssim_window; ++k)
                rows.values[rows.index(x, y)] += w[static_cast<size_t>(k)] * in.at(x + k, y);
    for (int y = 0; y < out.height; ++y)
        for (int k = 0; k < ssim_window; ++k)
            for (int x = 0; x < out.width; ++x)
                out.values[out.index(x, y)] += w[static_cast<size_t>(k)] * rows.at(x, y + k);
    return out;
}

}  // namespace

double mean_ssim(const Picture &reference, const Picture &result)
{
    constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);
    const Weights w = gaussian();
    const Map<double> a = luma(reference), b = luma(result);
    const Map<double> mean_a = means(a, w), mean_b = means(b, w);
    const Map<double> aa = means(product(a, a), w), bb = means(product(b, b), w), ab = means(product(a, b), w);
    double sum = 0;
    for (size_t i = 0; i < aa.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variance_a = aa.values[i] - ma * ma, variance_b = bb.values[i] - mb * mb;
        const double covariance = ab.values[i] - ma * mb;
        sum += (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variance_a + variance_b + c2));
    }
    return sum / static_cast<double>(aa.values.size());
}

}  // namespace parity

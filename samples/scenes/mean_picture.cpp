#include "samples/scenes/scene_renderer.h"

namespace scenes
{
namespace
{

// Halton's sequence: points that fill a pixel evenly, however many are used.
double halton(uint32_t i, uint32_t base)
{
    double at = 0, digit = 1;
    for (; i > 0; i /= base) at += (digit /= base) * (i % base);
    return at;
}

}  // namespace

void SceneRenderer::set_multisample(bool on)
{
    if (options_.multisample == 1) return;
    on ? gl_.Enable(gl::multisample) : gl_.Disable(gl::multisample);
}

const std::vector<uint8_t> &SceneRenderer::picture(double time_s, uint32_t samples, uint32_t first)
{
    if (samples <= 1) return picture(time_s);
    set_multisample(false);  // the mean of means would be blurred
    std::vector<uint32_t> sums;
    for (uint32_t i = first; i < first + samples; ++i) {
        moved_px_[0] = halton(i, 2) - 0.5, moved_px_[1] = halton(i, 3) - 0.5;
        const std::vector<uint8_t> &one = picture(time_s);
        sums.resize(one.size(), 0);
        for (size_t k = 0; k < one.size(); ++k) sums[k] += one[k];
    }
    moved_px_[0] = moved_px_[1] = 0;
    set_multisample(true);
    for (size_t k = 0; k < sums.size(); ++k) rgb_[k] = static_cast<uint8_t>((sums[k] + samples / 2) / samples);
    return rgb_;
}

}  // namespace scenes

// Renderers with textures of single individuals, and differences of pictures.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "tests/gl/support/fixture.h"

namespace gltest
{

// All individuals that may have one have one.
inline passes::RendererOptions close_options(passes::Strategy strategy = passes::Strategy::fused)
{
    passes::RendererOptions options = options_of(strategy);
    options.close_bytes = 64 << 20, options.close_distance_m = 1000;
    return options;
}

// Without filtering, as the template's own textures are shown.
inline passes::RendererOptions nearest_close(passes::Strategy strategy = passes::Strategy::fused)
{
    passes::RendererOptions options = close_options(strategy);
    options.close_nearest = true;
    return options;
}

// Of a channel, in 255ths.
inline int largest_difference(const Picture &a, const Picture &b)
{
    int most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(int(a[i]) - int(b[i])));
    return most;
}

}  // namespace gltest

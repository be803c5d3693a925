// Compares vertices and normals of two renderers, number by number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace parity
{

// The same individual's vertices in both arrays.
struct Span {
    uint32_t actor = 0;
    size_t reference_first = 0, result_first = 0, count = 0;  // vertices
    double size_m = 0;                                        // the character's; 0: unknown
};

struct Deviation {
    size_t compared = 0;      // vectors
    size_t not_finite = 0;    // of them with a NaN or infinity on either side; excluded from all other values
    double max = 0, rms = 0;  // distances, or angles in degrees for normals
    double max_relative = 0;  // the largest distance in sizes of its character; for positions only
    uint32_t worst_actor = 0;
    size_t worst_vertex = 0;                  // of that actor
    uint32_t ulp_max = 0, ulp_median = 0;     // over all components
    float ulp_reference = 0, ulp_result = 0;  // the numbers that are ulp_max apart
};

// xyz: three numbers a vertex. The spans lie inside both arrays.
Deviation positions_deviation(const std::vector<float> &reference, const std::vector<float> &result,
                              const std::vector<Span> &spans);

// Angles between directions, whatever their lengths: a renderer may normalise before or after it stores. If exactly
// one of the two has length 0, the angle is 180 degrees.
Deviation normals_deviation(const std::vector<float> &reference, const std::vector<float> &result,
                            const std::vector<Span> &spans);

}  // namespace parity

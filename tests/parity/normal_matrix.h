// The matrix that transforms normals where a joint matrix may stretch, as in docs/parity.md.
#pragma once

#include <cmath>
#include <cstddef>

namespace parity_test
{

// Rows of four in and out: the inverse transpose of the upper 3 x 3, to the size of a rotation; the fourth column is 0.
inline void normal_matrix(const float *rows, float *out)
{
    double cofactors[3][3], sum = 0, det = 0;
    const auto m = [&](int row, int column) { return static_cast<double>(rows[4 * (row % 3) + column % 3]); };
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            cofactors[r][c] = m(r + 1, c + 1) * m(r + 2, c + 2) - m(r + 1, c + 2) * m(r + 2, c + 1);
            sum += cofactors[r][c] * cofactors[r][c];
            if (r == 0) det += m(0, c) * cofactors[0][c];
        }
    const double factor = sum > 0 ? (det < 0 ? -1 : 1) / std::sqrt(sum / 3) : 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) out[4 * r + c] = c < 3 ? static_cast<float>(cofactors[r][c] * factor) : 0.0f;
}

}  // namespace parity_test

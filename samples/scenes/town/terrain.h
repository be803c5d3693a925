// The ground of the town as triangles over the lines of its plan, and its height. The height is that of the triangles,
// so that objects on them neither float nor sink.
#pragma once

#include <array>

#include "samples/scenes/geometry.h"
#include "samples/scenes/town/plan.h"

namespace scenes::town
{

class Terrain
{
public:
    Terrain(const Plan &plan, uint64_t seed);

    // The surface's height at a point; beyond its edge, where it is unknown, the lowest height.
    double height(double x, double z) const;

    size_t columns() const { return columns_; }  // of cells
    size_t rows() const { return rows_; }
    const Vec3 &corner(size_t column, size_t row) const { return corners_[row * (columns_ + 1) + column]; }
    const Vec3 &normal(size_t column, size_t row) const { return normals_[row * (columns_ + 1) + column]; }

    using Triangle = std::array<Vec3, 3>;  // counter-clockwise from above
    // Two for each cell.
    Triangle triangle(size_t number) const;
    size_t triangles() const { return 2 * columns_ * rows_; }
    // Numbers of the triangles whose boxes meet a box of the ground plan, ascending.
    void find(double x0, double z0, double x1, double z1, std::vector<uint32_t> &numbers) const;

private:
    // The triangles that may lie over each square of the ground plan.
    struct Squares {
        double half_m = 0, side_m = 1;
        int across = 0;
        std::vector<uint32_t> starts, numbers;
        int at(double metres) const;
        bool holds(double x, double z) const { return x > -half_m && x < half_m && z > -half_m && z < half_m; }
    };
    void index(Squares &squares, double half_m, int across) const;

    size_t columns_, rows_;
    std::vector<Vec3> corners_, normals_;
    double lowest_ = 0;
    Squares near_, far_;
};

}  // namespace scenes::town

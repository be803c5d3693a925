#include "samples/scenes/town/terrain.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/random.h"

namespace scenes::town
{
namespace
{

double smooth_height(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// The land before it is cut into triangles.
class Relief
{
public:
    Relief(const Plan &plan, uint64_t seed) : plan_(plan), seed_(seed)
    {
        for (uint64_t i = 0; i < 3; ++i) turns_[i] = random_between(seed, 40 + i, Purpose::gradient, 0, 6.28);
    }

    double at(double u, double v) const
    {
        const Point p = plan_.at(u, v);
        const double away = std::abs(plan_.from_stream(u)), water = -4.4 - 0.0012 * v;
        if (away <= Plan::water_half_m + 0.01) return on_high_street(v) ? water + 2.1 : water;
        const double valley = smooth_height((away - Plan::water_half_m - Plan::bank_m) / 140);
        const double side = smooth_height(away / 420);  // hills keep away from the stream
        return (water + 1.3) * (1 - valley) + (meadows(p) + side * hills(p)) * valley;
    }

private:
    bool on_high_street(double v) const
    {
        return std::abs(v - plan_.streets_v()[Plan::high_street]) < Plan::half_v(Plan::high_street) + 0.01;
    }
    double meadows(Point p) const
    {
        return 2.0 * std::sin(p.x / 170 + turns_[0]) * std::cos(p.z / 210 + turns_[1]) +
               1.1 * std::sin((p.x - p.z) / 150 + turns_[2]);
    }
    double hills(Point p) const
    {
        const double ramp = smooth_height((std::sqrt(p.x * p.x + p.z * p.z) - 320) / 2100);
        const double broad = gradient_noise(seed_ + 11, p.x / 720, p.z / 720);
        const double fine = gradient_noise(seed_ + 12, p.x / 260, p.z / 260);
        return ramp * (78 + 120 * broad + 30 * fine);
    }

    const Plan &plan_;
    uint64_t seed_;
    double turns_[3];
};

}  // namespace

Terrain::Terrain(const Plan &plan, uint64_t seed) : columns_(plan.strips_u().size()), rows_(plan.strips_v().size())
{
    const Relief relief(plan, seed);
    for (const double v : plan.lines_v())
        for (const double u : plan.lines_u()) {
            const Point p = plan.at(u, v);
            corners_.push_back({static_cast<float>(p.x), static_cast<float>(relief.at(u, v)), static_cast<float>(p.z)});
            lowest_ = std::min(lowest_, static_cast<double>(corners_.back().y));
            const double d = 3;
            const Point e = plan.at(u + d, v), w = plan.at(u - d, v), s = plan.at(u, v + d), n = plan.at(u, v - d);
            const double eu = relief.at(u + d, v) - relief.at(u - d, v), ev = relief.at(u, v + d) - relief.at(u, v - d);
            const double ux = e.x - w.x, uz = e.z - w.z, vx = s.x - n.x, vz = s.z - n.z;
            const double nx = ev * uz - eu * vz, ny = ux * vz - uz * vx, nz = eu * vx - ev * ux;
            const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
            normals_.push_back(
                {static_cast<float>(nx / length), static_cast<float>(ny / length), static_cast<float>(nz / length)});
        }
    index(near_, 320, 40);
    index(far_, 2 * Plan::reach_m, 60);
}

Terrain::Triangle Terrain::triangle(size_t number) const
{
    const size_t column = number / 2 % columns_, row = number / 2 / columns_;
    const Vec3 &a = corner(column, row), &b = corner(column + 1, row);
    const Vec3 &c = corner(column + 1, row + 1), &d = corner(column, row + 1);
    if (number % 2 == 0) return {d, c, b};
    return {d, b, a};
}

int Terrain::Squares::at(double metres) const
{
    return std::clamp(static_cast<int>(std::floor((metres + half_m) / side_m)), 0, across - 1);
}

void Terrain::index(Squares &squares, double half_m, int across) const
{
    squares.half_m = half_m;
    squares.across = across;
    squares.side_m = 2 * half_m / across;
    std::vector<std::vector<uint32_t>> lists(static_cast<size_t>(across) * static_cast<size_t>(across));
    for (size_t number = 0; number < triangles(); ++number) {
        const Triangle t = triangle(number);
        const auto [x0, x1] = std::minmax({t[0].x, t[1].x, t[2].x});
        const auto [z0, z1] = std::minmax({t[0].z, t[1].z, t[2].z});
        if (x0 > half_m || x1 < -half_m || z0 > half_m || z1 < -half_m) continue;
        for (int k = squares.at(z0); k <= squares.at(z1); ++k)
            for (int i = squares.at(x0); i <= squares.at(x1); ++i)
                lists[static_cast<size_t>(k * across + i)].push_back(static_cast<uint32_t>(number));
    }
    for (const std::vector<uint32_t> &list : lists) {
        squares.starts.push_back(static_cast<uint32_t>(squares.numbers.size()));
        squares.numbers.insert(squares.numbers.end(), list.begin(), list.end());
    }
    squares.starts.push_back(static_cast<uint32_t>(squares.numbers.size()));
}

double Terrain::height(double x, double z) const
{
    const Squares &squares = near_.holds(x, z) ? near_ : far_;
    const size_t square = static_cast<size_t>(squares.at(z) * squares.across + squares.at(x));
    for (uint32_t i = squares.starts[square]; i < squares.starts[square + 1]; ++i) {
        const Triangle t = triangle(squares.numbers[i]);
        const double ax = t[0].x, az = t[0].z, bx = t[1].x - ax, bz = t[1].z - az, cx = t[2].x - ax, cz = t[2].z - az;
        const double px = x - ax, pz = z - az, twice = bx * cz - bz * cx;
        const double b = (px * cz - pz * cx) / twice, c = (bx * pz - bz * px) / twice;
        constexpr double edge = -1e-9;  // a point on an edge belongs to both sides rather than to none
        if (b >= edge && c >= edge && b + c <= 1 - edge)
            return static_cast<double>(t[0].y) + b * (t[1].y - static_cast<double>(t[0].y)) +
                   c * (t[2].y - static_cast<double>(t[0].y));
    }
    return lowest_;
}

void Terrain::find(double x0, double z0, double x1, double z1, std::vector<uint32_t> &numbers) const
{
    numbers.clear();
    const Squares &squares = near_.holds(x0, z0) && near_.holds(x1, z1) ? near_ : far_;
    for (int k = squares.at(z0); k <= squares.at(z1); ++k)
        for (int i = squares.at(x0); i <= squares.at(x1); ++i) {
            const size_t square = static_cast<size_t>(k * squares.across + i);
            numbers.insert(numbers.end(), squares.numbers.begin() + squares.starts[square],
                           squares.numbers.begin() + squares.starts[square + 1]);
        }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace scenes::town

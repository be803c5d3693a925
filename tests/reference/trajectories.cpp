#include "trajectories.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <unordered_map>

namespace claque::reference
{
namespace
{

// Points by the cell they are in; cells as wide as the distance that is asked for.
class Grid
{
public:
    Grid(const std::vector<Vec3> &points, double cell) : points_(points), cell_(cell)
    {
        for (size_t i = 0; i < points.size(); ++i) cells_[key(place(points[i]))].push_back(i);
    }

    std::vector<size_t> near(const Vec3 &at) const
    {
        std::vector<size_t> found;
        const auto middle = place(at);
        for (int64_t n = 0; n < 27; ++n) {
            const auto cell =
                cells_.find(key({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1}));
            if (cell == cells_.end()) continue;
            for (const size_t i : cell->second)
                if (length(points_[i] - at) <= cell_) found.push_back(i);
        }
        return found;
    }

private:
    using Place = std::array<int64_t, 3>;
    Place place(const Vec3 &p) const
    {
        const auto along = [&](double x) { return static_cast<int64_t>(std::floor(x / cell_)); };
        return {along(p.x), along(p.y), along(p.z)};
    }
    // Cells that share a key cost time only: distances are measured.
    static uint64_t key(const Place &p)
    {
        return static_cast<uint64_t>(p[0]) * 73856093u ^ static_cast<uint64_t>(p[1]) * 19349663u ^
               static_cast<uint64_t>(p[2]) * 83492791u;
    }

    const std::vector<Vec3> &points_;
    double cell_;
    std::unordered_map<uint64_t, std::vector<size_t>> cells_;
};

bool goes_with(const std::vector<Pose> &poses, size_t actual, size_t expected, double distance)
{
    for (const Pose &pose : poses)
        if (!(length(pose.actual.positions[actual] - pose.expected.positions[expected]) <= distance)) return false;
    return true;
}

// Where the file or the pose has no normal, anything is right.
bool normals_agree(const std::vector<Pose> &poses, size_t actual, size_t expected)
{
    for (const Pose &pose : poses) {
        const Vec3 &n = pose.expected.normals[expected];
        if (length(n) == 0) continue;
        const double limit = normal_limit(pose.expected.stretches[expected], normal_slack);
        if (!(dot(n, normalized(pose.actual.normals[actual])) >= std::cos(limit))) return false;
    }
    return true;
}

}  // namespace

double normal_limit(double stretch, double slack)
{
    const double bend = std::isfinite(stretch) ? std::acos(2 * stretch / (1 + stretch * stretch)) : 3;
    return std::fmin(3.14159, bend + slack);
}

Matching match(const std::vector<Pose> &poses, const std::vector<bool> &used, double distance)
{
    Matching result;
    std::ostringstream text;
    const std::vector<Vec3> &actual = poses.at(0).actual.positions;
    std::vector<bool> found(used.size(), false);
    const Grid grid(poses[0].expected.positions, distance);
    for (size_t v = 0; v < actual.size(); ++v) {
        bool has_partner = false, has_normal = false;
        for (const size_t candidate : grid.near(actual[v])) {
            if (!goes_with(poses, v, candidate, distance)) continue;
            has_partner = found[candidate] = true;
            has_normal = has_normal || normals_agree(poses, v, candidate);
        }
        if (!has_partner && result.strays++ == 0) text << "no vertex of the file goes with split vertex " << v << "; ";
        if (has_partner && !has_normal && result.bad_normals++ == 0) text << "normals of split vertex " << v << "; ";
    }
    for (size_t v = 0; v < used.size(); ++v)
        if (used[v] && !found[v] && result.missing++ == 0) text << "vertex " << v << " of the file is missing; ";
    text << result.strays << " stray, " << result.missing << " missing, " << result.bad_normals << " of "
         << actual.size() << " with other normals";
    result.text = text.str();
    result.same = result.strays == 0 && result.missing == 0 && result.bad_normals == 0;
    return result;
}

std::vector<bool> vertices_of_triangles(const Character &character, double size)
{
    const Shape shape = evaluate(character, rest, 0);
    std::vector<bool> used(shape.positions.size(), false);
    size_t first = 0;
    for (const Part &part : character.parts) {
        const size_t step = part.mode == 4 ? 3 : 1;
        for (size_t i = 0; part.mode >= 4 && i + 2 < part.indices.size(); i += step) {
            const std::array<size_t, 3> corner{first + part.indices[part.mode == 6 ? 0 : i],
                                               first + part.indices[i + 1], first + part.indices[i + 2]};
            const Vec3 side = shape.positions[corner[1]] - shape.positions[corner[0]];
            const Vec3 other = shape.positions[corner[2]] - shape.positions[corner[0]];
            if (length(cross(side, other)) < 1e-10 * size * size) continue;
            for (const size_t v : corner) used[v] = true;
        }
        first += part.positions.size();
    }
    return used;
}

}  // namespace claque::reference

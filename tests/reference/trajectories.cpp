#include "tests/reference/trajectories.h"

#include <cmath>
#include <sstream>

#include "tests/reference/grid.h"

namespace claque::reference
{
namespace
{

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

}  // namespace claque::reference

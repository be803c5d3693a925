#include "samples/labels/face.h"

#include <algorithm>
#include <cmath>

namespace labels
{
namespace
{

std::map<std::string, std::array<double, 3>> both_sides(const std::array<double, 3> &nose,
                                                        const std::array<double, 3> &eye,
                                                        const std::array<double, 3> &ear)
{
    return {{"nose", nose},
            {"left_eye", eye},
            {"right_eye", {-eye[0], eye[1], eye[2]}},
            {"left_ear", ear},
            {"right_ear", {-ear[0], ear[1], ear[2]}}};
}

}  // namespace

Face face_of(const std::array<double, 3> &joint, const std::vector<float> &xyz)
{
    double tall = 0;
    for (size_t v = 1; v < xyz.size(); v += 3) tall = std::max(tall, static_cast<double>(xyz[v]) - joint[1]);
    // Up and forward from the joint to the tip of the nose.
    double up = 0, forward = 0;
    for (size_t v = 0; v + 2 < xyz.size(); v += 3) {
        const double x = static_cast<double>(xyz[v]) - joint[0], y = static_cast<double>(xyz[v + 1]) - joint[1],
                     z = static_cast<double>(xyz[v + 2]) - joint[2];
        if (std::abs(x) < 0.05 * tall && y > 0.1 * tall && y < 0.4 * tall && z > forward) up = y, forward = z;
    }
    Face out;
    const bool has_nose = up > 0.12 * tall && up < 0.35 * tall && forward > 0.4 * tall && forward < 0.8 * tall;
    if (!has_nose) {
        out.points = both_sides({0, 0.4 * tall, 0.5 * tall}, {0.15 * tall, 0.5 * tall, 0.42 * tall},
                                {0.36 * tall, 0.45 * tall, 0.05 * tall});
        out.middle = {0, 0.5 * tall, 0.1 * tall};
        out.radius_m = tall > 0 ? tall / 2 : out.radius_m;
        return out;
    }
    // Shares of the depth of a head, which hair does not change in front.
    const double eyes = up + 0.28 * forward;
    out.points =
        both_sides({0, up, forward}, {0.235 * forward, eyes, 0.75 * forward}, {0.56 * forward, eyes, 0.08 * forward});
    out.middle = {0, eyes, 0.1 * forward};
    out.radius_m = 0.85 * forward;
    return out;
}

}  // namespace labels

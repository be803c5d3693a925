#include "samples/scenes/camera_fit.h"

#include <algorithm>
#include <cmath>

namespace scenes
{

CameraFit fit_camera(const std::vector<PoseBox> &boxes, double fov_deg, double aspect, double pitch)
{
    constexpr double fill = 0.88;
    const double half_fov = fov_deg / 2 * 0.017453292519943295;
    const double tall = fill * std::sin(half_fov) / std::cos(half_fov), wide = tall * aspect;
    PoseBox all = PoseBox::none();
    for (const PoseBox &box : boxes) all.hold(box);
    const auto middle = [&](size_t axis) { return (all.low[axis] + all.high[axis]) / 2; };
    CameraFit f = {1, middle(0), middle(1), middle(2), -std::sin(pitch), -std::cos(pitch)};
    for (int round = 0; round < 8; ++round) {
        double top = -1e9, bottom = 1e9, left = 1e9, right = -1e9, next = 0.1;
        for (size_t corner = 0; corner < 8 * boxes.size(); ++corner) {
            const PoseBox &box = boxes[corner / 8];
            const double px = (corner & 1 ? box.high : box.low)[0] - f.target_x;
            const double py = (corner & 2 ? box.high : box.low)[1] - f.target_y;
            const double pz = (corner & 4 ? box.high : box.low)[2] - f.target_z;
            const double up = pz * f.fy - py * f.fz, ahead = py * f.fy + pz * f.fz;
            next = std::max({next, std::abs(up) / tall - ahead, std::abs(px) / wide - ahead});
            top = std::max(top, up / (f.distance + ahead));
            bottom = std::min(bottom, up / (f.distance + ahead));
            left = std::min(left, px / (f.distance + ahead));
            right = std::max(right, px / (f.distance + ahead));
        }
        if (round > 0) {  // equal margins
            f.target_x += (left + right) / 2 * f.distance;
            f.target_y += (top + bottom) / 2 * f.distance;
        }
        f.distance = next;
    }
    return f;
}

}  // namespace scenes

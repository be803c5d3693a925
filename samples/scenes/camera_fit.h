// A camera that looks down on boxes from the front, at the smallest distance that has all of them in the picture.
#pragma once

#include <vector>

#include "samples/scenes/posed_template.h"

namespace scenes
{

struct CameraFit {
    double distance, target_x, target_y, target_z, fy, fz;  // f: the eye's direction
};

// `pitch`: how far down it looks, in radians. At least one box.
CameraFit fit_camera(const std::vector<PoseBox> &boxes, double fov_deg, double aspect, double pitch);

}  // namespace scenes

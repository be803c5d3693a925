// Where eyes, ears and nose are on a head: found by its shape, since skeletons have no joints for them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace labels
{

// All in the space of the model, from the joint of the head. People face +z, and their left is +x.
struct Face {
    std::map<std::string, std::array<double, 3>> points;  // nose, left_eye, right_eye, left_ear, right_ear
    std::array<double, 3> middle = {0, 0, 0};             // of the head
    double radius_m = 0.1;                                // of the head
};

// xyz: the vertices in the rest pose. Hair may reach as high as it likes where there is a nose, the vertex that is the
// farthest in front of the joint in the middle of the face. Without one, the face is that of a head as tall as the body
// reaches above the joint.
Face face_of(const std::array<double, 3> &joint, const std::vector<float> &xyz);

}  // namespace labels

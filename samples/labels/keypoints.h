// Sets of keypoints: COCO's 17, SMPL's 24, or a file's own.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace labels
{

// Where a point of one's own is.
struct OwnPoint {
    std::string joint;                           // one of joint_names(), or a point of the face; empty: `nodes`
    std::vector<std::string> nodes;              // names in skeletons, of which the first that is there is taken
    std::array<double, 3> offset_m = {0, 0, 0};  // to the left, up and forwards in the rest pose
};

struct KeypointSet {
    std::string name;
    std::vector<std::string> names;
    std::vector<std::array<int, 2>> edges;  // from 0
    std::map<std::string, OwnPoint> own;    // by name; the others are joints of this name
};
const KeypointSet &coco_keypoints();  // 17
const KeypointSet &smpl_keypoints();  // 24

// `where` names the text in messages. Throws scenes::Failure with file, line, column and rule.
KeypointSet read_keypoints(const std::string &toml, const std::string &where);
// coco, smpl, or the path of a file. Throws scenes::Failure.
KeypointSet keypoint_set(const std::string &name);

}  // namespace labels

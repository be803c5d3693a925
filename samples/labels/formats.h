// The formats of labels that `claque labels --write` names.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace labels
{

// coco, panoptic, mot, kitti-flow, flo, depth, normals, boxes3d, heads, npz, sheet.
const std::vector<std::string> &format_names();
// Reads "coco,flo". Throws scenes::Failure with the names that there are.
std::set<std::string> read_formats(const std::string &text);

struct FrameFile {
    std::string path;  // within the folder of the labels
    std::string bytes;
};

}  // namespace labels

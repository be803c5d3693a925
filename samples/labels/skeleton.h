// Keypoints of people: the joints that the conventions of Mixamo, VRM, Quaternius, KayKit and claque's own characters
// name, in the order of COCO or SMPL.
#pragma once

#include <claque/claque.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "samples/scenes/library.h"

namespace labels
{

struct KeypointSet {
    std::string name;
    std::vector<std::string> names;
    std::vector<std::array<int, 2>> edges;  // from 0
};
const KeypointSet &coco_keypoints();  // 17
const KeypointSet &smpl_keypoints();  // 24
// Throws scenes::Failure with the names that there are.
const KeypointSet &keypoint_set(const std::string &name);

// Where the keypoints of a set are on one template.
class Skeletons
{
public:
    Skeletons(scenes::Library &library, const KeypointSet &set) : library_(library), set_(set) {}

    struct Place {
        uint32_t node = CLQ_NONE;              // CLQ_NONE: absent
        std::array<double, 3> at = {0, 0, 0};  // in the node's frame
        double below_m = 0;                    // the body's own surface may be so far in front of it
    };
    struct Skeleton {
        std::vector<Place> places;  // by keypoint
        Place head;
        double head_up_m = 1.6;  // of the middle of the head above the lowest vertex, in the rest pose
    };
    const Skeleton &of(const clq_template *tmpl);
    const KeypointSet &set() const { return set_; }

private:
    scenes::Library &library_;
    const KeypointSet &set_;
    std::map<const clq_template *, Skeleton> known_;
};

}  // namespace labels

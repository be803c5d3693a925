// Where the keypoints of a set are on skeletons.
#pragma once

#include <claque/claque.h>

#include <array>
#include <map>
#include <vector>

#include "samples/labels/keypoints.h"
#include "samples/scenes/library.h"

namespace labels
{

class Skeletons
{
public:
    // `set` must live as long.
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

// One run of claque labels.
#pragma once

#include <optional>
#include <set>

#include "samples/cli/track_arguments.h"
#include "samples/labels/keypoints.h"
#include "samples/labels/variation/rules.h"

namespace cli
{

struct LabelArguments {
    SceneArguments setup;
    TrackArguments tracks;  // where the people are those of a file
    std::string out, keypoints = "coco", json, vary;
    std::set<std::string> formats;
    labels::KeypointSet keypoint_set;    // that `keypoints` names
    std::optional<labels::Rules> rules;  // of the file `vary`
    std::vector<int> list;               // of frames
    int chunk = 0, chunk_count = 1;
    double fps = 25;
    int processes = 0;  // 0: one, or as many as a scheduler gave cores
    bool again = false, portable = false;
};

// Throws scenes::Failure.
void label(const LabelArguments &arguments);

}  // namespace cli

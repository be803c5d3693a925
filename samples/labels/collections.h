// Files about all pictures of a folder, made of what each picture says (frame_json.h).
#pragma once

#include "samples/labels/formats.h"
#include "samples/labels/frame_json.h"
#include "samples/labels/skeleton.h"

namespace labels
{

// frames: by number. coco.json, panoptic.json, mot/gt/gt.txt, boxes3d.json and heads.json as the formats say, and
// cameras.json.
std::vector<FrameFile> collections(const std::vector<Json> &frames, const std::set<std::string> &formats,
                                   const KeypointSet &keypoints);

}  // namespace labels

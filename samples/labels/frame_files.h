// The files that each picture has of its own.
#pragma once

#include "samples/labels/formats.h"
#include "samples/labels/sample.h"

namespace labels
{

std::vector<FrameFile> frame_files(const Sample &sample, const std::set<std::string> &formats);

// The zone and the actor of a pixel in one number, for panoptic pictures.
std::string number_of(int frame);  // "000012"

}  // namespace labels

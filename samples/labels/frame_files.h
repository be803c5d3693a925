// The files that each picture has of its own.
#pragma once

#include "samples/labels/formats.h"
#include "samples/labels/sample.h"

namespace labels
{

std::vector<FrameFile> frame_files(const Sample &sample, const std::set<std::string> &formats);

// As names of files have it: "000012".
std::string number_of(int frame);

}  // namespace labels

// Old character formats (Collada, FBX, MD5, X, 3DS, OBJ, Ogre XML and more) to GLB, by Assimp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/convert/child.h"

namespace convert
{

constexpr uint64_t most_picture_bytes = uint64_t(256) << 20;

struct Options {
    char up = 0;          // the axis that is up: x, y or z; 0: what the format says, else y
    double unit_m = 0;    // metres in a unit; 0: what the format says, else 1
    double height_m = 0;  // scales the rest pose to this height instead; 0: as it is
    std::string picture;  // of materials that name no picture, or one that is missing
};

struct Converted {
    std::string glb;
    std::vector<std::string> warnings;
};

// Throws scenes::Failure: one sentence that names the file.
Converted convert_file(const std::string &path, const Options &options, const Limits &limits);

}  // namespace convert

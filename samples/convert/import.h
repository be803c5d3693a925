// What runs in the child: reads a file with Assimp and writes its scene as GLB.
#pragma once

#include "samples/convert/convert.h"

namespace convert
{

// Throws std::exception with what is wrong. May also crash, hang or take any amount of memory.
Converted import_file(const std::string &path, const Options &options);

// The steps that Assimp does after reading. Vertices and nodes of the GLB have the order that these leave.
unsigned import_steps();

}  // namespace convert

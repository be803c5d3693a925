// A sentence about a file that is not there: the files beside it whose names are near. It needs the standard library
// alone, so the samples include it too; libclaque, which opens no files, goes without it.
#pragma once

#include <string>

namespace claque::base
{

// ": 'Soldier.glb' is near", or "". Of a large folder, 4096 files are compared.
std::string near_files(const std::string &path);

}  // namespace claque::base

// What Assimp is known to lose of a file, or to misplace, found in the file's own bytes.
#pragma once

#include <string>
#include <vector>

namespace convert
{

// A sentence for each: skeletons and clips of IQM; geometric transforms and inherited scales of FBX, in both its forms.
// The bytes may be anything.
std::vector<std::string> losses_in(const std::string &bytes);

}  // namespace convert

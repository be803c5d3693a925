// Finds vertices that earlier levels also have. Decimated levels of a chain share vertices, and the motion of a shared
// vertex needs to be examined only once.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "lib/model/template.h"

namespace claque::meshsplit
{

class KnownVertices
{
public:
    // Returns, per source vertex, whether an earlier vertex, of this level or of earlier calls, has the same position
    // and influences. For a level with morph targets all are 0.
    std::vector<uint8_t> among(const model::Level &level);

private:
    std::unordered_set<std::string> seen_;
};

}  // namespace claque::meshsplit

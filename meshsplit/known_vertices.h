// Vertices that levels before had too: near levels of a chain share theirs, and what they do need be looked at once.
#pragma once

#include "lib/model/template.h"

#include <string>
#include <unordered_set>
#include <vector>

namespace claque::meshsplit
{

class KnownVertices
{
public:
    // One a source vertex: whether one that moves in the same way, from the same place, came before, in this level or in those
    // asked for earlier. In a level with morph targets none did.
    std::vector<uint8_t> among(const model::Level &level);

private:
    std::unordered_set<std::string> seen_;
};

}  // namespace claque::meshsplit

// The bytes of each written character; written_characters.h says what they are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/gltf_maker.h"

namespace claque::testing
{

// Names and bytes: a file, then what it needs beside it.
using WrittenFiles = std::vector<std::pair<std::string, Bytes>>;

WrittenFiles written_person();
WrittenFiles written_rigid();
WrittenFiles written_morph();
WrittenFiles written_skins();
WrittenFiles written_sparse();
WrittenFiles written_quantised();
WrittenFiles written_odd();
WrittenFiles written_clips();
WrittenFiles written_lines();
WrittenFiles written_walk();
WrittenFiles written_refused();
Json written_inventory();

}  // namespace claque::testing

// Files whose templates take much, made here.
#pragma once

#include "../asset/maker.h"

namespace claque::testing
{

// A sheet of `count` triangles with a texture; `folded`: all on one another, but for a hair.
Bytes sheet(size_t count, bool folded);
// The same on two nodes that a clip moves, so that proxies are made.
Bytes moving_sheets(size_t count);
// A wavy net of about `count` triangles that share vertices, without normals: few bytes for each triangle. On `nodes`
// nodes beside one another.
Bytes nets(size_t count, size_t nodes);
// A sheet of `count` triangles that names numbers.bin, which holds numbers_beside(count), and picture.png.
Bytes named_files(size_t count);
Bytes numbers_beside(size_t count);

}  // namespace claque::testing

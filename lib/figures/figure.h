// The characters that nobody has to download, made by code: a body from profile tables, dressed, unwrapped, painted in
// three dimensions, bound to one skeleton, with clips of its own. Start-up only; the same bytes on every call.
#pragma once

#include <vector>

#include "lib/model/model.h"

namespace claque::figures
{

// A Roman citizen in a girded tunic: 1.75 m tall (in metres, Y up, facing +Z, standing on y = 0, the origin between
// the feet), about 1040 triangles, 33 nodes, one 512 x 512 image whose alpha holds the keys of eight zones (skin, hair,
// eyes, lips, tunic, belt, border, sandals), and the clips stand, walk, applaud and cheer.
// Throws base::Error, should the made model break a rule of model::check.
model::Model citizen();

struct Builtin {
    const char *name;
    model::Model (*make)();
};
const std::vector<Builtin> &builtins();

}  // namespace claque::figures

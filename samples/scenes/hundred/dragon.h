// The dragon of `hundred_actors` as a template, made through the C API from arrays (S0 6.1, Table 3). Its 40 Skeleton
// nodes have one rigid piece each. It has 80 Internal Bspheres: those of the pieces and those of the nodes, which hold
// everything below them.
#pragma once

#include "samples/scenes/library.h"

namespace scenes::hundred
{

// Lives as long as the library.
clq_template *dragon_of(Library &library);

}  // namespace scenes::hundred

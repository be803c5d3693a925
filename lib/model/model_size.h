// How much memory a Model holds, and how much was read to make it.
#pragma once

#include "lib/model/model.h"

namespace claque::model
{

// The bytes of all arrays of the model.
uint64_t held_bytes(const Model &model);

// Model::source_bytes; for a model that no file made, its own arrays are what was read.
uint64_t source_bytes(const Model &model);

}  // namespace claque::model

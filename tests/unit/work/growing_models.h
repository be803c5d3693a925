// Models with a number of one countable element, and little else.
#pragma once

#include <vector>

#include "lib/model/model.h"

namespace claque::testing
{

// `most` is ten times a number that the element has room for, and within the limits of a template.
struct GrowingModel {
    const char *element;
    model::Model (*make)(uint32_t count);
    uint32_t most;
};

const std::vector<GrowingModel> &growing_models();

// A net of `count` triangles on two joints, in two zones whose border crosses it.
model::Model net_of(uint32_t count);
void add_node(model::Model &model, uint32_t parent);

}  // namespace claque::testing

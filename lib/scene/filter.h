// Which individuals a question is about: by what they show and by the host's categories.
#pragma once

#include "lib/model/template.h"

namespace claque::scene
{

constexpr uint32_t category_count = 64;

struct Filter {
    const model::Template *tmpl = nullptr;         // null: any
    uint32_t texture_set = model::none;            // none: any
    uint32_t level = model::none;                  // shown last; none: any
    uint64_t any_of = 0, all_of = 0, none_of = 0;  // categories as bits; 0: no condition
};

}  // namespace claque::scene

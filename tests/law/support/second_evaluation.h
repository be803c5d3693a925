// A template's level as the reference's own character (tests/reference), which poses and skins it in double precision
// and shares no code with the library.
#pragma once

#include "lib/model/template.h"
#include "tests/reference/gltf_reference.h"

namespace claque::testing_support
{

reference::Character character_of(const model::Template &tmpl, const model::Level &level);

}  // namespace claque::testing_support

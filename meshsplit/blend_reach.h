// How far blended poses reach (S2 3.3): layers may turn every joint as no clip does, so what bounds them are lengths.
#pragma once

#include "lib/model/template.h"

namespace claque::meshsplit
{

// Fills Template::blend_reach and blend_radius; the levels and the Sklsroot Bsphere are there.
void find_blend_reach(model::Template &tmpl);

}  // namespace claque::meshsplit

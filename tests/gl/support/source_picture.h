// The picture of a model as its file gives it: its own triangles, UVs, images and zone keys, drawn plainly. Nothing of
// it comes from the splitter, so that it shows where the splitter is wrong about zones.
#pragma once

#include "lib/model/model.h"
#include "tests/gl/support/pictures.h"

namespace gltest
{

// `posed` is the model split and in some pose: only the places of its vertices are taken from it, for model vertices at
// the same place of the bind pose. Zones have the colours of the template's zones of their names.
Picture draw_source(contexts::Offscreen &context, const model::Model &source, const PosedModel &posed,
                    const Camera &camera, const uint8_t *zone_rgb);

}  // namespace gltest

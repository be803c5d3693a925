// The individual and the zone of each pixel, from a visibility picture (claque/visibility.h): triangle by triangle, by
// none of the renderer's strategies.
#pragma once

#include "samples/scenes/scene_renderer.h"

namespace parity
{

struct IdPictures {
    std::vector<uint32_t> actor;  // index1 a pixel, top row first; 0: background
    std::vector<uint16_t> zone;   // zone + 1
};

// Of the last update, people alone. The picture has at least 8 bits a channel and is drawn over. Throws Failure.
IdPictures id_pictures(scenes::SceneRenderer &scene_renderer);

}  // namespace parity

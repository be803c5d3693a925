// The individual and the zone of each pixel: flat pictures drawn by OpenGL 1.1 from claque's skinned vertices,
// triangle by triangle, without claque's own strategies.
#pragma once

#include "samples/contexts/offscreen.h"
#include "samples/parity/write/drawn_actors.h"

namespace parity
{

struct IdPictures {
    std::vector<uint32_t> actor;  // index1 a pixel, top row first; 0: background
    std::vector<uint16_t> zone;   // zone + 1
};

// The context must be current and have at least 8 bits a channel. OpenGL state is kept, except the picture and the
// matrices. Throws scenes::Failure.
IdPictures id_pictures(const contexts::Offscreen &context, const DrawnActors &drawn_actors, const Skinned &skinned,
                       const float projection[16]);

}  // namespace parity

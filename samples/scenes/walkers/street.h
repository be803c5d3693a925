// A straight street full of citizens, for measurements: on tracks along it, or walking in place where these are.
#pragma once

#include "samples/scenes/scene.h"

namespace scenes::walkers
{

// `crowd_options.count` people, 20 abreast, all in view from 3 m on. Their pace differs by a fifth.
std::unique_ptr<Scene> make_street(Library &library, const CrowdOptions &crowd_options, bool on_tracks);

}  // namespace scenes::walkers

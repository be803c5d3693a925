// What the GPU peer made of a scene, as a result's folder (docs/parity.md).
#pragma once

#include "tests/parity/peer.h"

namespace parity_test
{

// The context, of the scene's size, must be current. scene_folder: where the tables that both have are. Throws.
void write_result(const contexts::Offscreen &context, Peer &peer, const SceneIn &scene, const std::string &scene_folder,
                  const std::string &folder);

}  // namespace parity_test

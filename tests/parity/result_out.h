// The GPU peer's output for a scene, as a result folder (docs/parity.md).
#pragma once

#include "tests/parity/peer.h"

namespace parity_test
{

// The context, of the scene's size, must be current. scene_folder: holds the tables that scene and result share.
// Throws.
void write_result(const contexts::Offscreen &context, Peer &peer, const SceneIn &scene, const std::string &scene_folder,
                  const std::string &folder);

}  // namespace parity_test

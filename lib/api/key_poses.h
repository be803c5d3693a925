// Checks the key-pose settings of a host.
#pragma once

#include <claque/key_poses.h>

#include "animcache/keypose.h"

namespace claque::api
{

// Throws base::Error (CLQ_ARGUMENT).
animcache::KeyPoseSettings settings_of(const clq_key_poses &key_poses, float metres_per_unit);

}  // namespace claque::api

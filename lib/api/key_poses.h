// Checks what a host wants of key-poses.
#pragma once

#include <claque/key_poses.h>

#include "animcache/keypose.h"

namespace claque::api
{

// Throws base::Error (CLQ_ARGUMENT).
animcache::KeyPoseSettings settings_of(const clq_key_poses &key_poses);

}  // namespace claque::api

// Reads a host's camera.
#pragma once

#include <claque/view.h>

#include "lib/frame/view.h"

namespace claque::api
{

frame::Camera camera_of(const clq_camera &camera);  // throws base::Error (CLQ_ARGUMENT)

}  // namespace claque::api

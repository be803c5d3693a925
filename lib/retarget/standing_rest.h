// A file may have been saved in a jump. Its skins then tell the pose in which it was made. Internal to lib/retarget.
#pragma once

#include <optional>

#include "lib/model/rig.h"

namespace claque::retarget
{

// The rig at rest in the pose in which its skins were bound, if it rests above the ground and stands in that pose.
std::optional<model::Rig> standing_rest(const model::Rig &rig);

}  // namespace claque::retarget

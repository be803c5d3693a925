// Actors whose outermost vertices touch their bounding spheres, so that a sphere which is a little too small is seen.
#pragma once

#include "lib/model/model.h"

namespace actors
{

using namespace claque;

// A ball of radius 1 round a node at `centre`, spinning in its only clip.
model::Model ball_model(const glm::vec3 &centre);

// A small ball at the end of an arm of 2 m, which a clip swings half round a shoulder at the origin.
model::Model swing_model();

}  // namespace actors

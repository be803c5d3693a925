// The orders of each tier: senators, knights, citizens, the poor in dark clothes, and women and the poorest on the
// wooden benches, as the laws of Augustus had it (Suetonius, Augustus 44).
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/amphitheatre/plan.h"
#include "samples/scenes/social_classes.h"

namespace scenes::amphitheatre
{

// The kinds of people in a tier, by share.
const std::vector<SocialClass> &orders_of(Tier tier);
// The name of the class that a tier is for.
const char *class_of(Tier tier);

}  // namespace scenes::amphitheatre

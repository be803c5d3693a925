// The light of a clear day in Rome in June, by the hour: where the sun stands, and its colours.
#pragma once

#include "samples/scenes/light.h"

namespace scenes::amphitheatre
{

// hour: local solar time, [5.5, 18.5] while the sun is up enough to see by; others are taken as the nearer of these.
// +x is the end of the long axis that points east by south (azimuth 112.5 degrees), +z that of the short axis that
// points south by west.
Daylight daylight_at(double hour);

}  // namespace scenes::amphitheatre

// Where a person faces, by the names and places of the joints at rest: rigs disagree, and characters face +z.
#pragma once

#include "lib/model/rig.h"

namespace claque::model
{

struct Facing {
    const char *seen = nullptr;  // the joints that say it: "toes", "eyes" or "legs"; null: none does
    double heading_deg = 0;      // about y: 0 is +z, 90 is +x

    bool is_elsewhere() const { return seen && (heading_deg > 45 || heading_deg < -45); }
};

// Feet point ahead, or else eyes lie ahead of the head, or else the left leg is on the left side. A figure without two
// legs that stand on their feet says nothing.
Facing facing_of(const Rig &rig);

// The axis that is nearest to a heading, and the turn about y that brings it to +z: in quarters, or else to a degree.
const char *axis_of(double heading_deg);
double turn_to_front_deg(double heading_deg);

}  // namespace claque::model

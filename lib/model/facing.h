// Where a person faces, by the names and places of the joints: rigs disagree, and characters face +z.
#pragma once

#include <vector>

#include "lib/model/rig.h"

namespace claque::model
{

struct Facing {
    const char *seen = nullptr;  // the joints that say it: "toes", "eyes" or "legs"; null: none does
    double heading_deg = 0;      // about y: 0 is +z, 90 is +x

    bool is_elsewhere() const { return seen && (heading_deg > 45 || heading_deg < -45); }
};

// Feet point ahead, or else eyes lie ahead of the head, or else the left leg is on the left side. The heading is that
// of the hips where these agree with it: files rest in poses in which feet and heads are turned. A figure without two
// legs that stand says nothing. `globals`: the nodes in model space in a pose; without them at rest.
Facing facing_of(const Rig &rig);
Facing facing_of(const Rig &rig, const std::vector<math::Affine> &globals);

// Whether it stands on two legs at rest and has arms.
bool is_person(const Rig &rig);

// The axis that is nearest to a heading, and the quarter turns about y that bring it to +z: files face along an axis,
// and the poses in which they rest are twisted by up to 45 degrees.
const char *axis_of(double heading_deg);
int quarter_of(double heading_deg);  // the number of that axis, [0, 3]
double turn_to_front_deg(double heading_deg);

}  // namespace claque::model

#include "samples/cost/scene.h"

namespace cost
{

Factors factors_of(const Scene &s)
{
    const double actors = s.actors();
    return {actors,
            s.refpoint_within / actors,
            s.root_outside / actors,
            s.root_within / actors,
            s.internal_decided / actors,  // Table 4 takes C3.1 here, not C3
            s.internal_crossing / actors,
            static_cast<double>(s.nodes_per_actor),
            static_cast<double>(s.spheres_per_actor),
            s.nodes_kept};
}

}  // namespace cost

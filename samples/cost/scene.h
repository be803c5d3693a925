// The example scene of S0 6.1: the positions of its actors relative to the frustum from its Tables 2 and 3, and the
// factors of Table 4 that follow from them.
#pragma once

namespace cost
{

// Tables 2 and 3. Numbers of actors by the position of their spheres relative to the frustum.
struct Scene {
    int outside = 20;           // A: Refpoint Bsphere outside
    int refpoint_within = 30;   // B: Refpoint Bsphere within
    int root_outside = 20;      // C1: Refpoint Bsphere on the edge, Sklsroot Bsphere outside
    int root_within = 20;       // C2: Sklsroot Bsphere within
    int internal_decided = 8;   // C3.1: Sklsroot Bsphere on the edge, Internal Bspheres all outside or all within
    int internal_crossing = 2;  // C3.2: Internal Bspheres on the edge
    int nodes_per_actor = 40, spheres_per_actor = 80;
    double nodes_kept = 0.5;  // by skeletal level of detail (S0 5.2)

    int root_crossing() const { return internal_decided + internal_crossing; }                // C3
    int refpoint_crossing() const { return root_outside + root_within + root_crossing(); }    // C
    int actors() const { return outside + refpoint_within + refpoint_crossing(); }            // A + B + C
    int pass_first_cull() const { return refpoint_within + refpoint_crossing(); }             // S0 4.2, step 2
    int pass_second_cull() const { return refpoint_within + root_within + root_crossing(); }  // S0 4.2, step 4
};

// Table 4: ratios are of the number of actors.
struct Factors {
    double actors, refpoint_in, root_out, root_in, root_crossing, check_internal;
    double nodes_per_actor, spheres_per_actor, nodes_kept;
};

Factors factors_of(const Scene &scene);

}  // namespace cost

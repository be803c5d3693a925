// What some actors have beside their columns: attached objects, callbacks round their drawing, the ground under them; and
// how far an actor reaches with all of it (S0 4.1, 4.3, 7.1).
#pragma once

#include <claque/crowd.h>

#include "lib/model/template.h"

namespace claque::crowd
{

// What culling asks of one actor beside its place. Radii at scale 1.
struct Extent {
    float refpoint = 0;  // round the Reference Point, wherever its Skeleton Root goes and however it is turned
    float sklsroot = 0;  // round the template's Sklsroot centre
    float slack = 0;     // world units: how far the ground may take it
    float priority = 0;  // [0, 1] S0 5
};

// An object of the scene that an actor holds (S0 4.3): claque knows its sphere alone.
struct Attachment {
    uint32_t row = model::none;  // none: free, chained through `next`
    uint32_t next = model::none;
    uint32_t generation = 0;  // odd while it is there
    uint32_t node = 0;
    model::Sphere sphere;  // in the node's frame
};

struct Extra {
    clq_actor_hooks hooks = {nullptr, nullptr, nullptr};
    uint32_t first_attached = model::none;
    float max_up = 0, max_down = 0;  // world units
    uint32_t next_free = model::none;
};

// How far from the template's Sklsroot centre what is attached may come, at scale 1. Without node_reach (a template that
// knows none) as far as a sphere of the skeleton and the object can lie apart.
float reach_of(const model::Template &tmpl, const Attachment &attached);

// How far from there any vertex comes where clips are blended and the weights of differences that are added sum to
// `added`. A template without blend_reach was made by hand: nothing is known but that joints turn.
float blended_reach_of(const model::Template &tmpl, float added);

}  // namespace claque::crowd

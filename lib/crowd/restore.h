// The parts of restoring a crowd, in the order of the bytes. State that a public call can set is set by that call,
// which checks it; all other state is checked here. Throws base::Error (CLQ_FORMAT; CLQ_ARGUMENT if a call refuses).
#pragma once

#include "lib/crowd/save_rows.h"

namespace claque::crowd
{

// Something that the host has to supply and did not: no fault of the bytes.
class Missing : public base::Error
{
public:
    using base::Error::Error;
};

const model::Template *template_at(const Tables &tables, uint32_t index);  // throws if there is none

void read_behaviours(Reader &in, Resolver &resolver, Tables &out);  // mechanisms and paths
void read_layers(Reader &in, Tables &out);                          // gaits and masks
void read_actors(Reader &in, Crowd &out);
void read_uses(Reader &in, Crowd &out, uint32_t row);         // root path, mechanisms and commands of an actor
void read_layer_state(Reader &in, Crowd &out, uint32_t row);  // fades and layers of an actor, and whether it is watched

}  // namespace claque::crowd

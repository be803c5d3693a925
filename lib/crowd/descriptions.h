// The descriptions that many actors of a crowd share, one by one, as bytes: for a saved crowd and for a recorded call
// that adds one. Templates are named by their number in Tables::templates.
#pragma once

#include "lib/crowd/save.h"

namespace claque::crowd
{

void write_mechanism(Writer &out, const Tables &tables, uint32_t index);
void write_path(Writer &out, const Tables &tables, uint32_t index);
void write_gait(Writer &out, const Tables &tables, uint32_t index);
void write_mask(Writer &out, const Tables &tables, uint32_t index);

// Each checks the description and adds it, or throws base::Error (CLQ_FORMAT; CLQ_ARGUMENT for a broken rule of a
// public call, and from the resolver) or std::bad_alloc and changes nothing.
void read_mechanism(Reader &in, Resolver &resolver, Tables &out);
void read_path(Reader &in, Resolver &resolver, Tables &out);
void read_gait(Reader &in, Tables &out);
void read_mask(Reader &in, Tables &out);

}  // namespace claque::crowd

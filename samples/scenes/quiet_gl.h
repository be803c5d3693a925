// A context's functions, with a glDrawElements that can be told to do nothing. The rest of a draw is claque's own
// work.
#pragma once

#include "samples/contexts/offscreen.h"

namespace scenes
{

// Like Offscreen::get_proc_address(), with the Offscreen as `user`. With several contexts, glDrawElements is that of
// the last one asked.
contexts::GlFunction quiet_proc_address(void *user, const char *name);

// Applies from now on to all functions that came from here.
void quieten(bool quiet);

}  // namespace scenes

// A context's functions, but for one: glDrawElements can be told to do nothing. What a draw then takes is claque's alone.
#pragma once

#include "samples/contexts/offscreen.h"

namespace scenes
{

// As Offscreen::get_proc_address(), `user` being the Offscreen. Of several contexts the one asked last is drawn in.
contexts::GlFunction quiet_proc_address(void *user, const char *name);

// From now on, for everybody whose functions came from here.
void quieten(bool quiet);

}  // namespace scenes

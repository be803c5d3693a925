// The scene that a window shows, made from what the command line and dropped files ask for.
#pragma once

#include "samples/cli/view_files.h"
#include "samples/view/view.h"

namespace cli
{

// Whether the people of --characters stand side by side, as nothing else is shown.
bool lines_up(const ViewWhat &what);

// Throws scenes::Failure.
view::Opened open_view(const ViewWhat &what, scenes::Library &library);

// What a dropped file shows (docs/view.md), after `what` and the files that were dropped before it.
view::Drop view_drops(const ViewWhat &what);

}  // namespace cli

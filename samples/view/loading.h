// A window while what it shows is loaded.
#pragma once

#include <optional>

#include "samples/view/view.h"

namespace view
{

// Loads in another thread, and says meanwhile in the window for how long. Nothing: the window was closed, and loading
// has ended. Throws scenes::Failure.
std::optional<Loaded> load_in(Window &window, const Request &request);

}  // namespace view

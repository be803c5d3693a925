// A window without a screen, which viewers open over VNC.
#pragma once

#include <functional>

#include "samples/view/serve/options.h"
#include "samples/view/surface.h"

namespace view::serve
{

// `say` gets what a person needs to connect: the address, the password, a command. Throws scenes::Failure; also, with
// the package's name, where the view was built without LibVNCServer.
std::unique_ptr<Window> open_window(const Options &options, const std::string &title, contexts::Kind context, int width,
                                    int height, const std::function<void(const std::string &)> &say);

}  // namespace view::serve

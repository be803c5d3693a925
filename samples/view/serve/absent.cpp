// In place of serving, where LibVNCServer was not found.
#include "samples/scenes/check.h"
#include "samples/view/serve/window.h"

namespace view::serve
{

std::unique_ptr<Window> open_window(const Options &, const std::string &, contexts::Kind, int, int,
                                    const std::function<void(const std::string &)> &)
{
    throw scenes::Failure(
        "this claque was built without --serve, which needs LibVNCServer: install libvncserver-dev, and build it "
        "again");
}

}  // namespace view::serve

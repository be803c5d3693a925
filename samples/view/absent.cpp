// In place of the view, where Dear ImGui or SDL2 were not found.
#include "samples/view/view.h"

namespace view
{

void run(const Request &)
{
    throw scenes::Failure(
        "this claque was built without its window, which needs Dear ImGui and SDL2: install libimgui-dev and "
        "libsdl2-dev, and build it again");
}

}  // namespace view

#include "samples/scenes/quiet_gl.h"

#include <cstring>

namespace scenes
{
namespace
{

using DrawElements = void (*)(unsigned mode, int count, unsigned type, const void *indices);

DrawElements real = nullptr;
bool is_quiet = false;

void draw_elements(unsigned mode, int count, unsigned type, const void *indices)
{
    if (!is_quiet) real(mode, count, type, indices);
}

}  // namespace

contexts::GlFunction quiet_proc_address(void *user, const char *name)
{
    const contexts::Offscreen &offscreen = *static_cast<const contexts::Offscreen *>(user);
    const contexts::GlFunction function = offscreen.get_proc_address()(offscreen.user(), name);
    if (!function || std::strcmp(name, "glDrawElements") != 0) return function;
    real = reinterpret_cast<DrawElements>(function);
    return reinterpret_cast<contexts::GlFunction>(draw_elements);
}

void quieten(bool quiet) { is_quiet = quiet; }

}  // namespace scenes

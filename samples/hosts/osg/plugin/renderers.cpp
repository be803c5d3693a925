#include "samples/hosts/osg/plugin/renderers.h"

#include <osg/GLExtensions>

namespace osg_plugin
{

clq_gl_function get_gl_function(void *, const char *name)
{
    return reinterpret_cast<clq_gl_function>(osg::getGLExtensionFuncPtr(name));
}

// Of contexts that ended without notice.
void Renderers::forget_ended()
{
    for (auto one = entries_.begin(); one != entries_.end();) {
        if (one->second.state.valid()) {
            ++one;
            continue;
        }
        clq_renderer_abandon(one->second.renderer);
        one = entries_.erase(one);
    }
}

clq_renderer *Renderers::of(osg::State &state)
{
    const auto found = entries_.find(&state);
    if (found != entries_.end() && found->second.state.valid()) return found->second.renderer;
    forget_ended();
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = get_gl_function;
    clq_renderer *made = nullptr;
    scenes::check(clq_renderer_create(context_, &def, &made));
    entries_[&state] = {&state, made};
    return made;
}

void Renderers::release(osg::State &state)
{
    const auto found = entries_.find(&state);
    if (found == entries_.end() || !found->second.state.valid()) return;
    clq_renderer_destroy(found->second.renderer);
    entries_.erase(found);
}

}  // namespace osg_plugin

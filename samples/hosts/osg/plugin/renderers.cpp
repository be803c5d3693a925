#include "samples/hosts/osg/plugin/renderers.h"

#include <osg/GLExtensions>

namespace osg_plugin
{

clq_gl_function get_gl_function(void *, const char *name)
{
    return reinterpret_cast<clq_gl_function>(osg::getGLExtensionFuncPtr(name));
}

Renderers::~Renderers()
{
    for (auto &[number, entry] : entries_) clq_renderer_abandon(entry.renderer);  // no context is current here
}

clq_renderer *Renderers::of(osg::State &state)
{
    const auto found = entries_.find(state.getContextID());
    if (found != entries_.end()) {
        if (found->second.state.get() == &state) return found->second.renderer;
        clq_renderer_abandon(found->second.renderer);  // its context ended without notice, and another has its number
        entries_.erase(found);
    }
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = get_gl_function;
    clq_renderer *made = nullptr;
    scenes::check(clq_renderer_create(context_, &def, &made));
    entries_[state.getContextID()] = {&state, made};
    return made;
}

void Renderers::release(osg::State &state)
{
    const auto found = entries_.find(state.getContextID());
    if (found == entries_.end() || found->second.state.get() != &state) return;
    clq_renderer_destroy(found->second.renderer);
    entries_.erase(found);
}

}  // namespace osg_plugin

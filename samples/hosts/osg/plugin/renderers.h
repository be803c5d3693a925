// One clq_renderer for each GL context that OSG draws in, which its osg::State stands for: contexts that share textures
// have one number. The functions are called in draws, with their context current.
#pragma once

#include <map>

#include <osg/State>
#include <osg/observer_ptr>

#include "samples/scenes/check.h"

namespace osg_plugin
{

// For clq_renderer_def.get_proc_address and scenes::load.
clq_gl_function get_gl_function(void *, const char *name);

class Renderers
{
public:
    explicit Renderers(clq_context *context) : context_(context) {}

    // The renderer of the current context, which draws with this state. Throws scenes::Failure.
    clq_renderer *of(osg::State &state);
    // The context of this state ends, and is current.
    void release(osg::State &state);

private:
    struct Entry {
        osg::observer_ptr<osg::State> state;  // none where another one may be at its address
        clq_renderer *renderer;
    };
    void forget_ended();

    clq_context *context_;
    std::map<const osg::State *, Entry> entries_;
};

}  // namespace osg_plugin

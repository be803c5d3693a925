#include <claque/assets.h>
#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>
#include <claque/stage.h>

/* Twice, so that guards are tried as well. */
#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>

unsigned long clq_headers_compile(void);
unsigned long clq_headers_compile(void)
{
    const clq_context_def context = clq_context_def_init();
    const clq_template_def tmpl = clq_template_def_init();
    const clq_crowd_def crowd = clq_crowd_def_init();
    const clq_actor_def actor = clq_actor_def_init();
    const clq_renderer_def renderer = clq_renderer_def_init();
    const clq_asset_options options = clq_asset_options_init();
    return (unsigned long)context.struct_bytes + tmpl.struct_bytes + crowd.struct_bytes + actor.struct_bytes +
           renderer.struct_bytes + options.struct_bytes;
}

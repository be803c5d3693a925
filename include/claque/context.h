/* clq_context: the services that a host lends to claque. Templates, crowds, colour maps, renderers, locomotions, tracks
 * and records are made from a context and must be destroyed before it. Assets, trajectories and areas
 * (libclaque-assets) use a context during calls only.
 *
 * libclaque reads one variable of the environment, CLAQUE_SIMD (claque/simd.h). libclaque-assets also reads
 * XDG_CACHE_HOME and HOME, in clq_template_prepare, clq_template_load_gltf and clq_template_builtin. */
#ifndef CLAQUE_CONTEXT_H
#define CLAQUE_CONTEXT_H

#include <claque/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_context clq_context;

typedef struct clq_context_def {
    uint32_t struct_bytes; /* set by clq_context_def_init */
    /* Supplies all memory that claque keeps at run time. All zero: malloc and free. */
    clq_allocator allocator;
    /* All zero: notes and warnings are dropped. */
    clq_log log;
    /* Share the work of updates, of template builds and of making levels of detail. All zero: the calling thread does
     * all work. */
    clq_tasks tasks;
} clq_context_def;

CLQ_DEFINE_ZERO_INIT(clq_context_def)

/* Creates a context.
 *   def   copied; NULL means clq_context_def_init()
 *   out   owned by the host until clq_context_destroy
 * Fails: STRUCT_SIZE, ARGUMENT (an allocator with one function of two), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_context_create(const clq_context_def *def, clq_context **out);

/* Destroys a context; NULL is ignored.
 * Fails: IN_USE while something that was made from it exists; the context then stays. Threads: no other call may use
 * the context at the same time. GL: none. */
CLQ_API clq_status clq_context_destroy(clq_context *context);

/* For libraries and bindings on top of claque: writes a sentence to the context's log; without a log, does nothing.
 *   context, text   NULL: the call does nothing
 * Threads: any. GL: none. */
CLQ_API void clq_context_log(clq_context *context, clq_log_level level, const char *text);

/* For libraries and bindings on top of claque: calls job(job_data, i) once for each i in [0, count), in any order, on
 * the context's tasks or, without tasks, on this thread. Returns when all calls have returned. A job must not call this
 * function.
 *   context   NULL: without tasks
 *   job       NULL: the call does nothing
 * Fails: CALLBACK (a job threw an exception: the text names its index, the lowest of several; all others ran).
 * Threads: any. GL: none. */
CLQ_API clq_status clq_context_run(clq_context *context, uint32_t count, void (*job)(void *job_data, uint32_t index),
                                   void *job_data);

#ifdef __cplusplus
}
#endif

#endif

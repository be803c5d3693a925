/* clq_context: what a host lends to claque. Everything else is made from one and must be gone before it goes.
 *
 * Skinning uses the widest vectors that the processor has. The environment may say less, for measuring: CLAQUE_SIMD is
 * scalar, 128 or 256, read once. All give the same bits. Nothing else of the environment is read. */
#ifndef CLAQUE_CONTEXT_H
#define CLAQUE_CONTEXT_H

#include <claque/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_context clq_context;

typedef struct clq_context_def {
    uint32_t struct_bytes;   /* set by clq_context_def_init */
    clq_allocator allocator; /* zero: malloc and free. What claque keeps at run time comes from here */
    clq_log log;             /* zero: silence */
    clq_tasks tasks;         /* zero: everything on the calling thread. Updates are spread over them, and what is done
                                before: levels of detail, splitting, spheres */
} clq_context_def;

static inline clq_context_def clq_context_def_init(void)
{
    clq_context_def def;
    def.struct_bytes = (uint32_t)sizeof(clq_context_def);
    def.allocator.user = NULL;
    def.allocator.allocate = NULL;
    def.allocator.release = NULL;
    def.log.user = NULL;
    def.log.write = NULL;
    def.tasks.user = NULL;
    def.tasks.run = NULL;
    return def;
}

/* Makes a context.
 *   def     copied; NULL means clq_context_def_init()
 *   out     [owner: host, until clq_context_destroy]
 * Fails: STRUCT_SIZE, ARGUMENT (half an allocator), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_context_create(const clq_context_def *def, clq_context **out);

/* Ends a context; NULL is ignored.
 * Fails: IN_USE while a template, crowd or renderer made from it exists; it then lives on. Threads: no other call on
 * it. */
CLQ_API clq_status clq_context_destroy(clq_context *context);

/* For libraries and bindings built on claque: writes one sentence to the context's log, if it has one. Threads: any. */
CLQ_API void clq_context_log(clq_context *context, clq_log_level level, const char *text);

/* For the same: calls job(job_data, i) once for each i in [0, count), in any order, on the context's tasks or, where it has
 * none, here; returns when all are done. No job may throw or call it. Threads: any. */
CLQ_API void clq_context_run(clq_context *context, uint32_t count, void (*job)(void *job_data, uint32_t index),
                             void *job_data);

#ifdef __cplusplus
}
#endif

#endif

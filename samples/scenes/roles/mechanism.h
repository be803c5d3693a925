/* A control mechanism of your own for `claque view` and for scenarios: a shared object that exports
 *
 *     CLAQUE_MECHANISM_EXPORT const claque_mechanism *claque_mechanism_v1(void);
 *
 * It needs neither libclaque nor a linker's help: what it calls, it gets as arguments. samples/examples/nod.c is one.
 * The view asks for degrees of freedom by name through `find`, so one mechanism can serve several characters. */
#ifndef CLAQUE_SAMPLES_MECHANISM_H
#define CLAQUE_SAMPLES_MECHANISM_H

#include <claque/behave.h>

#ifdef __cplusplus
extern "C" {
#endif

/* clq_dof_write, and clq_template_find_dof. */
typedef void (*claque_write_dof)(clq_dof_writer *writer, uint32_t dof, float value, float weight);
typedef uint32_t (*claque_find_dof)(const clq_template *tmpl, const char *name);

typedef struct claque_mechanism {
    uint32_t struct_bytes; /* sizeof(claque_mechanism) */
    const char *name;      /* for people; lives as long as the object is loaded */
    bool has_memory;       /* as in clq_host_mechanism_def */
    /* Called once for each template that uses it. Returns what `run` gets as its first argument, or NULL if it has
     * nothing to move in this template: it is then refused with the sentence in *why, which lives as long as the
     * object. */
    void *(*open)(const clq_template *tmpl, claque_find_dof find, const char **why);
    /* As clq_host_mechanism_def.run; of claque it calls nothing but `write`. */
    void (*run)(void *opened, const clq_behaviour_call *call, clq_dof_writer *writer, claque_write_dof write);
    void (*close)(void *opened);
} claque_mechanism;

typedef const claque_mechanism *(*claque_mechanism_entry)(void);
#ifdef __GNUC__
#define CLAQUE_MECHANISM_EXPORT __attribute__((visibility("default")))
#else
#define CLAQUE_MECHANISM_EXPORT
#endif
#define CLAQUE_MECHANISM_ENTRY "claque_mechanism_v1"

#ifdef __cplusplus
}
#endif

#endif

/* Templates that are prepared once and kept on disk (libclaque-assets): the second start takes milliseconds. What lies
 * there is found by what it was made from, what was asked for and the version of the library, so that nothing stale is
 * ever used; a file that is cut off or changed is made anew. Files may be deleted at any time. */
#ifndef CLAQUE_PREPARE_H
#define CLAQUE_PREPARE_H

#include <claque/levels.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_prepare_def {
    uint32_t struct_bytes; /* set by clq_prepare_def_init */
    /* Exactly one of the two. A glTF's external files count as part of it. */
    const char *builtin;              /* of clq_asset_builtin */
    const char *path;                 /* of clq_asset_load_file */
    uint32_t clip_count;              /* of clq_asset_builtin_varied; 0: a built-in's own clips */
    const clq_asset_options *options; /* with path; NULL: defaults */
    const clq_levels_def *levels;     /* NULL: no levels of detail but the character's own */
    uint32_t max_texture_px;          /* of clq_asset_build */
    /* Where files are kept, made where it is not there. NULL: $XDG_CACHE_HOME/claque or ~/.cache/claque. "": nowhere,
     * everything is made anew. */
    const char *folder;
} clq_prepare_def;

static inline clq_prepare_def clq_prepare_def_init(void)
{
    clq_prepare_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.builtin = NULL;
    def.path = NULL;
    def.clip_count = 0;
    def.options = NULL;
    def.levels = NULL;
    def.max_texture_px = 0;
    def.folder = NULL;
    return def;
}

typedef struct clq_prepare_report {
    int32_t from_disk; /* 1: it was there */
    int32_t stored;    /* 1: it was made, and is there now; 0 with from_disk 0: see text */
    char text[256];    /* "" or why it could not be kept: a folder that may not be written is no failure */
} clq_prepare_report;

/* Loads or makes the character, its levels and its template, or takes what an earlier call made. Several programs may do
 * so at once: a file appears whole or not at all. Warnings of the character's file are logged when it is read, not when
 * its template comes from disk.
 *   out      [owner: host, until clq_template_destroy]
 *   report   may be NULL
 * Fails: STRUCT_SIZE, ARGUMENT, and as clq_asset_load_file, clq_asset_builtin_varied, clq_asset_make_levels and
 * clq_asset_build do. Threads: any. GL: none. */
CLQ_API clq_status clq_template_prepare(clq_context *context, const clq_prepare_def *def, clq_template **out,
                                        clq_prepare_report *report);

#ifdef __cplusplus
}
#endif

#endif

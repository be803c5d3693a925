/* Templates that are prepared once and kept on disk (libclaque-assets), so that later starts take milliseconds. A
 * prepared file is found by a hash of what it was made from: the character's files, the options, zone maps to the last
 * texel, and the sources of the library itself. So a stale file is never used. A file that is cut off or changed is
 * made again. Files may be deleted at any time. */
#ifndef CLAQUE_PREPARE_H
#define CLAQUE_PREPARE_H

#include <claque/levels.h>
#include <claque/zones.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_prepare_def {
    uint32_t struct_bytes; /* set by clq_prepare_def_init */
    /* Exactly one of builtin and path is given. External files of a glTF file count as part of it. */
    const char *builtin;              /* as in clq_asset_builtin */
    const char *path;                 /* as in clq_asset_load_file */
    uint32_t clip_count;              /* with builtin, as in clq_asset_builtin_varied; 0: the character's own clips */
    const clq_asset_options *options; /* with path; NULL: defaults */
    const clq_levels_def *levels;     /* NULL: only the character's own levels of detail */
    uint32_t max_texture_px;          /* as in clq_asset_build */
    /* The folder of prepared files, which is made with mode 0700 if it is missing. It must belong to the user that runs
     * the program, and no other user may write it. A file in it is not read if it is a link, or if another user owns it
     * or may write it.
     * NULL: $XDG_CACHE_HOME/claque, else $HOME/.cache/claque, else none; a built-in character comes from the folder
     * that was installed with the library, if it is there. "": no folder. Without a folder the template is made anew.
     *
     * The installed folder, share/claque/people, is found from the absolute path of the libclaque-assets.so that is
     * loaded; a program that links the library statically has none. It is only read. The folder and its files belong to
     * root or to the owner of the library, and no other user may write them. A file that breaks this rule, a link, a
     * damaged file and a file of another build are passed over, and a warning in the log names it and the reason. */
    const char *folder;
    const clq_asset_dof *dofs; /* [dof_count] added as by clq_asset_add_dofs, before levels are made */
    uint32_t dof_count;
    /* [zone_map_count] given to clq_asset_set_zone_map, in order, before levels are made */
    const clq_zone_map_def *const *zone_maps;
    uint32_t zone_map_count;
} clq_prepare_def;

CLQ_DEFINE_ZERO_INIT(clq_prepare_def)

typedef struct clq_prepare_report {
    uint32_t struct_bytes; /* set by clq_prepare_report_init */
    bool from_disk;        /* the template was loaded from the folder, or from the installed one */
    bool stored;           /* the template was made and stored in the folder */
    char text[256];        /* why it was made and not stored, which is no failure; else "" */
} clq_prepare_report;

CLQ_DEFINE_ZERO_INIT(clq_prepare_report)

/* Loads a prepared template, or makes the character, its levels and its template and stores it. Several programs may do
 * so at once: a file appears whole or not at all. Warnings of the character's file are logged when it is read, not when
 * the template comes from disk.
 *   out          owned by the host until clq_template_destroy
 *   out_report   made by clq_prepare_report_init; may be NULL
 * Fails: STRUCT_SIZE, ARGUMENT, and as clq_asset_load_file, clq_asset_builtin_varied, clq_asset_add_dofs,
 * clq_asset_set_zone_map, clq_asset_make_levels and clq_asset_build. Threads: any. GL: none. */
CLQ_API clq_status clq_template_prepare(clq_context *context, const clq_prepare_def *def, clq_template **out,
                                        clq_prepare_report *out_report);

#ifdef __cplusplus
}
#endif

#endif

/* Save and restore of a crowd's state, so that a host can record and replay.
 *
 * A saved crowd holds everything that a host has set in it: actors, groups and attached objects with their ids, which are
 * valid again after restoring (and stale where they were stale); templates by name; places, clips, colours, priorities;
 * mechanisms, root paths and their numbers, uses, commands; the seed. A restored crowd shows what the saved one showed at
 * the same time, and answers the same calls with the same ids.
 *
 * It does not hold what a host lends: see clq_crowd_restore. Nor what was chosen in clq_crowd_def but for the seed (caches,
 * periods, culling, level of detail), nor views: these are about seeing, and stay those of the crowd that is restored.
 * With lod_hysteresis what is shown has a memory, which is not saved. */
#ifndef CLAQUE_SAVE_H
#define CLAQUE_SAVE_H

#include <claque/behave.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Writes a crowd's state: the same bytes for the same state, on every machine. It asks for no memory.
 *   write   called in order with pieces of the file; returns 0 on success, anything else stops with IO. May call nothing
 *           of claque for this crowd
 * Fails: ARGUMENT (NULL), IO, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_save(const clq_crowd *crowd,
                                  int (*write)(void *user, const void *bytes, size_t size_bytes), void *user);

/* Replaces a crowd's whole state by what clq_crowd_save wrote, in this crowd at an earlier time or in another one. The
 * bytes may be anything: a file that is cut, changed or of another version is FORMAT, with a sentence.
 *   bytes       [size_bytes], not kept
 *   templates   [template_count] each once: among them, for every template that the saved crowd had ever used, one of the
 *               same name and structure (nodes, degrees of freedom, clips, zones, levels); its paint may differ. Those that
 *               are used are held until the crowd goes; the order is no matter but between templates that are alike
 * What a host lends stays as it is in this crowd: the ground; hooks, of actors whose id is in both states; callbacks of
 * host mechanisms, of the same number. So where the saved crowd had a mechanism of the host's, this one must have one of
 * that number already: a new crowd is set up as the saved one was, and then restored.
 * Views stay, with what the last update put in them.
 * Fails: ARGUMENT (NULL; a template that is missing, by name; a host's mechanism that is missing, by number), FORMAT,
 * OUT_OF_MEMORY, BUSY; the crowd is then as it was. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_restore(clq_crowd *crowd, const void *bytes, size_t size_bytes,
                                     clq_template *const *templates, uint32_t template_count);

#ifdef __cplusplus
}
#endif

#endif

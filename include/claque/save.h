/* Saving and restoring the state of a crowd, so that a host can record and replay it.
 *
 * A saved state contains everything that the host has set in the crowd: actors, groups and attachments with their ids;
 * the names of templates; transforms, clips, colours and priorities; mechanisms and root paths with their numbers, and
 * which actors use them; commands; the seed. Ids are valid (or stale) after restoring as they were when saved. A
 * restored crowd shows at any time what the saved crowd showed at that time, and answers the same calls with the same
 * ids.
 *
 * A saved state does not contain the services that the host lends (see clq_crowd_restore), the settings of
 * clq_crowd_def other than the seed (caches, periods, culling, level of detail), or views. The restoring crowd keeps
 * its own. With clq_crowd_def.lod_hysteresis the shown level depends on earlier updates; that memory is not saved. */
#ifndef CLAQUE_SAVE_H
#define CLAQUE_SAVE_H

#include <claque/behave.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the state of a crowd. Equal states give equal bytes on every machine. The call allocates no memory.
 *   write   gets the pieces of the file; must not call claque for this crowd
 * Fails: ARGUMENT (NULL), IO, BUSY, CALLBACK. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_save(const clq_crowd *crowd, clq_write_function write, void *user);

/* Replaces the whole state of a crowd by one that clq_crowd_save wrote, from this crowd or from another one. The bytes
 * may be anything: a file that is cut off, changed, of another version or of no state of a crowd fails with FORMAT.
 *   bytes       [size_bytes], not kept
 *   templates   [template_count], each once. For every template that the saved crowd ever used they must contain one of
 *               the same name and structure (nodes, degrees of freedom, clips, zones, levels); textures may differ. The
 *               crowd holds those that it uses until it is destroyed. The order matters only between templates of equal
 *               name and structure.
 * This crowd keeps the services that the host lends: the ground; hooks of actors whose id is in both states; callbacks
 * of host mechanisms of the same number. Where the saved crowd has a host mechanism, this crowd must already have one
 * of the same number; so add a new crowd's mechanisms as in the saved crowd before restoring. Views stay, with the draw
 * lists of the last update.
 * Fails: ARGUMENT (NULL; a missing template, by name; a missing track, by hash; a missing host mechanism, by number),
 * FORMAT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_restore(clq_crowd *crowd, const void *bytes, size_t size_bytes,
                                     clq_template *const *templates, uint32_t template_count);

#ifdef __cplusplus
}
#endif

#endif

/* Colour maps as files, of libclaque-assets: what designers write and hosts load. */
#ifndef CLAQUE_COLOUR_FILES_H
#define CLAQUE_COLOUR_FILES_H

#include <claque/colours.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Colour maps in TOML (S2 5.2: HSB maps are loaded, modified and saved):
 *   [[classes]]
 *   name = "decurions"
 *   template = "decurion"          who wears them; may be left out
 *   [classes.zones]
 *   tunic = { hue = [190, 290], saturation = [0.4, 0.8], brightness = [0.5, 0.7], colour_space = "oklab" }
 *   hair = { palette = [ { colour = "#2a1a10", weight = 3 },
 *                        { hue = [0, 360], saturation = [0, 0.08], brightness = [0.5, 0.8] } ] }
 *   belt = { linked_to = "sandals", variation = 0.1 }
 * with the members and limits of clq_colour_class, clq_zone_colours and clq_palette_entry; colour_space is "hsb" where nothing is said, a
 * weight 1. A key that is not known is refused.
 *
 * To change colours while a program runs: load again when the file has changed, and draw from the new map if that went well;
 * a file that is broken leaves the old map and its colours as they were.
 *   name   of the file, for sentences; NULL: "the colour map"
 *   out    [owner: host, until clq_colour_map_destroy]
 * Fail: ARGUMENT, FORMAT (line, column, and the rule that is broken), LIMIT (more than 4 MiB), IO, OUT_OF_MEMORY.
 * Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_load(clq_context *context, const void *bytes, size_t size_bytes, const char *name,
                                       clq_colour_map **out);
CLQ_API clq_status clq_colour_map_load_file(clq_context *context, const char *path, clq_colour_map **out);

/* Writes a map as TOML: the same bytes for the same map, and the same again when they are loaded and saved. Comments of a
 * file that was loaded are not part of its map.
 *   write   called in order with pieces of the file; returns 0 on success, anything else stops with IO
 * Fails: ARGUMENT (NULL; a name that is no UTF-8), IO, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_save(const clq_colour_map *map,
                                       int (*write)(void *user, const void *bytes, size_t size_bytes), void *user);

#ifdef __cplusplus
}
#endif

#endif

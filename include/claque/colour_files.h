/* Colour maps as TOML files, written by designers and loaded by hosts (libclaque-assets). */
#ifndef CLAQUE_COLOUR_FILES_H
#define CLAQUE_COLOUR_FILES_H

#include <claque/colours.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Load a colour map (S2 5.2: HSB maps are loaded, modified and saved). The file has the members and limits of
 * clq_colour_class, clq_zone_colours and clq_palette_entry:
 *   [[classes]]
 *   name = "decurions"
 *   template = "decurion"          # may be left out
 *   [classes.zones]
 *   tunic = { hue = [190, 290], saturation = [0.4, 0.8], brightness = [0.5, 0.7], colour_space = "oklab" }
 *   hair = { palette = [ { colour = "#2a1a10", weight = 3 },
 *                        { hue = [0, 360], saturation = [0, 0.08], brightness = [0.5, 0.8] } ] }
 *   belt = { linked_to = "sandals", variation = 0.1 }
 * colour_space is "hsb" and a weight is 1 by default. An unknown key is refused.
 *
 * To change colours at run time, load the file again when it has changed, and sample from the new map on success. A
 * broken file leaves the old map and its colours as they were.
 *   name   of the file, for messages; NULL: "the colour map"
 *   out    owned by the host until clq_colour_map_destroy
 * Fail: ARGUMENT, FORMAT (line, column and the broken rule), LIMIT (4 MiB, 16 parts of a key), IO, OUT_OF_MEMORY.
 * Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_load(clq_context *context, const void *bytes, size_t size_bytes, const char *name,
                                       clq_colour_map **out);
CLQ_API clq_status clq_colour_map_load_file(clq_context *context, const char *path, clq_colour_map **out);

/* Writes a map as TOML. Equal maps give equal bytes, also after loading and saving. Comments of a loaded file are not
 * part of its map.
 * Fails: ARGUMENT (NULL; a name that is not UTF-8), IO, CALLBACK, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_save(const clq_colour_map *map, clq_write_function write, void *user);

#ifdef __cplusplus
}
#endif

#endif

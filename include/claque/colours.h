/* clq_colour_map: what the colours of individuals are drawn from (S2 5): for each social class and each zone of its
 * template a hue, a saturation and a brightness range, or several with weights.
 *
 * A colour is a function of the map, the template, the crowd's seed, the actor's seed and the zone: not of the order of
 * calls, of threads, or of what was drawn before. Where a class has one dye a zone, spread in HSB, and no zone is like
 * another one, clq_crowd_randomise_colours gives what clq_actor_randomise_colours gives for the same ranges.
 *
 * Maps are immutable: any number of threads may read one. To change colours while a program runs, make another map, draw
 * from it, and destroy the old one. Files: claque/colour_files.h. */
#ifndef CLAQUE_COLOURS_H
#define CLAQUE_COLOURS_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_colour_map clq_colour_map;

/* In which space every place within a range is as likely as every other.
 * HSB: hue, saturation and brightness, each by itself (S2 5.2). Dark and pale colours, which the eye hardly tells apart, then
 * come as often as vivid ones.
 * PERCEIVED: OKLab. Parts of a range that look equally large come equally often. Of a range that is one number wide
 * somewhere the surface or line that is left is filled evenly. */
typedef enum clq_colour_space { CLQ_COLOUR_SPACE_HSB = 0, CLQ_COLOUR_SPACE_OKLAB = 1 } clq_colour_space;

/* One of the dyes that a zone's colour may be taken from; it is one colour where first is last throughout. */
typedef struct clq_palette_entry {
    clq_hsb_range range; /* saturation and brightness: first <= last; hue wraps when first > last (S2 5.2) */
    float weight;        /* (0, 1e6] its share is weight / sum of the zone's weights */
} clq_palette_entry;

/* What one zone's colours are drawn from. */
typedef struct clq_zone_colours {
    const char *zone;       /* its name, as templates have it */
    uint32_t palette_count; /* [0, 64]; 0: those of the zone that it is like, with their uniform */
    const clq_palette_entry *palette;
    clq_colour_space colour_space;
    /* Another zone of the same individual, which is drawn by itself: this one is then drawn by the same lots. With dyes of
     * its own it takes the same place among them as the other does among its own. NULL: it is drawn by itself. */
    const char *linked_to;
    /* [0, 1] how far from the other's its place in a range may be, as a share of the range: 0 the same place, 1 as if it were
     * drawn by itself. Whatever it is, the zone's own distribution stays the same. 0 without `like` */
    float variation;
} clq_zone_colours;

/* The colours of a social class (S2 5.3). Zones that it does not name keep the template's own ranges. */
typedef struct clq_colour_class {
    const char *name;
    const char *tmpl; /* name of the template that they wear, for whoever finds a class by it; may be NULL */
    uint32_t zone_count;
    const clq_zone_colours *zones;
} clq_colour_class;

typedef struct clq_colour_map_def {
    uint32_t struct_bytes; /* set by clq_colour_map_def_init */
    uint32_t class_count;  /* [1, 256] */
    const clq_colour_class *classes;
} clq_colour_map_def;

static inline clq_colour_map_def clq_colour_map_def_init(void)
{
    clq_colour_map_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.class_count = 0;
    def.classes = NULL;
    return def;
}

/* Makes a map. Names are not empty and stand once each, at most 255 zones a class and 4096 dyes in all; nothing of `def`
 * is kept. A dye that is uniform in what is perceived takes 17 kB and about 3 ms, which is why maps are made beforehand.
 *   out   [owner: host, until clq_colour_map_destroy]
 * Fails: STRUCT_SIZE, ARGUMENT (the first broken rule, with class and zone), OUT_OF_MEMORY. Threads: any. GL: none.
 * Seed: S2 5.2. */
CLQ_API clq_status clq_colour_map_create(clq_context *context, const clq_colour_map_def *def, clq_colour_map **out);

/* Ends a map; NULL is ignored. Colours that were drawn from it stay. Threads: any one. */
CLQ_API void clq_colour_map_destroy(clq_colour_map *map);

/* What a map was made of: what `class_count` and `classes` were. Strings and arrays live as long as the map.
 * Fail: ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_get_def(const clq_colour_map *map, clq_colour_map_def *out);

/* Index of the class of this name, and of the first class for templates of this name; or CLQ_NONE. Threads: any. */
CLQ_API uint32_t clq_colour_map_find(const clq_colour_map *map, const char *class_name);
CLQ_API uint32_t clq_colour_map_find_template(const clq_colour_map *map, const char *template_name);

/* Gives individuals colours out of a class, at once: what the next update hands to drawing shows them (S2 5.2: every
 * change affects each rendered human). A whole crowd, or one individual.
 *   actors   [actor_count] each of a template that has every zone that the class names
 * Fails, with everybody as before: STALE_ID (naming the first), ARGUMENT (no such class; a zone that a template lacks, by
 * name), OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_randomise_colours(clq_crowd *crowd, const clq_colour_map *map, uint32_t colour_class,
                                               const clq_actor *actors, uint32_t actor_count);

/* What clq_crowd_randomise_colours would give an individual, without one and before rounding to 8 bits.
 *   crowd_seed, actor_seed   of clq_crowd_def and clq_actor_def
 *   out_rgb                  [3 * zone_count], as glColor takes them
 *   zone_count               of the template
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_sample(const clq_colour_map *map, uint32_t colour_class, const clq_template *tmpl,
                                         uint64_t crowd_seed, uint64_t actor_seed, float *out_rgb, uint32_t zone_count);

/* An individual's colours as they are drawn: its own, else its template's; each its own a 255th.
 *   out_rgb   [3 * zone_count], zone_count of its template
 * Fails: STALE_ID, ARGUMENT. Threads: any, not while the crowd is changed. GL: none. */
CLQ_API clq_status clq_actor_get_colours(const clq_crowd *crowd, clq_actor actor, float *out_rgb, uint32_t zone_count);

#ifdef __cplusplus
}
#endif

#endif

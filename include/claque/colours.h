/* clq_colour_map: the colour classes from which colours of individuals are sampled (S2 5). A class has a hue, a
 * saturation and a brightness range for each zone, or several with weights.
 *
 * A colour is a function of the map, the template, the crowd's seed, the actor's seed and the zone. It does not depend
 * on the order of calls, on threads or on earlier samples. For classes with one palette entry per zone, in HSB, without
 * linked zones, clq_crowd_randomise_colours gives the colours that clq_actor_randomise_colours gives for the same
 * ranges.
 *
 * Maps are immutable: any number of threads may read one. To change colours at run time, create another map, sample
 * from it and destroy the old one. Files: claque/colour_files.h. */
#ifndef CLAQUE_COLOURS_H
#define CLAQUE_COLOURS_H

#include <claque/crowd.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_colour_map clq_colour_map;

/* The space in which a colour range is sampled uniformly. */
typedef enum clq_colour_space {
    /* Hue, saturation and brightness, each by itself (S2 5.2). Dark and pale colours, which look nearly alike, are as
     * frequent as vivid ones. */
    CLQ_COLOUR_SPACE_HSB = 0,
    /* OKLab: parts of a range that look equally large are equally frequent. Degenerate ranges are sampled uniformly
     * over the remaining surface or curve. */
    CLQ_COLOUR_SPACE_OKLAB = 1
} clq_colour_space;

/* A colour range from which the colour of a zone may be sampled. It is one colour if its minima equal its maxima. */
typedef struct clq_palette_entry {
    clq_hsb_range range;
    float weight; /* (0, 1e6] its probability is weight / sum of the zone's weights. Default 1 */
} clq_palette_entry;

static inline clq_palette_entry clq_palette_entry_init(void)
{
    clq_palette_entry entry;
    memset(&entry, 0, sizeof entry);
    entry.range = clq_hsb_range_init();
    entry.weight = 1.0f;
    return entry;
}

/* The colours of one zone. */
typedef struct clq_zone_colours {
    const char *zone;                 /* its name in templates */
    uint32_t palette_count;           /* [0, 64]; 0: the palette and colour space of the zone in linked_to */
    const clq_palette_entry *palette; /* [palette_count] */
    clq_colour_space colour_space;
    /* The name of another zone of the same template that is not linked itself. This zone then takes the same random
     * numbers as that one; with a palette of its own it takes the same position among its entries. NULL: the zone is
     * sampled by itself. */
    const char *linked_to;
    /* [0, 1] how far this zone's position in its range may be from that of the linked one, as a share of the range: 0
     * the same position, 1 an independent one. The distribution of the zone's colours stays the same. 0 without
     * linked_to. */
    float variation;
} clq_zone_colours;

CLQ_DEFINE_PLAIN_INIT(clq_zone_colours)

/* A colour class (S2 5.3). Zones that it does not name keep the template's own ranges. */
typedef struct clq_colour_class {
    const char *name;
    const char *tmpl; /* the name of the template it is meant for, see clq_colour_map_find_template; may be NULL */
    uint32_t zone_count;
    const clq_zone_colours *zones; /* [zone_count] */
} clq_colour_class;

CLQ_DEFINE_PLAIN_INIT(clq_colour_class)

typedef struct clq_colour_map_def {
    uint32_t struct_bytes;           /* set by clq_colour_map_def_init */
    uint32_t class_count;            /* [1, 256] */
    const clq_colour_class *classes; /* [class_count] */
} clq_colour_map_def;

CLQ_DEFINE_ZERO_INIT(clq_colour_map_def)

/* Creates a map. Nothing of `def` is kept. Names are not empty and occur once each. A class has at most 255 zones; a
 * map has at most 4096 palette entries. An entry in OKLab takes 17 kB and about 3 ms.
 *   out   owned by the host until clq_colour_map_destroy
 * Fails: STRUCT_SIZE, ARGUMENT (the first broken rule, with class and zone), OUT_OF_MEMORY. Threads: any. GL: none.
 * S2 5.2. */
CLQ_API clq_status clq_colour_map_create(clq_context *context, const clq_colour_map_def *def, clq_colour_map **out);

/* Destroys a map; NULL is ignored. Colours that were sampled from it stay. Threads: any, not while another call uses
 * the map. GL: none. */
CLQ_API void clq_colour_map_destroy(clq_colour_map *map);

/* Gets the classes of a map. Strings and arrays live as long as the map.
 *   out   made by clq_colour_map_def_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_get_def(const clq_colour_map *map, clq_colour_map_def *out);

/* Return the index of the class of this name, and of the first class for templates of this name; or CLQ_NONE.
 * Threads: any. GL: none. */
CLQ_API uint32_t clq_colour_map_find(const clq_colour_map *map, const char *class_name);
CLQ_API uint32_t clq_colour_map_find_template(const clq_colour_map *map, const char *template_name);

/* Samples the colours of individuals from a class. The next update shows them (S2 5.2).
 *   actors   [actor_count], each of a template that has every zone of the class
 * Fails: STALE_ID (names the first), ARGUMENT (no such class; a zone that a template lacks, by name), OUT_OF_MEMORY,
 * BUSY; all colours then stay. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_crowd_randomise_colours(clq_crowd *crowd, const clq_colour_map *map, uint32_t colour_class,
                                               const clq_actor *actors, uint32_t actor_count);

/* An individual whose colours are sampled without creating it. */
typedef struct clq_colour_sample_def {
    uint32_t struct_bytes; /* set by clq_colour_sample_def_init */
    uint32_t colour_class;
    const clq_template *tmpl;
    uint64_t crowd_seed, actor_seed; /* as in clq_crowd_def and clq_actor_def */
} clq_colour_sample_def;

CLQ_DEFINE_ZERO_INIT(clq_colour_sample_def)

/* Samples the colours that clq_crowd_randomise_colours would give an individual, before they are rounded to 8 bits.
 *   out_rgb      [3 * zone_count], as glColor takes them
 *   zone_count   that of the template
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_colour_map_sample(const clq_colour_map *map, const clq_colour_sample_def *def, float *out_rgb,
                                         uint32_t zone_count);

/* Gets the colours of an individual: its own, which are multiples of 1 / 255, or its template's.
 *   out_rgb      [3 * zone_count]
 *   zone_count   that of its template
 * Fails: STALE_ID, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_actor_get_colours(const clq_crowd *crowd, clq_actor actor, float *out_rgb, uint32_t zone_count);

#ifdef __cplusplus
}
#endif

#endif

/* Zones for characters that come without them (libclaque-assets): a map says which texels of an image are skin, cloth
 * or leather, so that individuals can be coloured zone by zone (S1 3). A map is painted, made by a program, or proposed
 * here from the colours of the image. Texels of a reduced zone lose their colours and keep their light and dark, so
 * that the zone can be given any colour (S2 2.3). */
#ifndef CLAQUE_ZONES_H
#define CLAQUE_ZONES_H

#include <claque/assets.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CLQ_NO_ZONE 0xffffu /* a texel of a zone map without a zone */

typedef struct clq_asset_image {
    uint32_t struct_bytes; /* set by clq_asset_image_init */
    const char *name;
    uint32_t width_px, height_px;
    const uint8_t *rgba; /* [4 * width_px * height_px], the row at v = 0 first; lives until the asset changes */
    clq_alpha_meaning alpha;
} clq_asset_image;

CLQ_DEFINE_ZERO_INIT(clq_asset_image)

/* Gets an image of an asset.
 *   out   made by clq_asset_image_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_get_image(const clq_asset *asset, uint32_t image, clq_asset_image *out);

/* A zone of a zone map. */
typedef struct clq_zone_map_zone {
    const char *name;
    /* True: its texels become grey, and their luminance is stretched until the brightest fiftieth is white. The zone's
     * own colour becomes the one that restores the image best. False: its texels keep their colours; the zone's own
     * colour is white. */
    bool reduced;
    /* The range that clq_actor_randomise_colours samples. NULL: a range near the colour, which follows from the name
     * (skin, hair, leather, ...) and the place on the body; a wide one, or none, with clq_asset_options.colours. */
    const clq_hsb_range *range;
} clq_zone_map_zone;

CLQ_DEFINE_PLAIN_INIT(clq_zone_map_zone)

typedef struct clq_zone_map_def {
    uint32_t struct_bytes;        /* set by clq_zone_map_def_init */
    uint32_t image;               /* of the asset */
    uint32_t width_px, height_px; /* of the map, 1 or more; the image may have another size */
    /* [width_px * height_px] indices of zones, the row at v = 0 first; CLQ_NO_ZONE takes the nearest zone. */
    const uint16_t *texels;
    uint32_t zone_count; /* [1, 256] */
    const clq_zone_map_zone *zones;
} clq_zone_map_def;

CLQ_DEFINE_ZERO_INIT(clq_zone_map_def)

/* Gives an image of an asset zones. Materials that show the image then take their zones from its alpha; their base
 * colours go into the texels. Zones that nothing shows any more are dropped. Images of several materials or texture
 * sets may share zones by name: the first image that is set decides the zone's colour and range. Zone keys that the
 * image had before are replaced.
 * Fails: STRUCT_SIZE, ARGUMENT (an image that no material shows or whose alpha cuts holes; a texel of no zone), LIMIT,
 * OUT_OF_MEMORY; the asset then stays. Threads: one per asset. GL: none. */
CLQ_API clq_status clq_asset_set_zone_map(clq_context *context, clq_asset *asset, const clq_zone_map_def *def);

/* The request for a zone map, and the host's arrays for the result. */
typedef struct clq_zone_proposal {
    uint32_t struct_bytes;  /* set by clq_zone_proposal_init */
    uint32_t max_zones;     /* [1, 48] there are fewer zones if the colours do not differ enough */
    uint16_t *texels;       /* [capacity_texels], filled; zones in descending order of their texels */
    size_t capacity_texels; /* width_px * height_px of the image or more */
    uint8_t *rgb;           /* [3 * max_zones], filled: the mean colour of each zone */
    uint32_t zone_count;    /* written: the number of zones */
} clq_zone_proposal;

CLQ_DEFINE_ZERO_INIT(clq_zone_proposal)

/* Proposes a zone map for an image: it groups texels of similar colours, where light and dark count half as much as
 * hue. Texels that no triangle shows, and soft edges, get CLQ_NO_ZONE. The result is the same on every machine.
 *   out   made by clq_zone_proposal_init; the host then sets all members but zone_count
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_propose_zones(const clq_asset *asset, uint32_t image, clq_zone_proposal *out);

/* Reads a PNG or JPEG file of at most 1 GiB, such as a painted zone map, as RGBA: 4 bytes a pixel, the file's top row
 * first.
 *   out   made by clq_picture_init; the host then sets pixels and capacity_bytes
 * Fails: STRUCT_SIZE, ARGUMENT (also a capacity that is too small), IO, FORMAT, UNSUPPORTED, LIMIT, OUT_OF_MEMORY.
 * Threads: any. GL: none. */
CLQ_API clq_status clq_image_read(clq_context *context, const char *path, clq_picture *out);

#ifdef __cplusplus
}
#endif

#endif

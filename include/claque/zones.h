/* Zones for characters that come without (libclaque-assets): which texels of an image are skin, cloth, leather, so that
 * individuals can be coloured zone by zone (S1 3). A map is painted by somebody, made by a program, or proposed here from the
 * colours that lie in the image; chosen zones give up their own colours for light and dark, so that any colour can be given to
 * them (S2 2.3). */
#ifndef CLAQUE_ZONES_H
#define CLAQUE_ZONES_H

#include <claque/assets.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CLQ_NO_ZONE 0xffffu /* of a texel in a zone map */

/* An image of an asset. Lives until the asset changes. */
typedef struct clq_asset_image {
    const char *name;
    uint32_t width_px, height_px;
    const uint8_t *rgba; /* [4 * width_px * height_px], the row at v = 0 first */
    clq_alpha_meaning alpha;
} clq_asset_image;

/* Fails: ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_get_image(const clq_asset *asset, uint32_t image, clq_asset_image *out);

typedef struct clq_zone_map_zone {
    const char *name;
    /* 1: its texels become grey, their luminance stretched until the brightest fiftieth is white; the
     * zone's colour (of an individual that was given none) becomes the one with which they look most like before. 0: its texels
     * keep their colours, and its colour is white. */
    int32_t reduced;
    const clq_hsb_range
        *range; /* what clq_actor_randomise_colours draws from; NULL: by the name (skin, hair, leather, ...) and
                                   the colour */
} clq_zone_map_zone;

typedef struct clq_zone_map_def {
    uint32_t struct_bytes;        /* set by clq_zone_map_def_init */
    uint32_t image;               /* of the asset */
    uint32_t width_px, height_px; /* [>= 1] of the map, which may have another size than the image */
    const uint16_t *texels; /* [width_px * height_px] zones, or CLQ_NO_ZONE: what lies nearest; row at v = 0 first */
    uint32_t zone_count;    /* [1, 256] */
    const clq_zone_map_zone *zones;
} clq_zone_map_def;

static inline clq_zone_map_def clq_zone_map_def_init(void)
{
    clq_zone_map_def def;
    def.struct_bytes = (uint32_t)sizeof def;
    def.image = 0;
    def.width_px = 0;
    def.height_px = 0;
    def.texels = NULL;
    def.zone_count = 0;
    def.zones = NULL;
    return def;
}

/* Gives an image of an asset zones. Materials that show it take them from its alpha; a base colour of theirs goes into the
 * texels. Zones that nothing shows any longer are dropped. Images of several materials or texture sets may share zones by name:
 * the first one that is set decides colour and range. An image that already has zone keys gets these instead.
 * Fails: STRUCT_SIZE, ARGUMENT (an image that no material shows, or whose alpha cuts holes; a texel of no zone), LIMIT,
 * OUT_OF_MEMORY; the asset is then as it was. Threads: any one. GL: none. */
CLQ_API clq_status clq_asset_set_zone_map(clq_context *context, clq_asset *asset, const clq_zone_map_def *def);

/* Proposes a map for an image: texels of like colours, where light and dark count half as much as colour. The same on every
 * machine.
 *   wanted      [1, 48] zones at most; there are fewer where colours do not differ enough
 *   out_texels  [width_px * height_px of the image], zones with the most texels first; CLQ_NO_ZONE where no triangle lies, and on soft edges
 *   capacity    texels that out_texels has room for
 *   out_rgb     [3 * wanted] the mean colour of each zone
 *   out_count   how many there are
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_propose_zones(const clq_asset *asset, uint32_t image, uint32_t max_zones,
                                           uint16_t *out_texels, size_t capacity, uint8_t *out_rgb,
                                           uint32_t *out_count);

/* Reads a PNG or JPEG file, a painted zone map for example.
 *   out_rgba  [4 * width * height] or NULL to ask for the size only; the file's top row first
 * Fails: ARGUMENT (also when capacity is too small), IO, FORMAT, UNSUPPORTED, LIMIT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_image_read(clq_context *context, const char *path, uint8_t *out_rgba, size_t capacity_bytes,
                                  uint32_t *out_width_px, uint32_t *out_height_px);

#ifdef __cplusplus
}
#endif

#endif

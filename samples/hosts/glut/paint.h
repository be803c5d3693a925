/* Textures of the park, painted by code and loaded into GL with mipmaps by GLU. */
#ifndef PAINT_H
#define PAINT_H

unsigned paint_grass(void);
unsigned paint_cobbles(void);
unsigned paint_leaves(void);
unsigned paint_boards(void);

/* In [0, 1), the same for equal numbers. */
float paint_random(unsigned x, unsigned y, unsigned what);

#endif

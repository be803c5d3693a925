/* A crowd in the lower left corner of the current GL context's picture. */
#ifndef CLAQUE_SAMPLES_GUEST_CORNER_H
#define CLAQUE_SAMPLES_GUEST_CORNER_H

#include <claque/renderer.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Draws a frame into the corner; the frame after the last is a sixtieth of a second later. The first call makes the
 * crowd. `context` tells contexts apart: the crowd is drawn in the first of them alone.
 * What the environment says:
 *   CLAQUE_GUEST        WIDTHxHEIGHT of the corner in pixels; default 320x240
 *   CLAQUE_GUEST_GUARD  full (default), minimal, none: see clq_guard
 * What goes wrong is printed once, and nothing is drawn. */
void corner_draw(const void *context, clq_gl_function (*get_proc_address)(void *user, const char *name));

#ifdef __cplusplus
}
#endif

#endif

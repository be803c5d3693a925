/* The park's visitors: all that this program has to do with claque. */
#ifndef VISITORS_H
#define VISITORS_H

#include "samples/hosts/glut/park.h"

#include <claque/claque.h>

/* Ends the program with claque's sentence where something fails. */
void visitors_create(clq_gl_function (*get_proc_address)(void *user, const char *name));
void visitors_draw(const park_eye *eye, double time_s, clq_guard guard);
void visitors_destroy(void);

/* For the map. Where number `who` is on the ground; returns whether it was in view. */
int visitors_count(void);
int visitors_at(int who, float *x, float *z);

clq_draw_stats visitors_stats(void);

#endif

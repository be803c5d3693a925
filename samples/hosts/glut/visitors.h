/* The park's visitors: the part of the program that uses claque. */
#ifndef VISITORS_H
#define VISITORS_H

#include <claque/claque.h>

#include "samples/hosts/glut/park.h"

/* Exits the program with claque's message if a call fails. */
void visitors_create(clq_gl_function (*get_proc_address)(void *user, const char *name));
void visitors_draw(const park_eye *eye, double time_s, clq_guard guard);
void visitors_destroy(void);

/* For the map: the position of number `person` on the ground; returns whether it was in view. */
int visitors_count(void);
int visitors_at(int person, float *x, float *z);

clq_draw_stats visitors_stats(void);

#endif

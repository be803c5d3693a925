/* The park: the part of the program that existed before claque. Display lists, textures, fog, a moon and two lamps.
 * All state is set once, in park_create, and assumed from then on, as was usual in programs of its age. */
#ifndef PARK_H
#define PARK_H

typedef struct park_eye {
    double at[3], target[3];
    double fov_y_deg, aspect, z_near, z_far;
} park_eye;

#define PARK_BANDSTAND_RADIUS 4.2f
#define PARK_BANDSTAND_FLOOR 0.7f
#define PARK_PATH_HALF_WIDTH 2.6f

void park_create(void);

/* Begins a frame: clears, sky, camera, lights, and everything behind the people. */
void park_draw_far(const park_eye *eye);

/* Draws everything before the people. Sets no state. */
void park_draw_near(void);

#endif

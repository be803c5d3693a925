/* The park: what this program drew before it knew of claque. Display lists, textures, fog, a moon and two lamps; everything is set
 * once, in park_create, and relied on ever after, as programs of its age do. */
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

/* The frame's beginning: clears, sky, camera, lights, and all that stands behind people. */
void park_draw_far(const park_eye *eye);

/* What stands before them. Nothing is set anew. */
void park_draw_near(void);

#endif

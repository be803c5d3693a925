/* The head-up display: a panel with text and a map, over everything. */
#ifndef HUD_H
#define HUD_H

#include "samples/hosts/glut/park.h"

void hud_draw(int width, int height, const park_eye *eye, double time_s, const char *guard, int with_people);

#endif

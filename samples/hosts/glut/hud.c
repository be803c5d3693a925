#include "samples/hosts/glut/hud.h"

#include <math.h>
#include <stdio.h>

#include <GL/freeglut.h>

#include "samples/hosts/glut/visitors.h"

static void panel(float x0, float y0, float x1, float y1)
{
    glColor4f(0.05f, 0.06f, 0.10f, 0.72f);
    glRectf(x0, y0, x1, y1);
    glColor4f(1, 1, 1, 0.6f);
    glBegin(GL_LINE_LOOP);
    glVertex2f(x0 + 0.5f, y0 + 0.5f), glVertex2f(x1 - 0.5f, y0 + 0.5f);
    glVertex2f(x1 - 0.5f, y1 - 0.5f), glVertex2f(x0 + 0.5f, y1 - 0.5f);
    glEnd();
}

static void write(int x, int y, const char *text)
{
    glRasterPos2i(x, y);
    glutBitmapString(GLUT_BITMAP_HELVETICA_12, (const unsigned char *)text);
}

/* Every visitor as a point, bright if in view; 3.4 pixels a metre, the bandstand in the centre. */
static void draw_map(float x0, float y0, float side, const park_eye *eye, int with_people)
{
    const float scale = 3.4f, cx = x0 + side / 2, cy = y0 + side * 0.6f;
    panel(x0, y0, x0 + side, y0 + side);
    glColor4f(0.75f, 0.70f, 0.60f, 0.8f);
    glBegin(GL_LINE_LOOP);
    for (int i = 0; i < 24; ++i) {
        const float turn = 0.2618f * (float)i;
        glVertex2f(cx + scale * PARK_BANDSTAND_RADIUS * sinf(turn), cy + scale * PARK_BANDSTAND_RADIUS * cosf(turn));
    }
    glEnd();
    glPointSize(2);
    glBegin(GL_POINTS);
    for (int person = 0; with_people && person < visitors_count(); ++person) {
        float x = 0, z = 0;
        if (visitors_at(person, &x, &z)) glColor4f(0.45f, 1, 0.45f, 1);
        else glColor4f(1, 0.5f, 0.4f, 0.8f);
        glVertex2f(cx + scale * x, cy - scale * (z + 12));
    }
    glEnd();
    const float ex = cx + scale * (float)eye->at[0], ey = cy - scale * (float)(eye->at[2] + 12);
    const double dx = eye->target[0] - eye->at[0], dz = eye->target[2] - eye->at[2], length = sqrt(dx * dx + dz * dz);
    glColor4f(1, 1, 1, 1);
    glBegin(GL_LINES);
    glVertex2f(ex, ey), glVertex2f(ex + 9 * (float)(dx / length), ey - 9 * (float)(dz / length));
    glEnd();
    glPointSize(1);
}

void hud_draw(int width, int height, const park_eye *eye, double time_s, const char *guard, int with_people)
{
    char line[128];
    glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT);
    glDisable(GL_DEPTH_TEST), glDisable(GL_LIGHTING), glDisable(GL_FOG), glDisable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glMatrixMode(GL_PROJECTION), glPushMatrix(), glLoadIdentity();
    gluOrtho2D(0, width, 0, height);
    glMatrixMode(GL_MODELVIEW), glPushMatrix(), glLoadIdentity();

    panel(10, (float)height - 66, 250, (float)height - 10);
    glColor3f(1, 0.92f, 0.55f);
    write(20, height - 27, "Concert in the park");
    glColor3f(1, 1, 1);
    snprintf(line, sizeof line, "%.2f s   guard %s", time_s, guard);
    write(20, height - 43, line);
    if (with_people) {
        const clq_draw_stats stats = visitors_stats();
        snprintf(line, sizeof line, "%u of %d visitors, %u triangles", stats.individuals, visitors_count(),
                 stats.triangles);
    } else snprintf(line, sizeof line, "nobody is here");
    write(20, height - 58, line);
    draw_map((float)width - 120, 10, 110, eye, with_people);

    glPopMatrix();
    glMatrixMode(GL_PROJECTION), glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopAttrib();
}

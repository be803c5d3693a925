#include "samples/hosts/glut/park.h"

#include <math.h>

#include <GL/glu.h>

#include "samples/hosts/glut/paint.h"

enum { FAR_LIST = 1, TREE_LIST, LAMP_LIST, NEAR_LIST };

static const float haze[4] = {0.70f, 0.73f, 0.78f, 1};
static const float lamps[2][3] = {{-3.2f, 3.6f, -1.5f}, {3.2f, 3.6f, -8.5f}};
static GLuint grass, cobbles, leaves, boards;
static GLUquadric *quadric;

/* Squares of one metre, so that lamps, which light vertices, light the ground. */
static void draw_floor(float x0, float z0, float x1, float z1, float y, float texture_m)
{
    glNormal3f(0, 1, 0);
    for (float z = z0; z < z1; z += 1) {
        glBegin(GL_TRIANGLE_STRIP);
        for (float x = x0; x <= x1; x += 1) {
            glTexCoord2f(x / texture_m, z / texture_m), glVertex3f(x, y, z);
            glTexCoord2f(x / texture_m, (z + 1) / texture_m), glVertex3f(x, y, z + 1);
        }
        glEnd();
    }
}

static void draw_column(float x, float y, float z, float radius, float height)
{
    glPushMatrix();
    glTranslatef(x, y, z);
    glRotatef(-90, 1, 0, 0);
    gluCylinder(quadric, radius, radius * 0.85, height, 12, 4);
    glPopMatrix();
}

static void draw_bandstand(void)
{
    const float r = PARK_BANDSTAND_RADIUS, floor_y = PARK_BANDSTAND_FLOOR;
    glPushMatrix();
    glTranslatef(0, 0, -12);
    glColor3f(0.72f, 0.66f, 0.58f);
    glBindTexture(GL_TEXTURE_2D, cobbles);
    glPushMatrix();
    glRotatef(-90, 1, 0, 0);
    gluCylinder(quadric, r, r, floor_y, 24, 2);
    glTranslatef(0, 0, floor_y);
    gluDisk(quadric, 0, r, 24, 6);
    glPopMatrix();
    glBindTexture(GL_TEXTURE_2D, boards);
    glColor3f(0.95f, 0.94f, 0.90f);
    for (int i = 0; i < 8; ++i) {
        const float turn = 0.785398f * ((float)i + 0.5f);
        draw_column((r - 0.3f) * sinf(turn), floor_y, (r - 0.3f) * cosf(turn), 0.11f, 3.1f);
    }
    glPushMatrix(); /* its roof, with a board round the eaves */
    glTranslatef(0, floor_y + 3.1f, 0);
    glRotatef(-90, 1, 0, 0);
    gluCylinder(quadric, r + 0.25, r + 0.25, 0.35, 32, 1);
    glColor3f(0.42f, 0.55f, 0.50f);
    glTranslatef(0, 0, 0.35f);
    gluCylinder(quadric, r + 0.5, 0.25, 1.7, 32, 8);
    glPopMatrix();
    glPopMatrix();
}

/* A crown of flattened balls. GL generates its texture coordinates. */
static void draw_tree(void)
{
    glColor3f(0.42f, 0.33f, 0.25f);
    glBindTexture(GL_TEXTURE_2D, boards);
    draw_column(0, 0, 0, 0.24f, 2.6f);
    glBindTexture(GL_TEXTURE_2D, leaves);
    glEnable(GL_TEXTURE_GEN_S), glEnable(GL_TEXTURE_GEN_T);
    for (unsigned i = 0; i < 16; ++i) {
        const float turn = 2.4f * (float)i, out = 1.35f * sqrtf(paint_random(i, 0, 20));
        const float size = 0.75f + 0.5f * paint_random(i, 1, 20), tone = 0.75f + 0.25f * paint_random(i, 2, 20);
        glColor3f(tone, tone, tone * 0.9f);
        glPushMatrix();
        glTranslatef(out * sinf(turn), 2.5f + 2.3f * paint_random(i, 3, 20), out * cosf(turn));
        glScalef(size, 0.72f * size, size);
        gluSphere(quadric, 1, 14, 9);
        glPopMatrix();
    }
    glDisable(GL_TEXTURE_GEN_S), glDisable(GL_TEXTURE_GEN_T);
}

static void draw_lamp(void)
{
    static const float glow[4] = {1, 0.85f, 0.55f, 1}, none[4] = {0, 0, 0, 1};
    glDisable(GL_TEXTURE_2D);
    glColor3f(0.13f, 0.15f, 0.14f);
    draw_column(0, 0, 0, 0.07f, 3.3f);
    glPushMatrix();
    glTranslatef(0, 3.5f, 0);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, glow);
    gluSphere(quadric, 0.22, 16, 12);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, none);
    glPopMatrix();
    glEnable(GL_TEXTURE_2D);
}

static void place(unsigned list, float x, float z, float turn_deg, float size)
{
    glPushMatrix();
    glTranslatef(x, 0, z);
    glRotatef(turn_deg, 0, 1, 0);
    glScalef(size, size, size);
    glCallList(list);
    glPopMatrix();
}

static void compile_lists(void)
{
    glNewList(TREE_LIST, GL_COMPILE), draw_tree(), glEndList();
    glNewList(LAMP_LIST, GL_COMPILE), draw_lamp(), glEndList();
    glNewList(FAR_LIST, GL_COMPILE);
    glColor3f(1, 1, 1);
    glBindTexture(GL_TEXTURE_2D, grass);
    draw_floor(-60, -80, 60, 14, -0.02f, 5);
    glBindTexture(GL_TEXTURE_2D, cobbles);
    draw_floor(-3, -26, 3, 14, 0, 3);  /* the path ... */
    draw_floor(-11, -23, 11, 1, 0, 3); /* ... and the square round the bandstand */
    draw_bandstand();
    for (unsigned i = 0; i < 44; ++i) {
        const float side = i % 2 ? 1.0f : -1.0f;
        const float x = side * (12 + 26 * paint_random(i, 0, 30)), z = 2 - 58 * paint_random(i, 1, 30);
        place(TREE_LIST, x, z, 360 * paint_random(i, 2, 30), 0.9f + 0.7f * paint_random(i, 3, 30));
    }
    for (int i = 0; i < 2; ++i) place(LAMP_LIST, lamps[i][0], lamps[i][2], 0, 1);
    glEndList();
    glNewList(NEAR_LIST, GL_COMPILE);
    place(TREE_LIST, -5.3f, 1.2f, 40, 0.95f);
    place(TREE_LIST, 5.9f, 0.4f, 170, 1.1f);
    place(LAMP_LIST, 2.9f, 2.2f, 0, 1);
    glEndList();
}

static void set_lights(void)
{
    static const float ambient[4] = {0.36f, 0.38f, 0.43f, 1}, moon[4] = {0.52f, 0.53f, 0.56f, 1};
    static const float warm[4] = {0.95f, 0.72f, 0.40f, 1}, none[4] = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, moon), glLightfv(GL_LIGHT0, GL_SPECULAR, none);
    for (GLenum light = GL_LIGHT1; light <= GL_LIGHT2; ++light) {
        glLightfv(light, GL_DIFFUSE, warm), glLightfv(light, GL_SPECULAR, none);
        glLightf(light, GL_QUADRATIC_ATTENUATION, 0.035f);
        glEnable(light);
    }
    glEnable(GL_LIGHT0), glEnable(GL_LIGHTING), glEnable(GL_NORMALIZE);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
}

void park_create(void)
{
    static const float along_x[4] = {1.1f, 0.3f, 0.5f, 0}, along_y[4] = {0.3f, 1.2f, 0.4f, 0};
    grass = paint_grass(), cobbles = paint_cobbles(), leaves = paint_leaves(), boards = paint_boards();
    quadric = gluNewQuadric();
    gluQuadricTexture(quadric, GL_TRUE);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), glTexGenfv(GL_S, GL_OBJECT_PLANE, along_x);
    glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), glTexGenfv(GL_T, GL_OBJECT_PLANE, along_y);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    set_lights();
    glFogi(GL_FOG_MODE, GL_EXP2), glFogf(GL_FOG_DENSITY, 0.020f), glFogfv(GL_FOG_COLOR, haze);
    glEnable(GL_FOG), glEnable(GL_DEPTH_TEST), glEnable(GL_TEXTURE_2D);
    compile_lists();
}

static void draw_sky(void)
{
    glPushAttrib(GL_ENABLE_BIT | GL_DEPTH_BUFFER_BIT | GL_CURRENT_BIT);
    glDisable(GL_FOG), glDisable(GL_LIGHTING), glDisable(GL_TEXTURE_2D), glDisable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION), glLoadIdentity();
    glMatrixMode(GL_MODELVIEW), glLoadIdentity();
    glBegin(GL_QUAD_STRIP);
    glColor3fv(haze), glVertex2f(-1, -1), glVertex2f(1, -1);
    glColor3fv(haze), glVertex2f(-1, 0.1f), glVertex2f(1, 0.1f);
    glColor3f(0.38f, 0.46f, 0.62f), glVertex2f(-1, 1), glVertex2f(1, 1);
    glEnd();
    glPopAttrib();
}

void park_draw_far(const park_eye *eye)
{
    static const float moon[4] = {-0.45f, 0.8f, 0.55f, 0};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_sky();
    glMatrixMode(GL_PROJECTION);
    gluPerspective(eye->fov_y_deg, eye->aspect, eye->z_near, eye->z_far);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(eye->at[0], eye->at[1], eye->at[2], eye->target[0], eye->target[1], eye->target[2], 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, moon);
    for (int i = 0; i < 2; ++i) {
        const float at[4] = {lamps[i][0], lamps[i][1], lamps[i][2], 1};
        glLightfv(GL_LIGHT1 + (GLenum)i, GL_POSITION, at);
    }
    glCallList(FAR_LIST);
}

void park_draw_near(void) { glCallList(NEAR_LIST); }

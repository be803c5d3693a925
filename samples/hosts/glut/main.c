/* A freeglut program with its own lights, fog, textures, display lists and head-up display, to which claque adds
 * people.
 *
 *   claque_host_glut                              a window: arrow keys walk and turn, p pauses, g changes the guard,
 *                                                 q quits
 *   claque_host_glut --frames N --picture F.png   N frames of 1/25 s, then the last one as a picture
 *     --people-until K   people are drawn in the frames before number K only; 0: claque is never called
 *     --guard full|minimal|none */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/freeglut.h>
#include <png.h>

#include "samples/hosts/glut/hud.h"
#include "samples/hosts/glut/visitors.h"

enum { WIDTH = 800, HEIGHT = 600 };

static const char *const guard_names[] = {"full", "minimal", "none"};
static int frames, people_until = -1, guard = CLQ_GUARD_FULL, width = WIDTH, height = HEIGHT, paused;
static const char *picture;
static int frame;
static double clock_s, last_s, eye_x, eye_z = 8.5, heading;

static clq_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return (clq_gl_function)glutGetProcAddress(name);
}

static int save(void)
{
    const size_t row = 3 * (size_t)width;
    unsigned char *rgb = malloc(row * (size_t)height);
    png_image image;
    int done;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION, image.format = PNG_FORMAT_RGB;
    image.width = (png_uint_32)width, image.height = (png_uint_32)height;
    if (!rgb) return 0;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    done = png_image_write_to_file(&image, picture, 0, rgb, -(png_int_32)row, NULL); /* GL's first row is the lowest */
    free(rgb);
    return done;
}

static void finish(int code)
{
    if (people_until != 0) visitors_destroy();
    exit(code);
}

static void display(void)
{
    const park_eye eye = {{eye_x, 1.9, eye_z},
                          {eye_x + 10 * sin(heading), 1.55, eye_z - 10 * cos(heading)},
                          50,
                          (double)width / height,
                          0.2,
                          120};
    const int with_people = people_until < 0 || frame < people_until;
    park_draw_far(&eye);
    if (with_people) visitors_draw(&eye, clock_s, (clq_guard)guard);
    park_draw_near();
    hud_draw(width, height, &eye, clock_s, guard_names[guard], with_people);
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) fprintf(stderr, "frame %d left the GL error 0x%04x\n", frame, error), finish(1);
    if (picture && frame + 1 == frames && !save()) fprintf(stderr, "%s could not be written\n", picture), finish(1);
    glutSwapBuffers();
    ++frame;
    if (frames && frame == frames) finish(0);
}

static void idle(void)
{
    const double now_s = glutGet(GLUT_ELAPSED_TIME) / 1000.0;
    if (frames) clock_s = frame / 25.0;
    else if (!paused) clock_s += now_s - last_s;
    last_s = now_s;
    glutPostRedisplay();
}

static void reshape(int w, int h)
{
    width = w, height = h;
    glViewport(0, 0, w, h);
}

static void key(unsigned char k, int x, int y)
{
    (void)x, (void)y;
    if (k == 'q' || k == 27) finish(0);
    if (k == 'p') paused = !paused;
    if (k == 'g') guard = (guard + 1) % 3;
}

static void arrow(int k, int x, int y)
{
    const double step = k == GLUT_KEY_UP ? 0.4 : k == GLUT_KEY_DOWN ? -0.4 : 0;
    (void)x, (void)y;
    eye_x += step * sin(heading), eye_z -= step * cos(heading);
    heading += k == GLUT_KEY_RIGHT ? 0.06 : k == GLUT_KEY_LEFT ? -0.06 : 0;
}

static int usage(void)
{
    fputs("usage: claque_host_glut [--frames N [--picture FILE.png]] [--people-until K] [--guard full|minimal|none]\n",
          stderr);
    return 2;
}

int main(int count, char **arguments)
{
    glutInit(&count, arguments);
    for (int i = 1; i < count; i += 2) {
        const char *name = arguments[i], *value = i + 1 < count ? arguments[i + 1] : "";
        if (strcmp(name, "--frames") == 0 && atoi(value) > 0) frames = atoi(value);
        else if (strcmp(name, "--people-until") == 0 && *value) people_until = atoi(value);
        else if (strcmp(name, "--picture") == 0 && *value) picture = value;
        else if (strcmp(name, "--guard") == 0) {
            for (guard = 0; guard < 3 && strcmp(value, guard_names[guard]) != 0; ++guard) continue;
            if (guard == 3) return usage();
        } else return usage();
    }
    if (picture && !frames) return usage();
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(WIDTH, HEIGHT);
    glutCreateWindow("claque in a GLUT program");
    park_create();
    if (people_until != 0) visitors_create(get_proc_address);
    glutDisplayFunc(display), glutReshapeFunc(reshape), glutIdleFunc(idle);
    glutKeyboardFunc(key), glutSpecialFunc(arrow);
    glutMainLoop();
    return 0;
}

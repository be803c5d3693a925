#include "samples/hosts/glut/paint.h"

#include <math.h>

#include <GL/glu.h>

enum { SIDE = 256 };

typedef struct colour {
    float r, g, b;
} colour;

float paint_random(unsigned x, unsigned y, unsigned what)
{
    unsigned bits = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ (what + 1) * 0xc2b2ae3du;
    bits ^= bits >> 15, bits *= 0x2c1b3c6du;
    bits ^= bits >> 12, bits *= 0x297a2d39u;
    bits ^= bits >> 15;
    return (float)(bits >> 8) / 16777216.0f;
}

/* Smooth noise that repeats with the picture. */
static float noise(float u, float v, unsigned cells, unsigned what)
{
    const float x = u * (float)cells, y = v * (float)cells;
    const unsigned i = (unsigned)x % cells, k = (unsigned)y % cells;
    float fx = x - floorf(x), fy = y - floorf(y);
    fx = fx * fx * (3 - 2 * fx), fy = fy * fy * (3 - 2 * fy);
    const float a = paint_random(i, k, what), b = paint_random((i + 1) % cells, k, what);
    const float c = paint_random(i, (k + 1) % cells, what), d = paint_random((i + 1) % cells, (k + 1) % cells, what);
    return (a + (b - a) * fx) * (1 - fy) + (c + (d - c) * fx) * fy;
}

static colour mix(colour a, colour b, float t)
{
    const colour c = {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
    return c;
}

static unsigned char byte_of(float value)
{
    return (unsigned char)(255 * (value < 0 ? 0 : value > 1 ? 1 : value) + 0.5f);
}

static unsigned bring(colour (*paint)(float u, float v))
{
    static unsigned char texels[SIDE][SIDE][3];
    for (int y = 0; y < SIDE; ++y)
        for (int x = 0; x < SIDE; ++x) {
            const colour c = paint(((float)x + 0.5f) / SIDE, ((float)y + 0.5f) / SIDE);
            texels[y][x][0] = byte_of(c.r), texels[y][x][1] = byte_of(c.g), texels[y][x][2] = byte_of(c.b);
        }
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, SIDE, SIDE, GL_RGB, GL_UNSIGNED_BYTE, texels);
    return name;
}

static colour grass_at(float u, float v)
{
    const colour dark = {0.20f, 0.34f, 0.14f}, light = {0.42f, 0.56f, 0.24f};
    const float blades = paint_random((unsigned)(u * SIDE), (unsigned)(v * SIDE) / 3, 1);
    return mix(dark, light, 0.5f * noise(u, v, 8, 2) + 0.25f * noise(u, v, 32, 3) + 0.25f * blades);
}

/* Rows of rounded stones, every other one shifted by half a stone. */
static colour cobbles_at(float u, float v)
{
    const colour joint = {0.27f, 0.25f, 0.22f}, dark = {0.50f, 0.47f, 0.42f}, light = {0.70f, 0.66f, 0.59f};
    const float y = v * 12;
    const float x = u * 8 + ((int)y % 2 ? 0.5f : 0.0f);
    const float dx = 2 * (x - floorf(x)) - 1, dy = 2 * (y - floorf(y)) - 1;
    const float edge = 1 - powf(powf(fabsf(dx), 4) + powf(fabsf(dy), 4), 0.25f);
    const float stone = edge > 0.22f ? 1 : edge > 0.08f ? (edge - 0.08f) / 0.14f : 0;
    const colour tone = mix(dark, light, paint_random((unsigned)x % 8, (unsigned)y, 5));
    return mix(joint, mix(tone, light, 0.25f * noise(u, v, 64, 6)), stone);
}

static colour leaves_at(float u, float v)
{
    const colour dark = {0.10f, 0.22f, 0.08f}, light = {0.44f, 0.58f, 0.20f};
    const float clumps = noise(u, v, 24, 7), leaf = noise(u, v, 96, 8);
    return mix(dark, light, 0.6f * clumps * clumps + 0.5f * leaf * leaf);
}

static colour boards_at(float u, float v)
{
    const colour dark = {0.36f, 0.24f, 0.15f}, light = {0.62f, 0.45f, 0.29f};
    const float x = u * 6, gap = x - floorf(x);
    const float tone = 0.5f * paint_random((unsigned)x, 0, 9) + 0.5f * noise(u, v * 0.25f, 64, 10);
    return gap < 0.04f ? mix(dark, light, -0.4f) : mix(dark, light, tone);
}

unsigned paint_grass(void) { return bring(grass_at); }
unsigned paint_cobbles(void) { return bring(cobbles_at); }
unsigned paint_leaves(void) { return bring(leaves_at); }
unsigned paint_boards(void) { return bring(boards_at); }

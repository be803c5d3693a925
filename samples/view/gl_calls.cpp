#include "samples/view/gl_calls.h"

// One line a function: its result's type, its name, its parameters, its arguments.
#define CLAQUE_VIEW_GL(FUNCTION)                                                                                       \
    FUNCTION(void, BindTexture, (unsigned a, unsigned b), (a, b))                                                      \
    FUNCTION(void, BlendFunc, (unsigned a, unsigned b), (a, b))                                                        \
    FUNCTION(void, ColorPointer, (int a, unsigned b, int c, const void *d), (a, b, c, d))                              \
    FUNCTION(void, DeleteTextures, (int a, const unsigned *b), (a, b))                                                 \
    FUNCTION(void, Disable, (unsigned a), (a))                                                                         \
    FUNCTION(void, DisableClientState, (unsigned a), (a))                                                              \
    FUNCTION(void, DrawElements, (unsigned a, int b, unsigned c, const void *d), (a, b, c, d))                         \
    FUNCTION(void, DrawPixels, (int a, int b, unsigned c, unsigned d, const void *e), (a, b, c, d, e))                 \
    FUNCTION(void, Enable, (unsigned a), (a))                                                                          \
    FUNCTION(void, EnableClientState, (unsigned a), (a))                                                               \
    FUNCTION(void, GenTextures, (int a, unsigned *b), (a, b))                                                          \
    FUNCTION(void, GetIntegerv, (unsigned a, int *b), (a, b))                                                          \
    FUNCTION(void, GetTexEnviv, (unsigned a, unsigned b, int *c), (a, b, c))                                           \
    FUNCTION(void, LoadIdentity, (), ())                                                                               \
    FUNCTION(void, MatrixMode, (unsigned a), (a))                                                                      \
    FUNCTION(void, Ortho, (double a, double b, double c, double d, double e, double f), (a, b, c, d, e, f))            \
    FUNCTION(void, PixelStorei, (unsigned a, int b), (a, b))                                                           \
    FUNCTION(void, PolygonMode, (unsigned a, unsigned b), (a, b))                                                      \
    FUNCTION(void, PopAttrib, (), ())                                                                                  \
    FUNCTION(void, PopMatrix, (), ())                                                                                  \
    FUNCTION(void, PushAttrib, (unsigned a), (a))                                                                      \
    FUNCTION(void, PushMatrix, (), ())                                                                                 \
    FUNCTION(void, RasterPos2f, (float a, float b), (a, b))                                                            \
    FUNCTION(void, ReadPixels, (int a, int b, int c, int d, unsigned e, unsigned f, void *g), (a, b, c, d, e, f, g))   \
    FUNCTION(void, Scissor, (int a, int b, int c, int d), (a, b, c, d))                                                \
    FUNCTION(void, ShadeModel, (unsigned a), (a))                                                                      \
    FUNCTION(void, TexCoordPointer, (int a, unsigned b, int c, const void *d), (a, b, c, d))                           \
    FUNCTION(void, TexEnvi, (unsigned a, unsigned b, int c), (a, b, c))                                                \
    FUNCTION(void, TexImage2D, (unsigned a, int b, int c, int d, int e, int f, unsigned g, unsigned h, const void *i), \
             (a, b, c, d, e, f, g, h, i))                                                                              \
    FUNCTION(void, TexParameteri, (unsigned a, unsigned b, int c), (a, b, c))                                          \
    FUNCTION(void, TexSubImage2D,                                                                                      \
             (unsigned a, int b, int c, int d, int e, int f, unsigned g, unsigned h, const void *i),                   \
             (a, b, c, d, e, f, g, h, i))                                                                              \
    FUNCTION(void, VertexPointer, (int a, unsigned b, int c, const void *d), (a, b, c, d))                             \
    FUNCTION(void, Viewport, (int a, int b, int c, int d), (a, b, c, d))

namespace view
{
namespace
{

struct GlCalls {
#define CLAQUE_VIEW_MEMBER(result, name, parameters, arguments) result(*name) parameters = nullptr;
    CLAQUE_VIEW_GL(CLAQUE_VIEW_MEMBER)
#undef CLAQUE_VIEW_MEMBER
};

GlCalls gl_calls;

constexpr unsigned rgb_format = 0x1907;

}  // namespace

bool load_gl_calls(scenes::GetProcAddress get, void *user, std::string &missing)
{
#define CLAQUE_VIEW_LOAD(result, name, parameters, arguments)                      \
    gl_calls.name = reinterpret_cast<result(*) parameters>(get(user, "gl" #name)); \
    if (!gl_calls.name) {                                                          \
        missing = "gl" #name;                                                      \
        return false;                                                              \
    }
    CLAQUE_VIEW_GL(CLAQUE_VIEW_LOAD)
#undef CLAQUE_VIEW_LOAD
    return true;
}

unsigned put_picture(unsigned texture, int side_px, const uint8_t *rgba)
{
    namespace gl = scenes::gl;
    constexpr unsigned bound = 0x8069;
    int before = 0;
    gl_calls.GetIntegerv(bound, &before);
    if (texture == 0) gl_calls.GenTextures(1, &texture);
    gl_calls.BindTexture(gl::texture_2d, texture);
    gl_calls.TexParameteri(gl::texture_2d, gl::mag_filter, gl::nearest);
    gl_calls.TexParameteri(gl::texture_2d, gl::min_filter, gl::nearest);
    gl_calls.PixelStorei(gl::unpack_alignment, 1);
    gl_calls.TexImage2D(gl::texture_2d, 0, gl::rgba, side_px, side_px, 0, gl::rgba, gl::unsigned_byte, rgba);
    gl_calls.BindTexture(gl::texture_2d, static_cast<unsigned>(before));
    return texture;
}

void read_columns(const processes::Tile &columns, int below, int height, uint8_t *rgb, int row_px)
{
    constexpr unsigned pack_row_length = 0xD02, pack_skip_pixels = 0xD04, pack_alignment = 0xD05;
    gl_calls.PixelStorei(pack_alignment, 1);
    gl_calls.PixelStorei(pack_row_length, row_px);
    gl_calls.PixelStorei(pack_skip_pixels, columns.x0);
    gl_calls.ReadPixels(columns.x0, below, columns.x1 - columns.x0, height, rgb_format, scenes::gl::unsigned_byte, rgb);
    gl_calls.PixelStorei(pack_skip_pixels, 0);
    gl_calls.PixelStorei(pack_row_length, 0);
    gl_calls.PixelStorei(pack_alignment, 4);
}

void draw_rows(int width, int height, const uint8_t *rgb, int row_px)
{
    namespace gl = scenes::gl;
    constexpr unsigned all_bits = 0xFFFFF, unpack_row_length = 0xCF2;
    constexpr unsigned changes_pixels[] = {gl::texture_2d, gl::lighting, gl::fog,         gl::depth_test,
                                           gl::blend,      0xBC0,        0xB90,           0xBD0,
                                           0xBF2,          0xBF1,        gl::scissor_test};
    gl_calls.PushAttrib(all_bits);
    // The last ones: alpha test, stencil test, dither, and logic operations of both kinds.
    for (const unsigned state : changes_pixels) gl_calls.Disable(state);
    for (const unsigned matrix : {gl::modelview, gl::projection}) {
        gl_calls.MatrixMode(matrix);
        gl_calls.PushMatrix();
        gl_calls.LoadIdentity();
    }
    gl_calls.PixelStorei(gl::unpack_alignment, 1);
    gl_calls.PixelStorei(unpack_row_length, row_px);
    gl_calls.RasterPos2f(-1, -1);  // exactly the corner of the viewport
    gl_calls.DrawPixels(width, height, rgb_format, gl::unsigned_byte, rgb);
    gl_calls.PixelStorei(unpack_row_length, 0);
    gl_calls.PixelStorei(gl::unpack_alignment, 4);
    for (const unsigned matrix : {gl::projection, gl::modelview}) {
        gl_calls.MatrixMode(matrix);
        gl_calls.PopMatrix();
    }
    gl_calls.PopAttrib();
}

void drop_picture(unsigned texture) { gl_calls.DeleteTextures(1, &texture); }

}  // namespace view

// Hidden, so that no library which the program opens takes them for libGL's.
extern "C" {
#define CLAQUE_VIEW_DEFINE(result, name, parameters, arguments)       \
    __attribute__((visibility("hidden"))) result gl##name parameters; \
    result gl##name parameters { return view::gl_calls.name arguments; }
CLAQUE_VIEW_GL(CLAQUE_VIEW_DEFINE)
#undef CLAQUE_VIEW_DEFINE
}

// The part of OpenGL 1.1 that claque uses: a table of function pointers, requested from the host, and enum values. No
// GL system header is included and no GL library linked; claque calls nothing outside this table.
#pragma once

#include <cstdint>

#include "lib/base/floats.h"
#include "lib/base/status.h"

#if defined(_WIN32)
#define CLAQUE_GL_CALL __stdcall
#else
#define CLAQUE_GL_CALL
#endif

namespace claque::passes
{

using GlFunction = void (*)();
using GetProcAddress = GlFunction (*)(void *user, const char *name);

namespace gl
{
using Enum = uint32_t;
using Bits = uint32_t;
using Bool = uint8_t;

constexpr Bool no = 0, yes = 1;

constexpr Enum front = 0x0404, back = 0x0405, cw = 0x0900, ccw = 0x0901, front_and_back = 0x0408;
constexpr Enum triangles = 0x0004;
constexpr Enum signed_byte = 0x1400, unsigned_byte = 0x1401, signed_short = 0x1402, unsigned_short = 0x1403;
constexpr Enum unsigned_int = 0x1405, real = 0x1406;
constexpr Enum equal = 0x0202, lequal = 0x0203, notequal = 0x0205, gequal = 0x0206;
constexpr Enum src_alpha = 0x0302, one_minus_src_alpha = 0x0303, keep = 0x1E00, replace = 0x1E01;

constexpr Enum version = 0x1F02, extensions = 0x1F03;
constexpr Enum render_mode = 0x0C40, render = 0x1C00, rgba_mode = 0x0C31, list_index = 0x0B33;
constexpr Enum attrib_stack_depth = 0x0BB0, client_attrib_stack_depth = 0x0BB1;
constexpr Enum max_attrib_stack_depth = 0x0D35, max_client_attrib_stack_depth = 0x0D3B, max_texture_size = 0x0D33;

constexpr Enum matrix_mode = 0x0BA0, modelview = 0x1700, projection = 0x1701, texture = 0x1702;
constexpr Enum modelview_matrix = 0x0BA6, projection_matrix = 0x0BA7, texture_matrix = 0x0BA8;
constexpr Enum modelview_stack_depth = 0x0BA3, projection_stack_depth = 0x0BA4, texture_stack_depth = 0x0BA5;
constexpr Enum max_modelview_stack_depth = 0x0D36;

constexpr Enum alpha_test = 0x0BC0, blend = 0x0BE2, colour_logic_op = 0x0BF2, colour_writemask = 0x0C23;
constexpr Enum cull_face = 0x0B44, depth_test = 0x0B71, normalize = 0x0BA1;
constexpr Enum lighting = 0x0B50, stencil_test = 0x0B90, polygon_offset_fill = 0x8037;
constexpr Enum stencil_bits = 0x0D57, viewport = 0x0BA2;
constexpr Enum line_smooth = 0x0B20, line_stipple = 0x0B24, polygon_smooth = 0x0B41, polygon_stipple = 0x0B42;
// `multisample` and those named after it are GL 1.3 and used only where the host has them.
constexpr Enum point_smooth = 0x0B10, multisample = 0x809D;
constexpr Enum sample_alpha_to_coverage = 0x809E, sample_alpha_to_one = 0x809F;
constexpr Enum colour_material = 0x0B57, ambient_and_diffuse = 0x1602, light_model_two_side = 0x0B52;
constexpr Enum emission = 0x1600;

constexpr Enum shade_model = 0x0B54, flat = 0x1D00, texture_1d = 0x0DE0;
constexpr Enum texture_2d = 0x0DE1, proxy_texture_2d = 0x8064, texture_env = 0x2300, texture_env_mode = 0x2200;
constexpr Enum texture_gen_s = 0x0C60, texture_gen_t = 0x0C61, texture_gen_r = 0x0C62, texture_gen_q = 0x0C63;
constexpr Enum texture_mag_filter = 0x2800, texture_min_filter = 0x2801, wrap_s = 0x2802, wrap_t = 0x2803;
constexpr Enum texture_binding_2d = 0x8069;
constexpr Enum nearest = 0x2600, linear = 0x2601, linear_mipmap_linear = 0x2703;
constexpr Enum clamp = 0x2900, repeat = 0x2901, modulate = 0x2100;
constexpr Enum alpha = 0x1906, alpha8 = 0x803C, rgba = 0x1908, rgba8 = 0x8058, texture_width = 0x1000,
               texture_alpha_size = 0x805F;
constexpr Enum unpack_swap_bytes = 0x0CF0, unpack_lsb_first = 0x0CF1, unpack_row_length = 0x0CF2;
constexpr Enum unpack_skip_rows = 0x0CF3, unpack_skip_pixels = 0x0CF4, unpack_alignment = 0x0CF5;
constexpr Enum map_colour = 0x0D10;
constexpr Enum red_scale = 0x0D14, red_bias = 0x0D15, green_scale = 0x0D18, green_bias = 0x0D19;
constexpr Enum blue_scale = 0x0D1A, blue_bias = 0x0D1B, alpha_scale = 0x0D1C, alpha_bias = 0x0D1D;

constexpr Enum vertex_array = 0x8074, normal_array = 0x8075, colour_array = 0x8076, index_array = 0x8077;
constexpr Enum texture_coord_array = 0x8078, edge_flag_array = 0x8079;
constexpr Enum vertex_array_size = 0x807A, vertex_array_type = 0x807B, vertex_array_stride = 0x807C;
constexpr Enum vertex_array_pointer = 0x808E;

constexpr Bits current_bit = 0x1, polygon_bit = 0x8, pixel_mode_bit = 0x20, lighting_bit = 0x40;
constexpr Bits depth_buffer_bit = 0x100, stencil_buffer_bit = 0x400, enable_bit = 0x2000, colour_buffer_bit = 0x4000,
               texture_bit = 0x40000;
constexpr Bits client_pixel_store_bit = 0x1, client_vertex_array_bit = 0x2;
constexpr Bits all_attrib_bits = 0xfffff, all_client_attrib_bits = 0xffffffff;
}  // namespace gl

// A function of the host's GL, which runs under the host's floating-point settings: software GL computes with them.
template <class Function>
class GlCall;
template <class Result, class... Arguments>
class GlCall<Result(Arguments...)>
{
public:
    using Pointer = Result(CLAQUE_GL_CALL *)(Arguments...);

    GlCall(Pointer function = nullptr) : function_(function) {}
    explicit operator bool() const { return function_ != nullptr; }

    [[gnu::noinline]] Result operator()(Arguments... arguments) const
    {
        if (!clq_floats_differ()) return function_(arguments...);
        const base::Floats<false> host;
        return function_(arguments...);
    }

private:
    Pointer function_;
};

struct Gl11 {
    using Enum = gl::Enum;
    using Bits = gl::Bits;
    using Bool = gl::Bool;

    GlCall<const uint8_t *(Enum name)> GetString;
    GlCall<void(Enum name, int32_t *out)> GetIntegerv;
    GlCall<void(Enum name, double *out)> GetDoublev;
    GlCall<void(Enum name, void **out)> GetPointerv;
    GlCall<Bool(Enum what)> IsEnabled;
    GlCall<int32_t(Enum mode)> RenderMode;
    GlCall<void()> EndList;
    GlCall<void()> Flush;

    GlCall<void(Enum what)> Enable;
    GlCall<void(Enum what)> Disable;
    GlCall<void(Enum function, float reference)> AlphaFunc;
    GlCall<void(Enum function)> DepthFunc;
    GlCall<void(Bool writes)> DepthMask;
    GlCall<void(Bool r, Bool g, Bool b, Bool a)> ColorMask;
    GlCall<void(Enum source, Enum destination)> BlendFunc;
    GlCall<void(float factor, float units)> PolygonOffset;
    GlCall<void(Enum function, int32_t reference, uint32_t mask)> StencilFunc;
    GlCall<void(Enum fails, Enum depth_fails, Enum passes)> StencilOp;
    GlCall<void(uint32_t mask)> StencilMask;
    GlCall<void(int32_t value)> ClearStencil;
    GlCall<void(Bits buffers)> Clear;
    GlCall<void(Enum face)> CullFace;
    GlCall<void(Enum winding)> FrontFace;
    GlCall<void(Enum model)> ShadeModel;
    GlCall<void(Enum name, int32_t value)> LightModeli;
    GlCall<void(Enum face, Enum name, float *out)> GetMaterialfv;
    GlCall<void(Enum face, Enum name, const float *values)> Materialfv;
    GlCall<void(Enum face, Enum what)> ColorMaterial;
    GlCall<void(Enum target, Enum name, int32_t value)> TexEnvi;

    GlCall<void(Bits groups)> PushAttrib;
    GlCall<void()> PopAttrib;
    GlCall<void(Bits groups)> PushClientAttrib;
    GlCall<void()> PopClientAttrib;
    GlCall<void(Enum stack)> MatrixMode;
    GlCall<void()> LoadIdentity;
    GlCall<void(const float *columns)> LoadMatrixf;
    GlCall<void(const double *columns)> LoadMatrixd;
    GlCall<void(const float *columns)> MultMatrixf;
    GlCall<void()> PushMatrix;
    GlCall<void()> PopMatrix;

    GlCall<void(int32_t count, uint32_t *names)> GenTextures;
    GlCall<void(int32_t count, const uint32_t *names)> DeleteTextures;
    GlCall<void(Enum target, uint32_t name)> BindTexture;
    GlCall<void(Enum target, int32_t level, int32_t internal_format, int32_t width, int32_t height, int32_t border,
                Enum format, Enum type, const void *pixels)>
        TexImage2D;
    GlCall<void(Enum target, Enum name, int32_t value)> TexParameteri;
    GlCall<void(Enum target, int32_t level, Enum name, int32_t *out)> GetTexLevelParameteriv;
    GlCall<void(Enum name, int32_t value)> PixelStorei;
    GlCall<void(Enum name, float value)> PixelTransferf;

    GlCall<void(Enum array)> EnableClientState;
    GlCall<void(Enum array)> DisableClientState;
    GlCall<void(int32_t size, Enum type, int32_t stride, const void *data)> VertexPointer;
    GlCall<void(Enum type, int32_t stride, const void *data)> NormalPointer;
    GlCall<void(int32_t size, Enum type, int32_t stride, const void *data)> TexCoordPointer;
    GlCall<void(int32_t size, Enum type, int32_t stride, const void *data)> ColorPointer;
    GlCall<void(Enum mode, int32_t count, Enum type, const void *indices)> DrawElements;
    GlCall<void(float r, float g, float b, float a)> Color4f;
};

inline int32_t integer(const Gl11 &gl, gl::Enum name)
{
    int32_t value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

// Fills the table. Fails with CLQ_ARGUMENT (no get_proc_address) or CLQ_GL_MISSING (names the first function that the
// host lacks; or no context is current, which shows as glGetString returning null). After a failure the table cannot be
// used.
base::Status load(Gl11 &table, GetProcAddress get_proc_address, void *user);

// CLQ_GL_MISSING if no context is current on this thread: GL calls then do nothing and report no error.
base::Status check_current(const Gl11 &gl);

// The result of drawing, or CLQ_GL_MISSING if the context was lost meanwhile.
base::Status still_current(const Gl11 &gl, const base::Status &drawn);

}  // namespace claque::passes

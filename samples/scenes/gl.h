// The few OpenGL 1.1 functions with which scenes draw the scenery round a crowd. They are loaded from the context by
// name, as claque does it: nothing is linked, and no GL header is needed.
#pragma once

#include <claque/renderer.h>

#include <cstddef>
#include <string>

namespace scenes
{

namespace gl
{
constexpr unsigned depth_buffer_bit = 0x100, color_buffer_bit = 0x4000;
constexpr unsigned triangles = 4, lequal = 0x203, src_alpha = 0x302, one_minus_src_alpha = 0x303;
constexpr unsigned front_and_back = 0x408, cull_face = 0xB44, lighting = 0xB50, color_material = 0xB57;
constexpr unsigned depth_test = 0xB71, normalize = 0xBA1, blend = 0xBE2, texture_2d = 0xDE1, light0 = 0x4000;
constexpr unsigned light_model_ambient = 0xB53, ambient = 0x1200, diffuse = 0x1201, specular = 0x1202,
                   position = 0x1203;
constexpr unsigned spot_direction = 0x1204, spot_exponent = 0x1205, spot_cutoff = 0x1206;
constexpr unsigned constant_attenuation = 0x1207, linear_attenuation = 0x1208, quadratic_attenuation = 0x1209;
constexpr unsigned ambient_and_diffuse = 0x1602, modelview = 0x1700, projection = 0x1701, rgba = 0x1908;
constexpr unsigned modulate = 0x2100, texture_env = 0x2300, texture_env_mode = 0x2200;
constexpr unsigned mag_filter = 0x2800, min_filter = 0x2801, wrap_s = 0x2802, wrap_t = 0x2803;
constexpr unsigned nearest = 0x2600, nearest_mipmap_nearest = 0x2700;
constexpr unsigned linear = 0x2601, linear_mipmap_nearest = 0x2701, linear_mipmap_linear = 0x2703, repeat = 0x2901,
                   clamp = 0x2900;
constexpr unsigned unsigned_byte = 0x1401, unsigned_int = 0x1405, float_type = 0x1406, unpack_alignment = 0xCF5;
constexpr unsigned vertex_array = 0x8074, normal_array = 0x8075, color_array = 0x8076, texcoord_array = 0x8078;
constexpr unsigned version = 0x1F02, scissor_test = 0xC11, multisample = 0x809D;
constexpr unsigned fog = 0xB60, fog_density = 0xB62, fog_mode = 0xB65, fog_color = 0xB66, exp = 0x800, exp2 = 0x801;
constexpr unsigned polygon_offset_fill = 0x8037;
}  // namespace gl

struct Gl {
    const unsigned char *(*GetString)(unsigned) = nullptr;
    void (*Viewport)(int, int, int, int) = nullptr;
    void (*ClearColor)(float, float, float, float) = nullptr;
    void (*Clear)(unsigned) = nullptr;
    void (*Enable)(unsigned) = nullptr;
    void (*Disable)(unsigned) = nullptr;
    void (*DepthMask)(unsigned char) = nullptr;
    void (*DepthFunc)(unsigned) = nullptr;
    void (*DepthRange)(double, double) = nullptr;
    void (*BlendFunc)(unsigned, unsigned) = nullptr;
    void (*MatrixMode)(unsigned) = nullptr;
    void (*LoadIdentity)() = nullptr;
    void (*LoadMatrixf)(const float *) = nullptr;
    void (*Lightfv)(unsigned, unsigned, const float *) = nullptr;
    void (*LightModelfv)(unsigned, const float *) = nullptr;
    void (*ColorMaterial)(unsigned, unsigned) = nullptr;
    void (*Color4f)(float, float, float, float) = nullptr;
    void (*GenTextures)(int, unsigned *) = nullptr;
    void (*DeleteTextures)(int, const unsigned *) = nullptr;
    void (*BindTexture)(unsigned, unsigned) = nullptr;
    void (*TexParameteri)(unsigned, unsigned, int) = nullptr;
    void (*TexEnvi)(unsigned, unsigned, int) = nullptr;
    void (*TexImage2D)(unsigned, int, int, int, int, int, unsigned, unsigned, const void *) = nullptr;
    void (*PixelStorei)(unsigned, int) = nullptr;
    void (*Fogf)(unsigned, float) = nullptr;
    void (*Fogi)(unsigned, int) = nullptr;
    void (*Fogfv)(unsigned, const float *) = nullptr;
    void (*PolygonOffset)(float, float) = nullptr;
    void (*EnableClientState)(unsigned) = nullptr;
    void (*DisableClientState)(unsigned) = nullptr;
    void (*VertexPointer)(int, unsigned, int, const void *) = nullptr;
    void (*NormalPointer)(unsigned, int, const void *) = nullptr;
    void (*ColorPointer)(int, unsigned, int, const void *) = nullptr;
    void (*TexCoordPointer)(int, unsigned, int, const void *) = nullptr;
    void (*DrawElements)(unsigned, int, unsigned, const void *) = nullptr;
    void (*Scissor)(int, int, int, int) = nullptr;
    void (*Flush)() = nullptr;
    void (*Finish)() = nullptr;
};

using GetProcAddress = clq_gl_function (*)(void *user, const char *name);

// Fills the table from the current context. Returns false with the name of the missing function if it cannot.
bool load(Gl &gl, GetProcAddress get, void *user, std::string &missing);

}  // namespace scenes

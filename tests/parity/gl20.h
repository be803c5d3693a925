// The functions of OpenGL 2.0 and of transform feedback that the GPU peer loads by name. The library never uses them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "samples/contexts/offscreen.h"

namespace parity_test
{

struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

namespace gl
{
constexpr unsigned triangles = 4, points = 0, unsigned_byte = 0x1401, unsigned_int = 0x1405, real = 0x1406;
constexpr unsigned color_buffer_bit = 0x4000, depth_buffer_bit = 0x100;
constexpr unsigned depth_test = 0xB71, lequal = 0x203, cull_face = 0xB44, back = 0x405, cw = 0x900, ccw = 0x901;
constexpr unsigned dither = 0xBD0, blend = 0xBE2, modelview = 0x1700, projection = 0x1701;
constexpr unsigned texture_2d = 0xDE1, texture0 = 0x84C0, mag_filter = 0x2800, min_filter = 0x2801, wrap_s = 0x2802,
                   wrap_t = 0x2803, nearest = 0x2600, clamp_to_edge = 0x812F, rgb = 0x1907, rgba = 0x1908,
                   rgb8 = 0x8051, rgba8 = 0x8058, unpack_alignment = 0xCF5;
constexpr unsigned array_buffer = 0x8892, element_array_buffer = 0x8893, static_draw = 0x88E4, stream_draw = 0x88E0;
constexpr unsigned vertex_shader = 0x8B31, fragment_shader = 0x8B30, compile_status = 0x8B81, link_status = 0x8B82,
                   max_vertex_uniform_components = 0x8B4A;
constexpr unsigned transform_feedback_buffer = 0x8C8E, interleaved_attribs = 0x8C8C, rasterizer_discard = 0x8C89;
}  // namespace gl

// type, name, arguments
#define PARITY_GL20(X)                                                                         \
    X(void, Viewport, (int, int, int, int))                                                    \
    X(void, ClearColor, (float, float, float, float))                                          \
    X(void, Clear, (unsigned))                                                                 \
    X(void, Enable, (unsigned))                                                                \
    X(void, Disable, (unsigned))                                                               \
    X(void, DepthFunc, (unsigned))                                                             \
    X(void, DepthMask, (uint8_t))                                                              \
    X(void, CullFace, (unsigned))                                                              \
    X(void, FrontFace, (unsigned))                                                             \
    X(void, MatrixMode, (unsigned))                                                            \
    X(void, LoadMatrixf, (const float *))                                                      \
    X(void, Finish, ())                                                                        \
    X(unsigned, GetError, ())                                                                  \
    X(void, GetIntegerv, (unsigned, int *))                                                    \
    X(void, GenTextures, (int, unsigned *))                                                    \
    X(void, DeleteTextures, (int, const unsigned *))                                           \
    X(void, BindTexture, (unsigned, unsigned))                                                 \
    X(void, TexParameteri, (unsigned, unsigned, int))                                          \
    X(void, TexImage2D, (unsigned, int, int, int, int, int, unsigned, unsigned, const void *)) \
    X(void, PixelStorei, (unsigned, int))                                                      \
    X(void, ActiveTexture, (unsigned))                                                         \
    X(void, DrawArrays, (unsigned, int, int))                                                  \
    X(void, DrawElements, (unsigned, int, unsigned, const void *))                             \
    X(void, GenBuffers, (int, unsigned *))                                                     \
    X(void, DeleteBuffers, (int, const unsigned *))                                            \
    X(void, BindBuffer, (unsigned, unsigned))                                                  \
    X(void, BufferData, (unsigned, ptrdiff_t, const void *, unsigned))                         \
    X(void, GetBufferSubData, (unsigned, ptrdiff_t, ptrdiff_t, void *))                        \
    X(void, VertexAttribPointer, (unsigned, int, unsigned, uint8_t, int, const void *))        \
    X(void, VertexAttrib4f, (unsigned, float, float, float, float))                            \
    X(void, EnableVertexAttribArray, (unsigned))                                               \
    X(void, DisableVertexAttribArray, (unsigned))                                              \
    X(unsigned, CreateShader, (unsigned))                                                      \
    X(void, ShaderSource, (unsigned, int, const char *const *, const int *))                   \
    X(void, CompileShader, (unsigned))                                                         \
    X(void, GetShaderiv, (unsigned, unsigned, int *))                                          \
    X(void, GetShaderInfoLog, (unsigned, int, int *, char *))                                  \
    X(void, DeleteShader, (unsigned))                                                          \
    X(unsigned, CreateProgram, ())                                                             \
    X(void, AttachShader, (unsigned, unsigned))                                                \
    X(void, BindAttribLocation, (unsigned, unsigned, const char *))                            \
    X(void, LinkProgram, (unsigned))                                                           \
    X(void, GetProgramiv, (unsigned, unsigned, int *))                                         \
    X(void, GetProgramInfoLog, (unsigned, int, int *, char *))                                 \
    X(void, UseProgram, (unsigned))                                                            \
    X(void, DeleteProgram, (unsigned))                                                         \
    X(int, GetUniformLocation, (unsigned, const char *))                                       \
    X(void, Uniform1i, (int, int))                                                             \
    X(void, Uniform1f, (int, float))                                                           \
    X(void, Uniform2fv, (int, int, const float *))                                             \
    X(void, Uniform3fv, (int, int, const float *))                                             \
    X(void, Uniform4fv, (int, int, const float *))

// Of OpenGL 3.0: needed to read back skinned vertices. Without it they are not read.
#define PARITY_GL30(X)                                                                 \
    X(void, TransformFeedbackVaryings, (unsigned, int, const char *const *, unsigned)) \
    X(void, BeginTransformFeedback, (unsigned))                                        \
    X(void, EndTransformFeedback, ())                                                  \
    X(void, BindBufferBase, (unsigned, unsigned, unsigned))

struct Gl20 {
    // The context must be current. Throws Failure with the first function of 2.0 that is missing.
    explicit Gl20(const contexts::Offscreen &context);
    bool has_feedback() const
    {
        return TransformFeedbackVaryings && BeginTransformFeedback && EndTransformFeedback && BindBufferBase;
    }
    // Throws Failure if OpenGL has recorded an error.
    void expect_no_error(const char *doing) const;

#define PARITY_FUNCTION(type, name, arguments) type(*name) arguments = nullptr;
    PARITY_GL20(PARITY_FUNCTION)
    PARITY_GL30(PARITY_FUNCTION)
#undef PARITY_FUNCTION
};

}  // namespace parity_test

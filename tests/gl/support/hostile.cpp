#include "tests/gl/support/hostile.h"

namespace gltest
{

HostileHost::HostileHost(const HostGl &host) : host_(host)
{
    set_fragments();
    set_rasterisation();
    set_lighting();
    set_texturing();
    set_matrices();
    set_arrays();
    set_pixels();
}

// Blending, a logic operation and an alpha test that would destroy the picture; the depth test is reversed and depth is
// not written.
void HostileHost::set_fragments() const
{
    host_.Enable(gl::blend);
    host_.BlendFunc(0x0306, 0x0301);  // GL_DST_COLOR, GL_ONE_MINUS_SRC_COLOR
    host_.Enable(gl::colour_logic_op);
    host_.LogicOp(0x1506);  // GL_XOR
    host_.Enable(gl::alpha_test);
    host_.AlphaFunc(0x0201, 0.3f);  // GL_LESS
    host_.Disable(gl::depth_test);
    host_.DepthFunc(0x0204);  // GL_GREATER
    host_.DepthMask(0);
    host_.ColorMask(1, 1, 1, 1);
    host_.ask<void (*)(int32_t, int32_t, int32_t, int32_t)>("glScissor")(0, 0, 4000, 4000);
    host_.Enable(0x0C11);                                                                // GL_SCISSOR_TEST
    host_.ask<void (*)(gl::Enum, int32_t, uint32_t)>("glStencilFunc")(0x0207, 3, 0x5f);  // GL_ALWAYS
    host_.ask<void (*)(gl::Enum, gl::Enum, gl::Enum)>("glStencilOp")(0x1E00, 0x1E01, 0x1E02);
    host_.Enable(0x0B90);   // GL_STENCIL_TEST
    host_.Disable(0x0BD0);  // GL_DITHER
}

void HostileHost::set_rasterisation() const
{
    host_.Enable(gl::cull_face);
    host_.CullFace(gl::front_and_back);
    host_.FrontFace(gl::cw);
    for (const gl::Enum what :
         {gl::point_smooth, gl::line_smooth, gl::polygon_smooth, gl::line_stipple, gl::polygon_stipple})
        host_.Enable(what);
    // Tightly packed whatever was set before: the pattern has no more bytes, and where pixels are skipped Mesa 22.3.6
    // writes one past its own copy.
    host_.PixelStorei(gl::unpack_alignment, 4);
    for (const gl::Enum name : {gl::unpack_row_length, gl::unpack_skip_rows, gl::unpack_skip_pixels})
        host_.PixelStorei(name, 0);
    uint8_t pattern[128];
    for (int i = 0; i < 128; ++i) pattern[i] = static_cast<uint8_t>(i * 37);
    host_.ask<void (*)(const uint8_t *)>("glPolygonStipple")(pattern);
    host_.ask<void (*)(int32_t, uint16_t)>("glLineStipple")(3, 0x5555);
    host_.ask<void (*)(float)>("glLineWidth")(2);
    host_.ask<void (*)(float, float)>("glPolygonOffset")(1.5f, 2);  // GL_POLYGON_OFFSET_FILL stays off
    for (const gl::Enum what : {gl::multisample, gl::sample_alpha_to_coverage, gl::sample_alpha_to_one})
        host_.Enable(what);
}

// Colour material on other faces and another property, odd materials that must be restored, lighting itself off.
void HostileHost::set_lighting() const
{
    const float odd[4] = {0.11f, 0.22f, 0.33f, 0.44f};
    for (const gl::Enum name : {0x1200u, 0x1201u, 0x1202u, 0x1600u}) {
        host_.Materialfv(0x0404, name, odd);
        host_.Materialfv(0x0405, name, odd);
    }
    host_.ColorMaterial(0x0404, 0x1600);  // GL_FRONT, GL_EMISSION
    host_.Enable(gl::colour_material);
    host_.Disable(gl::normalize);
    host_.LightModeli(gl::light_model_two_side, 1);
    host_.LightModelfv(0x0B53, odd);
    const float position[4] = {3, 4, 5, 1};
    host_.Lightfv(0x4003, 0x1203, position);
    host_.Fogi(0x0B65, 0x2601);  // GL_LINEAR
    host_.Color4f(0.5f, 0.25f, 0.125f, 0.75f);
    host_.ask<void (*)(float, float, float)>("glNormal3f")(0.6f, 0.8f, 0);
    host_.ask<void (*)(float, float, float, float)>("glTexCoord4f")(0.1f, 0.2f, 0.3f, 2);
}

void HostileHost::set_texturing()
{
    const uint8_t texel[4] = {1, 2, 3, 4};
    host_.GenTextures(2, texture_);
    host_.BindTexture(gl::texture_2d, texture_[0]);
    host_.TexParameteri(gl::texture_2d, gl::texture_min_filter, 0x2601);
    host_.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), 1, 1, 0, gl::rgba, gl::unsigned_byte, texel);
    host_.BindTexture(0x0DE0, texture_[1]);
    host_.Enable(0x0DE0);  // GL_TEXTURE_1D
    host_.Disable(gl::texture_2d);
    host_.TexEnvi(gl::texture_env, gl::texture_env_mode, 0x0BE2);  // GL_BLEND
    const gl::Enum generators[] = {gl::texture_gen_s, gl::texture_gen_t, gl::texture_gen_r, gl::texture_gen_q};
    for (uint32_t c = 0; c < 4; ++c) {
        host_.TexGeni(0x2000 + c, 0x2500, 0x2401);  // GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR
        host_.Enable(generators[c]);
    }
}

void HostileHost::set_matrices() const
{
    float odd[16];
    for (int i = 0; i < 16; ++i) odd[i] = 0.1f * static_cast<float>(i + 1) + (i % 5 == 0 ? 1.0f : 0.0f);
    int32_t most = 0, depth = 0;
    host_.GetIntegerv(0x0D38, &most);  // GL_MAX_PROJECTION_STACK_DEPTH
    host_.GetIntegerv(gl::projection_stack_depth, &depth);
    host_.MatrixMode(gl::projection);
    for (; depth < most; ++depth) host_.PushMatrix();  // the stack is full
    host_.LoadMatrixf(odd);
    host_.MatrixMode(gl::modelview);
    host_.LoadMatrixf(odd);
    host_.MatrixMode(gl::texture);
    host_.LoadMatrixf(odd);  // the matrix mode stays the projection's
}

void HostileHost::set_arrays() const
{
    for (const gl::Enum array : {gl::colour_array, gl::index_array, gl::edge_flag_array})
        host_.EnableClientState(array);
    host_.VertexPointer(2, 0x140A, 16, numbers_);  // GL_DOUBLE
    host_.NormalPointer(0x1400, 12, numbers_ + 1);
    host_.TexCoordPointer(3, 0x1402, 24, numbers_ + 2);
    host_.ColorPointer(3, 0x1401, 4, numbers_ + 3);
    host_.ask<void (*)(gl::Enum, int32_t, const void *)>("glIndexPointer")(0x1406, 4, numbers_ + 4);
    host_.ask<void (*)(int32_t, const void *)>("glEdgeFlagPointer")(1, numbers_ + 5);
}

void HostileHost::set_pixels() const
{
    host_.PixelStorei(gl::unpack_alignment, 8);
    host_.PixelStorei(gl::unpack_row_length, 77);
    host_.PixelStorei(gl::unpack_skip_rows, 2);
    host_.PixelStorei(gl::unpack_skip_pixels, 3);
    host_.PixelStorei(gl::unpack_swap_bytes, 1);
    host_.PixelTransferf(gl::red_scale, 0.5f);
    host_.PixelTransferf(gl::alpha_bias, 0.25f);
    host_.PixelTransferf(gl::map_colour, 1);
}

}  // namespace gltest

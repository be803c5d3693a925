#include "tests/gl/support/torture.h"

#include <vector>

namespace gltest
{

const Switch all_switches[] = {
    {0x0B10, false}, {0x0B20, false}, {0x0B24, false}, {0x0B41, false}, {0x0B42, false}, {0x0B44, false},
    {0x0B50, true},  {0x0B57, false}, {0x0B60, true},  {0x0B71, false}, {0x0B90, false}, {0x0BA1, false},
    {0x0BC0, false}, {0x0BD0, false}, {0x0BE2, false}, {0x0BF1, false}, {0x0BF2, false}, {0x0C11, false},
    {0x0C60, false}, {0x0C61, false}, {0x0C62, false}, {0x0C63, false}, {0x0D80, false}, {0x0D90, false},
    {0x0D91, false}, {0x0D92, false}, {0x0D93, false}, {0x0D94, false}, {0x0D95, false}, {0x0D96, false},
    {0x0D97, false}, {0x0D98, false}, {0x0DB0, false}, {0x0DB1, false}, {0x0DB2, false}, {0x0DB3, false},
    {0x0DB4, false}, {0x0DB5, false}, {0x0DB6, false}, {0x0DB7, false}, {0x0DB8, false}, {0x0DE0, false},
    {0x0DE1, false}, {0x2A01, false}, {0x2A02, false}, {0x8037, false}, {0x3000, false}, {0x3001, false},
    {0x3002, false}, {0x3003, false}, {0x3004, false}, {0x3005, false}, {0x4000, false}, {0x4001, false},
    {0x4002, false}, {0x4003, false}, {0x4004, false}, {0x4005, false}, {0x4006, false}, {0x4007, false}};
const size_t switch_count = sizeof all_switches / sizeof all_switches[0];

TorturedHost::TorturedHost(const HostGl &host, uint32_t number) : host_(host), state_(number * 0x9e3779b97f4a7c15u + 1)
{
    fill_stacks();
    set_switches();
    set_functions();
    set_colours();
    set_texturing();
    set_matrices();
    set_arrays();
    set_pixels();
}

uint32_t TorturedHost::random_below(uint32_t of)
{
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<uint32_t>((state_ >> 33) % of);
}

void TorturedHost::set_switches()
{
    for (size_t i = 0; i < switch_count; ++i) {
        if (all_switches[i].inherited_and_seen) continue;
        coin() ? host_.Enable(all_switches[i].name) : host_.Disable(all_switches[i].name);
    }
}

void TorturedHost::set_functions()
{
    host_.AlphaFunc(0x0200 + random_below(8), real());
    host_.DepthFunc(0x0200 + random_below(8));
    host_.DepthMask(coin());
    host_.BlendFunc(one_of({0, 1, 0x0302, 0x0304, 0x0306, 0x0308}), one_of({0, 1, 0x0300, 0x0302, 0x0303}));
    host_.LogicOp(0x1500 + random_below(16));
    host_.CullFace(one_of({0x0404, 0x0405, 0x0408}));
    host_.FrontFace(one_of({gl::cw, gl::ccw}));
    host_.LightModeli(gl::light_model_two_side, int32_t(random_below(2)));
    host_.ask<void (*)(float)>("glLineWidth")(1 + float(random_below(5)));
    host_.ask<void (*)(int32_t, uint16_t)>("glLineStipple")(int32_t(1 + random_below(9)),
                                                            uint16_t(random_below(65536)));
    host_.ask<void (*)(gl::Enum, gl::Enum)>("glHint")(0x0C50 + random_below(5), 0x1100 + random_below(3));
    std::vector<uint8_t> pattern(128);
    for (uint8_t &byte : pattern) byte = static_cast<uint8_t>(random_below(256));
    host_.ask<void (*)(const uint8_t *)>("glPolygonStipple")(pattern.data());
}

void TorturedHost::set_colours()
{
    const float odd[4] = {real(), real(), real(), real()};
    host_.ColorMaterial(one_of({0x0404, 0x0405, 0x0408}), one_of({0x1200, 0x1201, 0x1202, 0x1600, 0x1602}));
    for (const gl::Enum face : {0x0404u, 0x0405u})
        for (const gl::Enum name : {0x1200u, 0x1201u, 0x1202u, 0x1600u}) host_.Materialfv(face, name, odd);
    host_.LightModelfv(0x0B53, odd);
    host_.Lightfv(0x4000 + random_below(8), 0x1203, odd);
    host_.Color4f(real(), real(), real(), real());
    host_.ask<void (*)(float, float, float)>("glNormal3f")(real(), real(), real());
    host_.ask<void (*)(float, float, float, float)>("glTexCoord4f")(real(), real(), real(), real());
    host_.ask<void (*)(uint8_t)>("glEdgeFlag")(coin());
}

void TorturedHost::set_texturing()
{
    const std::vector<uint8_t> texels(64, static_cast<uint8_t>(random_below(256)));
    host_.GenTextures(2, textures_);
    host_.BindTexture(gl::texture_2d, coin() ? textures_[0] : 0);
    host_.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), 4, 4, 0, gl::rgba, gl::unsigned_byte, texels.data());
    host_.BindTexture(0x0DE0, coin() ? textures_[1] : 0);
    host_.TexEnvi(gl::texture_env, gl::texture_env_mode, int32_t(one_of({0x2100, 0x2101, 0x0BE2, 0x1E01})));
    const float colour[4] = {real(), real(), real(), real()};
    host_.ask<void (*)(gl::Enum, gl::Enum, const float *)>("glTexEnvfv")(gl::texture_env, 0x2201, colour);
    for (gl::Enum c = 0; c < 4; ++c)  // sphere maps exist for s and t only
        host_.TexGeni(0x2000 + c, 0x2500, int32_t(c < 2 ? one_of({0x2400, 0x2401, 0x2402}) : one_of({0x2400, 0x2401})));
}

void TorturedHost::set_matrices()
{
    for (const gl::Enum stack : {gl::modelview, gl::projection, gl::texture}) {
        float odd[16];
        for (float &number : odd) number = real();
        host_.MatrixMode(stack);
        host_.LoadMatrixf(odd);
    }
    host_.MatrixMode(one_of({gl::modelview, gl::projection, gl::texture}));
}

void TorturedHost::set_arrays()
{
    for (const gl::Enum array : {gl::vertex_array, gl::normal_array, gl::colour_array, gl::index_array,
                                 gl::texture_coord_array, gl::edge_flag_array})
        coin() ? host_.EnableClientState(array) : host_.DisableClientState(array);
    const auto type = [&] { return one_of({0x1402, 0x1404, 0x1406, 0x140A}); };
    host_.VertexPointer(int32_t(2 + random_below(3)), type(), int32_t(8 * random_below(5)),
                        numbers_ + random_below(64));
    host_.NormalPointer(one_of({0x1400, 0x1402, 0x1404, 0x1406, 0x140A}), int32_t(8 * random_below(5)),
                        numbers_ + random_below(64));
    host_.TexCoordPointer(int32_t(1 + random_below(4)), type(), int32_t(8 * random_below(5)),
                          numbers_ + random_below(64));
    host_.ColorPointer(int32_t(3 + random_below(2)), one_of({0x1400, 0x1401, 0x1403, 0x1406}),
                       int32_t(8 * random_below(5)), numbers_ + random_below(64));
    host_.ask<void (*)(int32_t, const void *)>("glEdgeFlagPointer")(int32_t(random_below(5)),
                                                                    numbers_ + random_below(64));
}

void TorturedHost::set_pixels()
{
    host_.PixelStorei(gl::unpack_alignment, int32_t(1 << random_below(4)));
    for (const gl::Enum name : {gl::unpack_row_length, gl::unpack_skip_rows, gl::unpack_skip_pixels})
        host_.PixelStorei(name, int32_t(random_below(200)));
    for (const gl::Enum name : {gl::unpack_swap_bytes, gl::unpack_lsb_first})
        host_.PixelStorei(name, int32_t(random_below(2)));
    for (gl::Enum name = gl::red_scale; name <= gl::alpha_bias; ++name)
        if (name != 0x0D16 && name != 0x0D17) host_.PixelTransferf(name, real());  // the zoom factors lie between them
    host_.PixelTransferf(gl::map_colour, float(random_below(2)));
}

// As deep as possible, less the attribute stack that a draw needs.
void TorturedHost::fill_stacks()
{
    const auto fill = [&](gl::Enum depth, gl::Enum most, int32_t keep, auto push) {
        int32_t now = 0, all = 0;
        host_.GetIntegerv(depth, &now);
        host_.GetIntegerv(most, &all);
        for (; now < all - keep; ++now) push();
    };
    for (gl::Enum i = 0; i < 3; ++i) {
        host_.MatrixMode(gl::modelview + i);
        if (coin())
            fill(gl::modelview_stack_depth + i,
                 gl::max_modelview_stack_depth + (i == 0   ? 0
                                                  : i == 1 ? 2
                                                           : 3),
                 0, [&] { host_.PushMatrix(); });
    }
    if (coin())
        fill(gl::attrib_stack_depth, gl::max_attrib_stack_depth, 1, [&] { host_.PushAttrib(gl::all_attrib_bits); });
    if (coin())
        fill(gl::client_attrib_stack_depth, gl::max_client_attrib_stack_depth, 1,
             [&] { host_.PushClientAttrib(gl::all_client_attrib_bits); });
}

}  // namespace gltest

// What each call does to the state of the watched GL. For watched_gl.cpp alone.
#pragma once

#include "tests/faults/gl_state.h"

namespace watched_gl
{

// Queries.
inline void effect(std::integral_constant<Id, Id::GetIntegerv>, uint32_t name, int32_t *out)
{
    const auto depth = [](size_t places) { return static_cast<int32_t>(places); };
    if (name == gl::attrib_stack_depth) *out = depth(context.pushed.size());
    if (name == gl::client_attrib_stack_depth) *out = depth(context.pushed_client.size());
    if (name == gl::matrix_mode) *out = static_cast<int32_t>(context.mode);
    if (name == gl::texture_binding_2d) *out = static_cast<int32_t>(context.bound);
    const uint32_t stacks[3] = {gl::modelview, gl::projection, gl::texture};
    const uint32_t depths[3] = {gl::modelview_stack_depth, gl::projection_stack_depth, gl::texture_stack_depth};
    for (int k = 0; k < 3; ++k)
        if (name == depths[k]) top(stacks[k]), *out = depth(context.stacks[stacks[k]].size());
    if (name == gl::max_modelview_stack_depth) *out = 32;
}
inline void effect(std::integral_constant<Id, Id::GetDoublev>, uint32_t name, double *out)
{
    const uint32_t mode = name == gl::projection_matrix ? gl::projection
                          : name == gl::texture_matrix  ? gl::texture
                                                        : gl::modelview;
    std::memcpy(out, top(mode).data(), sizeof(Matrix));
}
inline void effect(std::integral_constant<Id, Id::GetPointerv>, uint32_t, void **out)
{
    const auto vertices = context.client.arrays.find(gl::vertex_array);
    if (vertices != context.client.arrays.end()) *out = const_cast<void *>(vertices->second.data);
}
inline void effect(std::integral_constant<Id, Id::GetTexLevelParameteriv>, uint32_t target, int32_t, uint32_t name,
                   int32_t *out)
{
    if (name != gl::texture_width) return;
    *out = target == gl::proxy_texture_2d ? context.proxy_width : context.textures[context.bound].width;
}

// Matrices.
inline void effect(std::integral_constant<Id, Id::MatrixMode>, uint32_t mode) { context.mode = mode; }
inline void effect(std::integral_constant<Id, Id::LoadIdentity>)
{
    top(context.mode) = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}
inline void effect(std::integral_constant<Id, Id::LoadMatrixf>, const float *columns)
{
    for (size_t i = 0; i < 16; ++i) top(context.mode)[i] = double(columns[i]);
}
inline void effect(std::integral_constant<Id, Id::LoadMatrixd>, const double *columns)
{
    std::memcpy(top(context.mode).data(), columns, sizeof(Matrix));
}
inline void effect(std::integral_constant<Id, Id::MultMatrixf>, const float *columns)
{
    const Matrix before = top(context.mode);
    for (size_t column = 0; column < 4; ++column)
        for (size_t row = 0; row < 4; ++row) {
            double sum = 0;
            for (size_t k = 0; k < 4; ++k) sum += before[4 * k + row] * double(columns[4 * column + k]);
            top(context.mode)[4 * column + row] = sum;
        }
}
inline void effect(std::integral_constant<Id, Id::PushMatrix>)
{
    const Matrix now = top(context.mode);
    context.stacks[context.mode].push_back(now);
}
inline void effect(std::integral_constant<Id, Id::PopMatrix>)
{
    if (context.stacks[context.mode].size() > 1) context.stacks[context.mode].pop_back();
}

// Stacks of attributes.
inline void effect(std::integral_constant<Id, Id::PushAttrib>, uint32_t)
{
    context.pushed.push_back(context.settings);
    context.pushed_bound.push_back(context.bound);
}
inline void effect(std::integral_constant<Id, Id::PopAttrib>)
{
    if (context.pushed.empty()) return;
    context.settings = context.pushed.back(), context.pushed.pop_back();
    context.bound = context.pushed_bound.back(), context.pushed_bound.pop_back();
}
inline void effect(std::integral_constant<Id, Id::PushClientAttrib>, uint32_t)
{
    context.pushed_client.push_back(context.client);
}
inline void effect(std::integral_constant<Id, Id::PopClientAttrib>)
{
    if (context.pushed_client.empty()) return;
    context.client = context.pushed_client.back(), context.pushed_client.pop_back();
}

// Textures.
inline void effect(std::integral_constant<Id, Id::GenTextures>, int32_t names, uint32_t *out)
{
    for (int32_t i = 0; i < names; ++i) out[i] = context.next_name++, context.textures[out[i]];
}
inline void effect(std::integral_constant<Id, Id::DeleteTextures>, int32_t names, const uint32_t *which)
{
    for (int32_t i = 0; i < names; ++i) context.textures.erase(which[i]);
}
inline void effect(std::integral_constant<Id, Id::BindTexture>, uint32_t, uint32_t name) { context.bound = name; }
inline void effect(std::integral_constant<Id, Id::TexImage2D>, uint32_t target, int32_t, int32_t, int32_t width,
                   int32_t height, int32_t, uint32_t, uint32_t, const void *texels)
{
    if (target == gl::proxy_texture_2d) {
        context.proxy_width = width;
        return;
    }
    if (kind == Loss::image_memory && count == lost_at) return;
    Hash hash;
    hash.add(texels, 4 * static_cast<size_t>(width) * static_cast<size_t>(height));
    context.textures[context.bound].width = width, context.textures[context.bound].texels = hash.value;
}
inline void effect(std::integral_constant<Id, Id::TexParameteri>, uint32_t, uint32_t name, int32_t value)
{
    context.textures[context.bound].parameters[name] = value;
}

// Arrays.
inline void effect(std::integral_constant<Id, Id::EnableClientState>, uint32_t name)
{
    context.client.arrays[name].on = true;
}
inline void effect(std::integral_constant<Id, Id::DisableClientState>, uint32_t name)
{
    context.client.arrays[name].on = false;
}
inline void effect(std::integral_constant<Id, Id::VertexPointer>, int32_t size, uint32_t type, int32_t stride,
                   const void *data)
{
    point(gl::vertex_array, size, type, stride, data);
}
inline void effect(std::integral_constant<Id, Id::NormalPointer>, uint32_t type, int32_t stride, const void *data)
{
    point(gl::normal_array, 3, type, stride, data);
}
inline void effect(std::integral_constant<Id, Id::TexCoordPointer>, int32_t size, uint32_t type, int32_t stride,
                   const void *data)
{
    point(gl::texture_coord_array, size, type, stride, data);
}
inline void effect(std::integral_constant<Id, Id::ColorPointer>, int32_t size, uint32_t type, int32_t stride,
                   const void *data)
{
    point(gl::colour_array, size, type, stride, data);
}
inline void effect(std::integral_constant<Id, Id::DrawElements>, uint32_t, int32_t indices, uint32_t type,
                   const void *data)
{
    draw(indices, type, data);
}

// Calls without objects: the last arguments are the state, apart for each capability that is named.
inline void effect(std::integral_constant<Id, Id::Enable>, uint32_t what)
{
    context.settings[{int(Id::Enable), what}] = 1;
}
inline void effect(std::integral_constant<Id, Id::Disable>, uint32_t what)
{
    context.settings[{int(Id::Enable), what}] = 0;
}
inline void effect(std::integral_constant<Id, Id::GetString>, uint32_t) {}
inline void effect(std::integral_constant<Id, Id::IsEnabled>, uint32_t) {}
inline void effect(std::integral_constant<Id, Id::RenderMode>, uint32_t) {}
inline void effect(std::integral_constant<Id, Id::EndList>) {}
inline void effect(std::integral_constant<Id, Id::Flush>) {}
inline void effect(std::integral_constant<Id, Id::PixelStorei>, uint32_t name, int32_t value)
{
    context.client.settings[{int(Id::PixelStorei), name}] = static_cast<uint64_t>(value);
}
inline void effect(std::integral_constant<Id, Id::PixelTransferf>, uint32_t name, float value)
{
    context.settings[{int(Id::PixelTransferf), name}] = number(value);
}
template <Id id, class... Arguments>
void effect(std::integral_constant<Id, id>, Arguments... arguments)
{
    Hash hash;
    (hash.add(number(arguments)), ...);
    context.settings[{int(id), 0}] = hash.value;
}

}  // namespace watched_gl

// The state of the watched GL. For watched_gl.cpp alone.
#pragma once

#include <array>
#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

#include "passes/gl11.h"
#include "tests/faults/watched_gl.h"

namespace watched_gl
{

using namespace claque::passes;

#define CALLS(X)                                                                                                      \
    X(GetString)                                                                                                      \
    X(GetIntegerv)                                                                                                    \
    X(GetDoublev)                                                                                                     \
    X(GetPointerv)                                                                                                    \
    X(IsEnabled)                                                                                                      \
    X(RenderMode)                                                                                                     \
    X(EndList)                                                                                                        \
    X(Flush)                                                                                                          \
    X(Enable)                                                                                                         \
    X(Disable) X(AlphaFunc) X(DepthFunc) X(DepthMask) X(ColorMask) X(BlendFunc) X(PolygonOffset) X(StencilFunc)       \
        X(StencilOp) X(StencilMask) X(ClearStencil) X(Clear) X(CullFace) X(FrontFace) X(ShadeModel) X(LightModeli)    \
            X(GetMaterialfv) X(Materialfv) X(ColorMaterial) X(TexEnvi) X(PushAttrib) X(PopAttrib) X(PushClientAttrib) \
                X(PopClientAttrib) X(MatrixMode) X(LoadIdentity) X(LoadMatrixf) X(LoadMatrixd) X(MultMatrixf)         \
                    X(PushMatrix) X(PopMatrix) X(GenTextures) X(DeleteTextures) X(BindTexture) X(TexImage2D)          \
                        X(TexParameteri) X(GetTexLevelParameteriv) X(PixelStorei) X(PixelTransferf)                   \
                            X(EnableClientState) X(DisableClientState) X(VertexPointer) X(NormalPointer)              \
                                X(TexCoordPointer) X(ColorPointer) X(DrawElements) X(Color4f)

enum class Id {
#define X(name) name,
    CALLS(X)
#undef X
};

struct Hash {
    uint64_t value = 0xcbf29ce484222325u;
    void add(const void *bytes, size_t count)
    {
        const auto *at = static_cast<const unsigned char *>(bytes);
        for (size_t i = 0; i < count; ++i) value = (value ^ at[i]) * 0x100000001b3u;
    }
    template <class T>
    void add(const T &number)
    {
        add(&number, sizeof number);
    }
};

using Matrix = std::array<double, 16>;
// What a call has set, by the call and what of it the call names.
using Settings = std::map<std::pair<int, uint32_t>, uint64_t>;

struct Texture {
    int32_t width = 0;
    uint64_t texels = 0;
    std::map<uint32_t, int32_t> parameters;
};

struct Array {
    const void *data = nullptr;
    size_t element = 0, stride = 0;
    bool on = false;
};

struct Client {
    std::map<uint32_t, Array> arrays;
    Settings settings;
};

struct Context {
    Settings settings;
    Client client;
    std::vector<Settings> pushed;
    std::vector<Client> pushed_client;
    uint32_t mode = gl::modelview, bound = 0, next_name = 1;
    std::map<uint32_t, std::vector<Matrix>> stacks;
    std::map<uint32_t, Texture> textures;
    int32_t proxy_width = 0;
    std::vector<uint32_t> pushed_bound;
};

inline Context context;
inline Loss kind = Loss::none;
inline uint64_t lost_at = 0, count = 0;
inline Hash drawn;

inline Matrix &top(uint32_t mode)
{
    std::vector<Matrix> &stack = context.stacks[mode];
    if (stack.empty()) stack.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    return stack.back();
}

inline size_t size_of(uint32_t type)
{
    return type == gl::real ? 4 : type == gl::unsigned_byte || type == gl::signed_byte ? 1 : 2;
}

inline void point(uint32_t name, int32_t numbers, uint32_t type, int32_t stride, const void *data)
{
    Array &array = context.client.arrays[name];
    array.data = data, array.element = static_cast<size_t>(numbers) * size_of(type);
    array.stride = stride ? static_cast<size_t>(stride) : array.element;
}

inline void draw(int32_t index_count, uint32_t type, const void *indices)
{
    const uint64_t now = state();
    drawn.add(now);
    const auto texture = context.textures.find(context.bound);
    if (texture != context.textures.end()) drawn.add(texture->second.texels);
    for (int32_t i = 0; i < index_count; ++i) {
        uint32_t index = 0;
        const size_t bytes = type == gl::unsigned_int ? 4 : 2;
        std::memcpy(&index, static_cast<const char *>(indices) + bytes * static_cast<size_t>(i), bytes);
        for (const auto &[name, array] : context.client.arrays)
            if (array.on && array.data)
                drawn.add(static_cast<const char *>(array.data) + array.stride * index, array.element);
    }
}

inline uint64_t hash_of(const Settings &settings)
{
    Hash hash;
    for (const auto &[key, value] : settings) hash.add(key.first), hash.add(key.second), hash.add(value);
    return hash.value;
}

// A number among the arguments, for the hash of what was set; pointers change from run to run.
template <class T>
uint64_t number(const T &value)
{
    if constexpr (std::is_pointer_v<T>) return 0;
    else {
        uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof value);
        return bits;
    }
}

}  // namespace watched_gl

#include "tests/faults/watched_gl.h"

#include <array>
#include <cstring>
#include <type_traits>

#include "passes/gl11.h"
#include "tests/api/failing_memory.h"
#include "tests/api/stub_gl.h"

namespace watched_gl
{
namespace
{

using namespace claque::passes;

#define CALLS(X)                                                                                                    \
    X(GetString)                                                                                                    \
    X(GetIntegerv) X(GetDoublev) X(IsEnabled) X(RenderMode) X(EndList) X(Flush) X(Enable) X(Disable) X(AlphaFunc)   \
        X(DepthFunc) X(DepthMask) X(ColorMask) X(BlendFunc) X(PolygonOffset) X(StencilFunc) X(StencilOp)            \
            X(StencilMask) X(ClearStencil) X(Clear) X(CullFace) X(FrontFace) X(ShadeModel) X(LightModeli)           \
                X(ColorMaterial) X(TexEnvi) X(PushAttrib) X(PopAttrib) X(PushClientAttrib) X(PopClientAttrib)       \
                    X(MatrixMode) X(LoadIdentity) X(LoadMatrixf) X(LoadMatrixd) X(MultMatrixf) X(PushMatrix)        \
                        X(PopMatrix) X(GenTextures) X(DeleteTextures) X(BindTexture) X(TexImage2D) X(TexParameteri) \
                            X(GetTexLevelParameteriv) X(PixelStorei) X(PixelTransferf) X(EnableClientState)         \
                                X(DisableClientState) X(VertexPointer) X(NormalPointer) X(TexCoordPointer)          \
                                    X(ColorPointer) X(DrawElements) X(Color4f)

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

Context context;
Loss kind = Loss::none;
uint64_t lost_at = 0, count = 0;
Hash drawn;

Matrix &top(uint32_t mode)
{
    std::vector<Matrix> &stack = context.stacks[mode];
    if (stack.empty()) stack.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    return stack.back();
}

size_t size_of(uint32_t type)
{
    return type == gl::real ? 4 : type == gl::unsigned_byte || type == gl::signed_byte ? 1 : 2;
}

void point(uint32_t name, int32_t numbers, uint32_t type, int32_t stride, const void *data)
{
    Array &array = context.client.arrays[name];
    array.data = data, array.element = static_cast<size_t>(numbers) * size_of(type);
    array.stride = stride ? static_cast<size_t>(stride) : array.element;
}

void draw(int32_t index_count, uint32_t type, const void *indices)
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

uint64_t hash_of(const Settings &settings)
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

// Queries.
void effect(std::integral_constant<Id, Id::GetIntegerv>, uint32_t name, int32_t *out)
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
void effect(std::integral_constant<Id, Id::GetDoublev>, uint32_t name, double *out)
{
    const uint32_t mode = name == gl::projection_matrix ? gl::projection
                          : name == gl::texture_matrix  ? gl::texture
                                                        : gl::modelview;
    std::memcpy(out, top(mode).data(), sizeof(Matrix));
}
void effect(std::integral_constant<Id, Id::GetTexLevelParameteriv>, uint32_t target, int32_t, uint32_t name,
            int32_t *out)
{
    if (name != gl::texture_width) return;
    *out = target == gl::proxy_texture_2d ? context.proxy_width : context.textures[context.bound].width;
}

// Matrices.
void effect(std::integral_constant<Id, Id::MatrixMode>, uint32_t mode) { context.mode = mode; }
void effect(std::integral_constant<Id, Id::LoadIdentity>)
{
    top(context.mode) = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}
void effect(std::integral_constant<Id, Id::LoadMatrixf>, const float *columns)
{
    for (size_t i = 0; i < 16; ++i) top(context.mode)[i] = double(columns[i]);
}
void effect(std::integral_constant<Id, Id::LoadMatrixd>, const double *columns)
{
    std::memcpy(top(context.mode).data(), columns, sizeof(Matrix));
}
void effect(std::integral_constant<Id, Id::MultMatrixf>, const float *columns)
{
    const Matrix before = top(context.mode);
    for (size_t column = 0; column < 4; ++column)
        for (size_t row = 0; row < 4; ++row) {
            double sum = 0;
            for (size_t k = 0; k < 4; ++k) sum += before[4 * k + row] * double(columns[4 * column + k]);
            top(context.mode)[4 * column + row] = sum;
        }
}
void effect(std::integral_constant<Id, Id::PushMatrix>)
{
    const Matrix now = top(context.mode);
    context.stacks[context.mode].push_back(now);
}
void effect(std::integral_constant<Id, Id::PopMatrix>)
{
    if (context.stacks[context.mode].size() > 1) context.stacks[context.mode].pop_back();
}

// Stacks of attributes.
void effect(std::integral_constant<Id, Id::PushAttrib>, uint32_t)
{
    context.pushed.push_back(context.settings);
    context.pushed_bound.push_back(context.bound);
}
void effect(std::integral_constant<Id, Id::PopAttrib>)
{
    if (context.pushed.empty()) return;
    context.settings = context.pushed.back(), context.pushed.pop_back();
    context.bound = context.pushed_bound.back(), context.pushed_bound.pop_back();
}
void effect(std::integral_constant<Id, Id::PushClientAttrib>, uint32_t)
{
    context.pushed_client.push_back(context.client);
}
void effect(std::integral_constant<Id, Id::PopClientAttrib>)
{
    if (context.pushed_client.empty()) return;
    context.client = context.pushed_client.back(), context.pushed_client.pop_back();
}

// Textures.
void effect(std::integral_constant<Id, Id::GenTextures>, int32_t names, uint32_t *out)
{
    for (int32_t i = 0; i < names; ++i) out[i] = context.next_name++, context.textures[out[i]];
}
void effect(std::integral_constant<Id, Id::DeleteTextures>, int32_t names, const uint32_t *which)
{
    for (int32_t i = 0; i < names; ++i) context.textures.erase(which[i]);
}
void effect(std::integral_constant<Id, Id::BindTexture>, uint32_t, uint32_t name) { context.bound = name; }
void effect(std::integral_constant<Id, Id::TexImage2D>, uint32_t target, int32_t, int32_t, int32_t width,
            int32_t height, int32_t, uint32_t, uint32_t, const void *texels)
{
    if (target == gl::proxy_texture_2d) {
        context.proxy_width = width;
        return;
    }
    Hash hash;
    hash.add(texels, 4 * static_cast<size_t>(width) * static_cast<size_t>(height));
    context.textures[context.bound].width = width, context.textures[context.bound].texels = hash.value;
}
void effect(std::integral_constant<Id, Id::TexParameteri>, uint32_t, uint32_t name, int32_t value)
{
    context.textures[context.bound].parameters[name] = value;
}

// Arrays.
void effect(std::integral_constant<Id, Id::EnableClientState>, uint32_t name) { context.client.arrays[name].on = true; }
void effect(std::integral_constant<Id, Id::DisableClientState>, uint32_t name)
{
    context.client.arrays[name].on = false;
}
void effect(std::integral_constant<Id, Id::VertexPointer>, int32_t size, uint32_t type, int32_t stride,
            const void *data)
{
    point(gl::vertex_array, size, type, stride, data);
}
void effect(std::integral_constant<Id, Id::NormalPointer>, uint32_t type, int32_t stride, const void *data)
{
    point(gl::normal_array, 3, type, stride, data);
}
void effect(std::integral_constant<Id, Id::TexCoordPointer>, int32_t size, uint32_t type, int32_t stride,
            const void *data)
{
    point(gl::texture_coord_array, size, type, stride, data);
}
void effect(std::integral_constant<Id, Id::ColorPointer>, int32_t size, uint32_t type, int32_t stride, const void *data)
{
    point(gl::colour_array, size, type, stride, data);
}
void effect(std::integral_constant<Id, Id::DrawElements>, uint32_t, int32_t indices, uint32_t type, const void *data)
{
    draw(indices, type, data);
}

// Calls without objects: the last arguments are the state, apart for each capability that is named.
void effect(std::integral_constant<Id, Id::Enable>, uint32_t what) { context.settings[{int(Id::Enable), what}] = 1; }
void effect(std::integral_constant<Id, Id::Disable>, uint32_t what) { context.settings[{int(Id::Enable), what}] = 0; }
void effect(std::integral_constant<Id, Id::GetString>, uint32_t) {}
void effect(std::integral_constant<Id, Id::IsEnabled>, uint32_t) {}
void effect(std::integral_constant<Id, Id::RenderMode>, uint32_t) {}
void effect(std::integral_constant<Id, Id::EndList>) {}
void effect(std::integral_constant<Id, Id::Flush>) {}
void effect(std::integral_constant<Id, Id::PixelStorei>, uint32_t name, int32_t value)
{
    context.client.settings[{int(Id::PixelStorei), name}] = static_cast<uint64_t>(value);
}
void effect(std::integral_constant<Id, Id::PixelTransferf>, uint32_t name, float value)
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

// False: this call has no effect.
bool enter()
{
    ++count;
    if (kind == Loss::context) return count < lost_at;
    return kind == Loss::none || count != lost_at;
}

template <Id id, class Function>
struct Watched;
template <Id id, class Result, class... Arguments>
struct Watched<id, Result (*)(Arguments...)> {
    static Result (*under)(Arguments...);
    static Result call(Arguments... arguments)
    {
        const failing_memory::Unarmed unarmed;
        if (!enter()) return Result();
        if constexpr (std::is_void_v<Result>) {
            if (under && id != Id::DrawElements) under(arguments...);
            effect(std::integral_constant<Id, id>(), arguments...);
        } else {
            effect(std::integral_constant<Id, id>(), arguments...);
            return under(arguments...);
        }
    }
};
template <Id id, class Result, class... Arguments>
Result (*Watched<id, Result (*)(Arguments...)>::under)(Arguments...) = nullptr;

template <Id id, class Function>
clq_gl_function watch(const char *name)
{
    Watched<id, Function>::under = reinterpret_cast<Function>(stub_gl::find(nullptr, name));
    return reinterpret_cast<clq_gl_function>(&Watched<id, Function>::call);
}

}  // namespace

clq_gl_function find(void *, const char *name)
{
    const failing_memory::Unarmed unarmed;
#define X(one) \
    if (std::strcmp(name, "gl" #one) == 0) return watch<Id::one, decltype(Gl11::one)>(name);
    CALLS(X)
#undef X
    return nullptr;
}

void lose(Loss how, uint64_t n) { kind = how, lost_at = n, count = 0; }
uint64_t calls() { return count; }
void new_context() { context = Context(), kind = Loss::none; }

uint64_t picture()
{
    const uint64_t all = drawn.value;
    drawn = Hash();
    return all;
}

uint64_t state()
{
    Hash hash;
    hash.add(hash_of(context.settings)), hash.add(hash_of(context.client.settings));
    hash.add(context.mode), hash.add(context.bound);
    hash.add(context.pushed.size()), hash.add(context.pushed_client.size());
    for (const uint32_t mode : {gl::modelview, gl::projection, gl::texture})
        hash.add(top(mode)), hash.add(context.stacks[mode].size());
    for (const auto &[name, array] : context.client.arrays)
        if (array.on) hash.add(name);
    return hash.value;
}

uint64_t textures()
{
    Hash hash;
    for (const auto &[name, texture] : context.textures) {
        hash.add(name), hash.add(texture.width), hash.add(texture.texels);
        for (const auto &[parameter, value] : texture.parameters) hash.add(parameter), hash.add(value);
    }
    return hash.value;
}

size_t texture_count() { return context.textures.size(); }

}  // namespace watched_gl

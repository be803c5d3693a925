#include "tests/api/stub_gl.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>

#include "passes/gl11.h"

namespace
{

using namespace claque::passes;

struct Array {
    const void *data = nullptr;
    uint32_t type = gl::real;
    int32_t stride = 0, numbers = 0;
    bool on = false;
};
enum : size_t { positions, normals, uvs, colours, array_count };

constexpr int32_t max_stack = 16, max_side = 2048;

// What this thread's context holds. It allocates nothing: tests let allocations fail.
struct Bound {
    Array arrays[array_count], stack[max_stack][array_count];
    int32_t pushed_arrays = 0, pushed_groups = 0, pushed_matrices = 0, width = 0;
    uint32_t names = 0;
    uint64_t sum = 0;  // of all bytes read
};
thread_local Bound bound;

template <class Function>
struct Idle;
template <class Result, class... Arguments>
struct Idle<GlCall<Result(Arguments...)>> {
    static Result call(Arguments...) { return Result(); }
};

const uint8_t *get_string(uint32_t name) { return reinterpret_cast<const uint8_t *>(name == gl::version ? "1.1" : ""); }

bool is_colour_or_depth_bits(uint32_t name) { return name >= 0x0D52 && name <= 0x0D56; }

void get_integer(uint32_t name, int32_t *out)
{
    if (name == gl::viewport) {
        out[0] = out[1] = 0, out[2] = 64, out[3] = 48;
        return;
    }
    const Array &vertices = bound.arrays[positions];
    *out = name == gl::vertex_array_size                                                     ? vertices.numbers
           : name == gl::vertex_array_type                                                   ? int32_t(vertices.type)
           : name == gl::vertex_array_stride                                                 ? vertices.stride
           : name == gl::rgba_mode                                                           ? 1
           : name == gl::render_mode                                                         ? int32_t(gl::render)
           : name == gl::max_attrib_stack_depth || name == gl::max_client_attrib_stack_depth ? max_stack
           : name == gl::max_texture_size                                                    ? max_side
           : name == gl::stencil_bits || is_colour_or_depth_bits(name)                       ? 8
                                                                                             : 0;
}

void get_pointer(uint32_t, void **out) { *out = const_cast<void *>(bound.arrays[positions].data); }
void get_doubles(uint32_t, double *out) { std::memset(out, 0, 16 * sizeof *out); }
// Of the last uploaded texture.
void get_level(uint32_t, int32_t, uint32_t name, int32_t *out)
{
    *out = name == gl::texture_alpha_size ? 8 : bound.width;
}

void read(const void *from, size_t size)
{
    for (size_t i = 0; i < size; ++i) bound.sum += static_cast<const unsigned char *>(from)[i];
}

void make_names(int32_t count, uint32_t *names)
{
    for (int32_t i = 0; i < count; ++i) names[i] = ++bound.names;
}

void offer_texture(uint32_t target, int32_t level, int32_t, int32_t width, int32_t height, int32_t border,
                   uint32_t format, uint32_t type, const void *pixels)
{
    bound.width = width;
    EXPECT_TRUE(width > 0 && height > 0 && width <= max_side && height <= max_side) << width << " x " << height;
    EXPECT_TRUE(level >= 0 && level < 32 && border == 0 && type == gl::unsigned_byte) << level << " " << type;
    EXPECT_TRUE(format == gl::rgba || (format == gl::alpha && level == 0)) << format;
    const size_t texel_bytes = format == gl::alpha ? 1 : 4;
    if (target == gl::texture_2d && pixels) read(pixels, texel_bytes * size_t(width) * size_t(height));
}

size_t size_of(uint32_t type)
{
    return type == gl::signed_byte || type == gl::unsigned_byte ? 1
           : type == gl::real || type == gl::unsigned_int       ? 4
                                                                : 2;
}

void point(size_t which, int32_t numbers, uint32_t type, int32_t stride, const void *data)
{
    EXPECT_GE(stride, 0);
    Array &array = bound.arrays[which];
    array.numbers = numbers, array.type = type, array.stride = stride, array.data = data;
}
void point_at_positions(int32_t numbers, uint32_t type, int32_t stride, const void *data)
{
    EXPECT_TRUE(numbers >= 2 && numbers <= 4 && (type == gl::real || type == gl::signed_short))
        << numbers << " " << type;
    point(positions, numbers, type, stride, data);
}
void point_at_normals(uint32_t type, int32_t stride, const void *data)
{
    EXPECT_TRUE(type == gl::real || type == gl::signed_short || type == gl::signed_byte) << type;
    point(normals, 3, type, stride, data);
}
void point_at_uvs(int32_t numbers, uint32_t type, int32_t stride, const void *data)
{
    EXPECT_TRUE(numbers >= 1 && numbers <= 4 && (type == gl::real || type == gl::signed_short))
        << numbers << " " << type;
    point(uvs, numbers, type, stride, data);
}
void point_at_colours(int32_t numbers, uint32_t type, int32_t stride, const void *data)
{
    EXPECT_TRUE((numbers == 3 || numbers == 4) && (type == gl::real || type == gl::unsigned_byte)) << numbers;
    point(colours, numbers, type, stride, data);
}

void turn(uint32_t name, bool on)
{
    const uint32_t names[array_count] = {gl::vertex_array, gl::normal_array, gl::texture_coord_array, gl::colour_array};
    for (size_t i = 0; i < array_count; ++i)
        if (names[i] == name) bound.arrays[i].on = on;
}

void enable_array(uint32_t name) { turn(name, true); }
void disable_array(uint32_t name) { turn(name, false); }

void read_elements(uint32_t mode, int32_t count, uint32_t type, const void *indices)
{
    EXPECT_EQ(mode, gl::triangles);
    EXPECT_TRUE(count >= 0 && count % 3 == 0) << count;
    EXPECT_TRUE(type == gl::unsigned_byte || type == gl::unsigned_short || type == gl::unsigned_int) << type;
    EXPECT_TRUE(bound.arrays[positions].on);
    const size_t index_size = size_of(type);
    for (int32_t i = 0; i < count; ++i) {
        uint32_t index = 0;
        std::memcpy(&index, static_cast<const char *>(indices) + index_size * size_t(i), index_size);
        for (const Array &array : bound.arrays) {
            if (!array.on) continue;
            const size_t size = size_t(array.numbers) * size_of(array.type);
            read(static_cast<const char *>(array.data) + (array.stride ? size_t(array.stride) : size) * index, size);
        }
    }
}

void push_groups(uint32_t) { EXPECT_LE(++bound.pushed_groups, max_stack); }
void pop_groups() { EXPECT_GE(--bound.pushed_groups, 0); }
void push_arrays(uint32_t)
{
    ASSERT_LT(bound.pushed_arrays, max_stack);
    std::copy_n(bound.arrays, array_count, bound.stack[bound.pushed_arrays++]);
}
void pop_arrays()
{
    ASSERT_GT(bound.pushed_arrays, 0);
    std::copy_n(bound.stack[--bound.pushed_arrays], array_count, bound.arrays);
}
void push_matrix() { ++bound.pushed_matrices; }
void pop_matrix() { EXPECT_GE(--bound.pushed_matrices, 0); }

template <class Number>
void take_matrix(const Number *columns)
{
    read(columns, 16 * sizeof *columns);
}

#define NAMED(name, function)                              \
    {                                                      \
        "gl" #name, reinterpret_cast<GlFunction>(function) \
    }
#define IDLE(name) NAMED(name, &Idle<decltype(Gl11::name)>::call)

}  // namespace

namespace stub_gl
{

clq_gl_function find(void *, const char *name)
{
    static const std::map<std::string, GlFunction> functions = {NAMED(GetString, get_string),
                                                                NAMED(GetIntegerv, get_integer),
                                                                NAMED(GetDoublev, get_doubles),
                                                                NAMED(GetPointerv, get_pointer),
                                                                NAMED(GetTexLevelParameteriv, get_level),
                                                                NAMED(TexImage2D, offer_texture),
                                                                NAMED(VertexPointer, point_at_positions),
                                                                NAMED(NormalPointer, point_at_normals),
                                                                NAMED(TexCoordPointer, point_at_uvs),
                                                                NAMED(ColorPointer, point_at_colours),
                                                                NAMED(EnableClientState, enable_array),
                                                                NAMED(DisableClientState, disable_array),
                                                                NAMED(PushAttrib, push_groups),
                                                                NAMED(PopAttrib, pop_groups),
                                                                NAMED(PushClientAttrib, push_arrays),
                                                                NAMED(PopClientAttrib, pop_arrays),
                                                                NAMED(LoadMatrixf, take_matrix<float>),
                                                                NAMED(LoadMatrixd, take_matrix<double>),
                                                                NAMED(MultMatrixf, take_matrix<float>),
                                                                NAMED(PushMatrix, push_matrix),
                                                                NAMED(PopMatrix, pop_matrix),
                                                                NAMED(GenTextures, make_names),
                                                                NAMED(DrawElements, read_elements),
                                                                IDLE(IsEnabled),
                                                                IDLE(RenderMode),
                                                                IDLE(EndList),
                                                                IDLE(Flush),
                                                                IDLE(Enable),
                                                                IDLE(Disable),
                                                                IDLE(AlphaFunc),
                                                                IDLE(DepthFunc),
                                                                IDLE(DepthMask),
                                                                IDLE(ColorMask),
                                                                IDLE(CullFace),
                                                                IDLE(BlendFunc),
                                                                IDLE(PolygonOffset),
                                                                IDLE(StencilFunc),
                                                                IDLE(StencilOp),
                                                                IDLE(StencilMask),
                                                                IDLE(ClearStencil),
                                                                IDLE(Clear),
                                                                IDLE(FrontFace),
                                                                IDLE(LightModeli),
                                                                IDLE(GetMaterialfv),
                                                                IDLE(Materialfv),
                                                                IDLE(ShadeModel),
                                                                IDLE(ColorMaterial),
                                                                IDLE(TexEnvi),
                                                                IDLE(MatrixMode),
                                                                IDLE(LoadIdentity),
                                                                IDLE(DeleteTextures),
                                                                IDLE(BindTexture),
                                                                IDLE(TexParameteri),
                                                                IDLE(PixelStorei),
                                                                IDLE(PixelTransferf),
                                                                IDLE(Color4f)};
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

void expect_balance()
{
    EXPECT_EQ(bound.pushed_groups, 0);
    EXPECT_EQ(bound.pushed_matrices, 0);
    EXPECT_EQ(bound.pushed_arrays, 0);
    bound = {};
}

void new_context() { bound = Bound(); }

clq_renderer *new_renderer(TestWorld &test_world)
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = find;
    clq_renderer *renderer = nullptr;
    EXPECT_EQ(clq_renderer_create(test_world.context, &def, &renderer), CLQ_OK) << clq_last_error();
    for (clq_template *tmpl : test_world.templates)
        EXPECT_EQ(clq_renderer_prepare(renderer, tmpl), CLQ_OK) << clq_last_error();
    return renderer;
}

}  // namespace stub_gl

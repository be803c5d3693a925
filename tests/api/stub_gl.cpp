#include "tests/api/stub_gl.h"

#include <cstring>
#include <map>
#include <string>

#include "passes/gl11.h"

namespace
{

using namespace claque::passes;

struct Bound {
    const void *positions = nullptr;
    uint32_t type = 0;
    int32_t stride = 0, width = 0;
    uint64_t sum = 0;  // of all bytes read
};
thread_local Bound bound;

template <class Function>
struct Idle;
template <class Result, class... Arguments>
struct Idle<Result (*)(Arguments...)> {
    static Result call(Arguments...) { return Result(); }
};

const uint8_t *get_string(uint32_t name) { return reinterpret_cast<const uint8_t *>(name == gl::version ? "1.1" : ""); }

void get_integer(uint32_t name, int32_t *out)
{
    if (name == gl::viewport) {
        out[0] = out[1] = 0, out[2] = 64, out[3] = 48;
        return;
    }
    *out = name == gl::rgba_mode                                                             ? 1
           : name == gl::render_mode                                                         ? int32_t(gl::render)
           : name == gl::max_attrib_stack_depth || name == gl::max_client_attrib_stack_depth ? 16
           : name == gl::max_texture_size                                                    ? 2048
                                                                                             : 0;
}

void get_doubles(uint32_t, double *out) { std::memset(out, 0, 16 * sizeof *out); }
// Of the last uploaded texture.
void get_level(uint32_t, int32_t, uint32_t name, int32_t *out)
{
    *out = name == gl::texture_alpha_size ? 8 : bound.width;
}

void offer_texture(uint32_t, int32_t, int32_t, int32_t width, int32_t, int32_t, uint32_t, uint32_t, const void *)
{
    bound.width = width;
}

void point_at(int32_t, uint32_t type, int32_t stride, const void *data)
{
    bound.positions = data;
    bound.type = type;
    bound.stride = stride;
}

void read_elements(uint32_t, int32_t count, uint32_t, const void *indices)
{
    const size_t size = bound.type == gl::real ? 12 : 6, stride = bound.stride ? size_t(bound.stride) : size;
    for (int32_t i = 0; i < count; ++i) {
        uint16_t index;  // these templates are small
        std::memcpy(&index, static_cast<const char *>(indices) + 2 * i, 2);
        unsigned char bytes[12];
        std::memcpy(bytes, static_cast<const char *>(bound.positions) + stride * index, size);
        bound.sum += bytes[0];
    }
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
                                                                NAMED(GetTexLevelParameteriv, get_level),
                                                                NAMED(TexImage2D, offer_texture),
                                                                NAMED(VertexPointer, point_at),
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
                                                                IDLE(ShadeModel),
                                                                IDLE(ColorMaterial),
                                                                IDLE(TexEnvi),
                                                                IDLE(PushAttrib),
                                                                IDLE(PopAttrib),
                                                                IDLE(PushClientAttrib),
                                                                IDLE(PopClientAttrib),
                                                                IDLE(MatrixMode),
                                                                IDLE(LoadIdentity),
                                                                IDLE(LoadMatrixf),
                                                                IDLE(LoadMatrixd),
                                                                IDLE(MultMatrixf),
                                                                IDLE(PushMatrix),
                                                                IDLE(PopMatrix),
                                                                IDLE(GenTextures),
                                                                IDLE(DeleteTextures),
                                                                IDLE(BindTexture),
                                                                IDLE(TexParameteri),
                                                                IDLE(PixelStorei),
                                                                IDLE(PixelTransferf),
                                                                IDLE(EnableClientState),
                                                                IDLE(DisableClientState),
                                                                IDLE(NormalPointer),
                                                                IDLE(TexCoordPointer),
                                                                IDLE(ColorPointer),
                                                                IDLE(Color4f)};
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

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

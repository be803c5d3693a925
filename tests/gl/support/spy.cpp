#include "tests/gl/support/spy.h"

#include <stdexcept>

namespace gltest
{
namespace
{

using claque::passes::Gl11;
using claque::passes::GlCall;
using claque::passes::GlFunction;

Gl11 real;
Spy *active = nullptr;

template <auto member>
const char *&name_of()
{
    static const char *name = "";
    return name;
}

template <class Value>
double number(Value value)
{
    if constexpr (std::is_pointer_v<Value>) return static_cast<double>(reinterpret_cast<uintptr_t>(value));
    else return static_cast<double>(value);
}

template <auto member>
struct Between;

template <class Result, class... Arguments, GlCall<Result(Arguments...)> Gl11::*member>
struct Between<member> {
    static Result call(Arguments... arguments)
    {
        if (!active) throw std::logic_error(name_of<member>());
        active->note(name_of<member>(), {number(arguments)...});
        return (real.*member)(arguments...);
    }
};

// These can be made to give other answers.
void get_integer(gl::Enum name, int32_t *out)
{
    active->note("glGetIntegerv", {number(name), number(out)});
    const auto answer = active->answers.find(name);
    if (answer == active->answers.end()) return real.GetIntegerv(name, out);
    *out = answer->second;
}

const uint8_t *get_string(gl::Enum name)
{
    active->note("glGetString", {number(name)});
    const auto answer = active->strings.find(name);
    if (answer == active->strings.end()) return real.GetString(name);
    return reinterpret_cast<const uint8_t *>(answer->second.c_str());
}

void pop_client_attributes()
{
    active->note("glPopClientAttrib", {});
    int32_t size = 0, type = 0, stride = 0;
    void *pointer = nullptr;
    real.GetIntegerv(gl::vertex_array_size, &size);
    real.GetIntegerv(gl::vertex_array_type, &type);
    real.GetIntegerv(gl::vertex_array_stride, &stride);
    real.GetPointerv(gl::vertex_array_pointer, &pointer);
    real.PopClientAttrib();
    if (active->forgets_vertex_array) real.VertexPointer(size, static_cast<gl::Enum>(type), stride, pointer);
}

void pop_attributes()
{
    active->note("glPopAttrib", {});
    constexpr gl::Enum switches[] = {gl::multisample, gl::sample_alpha_to_coverage, gl::sample_alpha_to_one};
    bool on[3];
    for (int i = 0; i < 3; ++i) on[i] = real.IsEnabled(switches[i]) != gl::no;
    real.PopAttrib();
    for (int i = 0; active->forgets_samples && i < 3; ++i) on[i] ? real.Enable(switches[i]) : real.Disable(switches[i]);
}

using Table = std::map<std::string, GlFunction>;

template <auto member>
void add(Table &table, const char *name)
{
    name_of<member>() = name;
    table[name] = reinterpret_cast<GlFunction>(&Between<member>::call);
}

void add_state(Table &t)
{
    add<&Gl11::GetDoublev>(t, "glGetDoublev");
    add<&Gl11::GetPointerv>(t, "glGetPointerv");
    add<&Gl11::IsEnabled>(t, "glIsEnabled");
    add<&Gl11::Enable>(t, "glEnable");
    add<&Gl11::Disable>(t, "glDisable");
    add<&Gl11::AlphaFunc>(t, "glAlphaFunc");
    add<&Gl11::DepthFunc>(t, "glDepthFunc");
    add<&Gl11::DepthMask>(t, "glDepthMask");
    add<&Gl11::ColorMask>(t, "glColorMask");
    add<&Gl11::BlendFunc>(t, "glBlendFunc");
    add<&Gl11::PolygonOffset>(t, "glPolygonOffset");
    add<&Gl11::StencilFunc>(t, "glStencilFunc");
    add<&Gl11::StencilOp>(t, "glStencilOp");
    add<&Gl11::StencilMask>(t, "glStencilMask");
    add<&Gl11::ClearStencil>(t, "glClearStencil");
    add<&Gl11::Clear>(t, "glClear");
    add<&Gl11::CullFace>(t, "glCullFace");
    add<&Gl11::FrontFace>(t, "glFrontFace");
    add<&Gl11::LightModeli>(t, "glLightModeli");
    add<&Gl11::GetMaterialfv>(t, "glGetMaterialfv");
    add<&Gl11::Materialfv>(t, "glMaterialfv");
    add<&Gl11::ShadeModel>(t, "glShadeModel");
    add<&Gl11::ColorMaterial>(t, "glColorMaterial");
    add<&Gl11::TexEnvi>(t, "glTexEnvi");
    add<&Gl11::PushAttrib>(t, "glPushAttrib");
    add<&Gl11::PopAttrib>(t, "glPopAttrib");
    add<&Gl11::PushClientAttrib>(t, "glPushClientAttrib");
    add<&Gl11::MatrixMode>(t, "glMatrixMode");
    add<&Gl11::LoadIdentity>(t, "glLoadIdentity");
    add<&Gl11::LoadMatrixf>(t, "glLoadMatrixf");
    add<&Gl11::LoadMatrixd>(t, "glLoadMatrixd");
    add<&Gl11::MultMatrixf>(t, "glMultMatrixf");
    add<&Gl11::PushMatrix>(t, "glPushMatrix");
    add<&Gl11::PopMatrix>(t, "glPopMatrix");
    add<&Gl11::RenderMode>(t, "glRenderMode");
    add<&Gl11::EndList>(t, "glEndList");
    add<&Gl11::Flush>(t, "glFlush");
}

void add_drawing(Table &t)
{
    add<&Gl11::GenTextures>(t, "glGenTextures");
    add<&Gl11::DeleteTextures>(t, "glDeleteTextures");
    add<&Gl11::BindTexture>(t, "glBindTexture");
    add<&Gl11::TexImage2D>(t, "glTexImage2D");
    add<&Gl11::TexParameteri>(t, "glTexParameteri");
    add<&Gl11::GetTexLevelParameteriv>(t, "glGetTexLevelParameteriv");
    add<&Gl11::PixelStorei>(t, "glPixelStorei");
    add<&Gl11::PixelTransferf>(t, "glPixelTransferf");
    add<&Gl11::EnableClientState>(t, "glEnableClientState");
    add<&Gl11::DisableClientState>(t, "glDisableClientState");
    add<&Gl11::VertexPointer>(t, "glVertexPointer");
    add<&Gl11::NormalPointer>(t, "glNormalPointer");
    add<&Gl11::TexCoordPointer>(t, "glTexCoordPointer");
    add<&Gl11::ColorPointer>(t, "glColorPointer");
    add<&Gl11::DrawElements>(t, "glDrawElements");
    add<&Gl11::Color4f>(t, "glColor4f");
}

const Table &table()
{
    static const Table made = [] {
        Table t;
        add_state(t);
        add_drawing(t);
        t["glGetIntegerv"] = reinterpret_cast<GlFunction>(&get_integer);
        t["glPopClientAttrib"] = reinterpret_cast<GlFunction>(&pop_client_attributes);
        t["glPopAttrib"] = reinterpret_cast<GlFunction>(&pop_attributes);
        t["glGetString"] = reinterpret_cast<GlFunction>(&get_string);
        return t;
    }();
    return made;
}

}  // namespace

Spy::Spy(const contexts::Offscreen &context) : context_(context)
{
    const claque::base::Status status = claque::passes::load(real, context.get_proc_address(), context.user());
    if (!status.ok()) throw std::runtime_error(status.text);
    active = this;
}

Spy::~Spy() { active = nullptr; }

GlFunction Spy::get_proc_address(void *user, const char *name)
{
    Spy &spy = *static_cast<Spy *>(user);
    spy.asked.push_back(name);
    if (spy.refuse == name) return nullptr;
    const auto found = table().find(name);
    return found == table().end() ? spy.context_.get_proc_address()(spy.context_.user(), name) : found->second;
}

void Spy::note(const char *name, const std::vector<double> &arguments)
{
    ++calls[name];
    if (watch) watch(name, arguments);
}

uint32_t Spy::call_count() const
{
    uint32_t count = 0;
    for (const auto &[name, n] : calls) count += n;
    return count;
}

}  // namespace gltest

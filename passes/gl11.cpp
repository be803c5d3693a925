#include "passes/gl11.h"

#include "lib/base/host_call.h"

namespace claque::passes
{
namespace
{

// Requests one function after the other and remembers the first missing one.
class Loader
{
public:
    Loader(GetProcAddress get, void *user) : get_(get), user_(user) {}

    template <class Function>
    void operator()(GlCall<Function> &slot, const char *name)
    {
        slot = nullptr;
        if (missing_) return;
        thrown_ = base::call_host("get_proc_address", [&] {
            slot = reinterpret_cast<typename GlCall<Function>::Pointer>(get_(user_, name));
        });
        if (!slot) missing_ = name;
    }
    const char *missing() const { return missing_; }
    const base::Status &thrown() const { return thrown_; }

private:
    GetProcAddress get_;
    void *user_;
    const char *missing_ = nullptr;
    base::Status thrown_;
};

void load_queries_and_stacks(Loader &want, Gl11 &t)
{
    want(t.GetString, "glGetString");
    want(t.GetIntegerv, "glGetIntegerv");
    want(t.GetDoublev, "glGetDoublev");
    want(t.GetPointerv, "glGetPointerv");
    want(t.IsEnabled, "glIsEnabled");
    want(t.PushAttrib, "glPushAttrib");
    want(t.PopAttrib, "glPopAttrib");
    want(t.PushClientAttrib, "glPushClientAttrib");
    want(t.PopClientAttrib, "glPopClientAttrib");
    want(t.MatrixMode, "glMatrixMode");
    want(t.LoadIdentity, "glLoadIdentity");
    want(t.LoadMatrixf, "glLoadMatrixf");
    want(t.LoadMatrixd, "glLoadMatrixd");
    want(t.MultMatrixf, "glMultMatrixf");
    want(t.PushMatrix, "glPushMatrix");
    want(t.PopMatrix, "glPopMatrix");
    want(t.RenderMode, "glRenderMode");
    want(t.EndList, "glEndList");
    want(t.Flush, "glFlush");
}

void load_state(Loader &want, Gl11 &t)
{
    want(t.Enable, "glEnable");
    want(t.Disable, "glDisable");
    want(t.AlphaFunc, "glAlphaFunc");
    want(t.DepthFunc, "glDepthFunc");
    want(t.DepthMask, "glDepthMask");
    want(t.ColorMask, "glColorMask");
    want(t.BlendFunc, "glBlendFunc");
    want(t.PolygonOffset, "glPolygonOffset");
    want(t.StencilFunc, "glStencilFunc");
    want(t.StencilOp, "glStencilOp");
    want(t.StencilMask, "glStencilMask");
    want(t.ClearStencil, "glClearStencil");
    want(t.Clear, "glClear");
    want(t.CullFace, "glCullFace");
    want(t.FrontFace, "glFrontFace");
    want(t.ShadeModel, "glShadeModel");
    want(t.LightModeli, "glLightModeli");
    want(t.GetMaterialfv, "glGetMaterialfv");
    want(t.Materialfv, "glMaterialfv");
    want(t.ColorMaterial, "glColorMaterial");
    want(t.TexEnvi, "glTexEnvi");
}

void load_textures(Loader &want, Gl11 &t)
{
    want(t.GenTextures, "glGenTextures");
    want(t.DeleteTextures, "glDeleteTextures");
    want(t.BindTexture, "glBindTexture");
    want(t.TexImage2D, "glTexImage2D");
    want(t.TexParameteri, "glTexParameteri");
    want(t.GetTexLevelParameteriv, "glGetTexLevelParameteriv");
    want(t.PixelStorei, "glPixelStorei");
    want(t.PixelTransferf, "glPixelTransferf");
}

void load_vertices(Loader &want, Gl11 &t)
{
    want(t.EnableClientState, "glEnableClientState");
    want(t.DisableClientState, "glDisableClientState");
    want(t.VertexPointer, "glVertexPointer");
    want(t.NormalPointer, "glNormalPointer");
    want(t.TexCoordPointer, "glTexCoordPointer");
    want(t.ColorPointer, "glColorPointer");
    want(t.DrawElements, "glDrawElements");
    want(t.Color4f, "glColor4f");
}

}  // namespace

base::Status load(Gl11 &table, GetProcAddress get_proc_address, void *user)
{
    table = Gl11();
    if (!get_proc_address) return base::Status::bad(CLQ_ARGUMENT, "get_proc_address is null");
    Loader want(get_proc_address, user);
    load_queries_and_stacks(want, table);
    load_state(want, table);
    load_textures(want, table);
    load_vertices(want, table);
    if (!want.thrown().ok()) return want.thrown();
    if (want.missing())
        return base::Status::bad(CLQ_GL_MISSING, "the host's get_proc_address has no %s, a function of OpenGL 1.1",
                                 want.missing());
    return check_current(table);
}

base::Status check_current(const Gl11 &gl)
{
    if (gl.GetString(gl::version)) return base::Status::good();
    return base::Status::bad(CLQ_GL_MISSING, "no GL context is current on this thread (glGetString returns null)");
}

base::Status still_current(const Gl11 &gl, const base::Status &drawn)
{
    if (gl.GetString(gl::version)) return drawn;
    return base::Status::bad(CLQ_GL_MISSING, "the GL context was lost during the call (glGetString returns null)");
}

}  // namespace claque::passes

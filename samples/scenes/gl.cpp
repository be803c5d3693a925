#include "samples/scenes/gl.h"

namespace scenes
{
namespace
{

struct Loader {
    GetProcAddress get;
    void *user;
    std::string &missing;

    template <class Function>
    void operator()(const char *name, Function &function) const
    {
        function = reinterpret_cast<Function>(get(user, name));
        if (!function && missing.empty()) missing = name;
    }
};

}  // namespace

bool load(Gl &gl, GetProcAddress get, void *user, std::string &missing)
{
    missing.clear();
    const Loader find = {get, user, missing};
    find("glGetString", gl.GetString);
    find("glViewport", gl.Viewport);
    find("glClearColor", gl.ClearColor);
    find("glClear", gl.Clear);
    find("glEnable", gl.Enable);
    find("glDisable", gl.Disable);
    find("glDepthMask", gl.DepthMask);
    find("glDepthFunc", gl.DepthFunc);
    find("glDepthRange", gl.DepthRange);
    find("glBlendFunc", gl.BlendFunc);
    find("glMatrixMode", gl.MatrixMode);
    find("glLoadIdentity", gl.LoadIdentity);
    find("glLoadMatrixf", gl.LoadMatrixf);
    find("glLightfv", gl.Lightfv);
    find("glLightModelfv", gl.LightModelfv);
    find("glColorMaterial", gl.ColorMaterial);
    find("glColor4f", gl.Color4f);
    find("glGenTextures", gl.GenTextures);
    find("glDeleteTextures", gl.DeleteTextures);
    find("glBindTexture", gl.BindTexture);
    find("glTexParameteri", gl.TexParameteri);
    find("glTexEnvi", gl.TexEnvi);
    find("glTexImage2D", gl.TexImage2D);
    find("glPixelStorei", gl.PixelStorei);
    find("glFogf", gl.Fogf);
    find("glFogi", gl.Fogi);
    find("glFogfv", gl.Fogfv);
    find("glPolygonOffset", gl.PolygonOffset);
    find("glEnableClientState", gl.EnableClientState);
    find("glDisableClientState", gl.DisableClientState);
    find("glVertexPointer", gl.VertexPointer);
    find("glNormalPointer", gl.NormalPointer);
    find("glColorPointer", gl.ColorPointer);
    find("glTexCoordPointer", gl.TexCoordPointer);
    find("glDrawElements", gl.DrawElements);
    find("glScissor", gl.Scissor);
    find("glFlush", gl.Flush);
    find("glFinish", gl.Finish);
    return missing.empty();
}

}  // namespace scenes

#include "samples/scenes/light.h"

namespace scenes
{

clq_shadow_def shadows_in(const Daylight &light)
{
    clq_shadow_def def = clq_shadow_def_init();
    def.light[0] = static_cast<double>(light.to_sun.x);
    def.light[1] = static_cast<double>(light.to_sun.y);
    def.light[2] = static_cast<double>(light.to_sun.z);
    def.rgb[0] = 0.10f, def.rgb[1] = 0.09f, def.rgb[2] = 0.13f;  // the sky's share
    def.darkness = 0.55f;
    return def;
}

void set_lights(const Gl &g, const Daylight &light, const Eye &eye)
{
    const float none[4] = {0, 0, 0, 1};
    const float sky[4] = {light.sky.r, light.sky.g, light.sky.b, 1};
    const float sun[4] = {light.sun.r, light.sun.g, light.sun.b, 1};
    const float bounce[4] = {light.bounce.r, light.bounce.g, light.bounce.b, 1};
    const float to_sun[4] = {light.to_sun.x, light.to_sun.y, light.to_sun.z, 0};
    const float to_bounce[4] = {-light.to_sun.x, 0.15f, -light.to_sun.z, 0};

    g.MatrixMode(gl::projection);
    g.LoadMatrixf(eye.projection);
    g.MatrixMode(gl::modelview);
    g.LoadMatrixf(eye.view);
    g.Enable(gl::lighting);
    g.Enable(gl::normalize);
    g.LightModelfv(gl::light_model_ambient, sky);
    g.Enable(gl::light0);
    g.Lightfv(gl::light0, gl::position, to_sun);
    g.Lightfv(gl::light0, gl::ambient, none);
    g.Lightfv(gl::light0, gl::diffuse, sun);
    g.Lightfv(gl::light0, gl::specular, none);
    g.Enable(gl::light0 + 1);
    g.Lightfv(gl::light0 + 1, gl::position, to_bounce);
    g.Lightfv(gl::light0 + 1, gl::ambient, none);
    g.Lightfv(gl::light0 + 1, gl::diffuse, bounce);
    g.Lightfv(gl::light0 + 1, gl::specular, none);
    g.ColorMaterial(gl::front_and_back, gl::ambient_and_diffuse);
    g.Enable(gl::color_material);
}

}  // namespace scenes

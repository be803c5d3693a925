#include "samples/scenes/light.h"

#include <algorithm>
#include <cmath>

namespace scenes
{
namespace
{

Vec3 away_from_sun(const Daylight &light) { return {-light.to_sun.x, 0.15f, -light.to_sun.z}; }

float facing(Vec3 normal, Vec3 to_light)
{
    const float along = normal.x * to_light.x + normal.y * to_light.y + normal.z * to_light.z;
    const float n = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
    const float l = to_light.x * to_light.x + to_light.y * to_light.y + to_light.z * to_light.z;
    return std::max(0.0f, along / std::sqrt(n * l));
}

}  // namespace

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

void shine(const Daylight &light, SceneryVertex &vertex, Rgb texel)
{
    const float sun = facing(vertex.normal, light.to_sun), bounce = facing(vertex.normal, away_from_sun(light));
    const float lit[3] = {light.sky.r + sun * light.sun.r + bounce * light.bounce.r,
                          light.sky.g + sun * light.sun.g + bounce * light.bounce.g,
                          light.sky.b + sun * light.sun.b + bounce * light.bounce.b};
    const float mean[3] = {texel.r, texel.g, texel.b};
    for (int k = 0; k < 3; ++k) {
        const float seen = std::min(1.0f, lit[k] * static_cast<float>(vertex.rgba[k]) / 255) * mean[k];
        vertex.rgba[k] = static_cast<uint8_t>(seen * 255 + 0.5f);
    }
}

void set_lights(const Gl &g, const Daylight &light, const Eye &eye)
{
    const float none[4] = {0, 0, 0, 1};
    const float sky[4] = {light.sky.r, light.sky.g, light.sky.b, 1};
    const float sun[4] = {light.sun.r, light.sun.g, light.sun.b, 1};
    const float bounce[4] = {light.bounce.r, light.bounce.g, light.bounce.b, 1};
    const float to_sun[4] = {light.to_sun.x, light.to_sun.y, light.to_sun.z, 0};
    const Vec3 back = away_from_sun(light);
    const float to_bounce[4] = {back.x, back.y, back.z, 0};

    g.MatrixMode(gl::projection);
    g.LoadMatrixf(eye.projection);
    g.MatrixMode(gl::modelview);
    g.LoadMatrixf(eye.view);
    for (const unsigned off : {gl::texture_2d, gl::cull_face, gl::fog, gl::light0 + 2, gl::light0 + 3}) g.Disable(off);
    g.Enable(gl::depth_test);
    g.DepthFunc(gl::lequal);
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

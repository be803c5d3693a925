#include "samples/scenes/distance.h"

namespace scenes
{

void begin_distance(const Gl &g, const Eye &eye, float metres)
{
    g.MatrixMode(gl::projection);
    g.LoadMatrixf(eye.projection);
    g.MatrixMode(gl::modelview);
    float round_eye[16];
    for (int i = 0; i < 16; ++i) round_eye[i] = i < 12 ? eye.rotation[i] * metres : eye.rotation[i];
    g.LoadMatrixf(round_eye);
    for (const unsigned off : {gl::fog, gl::lighting, gl::cull_face, gl::texture_2d}) g.Disable(off);
    g.Enable(gl::depth_test);
    g.DepthFunc(gl::lequal);
    g.DepthRange(1, 1);  // of a cleared picture: anything that was drawn is nearer
    g.DepthMask(0);
}

void end_distance(const Gl &g, const Eye &eye)
{
    g.DepthRange(0, 1);
    g.DepthMask(1);
    g.Enable(gl::lighting);
    g.LoadMatrixf(eye.view);
}

}  // namespace scenes

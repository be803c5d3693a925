#include "passes/gl_state.h"

namespace claque::passes
{
namespace
{

void set_fragments(const Gl11 &gl)
{
    int32_t mask[4] = {1, 1, 1, 1};
    gl.GetIntegerv(gl::colour_writemask, mask);
    gl.ColorMask(mask[0] != 0, mask[1] != 0, mask[2] != 0, gl::no);
    gl.Disable(gl::blend);
    gl.Disable(gl::colour_logic_op);
    gl.Enable(gl::depth_test);
    gl.DepthFunc(gl::lequal);
    gl.DepthMask(gl::yes);
}

// Smoothing would multiply coverage into the alpha that carries zone keys, and samples would take theirs from it or
// replace it.
void set_rasterisation(const Gl11 &gl, Multisample multisample)
{
    gl.CullFace(gl::back);
    gl.Disable(gl::point_smooth);
    gl.Disable(gl::line_smooth);
    gl.Disable(gl::polygon_smooth);
    gl.Disable(gl::line_stipple);
    gl.Disable(gl::polygon_stipple);
    if (multisample == Multisample::missing) return;
    if (multisample == Multisample::off) gl.Disable(gl::multisample);
    gl.Disable(gl::sample_alpha_to_coverage);
    gl.Disable(gl::sample_alpha_to_one);
}

void set_texturing(const Gl11 &gl)
{
    gl.Enable(gl::texture_2d);
    gl.Disable(gl::texture_1d);
    gl.TexEnvi(gl::texture_env, gl::texture_env_mode, static_cast<int32_t>(gl::modulate));
    gl.Disable(gl::texture_gen_s);
    gl.Disable(gl::texture_gen_t);
    gl.Disable(gl::texture_gen_r);
    gl.Disable(gl::texture_gen_q);
}

void set_matrices(const Gl11 &gl, const float *projection)
{
    gl.MatrixMode(gl::texture);
    gl.LoadIdentity();
    gl.MatrixMode(gl::projection);
    gl.LoadMatrixf(projection);
    gl.MatrixMode(gl::modelview);
}

void set_arrays(const Gl11 &gl)
{
    gl.EnableClientState(gl::vertex_array);
    gl.EnableClientState(gl::normal_array);
    gl.EnableClientState(gl::texture_coord_array);
    gl.DisableClientState(gl::index_array);
    gl.DisableClientState(gl::edge_flag_array);
}

}  // namespace

void GlState::begin(const float *projection, Multisample multisample)
{
    set_fragments(gl_);
    set_rasterisation(gl_, multisample);
    set_texturing(gl_);
    set_matrices(gl_, projection);
    set_arrays(gl_);
    gl_.Enable(gl::normalize);
    gl_.ColorMaterial(gl::front_and_back, gl::ambient_and_diffuse);  // before glEnable, or other materials would follow
    gl_.Enable(gl::colour_material);
    int32_t shade_model = 0;
    gl_.GetIntegerv(gl::shade_model, &shade_model);
    shade_model_ = static_cast<gl::Enum>(shade_model);
    known_ = false;
    now_.flat = false;
    now_.lighting = model::Lighting();
    host_.known = false;
}

void GlState::set_flat(bool flat)
{
    if (flat == now_.flat) return;
    now_.flat = flat;
    stats_.state_changes += 2;
    gl_.ShadeModel(flat ? gl::flat : shade_model_);
    if (flat) {
        gl_.Disable(gl::texture_2d);
        gl_.DisableClientState(gl::texture_coord_array);
    } else {
        gl_.Enable(gl::texture_2d);
        gl_.EnableClientState(gl::texture_coord_array);
    }
}

void GlState::set_lighting(const model::Lighting &wanted)
{
    if (wanted == now_.lighting) return;
    if (!host_.known) {
        host_.known = true;
        host_.on = gl_.IsEnabled(gl::lighting) != gl::no;
        gl_.GetMaterialfv(gl::front, gl::emission, host_.front);
        gl_.GetMaterialfv(gl::back, gl::emission, host_.back);
    }
    if (host_.on && wanted.unlit != now_.lighting.unlit) {
        wanted.unlit ? gl_.Disable(gl::lighting) : gl_.Enable(gl::lighting);
        ++stats_.state_changes;
    }
    if (wanted.emission != now_.lighting.emission) {
        const float own[4] = {wanted.emission[0], wanted.emission[1], wanted.emission[2], 1};
        gl_.Materialfv(gl::front, gl::emission, wanted.emits() ? own : host_.front);
        gl_.Materialfv(gl::back, gl::emission, wanted.emits() ? own : host_.back);
        stats_.state_changes += 2;
    }
    now_.lighting = wanted;
}

void GlState::end()
{
    set_flat(false);
    set_lighting(model::Lighting());
}

void GlState::apply_alpha(const SurfaceState &wanted)
{
    const bool on = wanted.alpha_function != 0;
    if (!known_ || on != (now_.alpha_function != 0)) {
        on ? gl_.Enable(gl::alpha_test) : gl_.Disable(gl::alpha_test);
        ++stats_.state_changes;
    }
    if (on &&
        (!known_ || wanted.alpha_function != now_.alpha_function || wanted.alpha_reference != now_.alpha_reference)) {
        gl_.AlphaFunc(wanted.alpha_function, wanted.alpha_reference);
        ++stats_.state_changes;
    }
}

void GlState::apply(const SurfaceState &wanted)
{
    apply_alpha(wanted);
    set_flat(wanted.flat);
    set_lighting(wanted.lighting);
    if (!wanted.flat && (!known_ || wanted.texture != now_.texture)) {
        gl_.BindTexture(gl::texture_2d, wanted.texture);
        ++stats_.state_changes;
    }
    if (!known_ || wanted.double_sided != now_.double_sided) {
        wanted.double_sided ? gl_.Disable(gl::cull_face) : gl_.Enable(gl::cull_face);
        gl_.LightModeli(gl::light_model_two_side, wanted.double_sided);
        stats_.state_changes += 2;
    }
    if (!known_ || wanted.mirrored != now_.mirrored) {
        gl_.FrontFace(wanted.mirrored ? gl::cw : gl::ccw);
        ++stats_.state_changes;
    }
    if (!known_ || wanted.colour_array != now_.colour_array) {
        wanted.colour_array ? gl_.EnableClientState(gl::colour_array) : gl_.DisableClientState(gl::colour_array);
        ++stats_.state_changes;
    }
    now_ = wanted;
    known_ = true;
}

}  // namespace claque::passes

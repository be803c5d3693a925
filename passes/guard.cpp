#include "passes/guard.h"

#include <initializer_list>

namespace claque::passes
{
namespace
{

// With GL_COLOR_MATERIAL on, colours change materials; the lighting group saves those. The enable group holds the
// switches.
constexpr gl::Bits touched_groups = gl::current_bit | gl::polygon_bit | gl::lighting_bit | gl::depth_buffer_bit |
                                    gl::enable_bit | gl::colour_buffer_bit | gl::texture_bit;

constexpr gl::Enum arrays[] = {gl::vertex_array, gl::normal_array,        gl::colour_array,
                               gl::index_array,  gl::texture_coord_array, gl::edge_flag_array};

// Sets everything that affects glTexImage2D to its default.
void default_unpacking(const Gl11 &gl)
{
    constexpr gl::Enum zeros[] = {gl::unpack_swap_bytes, gl::unpack_lsb_first, gl::unpack_row_length,
                                  gl::unpack_skip_rows, gl::unpack_skip_pixels};
    for (const gl::Enum name : zeros) gl.PixelStorei(name, 0);
    gl.PixelStorei(gl::unpack_alignment, 1);
    gl.PixelTransferf(gl::map_colour, 0);
    for (const gl::Enum name : {gl::red_scale, gl::green_scale, gl::blue_scale, gl::alpha_scale})
        gl.PixelTransferf(name, 1);
    for (const gl::Enum name : {gl::red_bias, gl::green_bias, gl::blue_bias, gl::alpha_bias})
        gl.PixelTransferf(name, 0);
}

// If the host uses GL_COLOR_MATERIAL, its materials must equal its current colour after the pop. Mesa 22.3.6 leaves the
// last drawn colour in them, if the host tracks the same materials as claque, until tracking is enabled again.
void let_materials_follow(const Gl11 &gl)
{
    int32_t follows = 0;
    gl.GetIntegerv(gl::colour_material, &follows);
    if (!follows) return;
    gl.Disable(gl::colour_material);
    gl.Enable(gl::colour_material);
}

VertexArray vertex_array_of(const Gl11 &gl)
{
    VertexArray array;
    gl.GetIntegerv(gl::vertex_array_size, &array.size);
    gl.GetIntegerv(gl::vertex_array_type, &array.type);
    gl.GetIntegerv(gl::vertex_array_stride, &array.stride);
    gl.GetPointerv(gl::vertex_array_pointer, &array.pointer);
    return array;
}

// glPopClientAttrib of Mesa's indirect GLX (22.3.6) restores all arrays but this one. An array that the pop restored is
// not set again: it may lie in a buffer, which is no longer bound.
void restore(const Gl11 &gl, const VertexArray &array)
{
    if (array != vertex_array_of(gl))
        gl.VertexPointer(array.size, static_cast<gl::Enum>(array.type), array.stride, array.pointer);
}

}  // namespace

bool VertexArray::operator!=(const VertexArray &other) const
{
    return size != other.size || type != other.type || stride != other.stride || pointer != other.pointer;
}

StackEntries stack_entries_of(Guard mode) { return {mode == Guard::full, mode != Guard::none}; }

void disable_arrays(const Gl11 &gl)
{
    for (const gl::Enum array : arrays) gl.DisableClientState(array);
}

SampleSwitches::SampleSwitches(const Gl11 &gl, Multisample multisample)
    : gl_(gl), known_(multisample != Multisample::missing)
{
    for (int i = 0; known_ && i < 3; ++i) on_[i] = gl_.IsEnabled(names[i]) != gl::no;
}

void SampleSwitches::restore() const
{
    for (int i = 0; known_ && i < 3; ++i)
        if ((gl_.IsEnabled(names[i]) != gl::no) != on_[i]) on_[i] ? gl_.Enable(names[i]) : gl_.Disable(names[i]);
}

StateGuard::StateGuard(const Gl11 &gl, Guard mode, Multisample multisample, gl::Bits more)
    : gl_(gl), mode_(mode), samples_(gl, mode == Guard::full ? multisample : Multisample::missing)
{
    if (mode_ == Guard::none) return;
    if (mode_ == Guard::full) gl_.PushAttrib(touched_groups | more);
    vertex_array_ = vertex_array_of(gl_);
    gl_.PushClientAttrib(gl::client_vertex_array_bit);
    gl_.GetIntegerv(gl::matrix_mode, &matrix_mode_);
    gl_.GetDoublev(gl::modelview_matrix, modelview_);
    gl_.GetDoublev(gl::projection_matrix, projection_);
    gl_.GetDoublev(gl::texture_matrix, texture_);
}

StateGuard::~StateGuard()
{
    if (mode_ == Guard::none) {
        disable_arrays(gl_);
        return;
    }
    gl_.MatrixMode(gl::texture);
    gl_.LoadMatrixd(texture_);
    gl_.MatrixMode(gl::projection);
    gl_.LoadMatrixd(projection_);
    gl_.MatrixMode(gl::modelview);
    gl_.LoadMatrixd(modelview_);
    gl_.MatrixMode(static_cast<gl::Enum>(matrix_mode_));
    gl_.PopClientAttrib();
    restore(gl_, vertex_array_);
    if (mode_ != Guard::full) return;
    gl_.PopAttrib();
    samples_.restore();
    let_materials_follow(gl_);
}

UploadGuard::UploadGuard(const Gl11 &gl) : gl_(gl)
{
    gl_.PushAttrib(gl::texture_bit | gl::pixel_mode_bit);
    gl_.PushClientAttrib(gl::client_pixel_store_bit);
    default_unpacking(gl_);
}

UploadGuard::~UploadGuard()
{
    gl_.PopClientAttrib();
    gl_.PopAttrib();
}

}  // namespace claque::passes

// How much of the host's GL state a draw restores.
//
//   full     everything is as before.
//   minimal  the matrices, the matrix mode and all client state are as before; left_by_minimal below lists the state
//            that stays as claque set it.
//   none     left_by_minimal and left_by_none list the state that stays as claque set it.
//
// After an individual with hooks (draw::Hooks) all state that they may have changed is as before, with texture 0 bound.
//
// Matrices are saved by value: GL 1.1 guarantees a projection stack of two, and a host may use both entries.
#pragma once

#include "passes/gl11.h"
#include "passes/options.h"
#include "passes/preflight.h"

namespace claque::passes
{

// State that is left behind, by its name for glGet or glIsEnabled.
struct Left {
    gl::Enum name;
    const char *as;  // its value then
};

constexpr Left left_by_minimal[] = {
    {0x0B00, "current colour: undefined"},
    {0x0B02, "current normal: undefined"},
    {0x0B03, "current texture coordinates: undefined"},
    {0x0B10, "GL_POINT_SMOOTH: off"},
    {0x0B20, "GL_LINE_SMOOTH: off"},
    {0x0B24, "GL_LINE_STIPPLE: off"},
    {0x0B41, "GL_POLYGON_SMOOTH: off"},
    {0x0B42, "GL_POLYGON_STIPPLE: off"},
    {0x0B44, "GL_CULL_FACE: on, off after a double-sided surface"},
    {0x0B45, "GL_CULL_FACE_MODE: GL_BACK"},
    {0x0B46, "GL_FRONT_FACE: GL_CCW, GL_CW after a mirrored individual"},
    {0x0B52, "GL_LIGHT_MODEL_TWO_SIDE: 0, 1 after a double-sided surface"},
    {0x0B55, "GL_COLOR_MATERIAL_FACE: GL_FRONT_AND_BACK"},
    {0x0B56, "GL_COLOR_MATERIAL_PARAMETER: GL_AMBIENT_AND_DIFFUSE"},
    {0x0B57, "GL_COLOR_MATERIAL: on"},
    {0x1200, "GL_AMBIENT of both materials: undefined"},
    {0x1201, "GL_DIFFUSE of both materials: undefined"},
    {0x0B71, "GL_DEPTH_TEST: on"},
    {0x0B72, "GL_DEPTH_WRITEMASK: on"},
    {0x0B74, "GL_DEPTH_FUNC: GL_LEQUAL"},
    {0x0BA1, "GL_NORMALIZE: on"},
    {0x0BC0, "GL_ALPHA_TEST: as the last surface had it"},
    {0x0BC1, "GL_ALPHA_TEST_FUNC: GL_GEQUAL or GL_EQUAL, if a surface needed it"},
    {0x0BC2, "GL_ALPHA_TEST_REF: as the last surface had it"},
    {0x0BE2, "GL_BLEND: off"},
    {0x0BF2, "GL_COLOR_LOGIC_OP: off"},
    {0x0C23, "GL_COLOR_WRITEMASK: the host's, alpha off"},
    {0x0C60, "GL_TEXTURE_GEN_S: off"},
    {0x0C61, "GL_TEXTURE_GEN_T: off"},
    {0x0C62, "GL_TEXTURE_GEN_R: off"},
    {0x0C63, "GL_TEXTURE_GEN_Q: off"},
    {0x0DE0, "GL_TEXTURE_1D: off"},
    {0x0DE1, "GL_TEXTURE_2D: on"},
    {0x8069, "GL_TEXTURE_BINDING_2D: the last surface's texture, 0 after hooks"},
    {0x2200, "GL_TEXTURE_ENV_MODE: GL_MODULATE"},
    {0x809D, "GL_MULTISAMPLE, where GL has it: off, or as the host has it with RendererOptions::multisample"},
    {0x809E, "GL_SAMPLE_ALPHA_TO_COVERAGE, where GL has it: off"},
    {0x809F, "GL_SAMPLE_ALPHA_TO_ONE, where GL has it: off"},
};

constexpr Left left_by_none[] = {
    {0x0BA0, "GL_MATRIX_MODE: GL_MODELVIEW"},
    {0x0BA6, "GL_MODELVIEW_MATRIX: the last individual's, or that of one of its parts"},
    {0x0BA7, "GL_PROJECTION_MATRIX: the view's"},
    {0x0BA8, "GL_TEXTURE_MATRIX: identity"},
    {0x8074, "GL_VERTEX_ARRAY: off"},
    {0x8075, "GL_NORMAL_ARRAY: off"},
    {0x8076, "GL_COLOR_ARRAY: off"},
    {0x8077, "GL_INDEX_ARRAY: off"},
    {0x8078, "GL_TEXTURE_COORD_ARRAY: off"},
    {0x8079, "GL_EDGE_FLAG_ARRAY: off"},
    {0x807A, "GL_VERTEX_ARRAY_SIZE: 3"},
    {0x807B, "GL_VERTEX_ARRAY_TYPE: GL_FLOAT"},
    {0x807C, "GL_VERTEX_ARRAY_STRIDE: 0"},
    {0x808E, "GL_VERTEX_ARRAY_POINTER: the last individual's, memory that may be gone; so are the others"},
    {0x807E, "GL_NORMAL_ARRAY_TYPE: GL_FLOAT"},
    {0x807F, "GL_NORMAL_ARRAY_STRIDE: 0"},
    {0x808F, "GL_NORMAL_ARRAY_POINTER"},
    {0x8081, "GL_COLOR_ARRAY_SIZE: 4, where colours came from arrays; so are the next three"},
    {0x8082, "GL_COLOR_ARRAY_TYPE: GL_UNSIGNED_BYTE or GL_FLOAT"},
    {0x8083, "GL_COLOR_ARRAY_STRIDE: 0"},
    {0x8090, "GL_COLOR_ARRAY_POINTER"},
    {0x8088, "GL_TEXTURE_COORD_ARRAY_SIZE: 2"},
    {0x8089, "GL_TEXTURE_COORD_ARRAY_TYPE: GL_FLOAT"},
    {0x808A, "GL_TEXTURE_COORD_ARRAY_STRIDE: 0"},
    {0x8092, "GL_TEXTURE_COORD_ARRAY_POINTER"},
};

// Entries that it needs on the host's attribute stacks.
StackEntries stack_entries_of(Guard mode);

// The host's vertex array.
struct VertexArray {
    int32_t size = 0, type = 0, stride = 0;
    void *pointer = nullptr;
    bool operator!=(const VertexArray &other) const;
};

// The switches of GL 1.3 that a draw sets, saved by value: NVIDIA's driver (580.159.04) restores GL_MULTISAMPLE with
// none of the groups that the guard pushes.
class SampleSwitches
{
public:
    SampleSwitches(const Gl11 &gl, Multisample multisample);
    void restore() const;

private:
    static constexpr gl::Enum names[] = {gl::multisample, gl::sample_alpha_to_coverage, gl::sample_alpha_to_one};

    const Gl11 &gl_;
    bool known_;
    bool on_[3] = {false, false, false};
};

// Saves the state of the mode on construction and restores it on destruction. Preflight has checked the stacks.
class StateGuard
{
public:
    // `multisample`: what the draw does about it. `more`: additional attribute groups that the caller changes.
    StateGuard(const Gl11 &gl, Guard mode, Multisample multisample, gl::Bits more = 0);
    ~StateGuard();
    StateGuard(const StateGuard &) = delete;
    StateGuard &operator=(const StateGuard &) = delete;

private:
    const Gl11 &gl_;
    Guard mode_;
    SampleSwitches samples_;
    int32_t matrix_mode_ = 0;
    double modelview_[16], projection_[16], texture_[16];
    VertexArray vertex_array_;
};

// Disables all client arrays.
void disable_arrays(const Gl11 &gl);

// Saves and restores in full the state that uploading textures changes.
class UploadGuard
{
public:
    explicit UploadGuard(const Gl11 &gl);
    ~UploadGuard();
    UploadGuard(const UploadGuard &) = delete;
    UploadGuard &operator=(const UploadGuard &) = delete;

private:
    const Gl11 &gl_;
};

}  // namespace claque::passes

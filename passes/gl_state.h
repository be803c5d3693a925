// GL state as a value that is compared and applied, as in Quake III's renderer: no strategy calls glEnable. S1 3 names
// the state that zone colours depend on; preflight.h and tests/gl/host_state_test.cpp have what else breaks them.
#pragma once

#include "lib/model/model.h"
#include "passes/gl11.h"
#include "passes/options.h"

namespace claque::passes
{

// The state that differs between surfaces and between passes.
struct SurfaceState {
    uint32_t texture = 0;
    bool double_sided = false;    // no culling, both faces lit
    bool mirrored = false;        // front faces are clockwise
    bool colour_array = false;    // colours come from an array, otherwise from glColor
    bool flat = false;            // GL_FLAT without a texture
    model::Lighting lighting;     // unlit: without GL_LIGHTING, even where the host has it on
    gl::Enum alpha_function = 0;  // 0: no alpha test
    float alpha_reference = 0;

    bool operator==(const SurfaceState &o) const
    {
        return texture == o.texture && double_sided == o.double_sided && mirrored == o.mirrored &&
               colour_array == o.colour_array && flat == o.flat && lighting == o.lighting &&
               alpha_function == o.alpha_function && (alpha_function == 0 || alpha_reference == o.alpha_reference);
    }
};

// What a draw does about GL_MULTISAMPLE: nothing, as this GL has none; turns it off; leaves it as the host has it.
enum class Multisample : uint8_t { missing, off, hosts };

class GlState
{
public:
    GlState(const Gl11 &gl, DrawStats &stats) : gl_(gl), stats_(stats) {}

    // Sets all state that is constant during a draw. The rest is then unknown, so that the first apply() sets
    // everything. The host's RGB mask stays; alpha writes are masked.
    void begin(const float *projection, Multisample multisample);

    // Restores what is the host's and differs for single surfaces (shade model, lighting, emission), and enables
    // texturing again. To be called before other code sees GL's state.
    void end();

    // Called after other code changed per-surface state: the next apply() sets everything.
    void forget() { known_ = false; }

    // Issues the differences from the last call. The matrix mode is GL_MODELVIEW and stays so.
    void apply(const SurfaceState &wanted);

private:
    void apply_alpha(const SurfaceState &wanted);
    void set_flat(bool flat);
    void set_lighting(const model::Lighting &wanted);

    const Gl11 &gl_;
    DrawStats &stats_;
    SurfaceState now_;
    bool known_ = false;
    gl::Enum shade_model_ = 0;  // the host's
    // The host's lighting, and its emission in front and behind; asked for by the first surface that differs.
    struct HostLighting {
        bool known = false, on = false;
        float front[4] = {0, 0, 0, 1}, back[4] = {0, 0, 0, 1};
    };
    HostLighting host_;
};

}  // namespace claque::passes

// Rigid parts placed by GL's matrix stack instead of by moved vertices (S0 6.2.2: products that nobody tracks).
#pragma once

#include "passes/canvas.h"

namespace claque::passes
{

// How many more matrices may lie on the current context's modelview stack: GL 1.1 promises 32 in all, 30 are used at
// most, fewer where the host has some on it.
uint32_t matrix_room(const Gl11 &gl);

// Walks down to each part that an individual shows and draws what hangs on each node under its matrix. The canvas has
// placed it; the matrix mode is GL_MODELVIEW, and the stack is left as it was found. Where the tree is deeper than
// `room`, its lower matrices are multiplied here and take turns in the last place; without any room they replace the
// individual's matrix.
class MatrixWalk
{
public:
    MatrixWalk(const Gl11 &gl, Canvas &canvas, Array<math::Affine> &chain, DrawStats &stats, uint32_t room);
    void draw(const Individual &individual);

private:
    void rise_to(uint32_t depth);  // pops what lies deeper
    void descend(const math::Affine &matrix);
    void draw_nested(const Individual &individual, const MatrixStep &step);
    void draw_multiplied(const Individual &individual, const MatrixStep &step);
    void draw_own(const Individual &individual, const MatrixStep &step);

    const Gl11 &gl_;
    Canvas &canvas_;
    Array<math::Affine> &chain_;
    DrawStats &stats_;
    uint32_t room_, nested_;
    uint32_t depth_ = 0;  // matrices pushed
};

}  // namespace claque::passes

// Transforms rigid parts by GL's matrix stack instead of transforming their vertices (S0 6.2.2: untracked products).
#pragma once

#include "passes/canvas.h"

namespace claque::passes
{

// How many more matrices fit on the current context's modelview stack. GL 1.1 guarantees 32 entries; at most 30 are
// used, fewer if the host has pushed some.
uint32_t matrix_room(const Gl11 &gl);

// Walks down the tree to each drawn part of an individual and draws the parts of each node under its matrix. The canvas
// has set the individual's matrix; the matrix mode is GL_MODELVIEW, and the stack is afterwards as before. If the tree
// is deeper than `room`, lower matrices are multiplied here and replace each other in the last entry; with no room they
// replace the individual's matrix.
class MatrixWalk
{
public:
    MatrixWalk(const Gl11 &gl, Canvas &canvas, Array<math::Affine> &chain, DrawStats &stats, uint32_t room);
    void draw(const Individual &individual);

private:
    void rise_to(uint32_t depth);  // pops deeper entries
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

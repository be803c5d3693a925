#include "passes/matrix_walk.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include "passes/strategies.h"

namespace claque::passes
{

uint32_t matrix_room(const Gl11 &gl)
{
    constexpr int32_t maximum = 30;
    int32_t taken = 1, all = 32;
    gl.GetIntegerv(gl::modelview_stack_depth, &taken);
    gl.GetIntegerv(gl::max_modelview_stack_depth, &all);
    return static_cast<uint32_t>(std::clamp(all - taken, 0, maximum));
}

// The last entry is kept for matrices that are multiplied here and replace each other.
MatrixWalk::MatrixWalk(const Gl11 &gl, Canvas &canvas, Array<math::Affine> &chain, DrawStats &stats, uint32_t room)
    : gl_(gl), canvas_(canvas), chain_(chain), stats_(stats), room_(room), nested_(room > 0 ? room - 1 : 0)
{
}

void MatrixWalk::draw(const Individual &individual)
{
    const Array<MatrixStep> &steps = individual.ready->steps;
    for (uint32_t i = 0; i < steps.size();) {
        const MatrixStep &step = steps[i];
        if (!(step.below & individual.parts)) {
            i = step.next;
            continue;
        }
        step.depth <= nested_ ? draw_nested(individual, step) : draw_multiplied(individual, step);
        ++i;
    }
    rise_to(0);
}

void MatrixWalk::rise_to(uint32_t depth)
{
    for (; depth_ > depth; --depth_) gl_.PopMatrix();
}

void MatrixWalk::descend(const math::Affine &matrix)
{
    gl_.PushMatrix();
    gl_.MultMatrixf(glm::value_ptr(math::mat4_of(matrix)));
    ++stats_.matrices;
    ++depth_;
}

void MatrixWalk::draw_nested(const Individual &individual, const MatrixStep &step)
{
    rise_to(step.depth - 1);
    descend(individual.item->locals[step.node]);
    draw_own(individual, step);
}

void MatrixWalk::draw_multiplied(const Individual &individual, const MatrixStep &step)
{
    const math::Affine &local = individual.item->locals[step.node];
    const uint32_t level = step.depth - nested_ - 1;
    chain_[level] = level == 0 ? local : math::mul(chain_[level - 1], local);
    if (!(step.own & individual.parts)) return;
    rise_to(nested_);
    if (room_ > 0) descend(chain_[level]);
    else gl_.LoadMatrixf(glm::value_ptr(glm::make_mat4(individual.item->model_view) * math::mat4_of(chain_[level])));
    draw_own(individual, step);
}

void MatrixWalk::draw_own(const Individual &individual, const MatrixStep &step)
{
    if (!(step.own & individual.parts)) return;
    Individual part = individual;
    part.parts = step.own & individual.parts;
    draw_parts(canvas_, part);
}

}  // namespace claque::passes

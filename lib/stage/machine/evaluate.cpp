#include <algorithm>
#include <cmath>

#include "lib/stage/hash.h"
#include "lib/stage/machine/expression.h"

namespace claque::stage
{

double draw(Situation &at, uint32_t purpose) { return unit(hash(at.seed, at.agent_seed, purpose, (*at.draws)++)); }

// Free walking speeds have the mean and the deviation that Weidmann found (Transporttechnik der Fussgaenger, 1993,
// section 3.2). Twelve uniform numbers add up to a normal one with a deviation of 1 (Irwin and Hall, 1927), by sums
// alone; 2.5 deviations are the most.
double own_speed_m_s(uint64_t seed, uint64_t agent_seed)
{
    constexpr double mean = 1.34, deviation = 0.26;
    constexpr uint64_t purpose = 2;
    double normal = -6;
    for (uint64_t i = 0; i < 12; ++i) normal += unit(hash(seed, agent_seed, purpose, i));
    return mean + deviation * std::clamp(normal, -2.5, 2.5);
}

namespace
{

double read(const Op &op, Situation &at)
{
    switch (op.code) {
        case Code::number:
            return op.number;
        case Code::variable:
            return at.variables[op.index];
        case Code::crowd:
            return at.crowd[op.index];
        case Code::time:
            return at.time;
        case Code::clock:
            return at.clock;
        case Code::value:
            return at.value;
        case Code::distance:
            return at.distance;
        case Code::in_view:
            return at.in_view;
        case Code::walking:
            return at.walking;
        case Code::own_speed:
            return own_speed_m_s(at.seed, at.agent_seed);
        default:
            return at.nearby->nearest_m(op.index);
    }
}

double combine(const Op &op, double a, double b, Situation &at)
{
    switch (op.code) {
        case Code::add:
            return a + b;
        case Code::subtract:
            return a - b;
        case Code::multiply:
            return a * b;
        case Code::divide:
            return a / b;
        case Code::less:
            return a < b;
        case Code::less_equal:
            return a <= b;
        case Code::greater:
            return a > b;
        case Code::greater_equal:
            return a >= b;
        case Code::equal:
            return a == b;
        case Code::unequal:
            return a < b || a > b;
        case Code::min:
            return b < a ? b : a;
        case Code::max:
            return b > a ? b : a;
        default:
            return a + (b - a) * draw(at, op.index);
    }
}

}  // namespace

double evaluate(const Op *ops, Program program, Situation &at)
{
    double stack[max_stack];
    uint32_t top = 0;
    for (uint32_t i = program.first, end = program.first + program.count; i < end; ++i) {
        const Op &op = ops[i];
        if (op.code <= Code::near) {
            stack[top++] = read(op, at);
        } else if (op.code == Code::negate) {
            stack[top - 1] = -stack[top - 1];
        } else if (op.code == Code::negation) {
            stack[top - 1] = stack[top - 1] == 0;
        } else if (op.code == Code::abs) {
            stack[top - 1] = std::fabs(stack[top - 1]);
        } else if (op.code == Code::floor) {
            stack[top - 1] = std::floor(stack[top - 1]);
        } else if (op.code == Code::count) {
            stack[top - 1] = at.nearby->count(op.index, stack[top - 1]);
        } else if (op.code == Code::skip_if_false || op.code == Code::skip_if_true) {
            if ((stack[top - 1] != 0) == (op.code == Code::skip_if_true)) i += op.index;
            else --top;
        } else {
            --top;
            stack[top - 1] = combine(op, stack[top - 1], stack[top], at);
        }
    }
    return stack[0];
}

}  // namespace claque::stage

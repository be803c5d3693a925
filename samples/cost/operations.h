// How often each elementary operation of S0 Table 1 is done in a frame: Table 5 by its own formulas, and the same
// operations counted for the scene of Table 2 in the order of work of S0 4.2.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "samples/cost/scene.h"

namespace cost
{

enum Operation : size_t { no_01, no_02, no_03, no_04a, no_04b, no_05, operation_count };
enum class Processing { traditional, actor };

using Counts = std::array<double, operation_count>;

const char *name_of(Operation operation);
const char *description_of(Operation operation);

// A count as the paper or this file defines it: the formula, and its text.
struct TableFormula {
    const char *words;
    double (*count)(const Factors &);
};
struct SceneFormula {
    const char *words, *why;
    double (*count)(const Scene &);
};

const TableFormula &table_5(Operation operation, Processing processing);
const SceneFormula &by_order_of_work(Operation operation, Processing processing);

Counts counts_of_table_5(const Factors &factors, Processing processing);
Counts counts_by_order_of_work(const Scene &scene, Processing processing);

}  // namespace cost

// What the parts of a split take from its allowance, estimated before they are made.
#pragma once

#include "meshsplit/allowance.h"
#include "meshsplit/level_plan.h"
#include "meshsplit/material_plan.h"

namespace claque::meshsplit
{

// Vertices, triangles and morph targets of all levels. Throws base::Error (LIMIT), as below.
void charge_meshes(const model::Model &model, const std::vector<LevelPlan> &plans, Allowance &allowance);

// All planned textures at their final size, and what making the largest of them holds at once.
void charge_textures(const model::Model &model, const MaterialPlan &materials, uint32_t max_px, Allowance &allowance);

}  // namespace claque::meshsplit

// A generated character for tests: a tree of nodes, clips with every kind of key, two levels with vertices of one to
// six influences, copies, morph targets, zones. Random, but the same for the same seed.
#pragma once

#include <memory>

#include "lib/model/template.h"

namespace claque::testing_support
{

enum class Shape { similar, sheared };  // sheared: scales differ by axis, so normals need matrices of their own

struct FigureDef {
    uint32_t seed = 1;
    uint32_t nodes = 9;
    uint32_t vertices = 40;  // of the finer level, for each number of influences
    Shape shape = Shape::similar;
    bool morphs = true;
    std::pmr::memory_resource *memory = std::pmr::get_default_resource();
};

// Clips by index. `walk` 1.1 s at 30 Hz; `sway` cubic splines with irregular keys; `pose` one key; `steps` STEP keys.
enum : uint32_t { clip_walk = 0, clip_sway = 1, clip_pose = 2, clip_steps = 3 };

std::unique_ptr<model::Template> make_figure(const FigureDef &def = {});

}  // namespace claque::testing_support

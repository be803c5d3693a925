// Selects all parts of a model that are not hidden, with all its joints and morph weights.
#include <numeric>

#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

Selection all_visible(const model::Model &model)
{
    Selection all;
    all.rig = &model.rig;
    for (uint32_t p = 0; p < model.parts.size(); ++p)
        if (!model.parts[p].hidden) all.parts.push_back(p);
    all.entries.resize(model.rig.palette.size());
    std::iota(all.entries.begin(), all.entries.end(), 0u);
    for (const model::MorphSet &set : model.rig.morph_sets) all.first_weights.push_back(set.first_weight);
    return all;
}

}  // namespace claque::meshsplit

// One closed surface round all parts of a character at rest, in levels of a few triangles: clothes, hair and limbs that
// are pieces of their own grow together, and what is hidden inside is not there. Between the files of this room only.
#pragma once

#include "lib/base/services.h"
#include "lib/model/model.h"

namespace claque::lod
{

struct ProxyMeshOptions {
    std::vector<size_t> targets;  // triangles, descending strictly
    uint32_t cells = 48;          // along the character's longest side: what is thinner than one does not show
    // What a vertex costs that stands for surface that follows other joints, or shows another zone, in shares of the
    // character's size.
    double influence = 0.1, zone = 0.05;
    base::Jobs jobs;
};

// One skinned part for each target, without texture coordinates. Vertices follow the joints that what they stand for
// follows, the four that weigh most.
std::vector<model::Part> proxy_meshes(const model::Model &model, const std::vector<const model::Part *> &source,
                                      const ProxyMeshOptions &options);

}  // namespace claque::lod

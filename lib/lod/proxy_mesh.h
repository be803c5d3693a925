// One closed surface round all parts of a character at rest, in levels of a few triangles. Clothes, hair and separate
// limbs fuse, and hidden interior surface disappears. Internal to lib/lod.
#pragma once

#include "lib/base/services.h"
#include "lib/model/model.h"

namespace claque::lod
{

struct ProxyMeshOptions {
    std::vector<size_t> targets;  // triangles, strictly descending

    // The cost of a vertex that represents surface of other joints, or of another zone, as fractions of the character's
    // size.
    double influence = 0.1, zone = 0.05;
    base::Jobs jobs = {};
    uint32_t cells = 48;  // along the character's longest side; details below one cell are lost
};

// Returns one skinned part per target, without texture coordinates. A vertex follows the joints of the surface that it
// represents, at most the four heaviest.
std::vector<model::Part> proxy_meshes(const model::Model &model, const std::vector<const model::Part *> &source,
                                      const ProxyMeshOptions &options);

}  // namespace claque::lod

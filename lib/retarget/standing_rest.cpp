#include "lib/retarget/standing_rest.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "lib/retarget/joints.h"

namespace claque::retarget
{

namespace
{

constexpr double in_the_air = 0.15, on_the_ground = 0.1;  // of the height

// Lowest and highest joint of the skins.
struct Heights {
    double low = 1e300, high = -1e300;

    explicit Heights(const model::Rig &rig)
    {
        const GlobalPose rest = rest_pose(rig);
        for (const model::PaletteEntry &entry : rig.palette) {
            const double y = rest.positions[entry.node].y;
            low = std::min(low, y), high = std::max(high, y);
        }
    }
    double above() const { return low / (high - low); }  // of the height
};

// False where the matrix mirrors or flattens.
bool decompose(const math::Affine &matrix, math::Trs &out)
{
    glm::mat3 turn;
    for (int k = 0; k < 3; ++k) {
        const glm::vec3 column = matrix.column(k);
        out.scale[k] = glm::length(column);
        if (!(out.scale[k] > 0)) return false;
        turn[k] = column / out.scale[k];
    }
    if (!(glm::determinant(turn) > 0.99f)) return false;
    out.rotation = glm::normalize(glm::quat_cast(turn));
    out.translation = matrix.column(3);
    return true;
}

}  // namespace

std::optional<model::Rig> standing_rest(const model::Rig &rig)
{
    if (rig.palette.empty() || !(Heights(rig).above() > in_the_air)) return std::nullopt;
    std::vector<const math::Affine *> bound(rig.node_count());
    const math::Affine identity;  // of rigid parts
    for (const model::PaletteEntry &entry : rig.palette)
        if (!bound[entry.node] && !std::equal(entry.inverse_bind.c, std::end(entry.inverse_bind.c), identity.c))
            bound[entry.node] = &entry.inverse_bind;
    model::Rig out(rig, std::pmr::get_default_resource());
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        if (!bound[i]) continue;
        const uint32_t parent = rig.parents[i];
        // A skin is bound in the space of the node above its topmost joint.
        math::Affine local = math::inverse(*bound[i]);
        if (parent != model::none && bound[parent]) local = math::mul(*bound[parent], local);
        if (!decompose(local, out.rest[i])) return std::nullopt;
    }
    if (!(std::fabs(Heights(out).above()) < on_the_ground)) return std::nullopt;
    return out;
}

}  // namespace claque::retarget

#include "meshsplit/rest.h"

#include <cmath>

#include "lib/math/trig.h"

namespace claque::meshsplit
{

namespace
{

constexpr float tolerance = 1e-4f;

bool uniform(float x, float y, float z)
{
    const float limit = tolerance * std::fabs(x);
    return std::fabs(x - y) <= limit && std::fabs(x - z) <= limit;
}

bool uniform_keys(const model::Rig &rig, const model::Channel &channel)
{
    const uint32_t groups = channel.interpolation == model::Interpolation::cubic_spline ? 3 : 1;
    const float *v = rig.values.data() + channel.first_value;
    for (uint32_t i = 0; i < channel.key_count * groups; ++i)
        if (!uniform(v[3 * i], v[3 * i + 1], v[3 * i + 2])) return false;
    return true;
}

}  // namespace

std::vector<math::Affine> rest_locals(const model::Rig &rig)
{
    std::vector<math::Trs> rest(rig.rest.begin(), rig.rest.end());
    for (const model::Dof &dof : rig.dofs) {
        if (dof.kind == model::DofKind::morph || dof.rest == 0) continue;
        math::Trs &local = rest[dof.node];
        if (dof.kind == model::DofKind::translation) {
            local.translation += local.rotation * (dof.axis * dof.rest);
        } else {
            const float half = 0.5f * dof.rest;
            local.rotation = local.rotation * glm::quat(math::cos(half), math::sin(half) * dof.axis);
        }
    }
    std::vector<math::Affine> out;
    for (const math::Trs &trs : rest) out.push_back(math::affine_of(trs));
    return out;
}

std::vector<math::Affine> rest_palette(const model::Rig &rig)
{
    const std::vector<math::Affine> locals = rest_locals(rig);
    std::vector<math::Affine> global(rig.node_count()), palette;
    for (uint32_t i = 0; i < rig.node_count(); ++i)
        global[i] = rig.parents[i] == model::none ? locals[i] : math::mul(global[rig.parents[i]], locals[i]);
    for (const model::PaletteEntry &entry : rig.palette)
        palette.push_back(math::mul(global[entry.node], entry.inverse_bind));
    return palette;
}

bool similar_only(const model::Rig &rig)
{
    for (const math::Trs &trs : rig.rest)
        if (!uniform(std::fabs(trs.scale.x), std::fabs(trs.scale.y), std::fabs(trs.scale.z))) return false;
    for (const model::Channel &channel : rig.channels)
        if (channel.target == model::ChannelTarget::scale && !uniform_keys(rig, channel)) return false;
    for (const model::PaletteEntry &entry : rig.palette)
        if (!math::is_similarity(entry.inverse_bind)) return false;
    return true;
}

}  // namespace claque::meshsplit

// Gown and palla below the waist as one heavy cloth: like Region::gown, but cloth at the side partly follows the cloth
// in front and behind, so that a sitter's palla does not fold through the gown beside her thighs.
#include "lib/figures/brush.h"
#include "lib/figures/patrician/patrician.h"

namespace claque::figures::patrician
{

BoneWeights weigh_heavy_cloth(const Point &point)
{
    const glm::vec3 p = point.position;
    BoneWeights w{};
    const float hang = smoothstep(1.02f, 0.80f, p.y), below = smoothstep(0.56f, 0.40f, p.y);
    weigh_trunk(w, p, 1 - hang);
    const float left = smoothstep(-0.13f, 0.13f, p.x), front = smoothstep(-0.22f, 0.22f, p.z);
    const float above = hang * (1 - below);
    add_weight(w, Bone::skirt_front, above * left * front);
    add_weight(w, Bone::skirt_front_r, above * (1 - left) * front);
    add_weight(w, Bone::skirt_back, above * left * (1 - front));
    add_weight(w, Bone::skirt_back_r, above * (1 - left) * (1 - front));
    // In front the hem rests on the toes when the shins lean.
    const float toes = 0.72f * smoothstep(0.24f, 0.04f, p.y) * smoothstep(0.04f, 0.12f, p.z);
    add_weight(w, Bone::shin, hang * (below - toes) * left);
    add_weight(w, Bone::shin_r, hang * (below - toes) * (1 - left));
    add_weight(w, Bone::toes, hang * toes * left);
    add_weight(w, Bone::toes_r, hang * toes * (1 - left));
    return w;
}

}  // namespace claque::figures::patrician

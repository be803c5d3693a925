#include "lib/figures/weights.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/base/error.h"

namespace claque::figures
{

namespace
{

using Dense = BoneWeights;

float step(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

}  // namespace

void chain(BoneWeights &w, float whole, std::initializer_list<Link> links)
{
    for (const Link &link : links) {
        add_weight(w, link.bone, whole * (1 - link.share));
        whole *= link.share;
    }
}

void weigh_trunk(BoneWeights &w, glm::vec3 p, float whole)
{
    chain(w, whole,
          {{Bone::pelvis, step(0.97f, 1.09f, p.y)},
           {Bone::spine, step(1.07f, 1.19f, p.y)},
           {Bone::spine_upper, step(1.17f, 1.31f, p.y)},
           {Bone::chest, 0}});
}

// Torso and sleeve: trunk, then collar bone, then upper arm, by the point's distance outwards.
void weigh_shoulder(BoneWeights &w, glm::vec3 p, Side side, float whole)
{
    const glm::vec3 q = mirrored(p, side);
    const glm::vec3 joint = skeleton().joint(Bone::upper_arm);
    const float height = step(1.24f, 1.42f, p.y);
    const float out = step(0.03f, 0.17f, q.x) * height;
    const float arm = step(-0.055f, 0.075f, glm::dot(q - joint, arm_direction()) - 0.25f * (1.40f - q.y)) *
                      step(1.20f, 1.34f, q.y + (q.x > 0.2f ? 1 : 0));
    const float along = glm::dot(q - joint, arm_direction());
    weigh_trunk(w, p, whole * (1 - arm) * (1 - 0.75f * out));
    add_weight(w, on(side, Bone::clavicle), whole * (1 - arm) * 0.75f * out);
    chain(w, whole * arm,
          {{on(side, Bone::upper_arm), 0.12f * step(0.19f, 0.31f, along)}, {on(side, Bone::forearm), 0}});
}

void weigh_arm(BoneWeights &w, glm::vec3 p, Side side, float whole)
{
    const glm::vec3 d = arm_direction();
    const float along = glm::dot(mirrored(p, side) - skeleton().joint(Bone::upper_arm), d);
    chain(w, whole,
          {{on(side, Bone::upper_arm), step(0.240f, 0.345f, along)},
           {on(side, Bone::forearm), step(0.515f, 0.572f, along)},
           {on(side, Bone::hand), 0}});
}

namespace
{

// Below the belt each quarter of the cloth follows a skirt bone; the share `below` follows the shins instead.
void hang_cloth(BoneWeights &w, glm::vec3 p, float whole, float below)
{
    const float hang = step(1.02f, 0.80f, p.y);
    weigh_trunk(w, p, whole * (1 - hang));
    const float left = step(-0.13f, 0.13f, p.x), front = step(-0.12f, 0.12f, p.z);
    const float above = whole * hang * (1 - below);
    add_weight(w, Bone::skirt_front, above * left * front);
    add_weight(w, Bone::skirt_front_r, above * (1 - left) * front);
    add_weight(w, Bone::skirt_back, above * left * (1 - front));
    add_weight(w, Bone::skirt_back_r, above * (1 - left) * (1 - front));
    add_weight(w, Bone::shin, whole * hang * below * left);
    add_weight(w, Bone::shin_r, whole * hang * below * (1 - left));
}

}  // namespace

void weigh_gown(BoneWeights &w, glm::vec3 p, float whole) { hang_cloth(w, p, whole, step(0.56f, 0.40f, p.y)); }

namespace
{

void fingers(Dense &w, glm::vec3 p, Side side)
{
    const float along = glm::dot(mirrored(p, side) - skeleton().joint(Bone::hand), arm_direction());
    chain(w, 1,
          {{on(side, Bone::hand), step(0.070f, 0.112f, along)},
           {on(side, Bone::fingers), step(0.120f, 0.148f, along)},
           {on(side, Bone::fingertips), 0}});
}

void thumb(Dense &w, glm::vec3 p, Side side)
{
    const glm::vec3 q = mirrored(p, side) - skeleton().joint(Bone::hand);
    const float out = glm::dot(q, arm_thumbward()) + 0.5f * glm::dot(q, arm_direction());
    chain(w, 1, {{on(side, Bone::hand), step(0.030f, 0.085f, out)}, {on(side, Bone::thumb), 0}});
}

void leg(Dense &w, glm::vec3 p, Side side)
{
    chain(w, 1,
          {{on(side, Bone::thigh), step(0.56f, 0.42f, p.y)},
           {on(side, Bone::shin), step(0.125f, 0.070f, p.y)},
           {on(side, Bone::foot), 0}});
}

void foot(Dense &w, glm::vec3 p, Side side)
{
    const float down = step(0.125f, 0.070f, p.y);
    add_weight(w, on(side, Bone::shin), 1 - down);
    chain(w, down, {{on(side, Bone::foot), step(0.080f, 0.135f, p.z)}, {on(side, Bone::toes), 0}});
}

void head(Dense &w, glm::vec3 p)
{
    // The throat follows the head from a greater height than the nape.
    const float y = p.y + 0.25f * p.z;
    chain(w, 1, {{Bone::chest, step(1.445f, 1.500f, y)}, {Bone::neck, step(1.485f, 1.555f, y)}, {Bone::head, 0}});
}

Dense weights_of(const Point &point, Weigher weigher)
{
    if (point.region >= Region::own) return weigher(point);
    Dense w{};
    const glm::vec3 p = point.position;
    const Side side = p.x >= 0 ? Side::left : Side::right;
    switch (point.region) {
        case Region::head:
            head(w, p);
            break;
        case Region::torso:
            weigh_shoulder(w, p, side, 1);
            break;
        case Region::skirt:
            hang_cloth(w, p, 1, 0);
            break;
        case Region::gown:
            weigh_gown(w, p, 1);
            break;
        case Region::sleeve:
            weigh_shoulder(w, p, point.side, 1);
            break;
        case Region::arm:
        case Region::palm:
            weigh_arm(w, p, point.side, 1);
            break;
        case Region::index:
        case Region::fingers:
            fingers(w, p, point.side);
            break;
        case Region::thumb:
            thumb(w, p, point.side);
            break;
        case Region::leg:
            leg(w, p, point.side);
            break;
        case Region::foot:
            foot(w, p, point.side);
            break;
        default:
            break;
    }
    return w;
}

bool smoothed(Region region)
{
    return region == Region::torso || region == Region::sleeve || region == Region::skirt || region >= Region::own ||
           region == Region::gown;
}

void smooth(const Mesh &mesh, std::vector<Dense> &dense)
{
    // Points at equal positions are one here, or the surface would tear between them.
    std::map<std::tuple<float, float, float>, uint32_t> places;
    std::vector<uint32_t> welded;
    for (uint32_t i = 0; i < mesh.points.size(); ++i) {
        const glm::vec3 p = mesh.points[i].position;
        welded.push_back(places.try_emplace({p.x, p.y, p.z}, i).first->second);
    }
    std::vector<std::vector<uint32_t>> neighbours(mesh.points.size());
    for (const Face &f : mesh.faces)
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = welded[f.corners[k].point], b = welded[f.corners[(k + 1) % 3].point];
            neighbours[a].push_back(b);
            neighbours[b].push_back(a);
        }
    const std::vector<Dense> before = dense;
    constexpr float kept = 0.7f;
    for (size_t i = 0; i < dense.size(); ++i) {
        if (!smoothed(mesh.points[i].region) || neighbours[i].empty()) continue;
        for (size_t b = 0; b < bone_count; ++b) {
            float sum = 0;
            for (const uint32_t n : neighbours[i]) sum += before[n][b];
            dense[i][b] = kept * before[i][b] + (1 - kept) * sum / static_cast<float>(neighbours[i].size());
        }
    }
    for (size_t i = 0; i < dense.size(); ++i) dense[i] = dense[welded[i]];
}

Binding strongest(const Dense &w)
{
    std::array<uint32_t, bone_count> order{};
    for (uint32_t i = 0; i < bone_count; ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&w](uint32_t a, uint32_t b) { return w[a] > w[b]; });
    Binding binding;
    float sum = 0;
    for (size_t k = 0; k < 4; ++k) sum += w[order[k]] > 0.01f ? w[order[k]] : 0;
    for (size_t k = 0; k < 4; ++k) {
        const bool used = w[order[k]] > 0.01f;
        binding.bones[k] = used ? order[k] : order[0];
        binding.weights[k] = used ? w[order[k]] / sum : 0;
    }
    return binding;
}

}  // namespace

std::vector<Binding> bind(const Mesh &mesh, Weigher weigher)
{
    std::vector<Dense> dense;
    for (const Point &point : mesh.points) {
        if (point.region >= Region::own && !weigher)
            base::fail(CLQ_ARGUMENT, "a point has a region of the figure's own, but the figure has no weigher");
        dense.push_back(weights_of(point, weigher));
    }
    smooth(mesh, dense);
    std::vector<Binding> bindings;
    for (const Dense &w : dense) bindings.push_back(strongest(w));
    return bindings;
}

}  // namespace claque::figures

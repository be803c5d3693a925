#include "lib/track/sole.h"

#include <algorithm>
#include <cmath>

namespace claque::track
{

namespace
{

constexpr float min_weight = 0.6f;   // of the foot's nodes, for a vertex to be the foot's
constexpr float sole_height = 0.3f;  // of the ankle's: vertices below it are the sole's
constexpr float ball_share = 0.72f;  // of the length of the sole, from the heel; of people 0.70 to 0.74
constexpr float heel_share = 0.12f;  // where a foot with its toes up stands: heels are round

// The vertices of a foot at the finest level, in model space.
std::vector<glm::vec3> vertices_of(const model::Template &tmpl, const pose::Workspace &work, const pose::Leg &leg)
{
    std::vector<bool> inside(tmpl.rig.node_count(), false);
    for (const uint32_t node : leg.foot_nodes) inside[node] = true;
    const model::Level &level = tmpl.levels[0];
    std::vector<glm::vec3> out;
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t i = 0; i < run.count; ++i) {
            const uint32_t first = run.first_influence + i * run.influences;
            const float *p = level.positions.data() + 3 * size_t(run.first + i);
            glm::vec3 moved(0);
            float weight = 0;
            for (uint32_t k = 0; k < run.influences; ++k) {
                const model::PaletteEntry &entry = tmpl.rig.palette[level.joints[first + k]];
                if (!inside[entry.node]) continue;
                const math::Affine matrix = math::mul(work.global(entry.node), entry.inverse_bind);
                moved = moved + math::transform_point(matrix, glm::vec3(p[0], p[1], p[2])) * level.weights[first + k];
                weight += level.weights[first + k];
            }
            if (weight > min_weight) out.push_back(moved / weight);
        }
    return out;
}

}  // namespace

void set_sole(const model::Template &tmpl, const pose::Workspace &work, uint32_t toes, pose::Leg &leg)
{
    const glm::vec3 ankle = work.global(leg.foot).column(3);
    std::vector<glm::vec3> points = vertices_of(tmpl, work, leg);
    float low = 0;
    if (!points.empty())
        low = std::min_element(points.begin(), points.end(), [](const auto &a, const auto &b) { return a.y < b.y; })->y;
    const float ceiling = low + sole_height * (ankle.y - low);
    points.erase(std::remove_if(points.begin(), points.end(), [&](const glm::vec3 &p) { return p.y > ceiling; }),
                 points.end());

    // The foot points where its sole is longest from the ankle; rigs and poses turn it outwards.
    glm::vec3 tip = ankle + glm::vec3(0, 0, ankle.y - low);
    float length = 0;
    for (const glm::vec3 &p : points) {
        const float x = p.x - ankle.x, z = p.z - ankle.z, reach = x * x + z * z;
        if (reach > length) length = reach, tip = p;
    }
    const float dx = tip.x - ankle.x, dz = tip.z - ankle.z, size = std::sqrt(dx * dx + dz * dz);
    const glm::vec3 ahead = size > 0 ? glm::vec3(dx / size, 0, dz / size) : glm::vec3(0, 0, 1);
    float back = -0.3f * size, front = size;
    for (const glm::vec3 &p : points) {
        const float along = (p.x - ankle.x) * ahead.x + (p.z - ankle.z) * ahead.z;
        back = std::min(back, along), front = std::max(front, along);
    }
    const glm::vec3 base(ankle.x, low, ankle.z);
    glm::vec3 ball = base + ahead * (back + ball_share * (front - back));
    if (toes != model::none) {
        ball = work.global(toes).column(3);
        ball.y = low;
    }
    const math::Affine to_foot = math::inverse(work.global(leg.foot));
    leg.ball = math::transform_point(to_foot, ball);
    leg.heel = math::transform_point(to_foot, base + ahead * (back + heel_share * (front - back)));
}

}  // namespace claque::track

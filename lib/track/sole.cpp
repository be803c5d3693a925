#include "lib/track/sole.h"

#include <algorithm>
#include <cmath>

#include "lib/math/trig.h"

namespace claque::track
{

namespace
{

constexpr float min_weight = 0.6f;   // of the foot's nodes, for a vertex to be the foot's
constexpr float sole_height = 0.3f;  // of the ankle's: vertices below it are the sole's
constexpr float ball_share = 0.72f;  // of the length of the sole, from the heel; of people 0.70 to 0.74
constexpr float heel_share = 0.12f;  // where a foot with its toes up stands: heels are round
constexpr float flat_share = 0.02f;  // of the length of the sole: what lies lower touches the ground under a flat foot
// The ways in which a foot is tilted to find the points on which it can stand.
constexpr int pitches = 6, rolls = 1;  // to either side
constexpr double pitch_rad = 0.25, roll_rad = 0.3;

struct Vertex {
    glm::vec3 at = glm::vec3(0);  // in model space
    bool of_toes = false;
};

// The vertices of a foot at the finest level.
std::vector<Vertex> vertices_of(const model::Template &tmpl, const pose::Workspace &work, const pose::Leg &leg)
{
    std::vector<bool> inside(tmpl.rig.node_count(), false), toes(inside);
    for (const uint32_t node : leg.foot_nodes) inside[node] = true;
    if (leg.toes != model::none)
        for (const uint32_t node : pose::nodes_below(tmpl.rig, leg.toes, model::none, std::pmr::get_default_resource()))
            toes[node] = true;
    const model::Level &level = tmpl.levels[0];
    std::vector<Vertex> out;
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t i = 0; i < run.count; ++i) {
            const uint32_t first = run.first_influence + i * run.influences;
            const float *p = level.positions.data() + 3 * size_t(run.first + i);
            glm::vec3 moved(0);
            float weight = 0, of_toes = 0;
            for (uint32_t k = 0; k < run.influences; ++k) {
                const model::PaletteEntry &entry = tmpl.rig.palette[level.joints[first + k]];
                if (!inside[entry.node]) continue;
                const math::Affine matrix = math::mul(work.global(entry.node), entry.inverse_bind);
                moved = moved + math::transform_point(matrix, glm::vec3(p[0], p[1], p[2])) * level.weights[first + k];
                weight += level.weights[first + k];
                if (toes[entry.node]) of_toes += level.weights[first + k];
            }
            if (weight > min_weight) out.push_back({moved / weight, 2 * of_toes > weight});
        }
    return out;
}

// Where a foot touches the ground: seen from its ball, ahead, aside and up.
struct Frame {
    glm::vec3 ball, ahead;

    glm::vec3 operator()(const glm::vec3 &p) const
    {
        const glm::vec3 d = p - ball;
        return glm::vec3(d.x * ahead.x + d.z * ahead.z, d.x * ahead.z - d.z * ahead.x, d.y);
    }
};

// The vertices of one node that are the lowest ones in some pose of the foot.
void add_points(const std::vector<Vertex> &vertices, bool of_toes, const Frame &frame, const math::Affine &to_node,
                pose::Leg &leg)
{
    float back = 0, front = 0, size = 0;  // of what touches the ground, and of the whole foot
    for (const Vertex &v : vertices) size = std::max(size, std::fabs(frame(v.at).x));
    for (const Vertex &v : vertices) {
        const glm::vec3 p = frame(v.at);
        if (p.z < flat_share * size) back = std::min(back, p.x), front = std::max(front, p.x);
    }
    std::vector<size_t> found;
    for (int pitch = -pitches; pitch <= pitches; ++pitch)
        for (int roll = -rolls; roll <= rolls; ++roll) {
            const auto tilted = [&](size_t v) {
                const glm::dvec3 p(frame(vertices[v].at));
                const double up = p.z * math::cos(roll * roll_rad) + p.y * math::sin(roll * roll_rad);
                return up * math::cos(pitch * pitch_rad) + p.x * math::sin(pitch * pitch_rad);
            };
            size_t lowest = vertices.size();
            for (size_t v = 0; v < vertices.size(); ++v)
                if (vertices[v].of_toes == of_toes && (lowest == vertices.size() || tilted(v) < tilted(lowest)))
                    lowest = v;
            if (lowest < vertices.size()) found.push_back(lowest);
        }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const size_t v : found) {
        const glm::vec3 p = frame(vertices[v].at);
        // Toes and heels that are round come down farther from the ball than they are.
        const float past = p.x > front ? p.x - front : p.x < back ? p.x - back : 0;
        const float rolled = std::copysign(std::sqrt(past * past + p.z * p.z), past);
        const float ahead = past != 0 ? p.x - past + rolled : p.x;
        leg.sole.push_back({math::transform_point(to_node, vertices[v].at), ahead, p.y});
    }
}

}  // namespace

void set_sole(const model::Template &tmpl, const pose::Workspace &work, uint32_t toes, pose::Leg &leg)
{
    leg.toes = toes;
    const glm::vec3 ankle = work.global(leg.foot).column(3);
    const std::vector<Vertex> vertices = vertices_of(tmpl, work, leg);
    float low = vertices.empty() ? 0 : vertices[0].at.y;
    for (const Vertex &v : vertices) low = std::min(low, v.at.y);
    std::vector<glm::vec3> points;
    for (const Vertex &v : vertices)
        if (!(v.at.y > low + sole_height * (ankle.y - low))) points.push_back(v.at);

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
    const glm::vec3 base(ankle.x, low, ankle.z), heel = base + ahead * (back + heel_share * (front - back));
    glm::vec3 ball = base + ahead * (back + ball_share * (front - back));
    if (toes != model::none) {
        ball = work.global(toes).column(3);
        ball.y = low;
    }
    const math::Affine to_foot = math::inverse(work.global(leg.foot));
    leg.ball = math::transform_point(to_foot, ball);
    leg.heel = math::transform_point(to_foot, heel);

    const glm::vec3 d = ball - heel;
    const float flat = std::sqrt(d.x * d.x + d.z * d.z);
    const Frame frame{ball, flat > 0 ? d / flat : glm::vec3(0, 0, 1)};
    leg.sole.clear();
    add_points(vertices, false, frame, to_foot, leg);
    if (leg.sole.empty())
        for (const glm::vec3 &p : {ball, heel}) leg.sole.push_back({math::transform_point(to_foot, p), frame(p).x, 0});
    leg.first_of_toes = static_cast<uint32_t>(leg.sole.size());
    if (toes != model::none) add_points(vertices, true, frame, math::inverse(work.global(toes)), leg);
}

}  // namespace claque::track

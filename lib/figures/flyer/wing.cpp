#include "lib/figures/flyer/wing.h"

#include "lib/figures/brush.h"

namespace claque::figures::flyer
{

namespace
{

// By the fraction of the span: the leading edge and the tips of the feathers, from the root, in metres.
constexpr glm::vec2 lead_x[] = {{0, 0}, {0.2f, 0.27f}, {0.42f, 0.60f}, {0.65f, 1.02f}, {0.85f, 1.42f}, {1, 1.70f}};
constexpr glm::vec2 lead_y[] = {{0, 0.05f},      {0.12f, 0.150f}, {0.28f, 0.285f}, {0.40f, 0.330f},
                                {0.55f, 0.310f}, {0.75f, 0.190f}, {0.90f, 0.000f}, {1, -0.19f}};
constexpr glm::vec2 tips_x[] = {{0, 0.03f},     {0.2f, 0.22f},  {0.45f, 0.58f}, {0.65f, 0.93f},
                                {0.80f, 1.25f}, {0.92f, 1.54f}, {1, 1.715f}};
constexpr glm::vec2 tips_y[] = {{0, -0.30f},      {0.1f, -0.415f},  {0.45f, -0.480f}, {0.62f, -0.560f},
                                {0.80f, -0.570f}, {0.92f, -0.420f}, {1, -0.215f}};

enum class WingFace : uint8_t { back, front };

// `c` runs from the leading edge, 0, to the tips, 1.
glm::vec3 on_wing(const Wing &wing, float u, float c, WingFace face)
{
    const glm::vec2 lead(profile(lead_x, u), profile(lead_y, u)), tip(profile(tips_x, u), profile(tips_y, u));
    const glm::vec2 q = lead + (tip - lead) * c;
    const float arch = -0.150f * (1 - (2 * q.x / 1.7f - 0.75f) * (2 * q.x / 1.7f - 0.75f)) + 0.065f;
    const float thick = (0.030f - 0.022f * u) * (c < 0.3f ? 1 : (1 - c) / 0.7f) * (c == 0 ? 0 : 1);
    const float droop = 0.050f * c * c;  // feathers bend down at their ends
    return wing.root +
           glm::vec3(q.x * wing.scale.x, q.y * wing.scale.y, arch + droop + (face == WingFace::front ? thick : -thick));
}

// The row of tips: a tip, then a notch; notches are deeper between the feathers of the hand.
std::vector<std::pair<float, float>> tips_of(int feathers, float hand_from, float notch, float hand_notch)
{
    std::vector<std::pair<float, float>> out = {{0, 1}};
    for (int i = 1; i <= feathers; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(feathers);
        const float between = u - 0.30f / static_cast<float>(feathers);
        if (i > 1) out.push_back({between, 1 - (u > hand_from ? hand_notch : notch)});
        out.push_back({u, 1});
    }
    return out;
}

std::vector<std::pair<float, float>> row(float c, const std::vector<float> &us)
{
    std::vector<std::pair<float, float>> out;
    for (const float u : us) out.push_back({u, c});
    return out;
}

std::vector<std::vector<std::pair<float, float>>> rows_of(int level)
{
    const std::vector<float> fine = {0, 0.15f, 0.3f, 0.45f, 0.6f, 0.75f, 0.9f, 1}, medium = {0, 0.25f, 0.45f, 0.75f, 1};
    switch (level) {
        case 0:
            return {tips_of(11, 0.55f, 0.07f, 0.22f), row(0.32f, {0, 0.13f, 0.26f, 0.4f, 0.56f, 0.68f, 0.8f, 0.9f, 1}),
                    row(0, fine)};
        case 1:
            return {tips_of(6, 0.55f, 0.05f, 0.16f), row(0.32f, medium), row(0, medium)};
        case 2:
            return {row(1, {0, 0.4f, 0.8f, 1}), row(0, {0, 0.4f, 0.75f, 1})};
        default:
            return {row(1, {0, 0.8f}), row(0, {0, 0.45f, 1})};
    }
}

}  // namespace

void add_wing(Mesh &mesh, const Wing &wing, Side side, int level)
{
    for (const WingFace face : {WingFace::back, WingFace::front}) {
        MeshBuilder to(mesh);  // separate, because normals must not be shared round the edges of a thin wing
        const Chart chart = face == WingFace::back ? wing.back : wing.front;
        // Seen from the front the span of the left wing runs to the right, seen from behind to the left.
        const bool as_given = (face == WingFace::front) == (side == Side::left);
        std::vector<std::vector<MeshBuilder::SheetVertex>> lines;
        for (const auto &line : rows_of(level)) {
            std::vector<MeshBuilder::SheetVertex> stops;
            for (const auto &[u, c] : line)
                stops.push_back({mirrored(on_wing(wing, u, c, face), side), glm::vec2(-c, u)});
            lines.push_back(stops);
        }
        to.sheet(chart, as_given ? Winding::reversed : Winding::as_given, lines);
    }
}

}  // namespace claque::figures::flyer

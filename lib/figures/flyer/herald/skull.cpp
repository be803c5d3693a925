// The head as one function of angle and height, which every level of detail samples: profiles in front, at the side and
// behind, then nose, sockets, lips, cheeks and hair.
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/flyer/herald/herald.h"
#include "lib/math/trig.h"

namespace claque::figures::flyer::herald
{

namespace
{

constexpr glm::vec2 front[] = {{-0.150f, 0.026f}, {-0.128f, 0.060f}, {-0.112f, 0.083f}, {-0.090f, 0.086f},
                               {-0.072f, 0.089f}, {-0.045f, 0.092f}, {0.000f, 0.094f},  {0.030f, 0.092f},
                               {0.052f, 0.100f},  {0.080f, 0.099f},  {0.105f, 0.084f},  {0.125f, 0.050f},
                               {0.137f, 0.000f}};
constexpr glm::vec2 side[] = {{-0.150f, 0.026f}, {-0.128f, 0.044f}, {-0.105f, 0.055f}, {-0.072f, 0.071f},
                              {-0.030f, 0.082f}, {0.020f, 0.087f},  {0.050f, 0.090f},  {0.080f, 0.088f},
                              {0.105f, 0.073f},  {0.125f, 0.045f},  {0.137f, 0.000f}};
constexpr glm::vec2 back[] = {{-0.150f, 0.030f}, {-0.100f, 0.058f}, {-0.060f, 0.082f},
                              {0.000f, 0.102f},  {0.050f, 0.108f},  {0.080f, 0.102f},
                              {0.105f, 0.084f},  {0.125f, 0.050f},  {0.137f, 0.000f}};
constexpr glm::vec2 nose[] = {{-0.053f, 0.000f}, {-0.046f, 0.012f}, {-0.036f, 0.0265f}, {-0.028f, 0.0265f},
                              {0.010f, 0.010f},  {0.040f, 0.002f},  {0.060f, 0}};

// The thickness of the hair, with tufts.
float hair(float angle, float height)
{
    const float over = height - hairline(std::fabs(angle));
    const float tuft = math::sin(angle * 5 + 0.6f) * math::sin(height * 70 + angle * 3);
    return smoothstep(-0.004f, 0.012f, over) * (0.013f + 0.007f * tuft);
}

// Below the mouth, as far as the jaw reaches.
float hollow(float angle, float height)
{
    const float a = std::fabs(angle);
    return smoothstep(-0.0735f, -0.0755f, height) * smoothstep(0.64f, 0.57f, a) * smoothstep(-0.148f, -0.130f, height);
}

}  // namespace

float angle_of(float s) { return s < 0.62f ? s * 0.95f / 0.62f : 0.95f + (s - 0.62f) * (3.14159265f - 0.95f) / 0.38f; }
float s_of(float a) { return a < 0.95f ? a * 0.62f / 0.95f : 0.62f + (a - 0.95f) * 0.38f / (3.14159265f - 0.95f); }

float hairline(float angle)
{
    static constexpr glm::vec2 line[] = {{0.00f, 0.082f},  {0.30f, 0.088f},  {0.60f, 0.074f},  {0.90f, 0.040f},
                                         {1.02f, -0.010f}, {1.20f, -0.048f}, {1.50f, -0.052f}, {1.66f, -0.036f},
                                         {1.85f, -0.062f}, {2.60f, -0.108f}, {3.20f, -0.112f}};
    return profile(line, angle);
}

glm::vec3 on_head(float angle, float height, Sculpt sculpt)
{
    const float sx = math::sin(angle), cz = math::cos(angle);
    const float a = profile(side, height), b = cz > 0 ? profile(front, height) : profile(back, height);
    if (a <= 0) return head_centre + glm::vec3(0, height, 0);
    constexpr float p = 2.25f;
    const float radius = math::pow(math::pow(std::fabs(sx) / a, p) + math::pow(std::fabs(cz) / b, p), -1 / p);
    glm::vec3 q(radius * sx, height, radius * cz);
    const glm::vec2 f(std::fabs(q.x), q.y);
    const float ahead = cz > 0 ? 1.0f : 0.0f;
    float out = 0.005f * spot(f, {0.052f, -0.030f}, {0.034f, 0.036f});  // cheeks
    out += 0.004f * spot(f, {0.036f, 0.049f}, {0.030f, 0.016f});        // below the brows
    out += 0.0055f * spot(f, {0, -0.0625f}, {0.026f, 0.011f});          // upper lip
    out += 0.0050f * spot(f, {0, -0.0815f}, {0.024f, 0.012f});          // lower lip
    out += 0.0070f * spot(f, {0, -0.108f}, {0.030f, 0.022f});           // chin
    out +=
        profile(nose, height) * std::max(0.0f, 1 - std::fabs(q.x) / (0.013f + 0.008f * spot(height + 0.036f, 0.03f)));
    if (sculpt == Sculpt::near) out -= 0.0135f * spot(f, {0.0360f, 0.0175f}, {0.037f, 0.031f});
    if (sculpt == Sculpt::near) out -= 0.014f * hollow(angle, height);
    q.z += ahead * out;
    if (sculpt == Sculpt::jaw) {
        q += glm::vec3(sx, 0, cz) * 0.0015f;
    } else {
        const float h = hair(angle, height);
        q += glm::vec3(sx, 0.6f * smoothstep(0.05f, 0.13f, height), cz) * h;
    }
    return head_centre + q;
}

}  // namespace claque::figures::flyer::herald

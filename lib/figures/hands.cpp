// A relaxed hand: the palm continues into three fingers side by side; index finger and thumb are separate, with their
// roots inside the palm.
#include <glm/geometric.hpp>

#include "lib/figures/parts.h"
#include "lib/figures/skeleton.h"

namespace claque::figures
{

namespace
{

// Along the hand, across it towards the thumb, and up towards its back.
struct HandPoint {
    float along, across, up;
};
using Section = std::vector<HandPoint>;

// Six points each: little-finger side, back of the hand twice, thumb side, palm twice.
const std::array<Section, 5> palm = {{
    {{0.000f, -0.029f, 0},
     {0, -0.015f, 0.020f},
     {0, 0.015f, 0.020f},
     {0, 0.029f, 0},
     {0, 0.015f, -0.020f},
     {0, -0.015f, -0.020f}},
    {{0.045f, -0.041f, 0},
     {0.045f, -0.024f, 0.017f},
     {0.045f, 0.022f, 0.019f},
     {0.040f, 0.040f, -0.004f},
     {0.045f, 0.022f, -0.018f},
     {0.040f, -0.022f, -0.021f}},
    {{0.084f, -0.043f, -0.002f},
     {0.088f, -0.024f, 0.013f},
     {0.094f, 0.024f, 0.016f},
     {0.090f, 0.044f, 0},
     {0.092f, 0.020f, -0.012f},
     {0.084f, -0.024f, -0.013f}},
    {{0.122f, -0.041f, -0.008f},
     {0.130f, -0.022f, 0.006f},
     {0.138f, 0.010f, 0.007f},
     {0.134f, 0.019f, -0.004f},
     {0.134f, 0.008f, -0.014f},
     {0.126f, -0.024f, -0.015f}},
    {{0.150f, -0.036f, -0.018f},
     {0.168f, -0.020f, -0.013f},
     {0.180f, 0.006f, -0.011f},
     {0.172f, 0.017f, -0.015f},
     {0.176f, 0.006f, -0.021f},
     {0.162f, -0.020f, -0.023f}},
}};

struct Digit {
    Region region;
    float chart_shift;  // its offset from the palm in the chart
    std::array<HandPoint, 3> centres;
    std::array<float, 2> radii;
    HandPoint spread;  // the direction of its width
};

const std::array<Digit, 2> digits = {{
    {Region::index,
     0.030f,
     {{{0.074f, 0.030f, -0.001f}, {0.130f, 0.0285f, -0.002f}, {0.172f, 0.0255f, -0.013f}}},
     {0.0115f, 0.0095f},
     {0, 1, 0}},
    {Region::thumb,
     0.036f,
     {{{0.030f, 0.017f, -0.008f}, {0.066f, 0.055f, -0.014f}, {0.104f, 0.070f, -0.019f}}},
     {0.0140f, 0.0125f},
     {-0.6f, 0.8f, 0}},
}};

class HandBuilder
{
public:
    HandBuilder(Mesh &mesh, Side side) : mesh_(mesh), side_(side) {}

    std::vector<uint32_t> build()
    {
        std::vector<uint32_t> wrist, before;
        for (size_t i = 0; i < palm.size(); ++i) {
            const Region region = i < 2 ? Region::palm : Region::fingers;
            std::vector<uint32_t> ring;
            for (const HandPoint p : palm[i]) ring.push_back(point(p, region, 0));
            if (i == 0) wrist = ring;
            else sew(before, ring);
            before = ring;
        }
        cap(before);
        for (const Digit &digit : digits) build(digit);
        return wrist;
    }

private:
    uint32_t point(HandPoint p, Region region, float shift)
    {
        const glm::vec3 wrist = skeleton().joint(Bone::hand);
        const glm::vec3 position = wrist + arm_direction() * p.along + arm_thumbward() * p.across + arm_dorsal() * p.up;
        const uint32_t index = mesh_.add(mirrored(position, side_), region, side_);
        st_.resize(mesh_.points.size());
        st_[index] = glm::vec2(p.along, p.across + shift);
        return index;
    }

    // Each triangle belongs to the chart of the side that it faces.
    void face(uint32_t a, uint32_t b, uint32_t c)
    {
        const auto at = [&](uint32_t i) { return mirrored(mesh_.points[i].position, side_); };
        const bool back = glm::dot(glm::cross(at(b) - at(a), at(c) - at(a)), arm_dorsal()) > 0;
        mesh_.face(on(side_, back ? Chart::hand_back : Chart::hand_palm), winding_of(side_), {a, st_[a]}, {b, st_[b]},
                   {c, st_[c]});
    }

    void sew(const std::vector<uint32_t> &lower, const std::vector<uint32_t> &upper)
    {
        const size_t n = lower.size();
        for (size_t i = 0; i < n; ++i) {
            const uint32_t a = lower[i], b = lower[(i + 1) % n], c = upper[(i + 1) % n], d = upper[i];
            const auto gap = [&](uint32_t p, uint32_t q) {
                return glm::distance(mesh_.points[p].position, mesh_.points[q].position);
            };
            if (gap(a, c) < gap(b, d)) face(a, b, c), face(a, c, d);
            else face(a, b, d), face(b, c, d);
        }
    }

    void cap(const std::vector<uint32_t> &ring)
    {
        face(ring[0], ring[1], ring[5]);
        face(ring[1], ring[2], ring[5]);
        face(ring[2], ring[4], ring[5]);
        face(ring[2], ring[3], ring[4]);
    }

    void build(const Digit &digit)
    {
        std::vector<uint32_t> before;
        for (size_t k = 0; k < 2; ++k) {
            const HandPoint c = digit.centres[k];
            const float r = digit.radii[k];
            std::vector<uint32_t> ring;
            for (const auto &[wide, high] : {std::pair(-1.f, 0.f), {0.f, 1.f}, {1.f, 0.f}, {0.f, -1.f}})
                ring.push_back(point({c.along + wide * r * digit.spread.along,
                                      c.across + wide * r * digit.spread.across, c.up + high * r * 0.95f},
                                     digit.region, digit.chart_shift));
            if (k > 0) sew(before, ring);
            before = ring;
        }
        // A blunt end: two points on the side of the nail, one below.
        const HandPoint tip = digit.centres[2];
        const float half = 0.50f * digit.radii[1];
        const auto end = [&](float wide, float back, float high) {
            return point({tip.along + wide * half * digit.spread.along - back,
                          tip.across + wide * half * digit.spread.across, tip.up + high * half},
                         digit.region, digit.chart_shift);
        };
        const uint32_t a = end(-1, 0, 0.7f), b = end(1, 0, 0.7f), c = end(0, 0.003f, -1.0f);
        face(before[0], before[1], a);
        face(before[1], b, a);
        face(before[1], before[2], b);
        face(before[2], c, b);
        face(before[2], before[3], c);
        face(before[3], before[0], c);
        face(before[0], a, c);
        face(a, b, c);
    }

    Mesh &mesh_;
    Side side_;
    std::vector<glm::vec2> st_;
};

}  // namespace

std::vector<uint32_t> add_hand(Mesh &mesh, Side side) { return HandBuilder(mesh, side).build(); }

}  // namespace claque::figures

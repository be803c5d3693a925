#include "samples/labels/sheet.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "samples/io/png.h"
#include "samples/scenes/angles.h"
#include "samples/scenes/zone_inks.h"

namespace labels
{
namespace
{

using Rgb = scenes::Ink;

uint8_t byte_of(double value) { return static_cast<uint8_t>(std::clamp(255 * value + 0.5, 0.0, 255.0)); }

Rgb of_number(uint32_t number)
{
    if (number == 0) return {24, 24, 24};
    const double turn = 0.6180339887498949 * number;
    return scenes::ink_of(turn, number % 2 == 0 ? 0.75 : 0.55, number % 3 == 0 ? 0.7 : 0.95);
}

class Sheet
{
public:
    explicit Sheet(const Sample &sample)
        : sample_(sample), width_(4 * sample.width), rgb_(3 * 8 * sample.actor.size(), 24)
    {
    }

    // One of the eight pictures: `colour` gives each pixel's.
    template <class Colour>
    void fill(int column, int row, const Colour &colour)
    {
        for (size_t i = 0; i < sample_.actor.size(); ++i) {
            const int x = static_cast<int>(i) % sample_.width, y = static_cast<int>(i) / sample_.width;
            set(column, row, x, y, colour(i));
        }
    }
    // reach: pixels round the middle one.
    void dot(int column, int row, const Keypoint &at, int reach, const Rgb &colour)
    {
        const double x = at.px[0], y = at.px[1];
        for (int v = -reach; v <= reach; ++v)
            for (int u = -reach; u <= reach; ++u) {
                const int px = static_cast<int>(std::floor(x)) + u, py = static_cast<int>(std::floor(y)) + v;
                if (px >= 0 && py >= 0 && px < sample_.width && py < sample_.height) set(column, row, px, py, colour);
            }
    }
    std::vector<unsigned char> png() const { return io::quick_png(rgb_, width_, 2 * sample_.height, 3); }

private:
    void set(int column, int row, int x, int y, const Rgb &colour)
    {
        const size_t at = 3 * (static_cast<size_t>(row * sample_.height + y) * static_cast<size_t>(width_) +
                               static_cast<size_t>(column * sample_.width + x));
        std::copy(colour.begin(), colour.end(), rgb_.begin() + static_cast<std::ptrdiff_t>(at));
    }

    const Sample &sample_;
    int width_;
    std::vector<uint8_t> rgb_;
};

constexpr Rgb nothing = {24, 24, 24};

}  // namespace

std::vector<unsigned char> sheet(const Sample &s)
{
    Sheet out(s);
    const auto colour = [&](size_t i) -> Rgb {
        return s.rgb.empty() ? nothing : Rgb{s.rgb[3 * i], s.rgb[3 * i + 1], s.rgb[3 * i + 2]};
    };
    out.fill(0, 0, colour);
    out.fill(1, 0, [&](size_t i) { return of_number(s.actor[i]); });
    out.fill(2, 0, [&](size_t i) { return s.zone.empty() ? nothing : of_number(s.zone[i]); });
    double nearest = HUGE_VAL, farthest = 0;
    for (const float d : s.depth_m)
        if (!std::isnan(d)) {
            nearest = std::min(nearest, static_cast<double>(d));
            farthest = std::max(farthest, static_cast<double>(d));
        }
    out.fill(3, 0, [&](size_t i) -> Rgb {
        if (s.depth_m.empty() || std::isnan(s.depth_m[i])) return nothing;
        const double t =
            std::log(static_cast<double>(s.depth_m[i]) / nearest) / std::log(std::max(1.01, farthest / nearest));
        const uint8_t grey = byte_of(1 - 0.8 * t);
        return {grey, grey, grey};
    });
    out.fill(0, 1, [&](size_t i) -> Rgb {
        if (s.normal.empty() || std::isnan(s.normal[3 * i])) return nothing;
        Rgb made;
        for (size_t k = 0; k < 3; ++k) made[k] = byte_of((static_cast<double>(s.normal[3 * i + k]) + 1) / 2);
        return made;
    });
    double fastest = 1e-6;
    for (size_t i = 0; i + 1 < s.forward.size(); i += 2)
        if (!std::isnan(s.forward[i]))
            fastest =
                std::max(fastest, std::hypot(static_cast<double>(s.forward[i]), static_cast<double>(s.forward[i + 1])));
    out.fill(1, 1, [&](size_t i) -> Rgb {
        if (s.forward.empty() || std::isnan(s.forward[2 * i])) return nothing;
        const double u = static_cast<double>(s.forward[2 * i]), v = static_cast<double>(s.forward[2 * i + 1]);
        return scenes::ink_of(std::atan2(-v, u) / scenes::two_pi + 1, std::sqrt(std::hypot(u, v) / fastest), 1);
    });
    std::map<uint32_t, double> share;
    for (const Person &person : s.people) share[person.actor] = person.visibility();
    out.fill(2, 1,
             [&](size_t i) { return s.actor[i] == 0 ? nothing : scenes::ink_of(share[s.actor[i]] / 3, 0.8, 0.95); });
    out.fill(3, 1, [&](size_t i) -> Rgb {
        Rgb dim = colour(i);
        for (uint8_t &c : dim) c = static_cast<uint8_t>(c / 2);
        return dim;
    });
    for (const Person &person : s.people) {
        // Joints of small people would cover them.
        const double tall_px = person.whole.y1 - person.whole.y0;
        if (person.visible_px == 0 || tall_px < 24) continue;
        const int reach = tall_px < 80 ? 0 : 1;
        for (const Keypoint &point : person.keypoints)
            if (point.seen == Seen::visible) out.dot(3, 1, point, reach, {80, 255, 80});
            else if (point.seen == Seen::hidden) out.dot(3, 1, point, reach, {255, 90, 60});
    }
    return out.png();
}

}  // namespace labels

// Bays of walls: doors, shops, windows, timber, stone. They are painted in layers: the wall first, then the objects in
// it, lighter and darker edges last. Metres inside a bay, three by three; x to the right, y up.
#include <cmath>

#include "samples/scenes/town/canvas.h"
#include "samples/scenes/town/pictures.h"

namespace scenes::town
{
namespace
{

constexpr double bay_m = 3.0;
constexpr Rgb frame = {0.96f, 0.95f, 0.91f}, oak = {0.44f, 0.31f, 0.21f}, iron = {0.20f, 0.20f, 0.22f};
constexpr Rgb green = {0.30f, 0.46f, 0.36f}, blue = {0.34f, 0.46f, 0.60f}, trim = {0.80f, 0.76f, 0.68f};

struct Box {
    double x0, y0, x1, y1;
    bool holds(double x, double y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    Box grown(double by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
    double inside(double x, double y) const { return std::min({x - x0, x1 - x, y - y0, y1 - y}); }
};

class Brush
{
public:
    explicit Brush(uint64_t seed)
        : seed_(seed), broad_(seed + 90, 12, 12), fine_(seed + 91, 400, 400), grain_(seed + 92, 40, 300)
    {
    }

    Rgb texel(Bay bay, double x, double y, double u, double v) const
    {
        u_ = u, v_ = v;
        const Rgb wall = plaster(x, y);
        switch (bay) {
            case Bay::door:
                return door(wall, x, y);
            case Bay::shop:
                return shop(wall, x, y);
            case Bay::shutters:
                return shuttered(wall, green, x, y);
            case Bay::window:
                return window(stone_round(wall, opening, x, y), opening, x, y);
            case Bay::flowers:
                return flowers(shuttered(wall, blue, x, y), x, y);
            case Bay::blank:
                return wall;
            case Bay::timber:
                return timber(wall, x, y, true);
            case Bay::timber_window:
                return window(timber(wall, x, y, false), {0.95, 0.95, 2.05, 2.25}, x, y);
            case Bay::arch:
                return arched(ashlar(x, y), {0.9, 0.25, 2.1, 2.75}, x, y, {0.24f, 0.28f, 0.36f});
            case Bay::ashlar:
                return ashlar(x, y);
            case Bay::plinth:
                return ashlar(x, y) * 0.86f;
            case Bay::gate:
                return gate(wall, x, y);
            case Bay::gable:
                return window(wall, {1.32, 0.55, 1.68, 1.45}, x, y);
            case Bay::portal:
                return arched(ashlar(x, y), {0.5, 0.0, 2.5, 2.8}, x, y, oak);
            case Bay::clock:
                return clock(ashlar(x, y), x, y);
            case Bay::planks:
                return planks(x, y);
        }
        return wall;
    }

private:
    static constexpr Box opening = {0.95, 0.85, 2.05, 2.35};

    // The same at all edges of a bay, so that bays join into one wall.
    Rgb plaster(double x, double y) const
    {
        const double inside = smooth_step(std::min({x, bay_m - x, y, bay_m - y}) / 0.5);
        const double tone = 0.94 + inside * (0.05 * (broad_(u_, v_) - 0.5)) + 0.04 * (fine_(u_, v_) - 0.5);
        return {static_cast<float>(tone), static_cast<float>(tone * 0.99), static_cast<float>(tone * 0.97)};
    }

    Rgb ashlar(double x, double y) const
    {
        const double row = std::floor(y / 0.375), shift = static_cast<int>(row) % 2 == 0 ? 0.0 : 0.375;
        const double along = (x + shift) / 0.75, column = std::floor(along), fy = y / 0.375 - row;
        const uint64_t number = static_cast<uint64_t>(row) * 16 + static_cast<uint64_t>(static_cast<int>(column) % 4);
        const double joint =
            std::min({(along - column) * 0.75, (column + 1 - along) * 0.75, fy * 0.375, (1 - fy) * 0.375});
        const double tone =
            (0.86 + 0.14 * (random_unit(seed_, number, Purpose::slab) - 0.5) + 0.10 * (fine_(u_, v_) - 0.5)) *
            (0.74 + 0.26 * smooth_step(joint / 0.025));
        return {static_cast<float>(tone), static_cast<float>(tone * 0.98), static_cast<float>(tone * 0.93)};
    }

    Rgb wood(Rgb colour, double along) const
    {
        return colour * static_cast<float>(0.86 + 0.28 * grain_(along - std::floor(along), v_));
    }

    Rgb planks(double x, double y) const
    {
        const double board = x / 0.25 - std::floor(x / 0.25);
        const uint64_t number = static_cast<uint64_t>(x / 0.25);
        const double gap = smooth_step(std::min(board, 1 - board) / 0.10);
        return wood({0.66f, 0.55f, 0.44f}, y * 0.31 + random_unit(seed_, number, Purpose::slab)) *
               static_cast<float>((0.5 + 0.5 * gap) * random_between(seed_, number, Purpose::tone, 0.85, 1.1));
    }

    // Panes that mirror the sky above and are dark below, bars between, a frame, the reveal's shadow at the top.
    Rgb window(Rgb under, Box box, double x, double y) const
    {
        if (box.grown(0.05).holds(x, y) && y < box.y0) return trim * 0.9f;
        if (!box.holds(x, y)) return under;
        const double in = box.inside(x, y), cross = std::abs(x - (box.x0 + box.x1) / 2);
        const double third = (box.y1 - box.y0) / 3, bar = std::abs(std::remainder(y - box.y0, third));
        if (in < 0.07) return frame * (y > box.y1 - 0.07 ? 0.62f : 1.0f);
        if (cross < 0.035 || (bar < 0.018 && in > 0.1)) return frame * 0.94f;
        const double up = (y - box.y0) / (box.y1 - box.y0);
        const double curtain = smooth_step((std::abs(x - (box.x0 + box.x1) / 2) / (box.x1 - box.x0) - 0.26) / 0.06);
        const Rgb glass = blend({0.17f, 0.21f, 0.26f}, {0.44f, 0.54f, 0.64f}, up * up);
        const Rgb seen = blend(glass, {0.72f, 0.70f, 0.66f}, 0.45 * curtain);
        return seen * (y > box.y1 - 0.2 ? 0.72f : 1.0f);
    }

    Rgb stone_round(Rgb under, Box box, double x, double y) const
    {
        const Box round = box.grown(0.16);
        if (!round.holds(x, y))
            return y < round.y0 && y > round.y0 - 0.1 && round.grown(0.06).holds(x, y) ? under * 0.7f : under;
        return trim * static_cast<float>(0.94 + 0.12 * fine_(u_, v_));
    }

    Rgb shuttered(Rgb under, Rgb colour, double x, double y) const
    {
        for (const Box leaf : {Box{0.42, 0.83, 0.93, 2.37}, Box{2.07, 0.83, 2.58, 2.37}}) {
            if (!leaf.holds(x, y)) {
                if (leaf.holds(x - 0.05, y + 0.05)) under = under * 0.74f;  // its shadow
                continue;
            }
            const double slat = std::abs(std::remainder(y, 0.075)) / 0.0375;
            if (leaf.inside(x, y) < 0.06 || std::abs(y - 1.6) < 0.04) return colour * 1.08f;
            return colour * static_cast<float>(0.72 + 0.36 * slat);
        }
        return window(under, opening, x, y);
    }

    Rgb flowers(Rgb under, double x, double y) const
    {
        if (Box{0.9, 0.62, 2.1, 0.80}.holds(x, y)) return oak * 1.3f;
        if (!Box{0.85, 0.68, 2.15, 1.08}.holds(x, y)) return under;
        const int column = static_cast<int>(x / 0.045), row = static_cast<int>(y / 0.045);
        const double share = random_unit(seed_, static_cast<uint64_t>(row * 128 + column), Purpose::grain);
        if (share < (y - 0.68) / 0.40) return under;
        return share > 0.80   ? Rgb{0.86f, 0.24f, 0.26f}
               : share > 0.68 ? Rgb{0.95f, 0.72f, 0.76f}
                              : Rgb{0.30f, 0.46f, 0.22f};
    }

    Rgb door(Rgb wall, double x, double y) const
    {
        const Box leaf = {0.95, 0, 2.05, 2.1};
        if (y < 2.7) wall = stone_round(wall, {0.95, -1, 2.05, 2.5}, x, y);
        if (Box{0.95, 2.1, 2.05, 2.5}.holds(x, y))
            return std::abs(y - 2.12) < 0.03 || std::abs(std::remainder(x - 1.5, 0.36)) < 0.02
                       ? frame
                       : Rgb{0.22f, 0.27f, 0.33f};
        if (!leaf.holds(x, y)) return wall;
        Rgb colour = wood({0.42f, 0.27f, 0.20f}, y * 0.3);
        for (const double low : {0.18, 0.82, 1.45})
            for (const double left : {1.07, 1.56}) {
                const Box panel = {left, low, left + 0.37, low + 0.52};
                if (!panel.holds(x, y)) continue;
                colour =
                    colour * (panel.inside(x, y) < 0.03 ? (y > low + 0.4 || x < left + 0.05 ? 0.6f : 1.5f) : 1.15f);
            }
        if (std::abs(x - 1.5) < 0.012) colour = colour * 0.5f;
        if (Box{1.42, 1.0, 1.47, 1.12}.holds(x, y)) colour = {0.85f, 0.70f, 0.36f};
        return colour;
    }

    Rgb shop(Rgb wall, double x, double y) const
    {
        if (Box{0.12, 2.28, 2.88, 2.75}.holds(x, y)) {  // the board with the name
            const Rgb board = wood({0.36f, 0.22f, 0.20f}, x * 0.3);
            const double letters = grain_(x * 0.33, 0.3) * fine_(x * 0.11, 0.2);
            return Box{0.5, 2.42, 2.5, 2.6}.holds(x, y) && letters > 0.24 ? Rgb{0.90f, 0.80f, 0.52f} : board;
        }
        const Box front = {0.2, 0.0, 2.8, 2.28};
        if (!front.holds(x, y)) return wall;
        if (y < 0.55)
            return wood({0.36f, 0.22f, 0.20f}, x * 0.3) * (std::abs(std::remainder(x, 0.65)) < 0.02 ? 0.6f : 1.0f);
        if (front.inside(x, y) < 0.08 || std::abs(std::remainder(x - 0.2, 0.8667)) < 0.03 || std::abs(y - 1.85) < 0.025)
            return {0.50f, 0.32f, 0.27f};
        const double goods =
            random_unit(seed_, static_cast<uint64_t>(x / 0.16) * 64 + static_cast<uint64_t>(y / 0.2), Purpose::tone);
        if (y < 1.15 && goods > 0.45) return blend({0.70f, 0.42f, 0.24f}, {0.86f, 0.80f, 0.60f}, goods * 2 - 1) * 0.8f;
        return blend({0.16f, 0.17f, 0.19f}, {0.42f, 0.50f, 0.56f}, (x + y - 1.4) / 3);
    }

    Rgb timber(Rgb wall, double x, double y, bool braced) const
    {
        const auto beam = [&](double distance, double along) {
            if (distance < 0.10) wall = wood(oak, along * 0.3) * (distance > 0.085 ? 0.7f : 1.0f);
        };
        beam(std::min(x, bay_m - x), y);
        beam(std::min(y, bay_m - y) - 0.02, x);
        if (braced) {
            beam(std::abs(y - x) * 0.7071, x);
            beam(std::abs(x - 1.5), y);
        } else beam(std::abs(y - 0.85), x);
        return wall;
    }

    Rgb gate(Rgb wall, double x, double y) const
    {
        const Box leaf = {0.25, 0, 2.75, 2.55};
        if (leaf.grown(0.15).holds(x, y) && !leaf.holds(x, y)) return trim;
        if (!leaf.holds(x, y)) return wall;
        if (std::abs(x - 1.5) < 0.02) return iron;
        if (std::abs(y - 0.5) < 0.05 || std::abs(y - 2.0) < 0.05) return iron;
        return planks(x, y) * 0.62f;
    }

    Rgb arched(Rgb wall, Box box, double x, double y, Rgb fill) const
    {
        const double half = (box.x1 - box.x0) / 2, spring = box.y1 - half, dx = x - box.x0 - half;
        const auto within = [&](double by) {
            if (std::abs(dx) > half + by || y < box.y0 - by) return false;
            return y < spring || dx * dx + (y - spring) * (y - spring) < (half + by) * (half + by);
        };
        if (!within(0.16)) return wall;
        if (!within(0)) return trim * (y < box.y0 ? 0.8f : 1.02f);
        if (!within(-0.1)) return fill * 0.5f;
        const double lattice = std::min(std::abs(std::remainder(x - 1.5, 0.4)), std::abs(std::remainder(y, 0.5)));
        return lattice < 0.025 ? fill * 0.55f
                               : fill * static_cast<float>(0.8 + 0.5 * fine_(u_, v_) * (y - box.y0) / 2.5);
    }

    Rgb clock(Rgb wall, double x, double y) const
    {
        const double dx = x - 1.5, dy = y - 1.5, r = std::sqrt(dx * dx + dy * dy);
        if (r > 1.3) return wall;
        if (r > 1.18 || r < 0.07) return iron;
        // Hours as strokes, where the direction is near a multiple of thirty degrees.
        double nearest = 9;
        for (int hour = 0; hour < 12; ++hour) {
            const double angle = hour * 0.5235987755982988, s = std::sin(angle), c = std::cos(angle);
            if (dx * s + dy * c > 0) nearest = std::min(nearest, std::abs(dx * c - dy * s));
        }
        if (r > 0.95 && nearest < 0.05) return iron;
        const auto hand = [&](double angle, double reach, double half) {
            const double s = std::sin(angle), c = std::cos(angle), along = dx * s + dy * c;
            return along > -0.12 && along < reach && std::abs(dx * c - dy * s) < half;
        };
        if (hand(5.3, 0.62, 0.06) || hand(0.9, 0.92, 0.04)) return {0.16f, 0.15f, 0.18f};
        return {0.95f, 0.94f, 0.88f};
    }

    uint64_t seed_;
    RepeatingNoise broad_, fine_, grain_;
    mutable double u_ = 0, v_ = 0;
};

}  // namespace

Image facades(uint64_t seed)
{
    const Brush brush(seed);
    return painted(1024, [&](double u, double v) {
        const int column = static_cast<int>(u * bays_each_way), row = static_cast<int>(v * bays_each_way);
        const double x = (u * bays_each_way - column) * bay_m, y = (v * bays_each_way - row) * bay_m;
        return brush.texel(static_cast<Bay>(row * bays_each_way + column), x, y, u, v);
    });
}

}  // namespace scenes::town

// One house: walls of bays on a plinth that follows the ground, a roof with eaves, a chimney, a step at the door.
#include <algorithm>
#include <cmath>
#include <optional>

#include "samples/scenes/random.h"
#include "samples/scenes/town/houses.h"
#include "samples/scenes/town/roofs.h"

namespace scenes::town
{
namespace
{

constexpr double sunk_m = 0.03;  // into the ground, which bends between the corners
constexpr Rgb brick = {0.70f, 0.48f, 0.40f}, cap = {0.55f, 0.50f, 0.46f}, step = {0.80f, 0.77f, 0.72f},
              plinth_stone = {0.70f, 0.66f, 0.60f};

class Builder
{
public:
    Builder(Pieces &pieces, const House &house, const Terrain &terrain, uint64_t seed)
        : pieces_(pieces), h_(house), terrain_(terrain), site_(house.site()), floor_(floor_of(house, terrain))
    {
        seed_ = seed + 7919 * house.number;
        const double share = random_unit(seed_, 0, Purpose::clip);
        window_ = share < 0.45 ? Bay::shutters : share < 0.8 ? Bay::window : Bay::flowers;
    }

    void build()
    {
        const double a = h_.width_m / 2, o = h_.depth_m / 2;
        wall(0, {-a, o, a, o});
        wall(1, {a, o, a, -o});
        wall(2, {a, -o, -a, -o});
        wall(3, {-a, -o, -a, o});
        roof(RoofPart::tiles);
        if (h_.chimney) chimney();
        pieces_.from_now(Visibility::near);
        roof(RoofPart::edges);
        if (h_.chimney) chimney_cap();
        if (door_at_) doorstep(*door_at_);
    }

private:
    double ground(double along, double out) const
    {
        const Point p = site_.ground(along, out);
        return terrain_.height(p.x, p.z);
    }

    // One of the four sides; the front is 0.
    void wall(int side, const Site::Upright &w)
    {
        const double da = w.right_along - w.left_along, dout = w.right_out - w.left_out;
        const int bays = std::max(2, static_cast<int>(std::sqrt(da * da + dout * dout) / 2.9 + 0.5));
        const int door = side == 0   ? static_cast<int>(random_unit(seed_, 1, Purpose::slab) * bays)
                         : side == 2 ? bays / 2
                                     : -1;
        const auto part = [&](double s, double t) {
            return Site::Upright{w.left_along + da * s, w.left_out + dout * s, w.left_along + da * t,
                                 w.left_out + dout * t};
        };
        plinth(part(0, 0.5));
        plinth(part(0.5, 1));
        for (int storey = 0; storey < h_.storeys; ++storey) {
            const double low = floor_ + House::plinth_m + storey * House::storey_m;
            for (int bay = 0, next = 0; bay < bays; bay = next) {
                const Bay shown = choose(side, storey, bay, door, bays);
                next = bay + 1;  // bare wall is one piece
                while (shown == Bay::blank && next < bays && choose(side, storey, next, door, bays) == Bay::blank)
                    ++next;
                const Site::Upright here = part(static_cast<double>(bay) / bays, static_cast<double>(next) / bays);
                site_.bay(pieces_.on(SurfaceKind::facades), here, low, low, low + House::storey_m, shown, h_.walls);
                if (shown == Bay::door && side == 0) door_at_ = here;
            }
        }
    }

    void plinth(const Site::Upright &w)
    {
        const double top = floor_ + House::plinth_m;
        const auto corner = [](double along, double y, double out) {
            return Vec3{static_cast<float>(along), static_cast<float>(y), static_cast<float>(out)};
        };
        site_.face(pieces_.on(SurfaceKind::stone),
                   {corner(w.left_along, ground(w.left_along, w.left_out) - sunk_m, w.left_out),
                    corner(w.right_along, ground(w.right_along, w.right_out) - sunk_m, w.right_out),
                    corner(w.right_along, top, w.right_out), corner(w.left_along, top, w.left_out)},
                   plinth_stone, 4);
    }

    Bay choose(int side, int storey, int bay, int door, int bays) const
    {
        const double share = random_unit(seed_, static_cast<uint64_t>(side * 64 + storey * 16 + bay), Purpose::grain);
        if (h_.style == House::Style::barn) return side == 0 && bay == bays / 2 ? Bay::gate : Bay::planks;
        if (storey == 0 && bay == door) return Bay::door;
        if (storey == 0 && side == 0 && h_.style == House::Style::shop) return Bay::shop;
        const bool open = side == 0 || (side == 2 ? share < 0.6 : share < 0.42);
        if (h_.style == House::Style::timber && storey > 0) return open ? Bay::timber_window : Bay::timber;
        if (!open) return Bay::blank;
        if (storey == 0 && window_ == Bay::flowers) return Bay::shutters;
        return window_;
    }

    void doorstep(const Site::Upright &w)
    {
        const double middle = (w.left_along + w.right_along) / 2, side = w.left_out > 0 ? 1 : -1, near = w.left_out;
        const double out = near + side * 0.38, low = std::min(ground(middle, near), ground(middle, out)) - sunk_m;
        site_.box(pieces_.on(SurfaceKind::stone),
                  {static_cast<float>(middle - 0.75), static_cast<float>(low), static_cast<float>(std::min(near, out))},
                  {static_cast<float>(middle + 0.75), static_cast<float>(floor_ + House::plinth_m - 0.14),
                   static_cast<float>(std::max(near, out))},
                  step, 4);
    }

    void roof(RoofPart part)
    {
        const double eaves = floor_ + h_.eaves_height();
        const bool across =
            h_.roof == House::Roof::gable_to_street || (h_.roof == House::Roof::hip && h_.depth_m > h_.width_m);
        ridge_ = across ? Site(h_.at, site_.along()) : site_;
        const double length = across ? h_.depth_m : h_.width_m, span = across ? h_.width_m : h_.depth_m;
        const RoofShape shape = {length / 2, span / 2, eaves, h_.pitch, House::eaves_m};
        if (h_.roof == House::Roof::hip) hip_roof(pieces_.on(SurfaceKind::tiles), ridge_, shape, part, h_.tiles);
        else {
            gable_roof(pieces_.on(SurfaceKind::tiles), ridge_, shape, part, h_.tiles);
            if (part == RoofPart::tiles)
                gable_walls(pieces_.on(SurfaceKind::facades), ridge_, shape, h_.walls,
                            h_.style == House::Style::barn ? Bay::planks : Bay::gable);
        }
        length_ = length, span_ = span;
    }

    double chimney_top() const { return floor_ + h_.ridge_height() + 0.75; }

    void chimney()
    {
        const double low = chimney_top() - 0.75 - h_.pitch * (0.10 * span_ + 0.5);
        block(0.42, low, chimney_top() - 0.12, brick);
    }

    void chimney_cap() { block(0.50, chimney_top() - 0.24, chimney_top() - 0.1, cap); }

    void block(double half, double y0, double y1, Rgb colour)
    {
        const double a = (random_unit(seed_, 2, Purpose::gap) < 0.5 ? -0.22 : 0.24) * length_, o = 0.10 * span_;
        ridge_.box(pieces_.on(SurfaceKind::stone),
                   {static_cast<float>(a - half), static_cast<float>(y0), static_cast<float>(o - half * 0.8)},
                   {static_cast<float>(a + half), static_cast<float>(y1), static_cast<float>(o + half * 0.8)}, colour,
                   1.5f);
    }

    Pieces &pieces_;
    const House &h_;
    const Terrain &terrain_;
    uint64_t seed_ = 0;
    Site site_, ridge_ = Site({0, 0}, {0, 1});
    double floor_, length_ = 0, span_ = 0;
    Bay window_ = Bay::window;
    std::optional<Site::Upright> door_at_;
};

}  // namespace

void build_house(Pieces &pieces, const House &house, const Terrain &terrain, uint64_t seed)
{
    Builder(pieces, house, terrain, seed).build();
    pieces.finish(Piece::Kind::house);
}

}  // namespace scenes::town

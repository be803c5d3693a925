// Positions of houses: side by side along the four sides of each block with their fronts to the street, and farms in
// the fields.
#include "samples/scenes/town/houses.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"

namespace scenes::town
{
namespace
{

constexpr Rgb walls[] = {{0.98f, 0.95f, 0.87f}, {0.97f, 0.86f, 0.66f}, {0.95f, 0.78f, 0.62f}, {0.94f, 0.92f, 0.88f},
                         {0.90f, 0.80f, 0.70f}, {0.98f, 0.90f, 0.74f}, {0.86f, 0.88f, 0.86f}, {0.93f, 0.74f, 0.68f},
                         {0.84f, 0.88f, 0.92f}, {0.97f, 0.93f, 0.80f}};
constexpr Rgb roofs[] = {{0.86f, 0.44f, 0.30f}, {0.78f, 0.40f, 0.28f}, {0.92f, 0.52f, 0.34f}, {0.70f, 0.38f, 0.28f},
                         {0.84f, 0.48f, 0.36f}, {0.60f, 0.40f, 0.33f}, {0.52f, 0.54f, 0.58f}};

template <class Item, size_t count>
const Item &pick(const Item (&items)[count], double share)
{
    return items[std::min(count - 1, static_cast<size_t>(share * count))];
}

class Placer
{
public:
    Placer(const Plan &plan, uint64_t seed) : plan_(plan), seed_(seed) {}

    std::vector<House> place()
    {
        for (const Block &block : plan_.blocks()) {
            if (block.kind == Block::Kind::houses) fill(block);
            if (block.kind == Block::Kind::yards) edge(block);
        }
        farms();
        return std::move(houses_);
    }

private:
    enum class Side { north, south, west, east };

    void fill(const Block &b)
    {
        const double corner = 14;  // the depth of the houses on the other sides
        row(b, Side::north, b.u0 + 1.2, b.u1 - 1.2, 0.86);
        row(b, Side::south, b.u0 + 1.2, b.u1 - 1.2, 0.86);
        row(b, Side::west, b.v0 + corner, b.v1 - corner, 0.78);
        row(b, Side::east, b.v0 + corner, b.v1 - corner, 0.78);
    }

    // Beyond the outermost streets: a few houses in gardens.
    void edge(const Block &b)
    {
        const std::vector<double> &u = plan_.streets_u(), &v = plan_.streets_v();
        const bool in_u = b.u0 > u.front() && b.u1<u.back(), in_v = b.v0> v.front() && b.v1 < v.back();
        if (in_u) row(b, b.v1 < v.front() ? Side::south : Side::north, b.u0 + 3, b.u1 - 3, 0.36);
        if (in_v) row(b, b.u1 < u.front() ? Side::east : Side::west, b.v0 + 3, b.v1 - 3, 0.36);
    }

    void row(const Block &b, Side side, double from, double to, double density)
    {
        const bool level = side == Side::north || side == Side::south, yards = b.kind == Block::Kind::yards;
        const double wanted = yards ? 19 : 15.5;
        const int lots = std::max(1, static_cast<int>((to - from) / wanted + 0.5));
        const double wide = (to - from) / lots;
        for (int i = 0; i < lots; ++i) {
            const uint64_t number = draws_++;
            if (random_unit(seed_, number, Purpose::place_x) > density) continue;
            House h = draw(number, wide, yards);
            const double back =
                (yards ? random_between(seed_, number, Purpose::place_z, 2.5, 6) : 0.25) + h.depth_m / 2;
            const double along = from + wide * (i + 0.5);
            const double u = level ? along : side == Side::west ? b.u0 + back : b.u1 - back;
            const double v = level ? (side == Side::north ? b.v0 + back : b.v1 - back) : along;
            stand(h, u, v, side);
        }
    }

    void stand(House &h, double u, double v, Side side)
    {
        h.at = plan_.at(u, v);
        const Point way = side == Side::north || side == Side::south ? plan_.east(u, v) : plan_.south(u, v);
        switch (side) {  // across the direction of the street there, towards it
            case Side::north:
                h.out = {way.z, -way.x};
                break;
            case Side::south:
                h.out = {-way.z, way.x};
                break;
            case Side::west:
                h.out = {-way.z, way.x};
                break;
            case Side::east:
                h.out = {way.z, -way.x};
                break;
        }
        houses_.push_back(h);
    }

    House draw(uint64_t number, double lot_wide, bool yards) const
    {
        House h = {};
        h.number = number;
        const double kind = random_unit(seed_, number, Purpose::act), shape = random_unit(seed_, number, Purpose::clip);
        h.width_m = yards ? random_between(seed_, number, Purpose::size, 8.5, 12.5)
                          : lot_wide - random_between(seed_, number, Purpose::gap, 0.7, 3.2);
        h.depth_m = random_between(seed_, number, Purpose::radius, 8.4, 10.8);
        h.storeys = yards ? (shape < 0.6 ? 1 : 2) : (kind < 0.15 ? 3 : kind < 0.9 ? 2 : 1);
        h.roof = shape < 0.50 ? House::Roof::gable : shape < 0.78 ? House::Roof::gable_to_street : House::Roof::hip;
        h.style = kind > 0.30 && kind < 0.52              ? House::Style::timber
                  : !yards && shape > 0.2 && shape < 0.55 ? House::Style::shop
                                                          : House::Style::plaster;
        h.pitch = random_between(seed_, number, Purpose::slab, 0.72, 1.0) * (h.roof == House::Roof::hip ? 0.8 : 1.0);
        h.walls = pick(walls, random_unit(seed_, number, Purpose::tone));
        h.tiles = pick(roofs, random_unit(seed_, number, Purpose::row));
        h.chimney = random_unit(seed_, number, Purpose::lane) < 0.85;
        return h;
    }

    // A house and a barn each, beside the roads out of town.
    void farms()
    {
        struct Farm {
            bool on_high_street;
            double along, beside;  // metres in the plan; beside the centre of the road, either sign
        };
        constexpr Farm sites[] = {{true, -330, 26},   {true, -560, -30}, {true, 420, 34},   {true, 560, -26},
                                  {false, -330, -26}, {false, 430, 30},  {false, -560, 28}, {false, 640, -28}};
        for (const Farm &farm : sites) {
            const uint64_t number = 5000 + draws_++;
            const double street =
                farm.on_high_street ? plan_.streets_v()[Plan::high_street] : plan_.streets_u()[Plan::south_street];
            const double u = farm.on_high_street ? farm.along : street + farm.beside;
            const double v = farm.on_high_street ? street + farm.beside : farm.along;
            const Side side = farm.on_high_street ? (farm.beside > 0 ? Side::north : Side::south)
                                                  : (farm.beside > 0 ? Side::west : Side::east);
            House home = draw(number, 14, true);
            home.storeys = 2;
            stand(home, u, v, side);
            House barn = draw(number + 400, 18, true);
            barn.style = House::Style::barn, barn.roof = House::Roof::gable, barn.storeys = 1;
            barn.width_m = 17, barn.depth_m = 10, barn.chimney = false, barn.walls = {0.95f, 0.86f, 0.76f};
            stand(barn, u + (farm.on_high_street ? 22 : 0), v + (farm.on_high_street ? 0 : 22), side);
        }
    }

    const Plan &plan_;
    uint64_t seed_;
    uint64_t draws_ = 0;
    std::vector<House> houses_;
};

}  // namespace

double House::ridge_height() const
{
    const double span = roof == Roof::gable_to_street ? width_m
                        : roof == Roof::gable         ? depth_m
                                                      : std::min(width_m, depth_m);
    return eaves_height() + pitch * span / 2;
}

std::vector<House> place_houses(const Plan &plan, uint64_t seed) { return Placer(plan, seed).place(); }

double floor_of(const House &h, const Terrain &terrain)
{
    double floor = -1e9;
    for (const double a : {-0.5, 0.5})
        for (const double o : {-0.5, 0.5}) {
            const Point p = h.site().ground(a * h.width_m, o * h.depth_m);
            floor = std::max(floor, terrain.height(p.x, p.z));
        }
    return floor;
}

}  // namespace scenes::town

#include "samples/scenes/town/ground.h"

#include <algorithm>

#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/random.h"
#include "samples/scenes/town/canvas.h"
#include "samples/scenes/town/pictures.h"

namespace scenes::town
{
namespace
{

constexpr Rgb meadow = {0.56f, 0.72f, 0.34f}, lawn = {0.50f, 0.74f, 0.34f}, garden = {0.60f, 0.73f, 0.38f};
constexpr Rgb reeds = {0.48f, 0.60f, 0.30f}, floor_of_wood = {0.30f, 0.38f, 0.20f}, sand = {0.93f, 0.83f, 0.66f};
constexpr Rgb pavement = {0.93f, 0.91f, 0.87f}, flags = {0.96f, 0.93f, 0.87f}, wall = {0.72f, 0.68f, 0.60f};
constexpr Rgb stream = {0.62f, 0.76f, 0.80f};

struct Crop {
    Rgb colour;
    SurfaceKind layer;
};
constexpr Crop crops[] = {
    {{0.93f, 0.80f, 0.46f}, SurfaceKind::furrows}, {{0.55f, 0.72f, 0.34f}, SurfaceKind::land},
    {{0.66f, 0.52f, 0.38f}, SurfaceKind::furrows}, {{0.46f, 0.68f, 0.32f}, SurfaceKind::furrows},
    {{0.86f, 0.84f, 0.40f}, SurfaceKind::land},    {{0.60f, 0.78f, 0.40f}, SurfaceKind::land},
    {{0.80f, 0.72f, 0.44f}, SurfaceKind::furrows}, {{0.50f, 0.66f, 0.38f}, SurfaceKind::furrows},
};

class Paver
{
public:
    Paver(Pieces &pieces, const Plan &plan, const Terrain &terrain, uint64_t seed)
        : pieces_(pieces), plan_(plan), terrain_(terrain), seed_(seed), u_(plan.lines_u()), v_(plan.lines_v())
    {
    }

    void cell(size_t i, size_t k)
    {
        switch (plan_.cover(i, k)) {
            case Cover::street:
                return street(i, k);
            case Cover::crossing:
                return crossing(i, k);
            case Cover::square:
                return flat(i, k, SurfaceKind::paving, flags, 8);
            case Cover::road:
                return flat(i, k, SurfaceKind::land, sand, land_metres);
            case Cover::park:
                return flat(i, k, SurfaceKind::land, lawn, land_metres);
            case Cover::garden:
                return plot(i, k);
            case Cover::bank:
                return flat(i, k, SurfaceKind::land, reeds, land_metres);
            case Cover::wood:
                return flat(i, k, SurfaceKind::land, floor_of_wood, land_metres);
            case Cover::embankment:
                return flat(i, k, SurfaceKind::stone, wall, 4);
            case Cover::water:
                return flat(i, k, SurfaceKind::water, stream, water_metres);
            case Cover::field:
                return field(i, k);
        }
    }

private:
    // Patches of lighter and darker over many metres, so that repeats of a texture do not show from the air.
    Rgb mottled(Rgb c, const Vec3 &p, double depth) const
    {
        const double broad = gradient_noise(seed_ + 21, static_cast<double>(p.x) / 130, static_cast<double>(p.z) / 130);
        const double fine = gradient_noise(seed_ + 22, static_cast<double>(p.x) / 37, static_cast<double>(p.z) / 37);
        const float k = static_cast<float>(1 + depth * (0.7 * broad + 0.5 * fine));
        return {std::min(1.0f, c.r * k), std::min(1.0f, c.g * k), std::min(1.0f, c.b * (k * 0.5f + 0.5f))};
    }

    // u and v of the texture as functions of the cell's corner (0 or 1 each way).
    template <class Texel>
    void put(size_t i, size_t k, SurfaceKind layer, Rgb colour, double depth, Texel texel)
    {
        Geometry &g = pieces_.on(layer);
        uint32_t at[4];
        constexpr size_t across[] = {0, 1, 1, 0}, down[] = {1, 1, 0, 0};
        for (size_t n = 0; n < 4; ++n) {
            const size_t column = i + across[n], row = k + down[n];
            const Vec3 &p = terrain_.corner(column, row);
            const auto [s, t] = texel(column, row);
            at[n] = g.add(p, terrain_.normal(column, row), static_cast<float>(s), static_cast<float>(t),
                          depth > 0 ? mottled(colour, p, depth) : colour);
        }
        g.triangle(at[0], at[1], at[2]);  // the same triangles as Terrain::triangle
        g.triangle(at[0], at[2], at[3]);
    }

    struct Texel {
        double s, t;
    };

    void flat(size_t i, size_t k, SurfaceKind layer, Rgb colour, double metres)
    {
        const double depth = layer == SurfaceKind::land ? 0.34 : 0.0;
        put(i, k, layer, colour, depth, [&](size_t column, size_t row) {
            const Vec3 &p = terrain_.corner(column, row);
            return Texel{static_cast<double>(p.x) / metres, static_cast<double>(p.z) / metres};
        });
    }

    // The picture lies across the street from kerb to kerb.
    void street(size_t i, size_t k)
    {
        const bool along_v = plan_.strips_u()[i].use == Strip::Use::street;
        put(i, k, SurfaceKind::cobbles, pavement, 0, [&](size_t column, size_t row) {
            return along_v ? Texel{v_[row] / cobbles_metres, column == i ? 0.0 : 1.0}
                           : Texel{u_[column] / cobbles_metres, row == k ? 0.0 : 1.0};
        });
    }

    void crossing(size_t i, size_t k)
    {
        const auto between = [](bool last) { return last ? 0.5 + roadway_share / 2 : 0.5 - roadway_share / 2; };
        put(i, k, SurfaceKind::cobbles, pavement, 0, [&](size_t column, size_t row) {
            return Texel{column == i ? 0.0 : roadway_share, between(row != k)};
        });
    }

    // Behind the houses: lawns, beds in rows, a yard here and there.
    void plot(size_t i, size_t k)
    {
        const uint64_t number = i * 4096 + k;
        const double share = random_unit(seed_, number, Purpose::act);
        const Rgb lawns = blend(garden, {0.70f, 0.72f, 0.40f}, random_unit(seed_, number, Purpose::tone));
        if (by_street(i, k)) flat(i, k, SurfaceKind::land, lawns, land_metres);
        else if (share < 0.36)
            rows(i, k, SurfaceKind::furrows, share < 0.18 ? Rgb{0.70f, 0.62f, 0.46f} : Rgb{0.58f, 0.74f, 0.40f}, 2.2,
                 number);
        else if (share < 0.48) flat(i, k, SurfaceKind::land, sand, land_metres);
        else flat(i, k, SurfaceKind::land, lawns, land_metres);
    }

    bool by_street(size_t i, size_t k) const
    {
        const auto paved = [&](size_t column, size_t row) {
            const Cover c = plan_.cover(column, row);
            return c == Cover::street || c == Cover::crossing;
        };
        return paved(i - 1, k) || paved(i + 1, k) || paved(i, k - 1) || paved(i, k + 1);
    }

    void rows(size_t i, size_t k, SurfaceKind layer, Rgb colour, double closer, uint64_t number)
    {
        const bool turned = random_unit(seed_, number, Purpose::row) < 0.5;
        put(i, k, layer, colour, 0.16, [&](size_t column, size_t row) {
            const double s = u_[column] / furrows_metres * closer, t = v_[row] / furrows_metres * closer;
            return turned ? Texel{t, s} : Texel{s, t};
        });
    }

    void field(size_t i, size_t k)
    {
        const uint64_t parcel = plan_.parcel(i, k);
        const double share = random_unit(seed_, parcel, Purpose::tone);
        const Crop &crop = crops[static_cast<size_t>(share * (sizeof crops / sizeof *crops))];
        const Rgb colour = crop.colour * static_cast<float>(random_between(seed_, parcel, Purpose::grain, 0.9, 1.06));
        rows(i, k, crop.layer, random_unit(seed_, parcel, Purpose::gap) < 0.22 ? meadow : colour, 1, parcel);
    }

    Pieces &pieces_;
    const Plan &plan_;
    const Terrain &terrain_;
    uint64_t seed_;
    std::vector<double> u_, v_;
};

}  // namespace

void cover_ground(Pieces &pieces, const Plan &plan, const Terrain &terrain, uint64_t seed)
{
    constexpr size_t patch = 6;  // cells of a piece each way
    Paver paver(pieces, plan, terrain, seed);
    for (size_t row = 0; row < terrain.rows(); row += patch)
        for (size_t column = 0; column < terrain.columns(); column += patch) {
            for (size_t k = row; k < std::min(row + patch, terrain.rows()); ++k)
                for (size_t i = column; i < std::min(column + patch, terrain.columns()); ++i) paver.cell(i, k);
            pieces.finish(Piece::Kind::ground);
        }
}

}  // namespace scenes::town

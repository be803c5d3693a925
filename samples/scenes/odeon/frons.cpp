#include "samples/scenes/odeon/frons.h"

#include <algorithm>
#include <array>

namespace scenes
{
namespace
{

constexpr Rgb marble = {0.95f, 0.92f, 0.85f}, travertine = {0.86f, 0.80f, 0.69f}, red = {0.60f, 0.25f, 0.19f};
constexpr Rgb boards = {0.52f, 0.39f, 0.27f}, bronze = {0.30f, 0.23f, 0.15f};
constexpr Rgb serpentine = {0.36f, 0.46f, 0.38f}, giallo = {0.93f, 0.76f, 0.48f};
constexpr Rgb granite = {0.62f, 0.57f, 0.56f}, tile = {0.66f, 0.38f, 0.27f};

class House
{
public:
    House(Geometry &stone, const Theatre &theatre)
        : stone_(stone),
          front_(static_cast<float>(theatre.stage.front_z_m)),
          back_(static_cast<float>(theatre.stage.front_z_m + theatre.stage.depth_m)),
          half_(static_cast<float>(theatre.stage.half_width_m)),
          floor_(static_cast<float>(theatre.stage.floor_y_m)),
          top_(static_cast<float>(theatre.stage.floor_y_m + theatre.stage.wall_height_m))
    {
    }

    void build()
    {
        stage();
        wall();
        wings();
        const float high = top_ - floor_;
        storey(floor_, high * 0.53f, 1.5f, granite, {red, serpentine});
        storey(floor_ + high * 0.53f, high * 0.40f, 1.2f, giallo, {serpentine, red});
        const float cornice = top_ - high * 0.07f;
        stone_.box({-half_ - 1.2f, cornice, back_ - 0.9f}, {half_ + 1.2f, top_, back_ + 1.45f}, marble);
        doors();
        roof();
    }

private:
    void stage()
    {
        stone_.box({-half_, 0, front_}, {half_, floor_ - 0.12f, back_}, travertine);
        stone_.box({-half_, floor_ - 0.12f, front_ - 0.08f}, {half_, floor_, back_}, boards);
        // Niches in the front, alternately round and square, as shadows between pilasters.
        const int bays = std::max(4, static_cast<int>(half_ * 2 / 1.3f));
        for (int bay = 0; bay <= bays; ++bay) {
            const float x = -half_ + 2 * half_ * static_cast<float>(bay) / static_cast<float>(bays);
            stone_.box({x - 0.12f, 0, front_ - 0.10f}, {x + 0.12f, floor_ - 0.12f, front_}, marble);
            if (bay == bays) break;
            const float middle = x + half_ / static_cast<float>(bays);
            stone_.box({middle - 0.28f, 0.15f, front_ - 0.02f}, {middle + 0.28f, floor_ - 0.3f, front_},
                       (bay % 2 == 0 ? red : travertine) * 0.62f);
        }
    }

    void wings()
    {
        for (const float side : {-1.0f, 1.0f}) {
            const float a = side * half_, b = side * (half_ + 1);
            stone_.box({std::min(a, b), 0, front_ + 1.2f}, {std::max(a, b), floor_ + 0.62f * (top_ - floor_), back_},
                       travertine);
            stone_.box({std::min(a, b) - 0.15f, floor_ + 0.62f * (top_ - floor_), front_ + 1.05f},
                       {std::max(a, b) + 0.15f, floor_ + 0.66f * (top_ - floor_), back_}, marble);
        }
    }

    // Pairs of columns on a podium before a veneered wall, with an entablature on them and statues between.
    void storey(float foot, float high, float deep, Rgb shaft, const std::array<Rgb, 2> &veneer)
    {
        const float podium = high * 0.20f, beam = high * 0.15f, columns = high - podium - beam;
        const float sill = foot + podium, under = foot + high - beam;
        stone_.box({-half_, foot, back_ - 0.25f}, {half_, sill, back_}, travertine);
        stone_.box({-half_, under, back_ - 0.3f}, {half_, foot + high - 0.02f, back_}, marble);
        const int pairs = 6;
        for (int pair = 0; pair < pairs; ++pair) {
            const float x = half_ * (-0.87f + 1.74f * static_cast<float>(pair) / (pairs - 1));
            stone_.box({x - 0.95f, foot, back_ - deep}, {x + 0.95f, sill, back_}, marble * 0.96f);
            stone_.box({x - 0.95f, under, back_ - deep}, {x + 0.95f, foot + high - 0.14f, back_}, marble);
            stone_.box({x - 1.08f, foot + high - 0.14f, back_ - deep - 0.12f}, {x + 1.08f, foot + high - 0.01f, back_},
                       marble);
            panel(x, 0.38f, sill + 0.1f, under - 0.2f, veneer[1]);
            for (const float side : {-0.6f, 0.6f})
                column(x + side, back_ - deep * 0.62f, sill, columns, 0.055f * columns, shaft);
        }
        for (int bay = 0; bay + 1 < pairs; ++bay) {
            const float x = half_ * (-0.87f + 1.74f * (static_cast<float>(bay) + 0.5f) / (pairs - 1));
            panel(x, 1.02f, sill + 0.12f, under - 0.25f, veneer[0]);
            if (bay % 2 == 1 || foot > floor_ + 0.1f)
                statue(x, back_ - 0.5f * deep, sill, columns * 0.66f, 0.5f * deep);
        }
    }

    // A slab in a frame, darker above in the shade of the beam.
    void panel(float x, float half, float low, float high, Rgb colour)
    {
        stone_.box({x - half - 0.1f, low - 0.1f, back_ - 0.04f}, {x + half + 0.1f, high + 0.1f, back_},
                   travertine * 0.9f);
        const float z = back_ - 0.05f;
        const Vec3 out = {0, 0, -1};
        const uint32_t a = stone_.add({x + half, low, z}, out, 0, 0, colour);
        const uint32_t b = stone_.add({x - half, low, z}, out, half * 0.5f, 0, colour);
        const uint32_t c = stone_.add({x - half, high, z}, out, half * 0.5f, 0.7f, colour * 0.66f);
        const uint32_t d = stone_.add({x + half, high, z}, out, 0, 0.7f, colour * 0.66f);
        stone_.triangle(a, b, c);
        stone_.triangle(a, c, d);
    }

    // A draped statue, as detailed as it appears from the seats.
    void statue(float x, float z, float foot, float high, float deep)
    {
        stone_.box({x - 0.45f, foot - 0.02f, z - 0.35f}, {x + 0.45f, foot + 0.25f, z + deep}, marble * 0.9f);
        const float y = foot + 0.25f, h = high;
        stone_.turned(x, z,
                      {{0.155f * h, y},
                       {0.13f * h, y + 0.10f * h},
                       {0.12f * h, y + 0.35f * h},
                       {0.135f * h, y + 0.52f * h},
                       {0.105f * h, y + 0.62f * h},
                       {0.15f * h, y + 0.76f * h},
                       {0.13f * h, y + 0.82f * h},
                       {0.045f * h, y + 0.85f * h},
                       {0.045f * h, y + 0.87f * h},
                       {0.066f * h, y + 0.91f * h},
                       {0.062f * h, y + 0.97f * h},
                       {0.01f * h, y + h}},
                      12, marble * 1.03f);
    }

    void column(float x, float z, float foot, float high, float r, Rgb shaft)
    {
        const float top = foot + high;
        stone_.box({x - 1.35f * r, foot, z - 1.35f * r}, {x + 1.35f * r, foot + 0.5f * r, z + 1.35f * r}, marble);
        stone_.turned(
            x, z,
            {{1.28f * r, foot + 0.5f * r}, {1.02f * r, foot + r}, {r, foot + 0.35f * high}, {0.85f * r, top - 2 * r}},
            12, shaft);
        stone_.turned(x, z, {{0.9f * r, top - 2 * r}, {1.0f * r, top - 1.2f * r}, {1.45f * r, top - 0.3f * r}}, 12,
                      marble);
        stone_.box({x - 1.4f * r, top - 0.3f * r, z - 1.4f * r}, {x + 1.4f * r, top, z + 1.4f * r}, marble);
    }

    void doors()
    {
        const auto door = [&](float x, float half, float high) {
            const float z = back_ - 0.36f;
            stone_.box({x - half - 0.28f, floor_, z}, {x + half + 0.28f, floor_ + high + 0.32f, back_}, marble);
            stone_.box({x - half - 0.45f, floor_ + high + 0.32f, z - 0.12f},
                       {x + half + 0.45f, floor_ + high + 0.5f, back_}, marble);
            stone_.box({x - half, floor_, z - 0.03f}, {x + half, floor_ + high, back_}, bronze * 0.6f);
            for (const float leaf : {-0.5f, 0.5f})
                for (int row = 0; row < 3; ++row) {
                    const float middle = x + leaf * half, low = floor_ + 0.12f + static_cast<float>(row) * high / 3;
                    stone_.box({middle - 0.36f * half, low, z - 0.06f},
                               {middle + 0.36f * half, low + high / 3 - 0.2f, back_}, bronze * 1.25f);
                }
        };
        door(0, 0.95f, 3.1f);
        for (const float side : {-1.0f, 1.0f}) door(side * 0.696f * half_, 0.7f, 2.5f);
    }

    // The wall, with pilasters and windows behind.
    void wall()
    {
        const float under = top_ - 0.3f, behind = back_ + 1.2f;
        stone_.box({-half_ - 1, 0, back_}, {half_ + 1, under, behind}, travertine);
        stone_.box({-half_, floor_, back_ - 0.02f}, {half_, under, back_}, giallo * 0.92f);
        const int bays = 9;
        for (int bay = 0; bay <= bays; ++bay) {
            const float x = (half_ + 0.6f) * (-1 + 2 * static_cast<float>(bay) / bays);
            stone_.box({x - 0.35f, 0, behind}, {x + 0.35f, under, behind + 0.18f}, marble);
            if (bay == bays) break;
            const float middle = x + (half_ + 0.6f) / bays, sill = floor_ + 0.55f * (top_ - floor_);
            stone_.box({middle - 0.55f, sill, behind}, {middle + 0.55f, sill + 1.7f, behind + 0.03f}, bronze);
        }
    }

    // Tiles that slope away from the stage.
    void roof()
    {
        const float left = -half_ - 1.3f, right = half_ + 1.3f, z0 = back_ - 0.9f, z1 = back_ + 1.9f;
        const float ridge = top_ + 1.0f, eaves = top_ + 0.06f;
        stone_.quad({Vec3{right, ridge, z0}, {left, ridge, z0}, {left, eaves, z1}, {right, eaves, z1}}, tile);
        stone_.quad({Vec3{left, eaves, z1}, {left, ridge, z0}, {right, ridge, z0}, {right, eaves, z1}}, tile * 0.5f);
        stone_.quad({Vec3{right, top_, z0}, {left, top_, z0}, {left, ridge, z0}, {right, ridge, z0}}, marble);
        for (const float x : {left, right}) {
            const Vec3 a = {x, top_, z0}, b = {x, top_, z1}, c = {x, eaves, z1}, d = {x, ridge, z0};
            if (x > 0) stone_.quad({b, a, d, c}, marble);
            else stone_.quad({a, b, c, d}, marble);
        }
    }

    Geometry &stone_;
    float front_, back_, half_, floor_, top_;
};

}  // namespace

void build_stage(Geometry &stone, const Theatre &theatre) { House(stone, theatre).build(); }

}  // namespace scenes

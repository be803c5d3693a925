#include "samples/scenes/odeon/frons.h"

#include <algorithm>

namespace scenes
{
namespace
{

constexpr Rgb marble = {0.95f, 0.92f, 0.85f}, travertine = {0.86f, 0.80f, 0.69f}, red = {0.60f, 0.25f, 0.19f};
constexpr Rgb ochre = {0.80f, 0.60f, 0.36f}, boards = {0.52f, 0.39f, 0.27f}, bronze = {0.30f, 0.23f, 0.15f};
constexpr Rgb granite = {0.58f, 0.53f, 0.52f}, tile = {0.66f, 0.38f, 0.27f};

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
        storey(floor_, high * 0.53f, 1.5f, granite, red);
        storey(floor_ + high * 0.53f, high * 0.40f, 1.2f, marble, ochre);
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
        // Niches in the front, round and square in turn as shadows between pilasters.
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

    // Columns two by two on a podium before panels, an entablature on them.
    void storey(float foot, float high, float deep, Rgb shaft, Rgb panel)
    {
        const float podium = high * 0.20f, beam = high * 0.15f, columns = high - podium - beam;
        stone_.box({-half_, foot, back_ - 0.25f}, {half_, foot + podium, back_}, travertine);
        stone_.box({-half_, foot + high - beam, back_ - 0.3f}, {half_, foot + high, back_}, marble);
        const int pairs = 6;
        for (int pair = 0; pair < pairs; ++pair) {
            const float x = half_ * (-0.87f + 1.74f * static_cast<float>(pair) / (pairs - 1));
            const float z = back_ - deep * 0.62f;
            stone_.box({x - 0.95f, foot, back_ - deep}, {x + 0.95f, foot + podium, back_}, marble * 0.96f);
            stone_.box({x - 0.95f, foot + high - beam, back_ - deep}, {x + 0.95f, foot + high, back_}, marble);
            stone_.box({x - 1.08f, foot + high - 0.12f, back_ - deep - 0.12f}, {x + 1.08f, foot + high, back_}, marble);
            stone_.box({x - 0.34f, foot + podium + 0.2f, back_ - 0.04f},
                       {x + 0.34f, foot + podium + columns * 0.8f, back_}, panel * 0.75f);
            for (const float side : {-0.6f, 0.6f})
                column(x + side, z, foot + podium, columns, 0.085f * columns * 0.65f, shaft);
        }
        for (int bay = 0; bay + 1 < pairs; ++bay) {
            const float x = half_ * (-0.87f + 1.74f * (static_cast<float>(bay) + 0.5f) / (pairs - 1));
            stone_.box({x - 0.9f, foot + podium + 0.25f, back_ - 0.03f}, {x + 0.9f, foot + high - beam - 0.3f, back_},
                       panel);
        }
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
            stone_.box({x - half - 0.25f, floor_, back_ - 0.34f}, {x + half + 0.25f, floor_ + high + 0.3f, back_},
                       marble);
            stone_.box({x - half, floor_, back_ - 0.38f}, {x + half, floor_ + high, back_}, bronze);
        };
        door(0, 0.95f, 3.1f);
        for (const float side : {-1.0f, 1.0f}) door(side * 0.525f * half_, 0.7f, 2.6f);
    }

    // The wall, with pilasters and windows behind.
    void wall()
    {
        const float under = top_ - 0.3f, behind = back_ + 1.2f;
        stone_.box({-half_ - 1, 0, back_}, {half_ + 1, under, behind}, travertine);
        stone_.box({-half_, floor_, back_ - 0.02f}, {half_, under, back_}, ochre);
        const int bays = 9;
        for (int bay = 0; bay <= bays; ++bay) {
            const float x = (half_ + 0.6f) * (-1 + 2 * static_cast<float>(bay) / bays);
            stone_.box({x - 0.35f, 0, behind}, {x + 0.35f, under, behind + 0.18f}, marble);
            if (bay == bays) break;
            const float middle = x + (half_ + 0.6f) / bays, sill = floor_ + 0.55f * (top_ - floor_);
            stone_.box({middle - 0.55f, sill, behind}, {middle + 0.55f, sill + 1.7f, behind + 0.03f}, bronze);
        }
    }

    // Tiles that fall away from the stage.
    void roof()
    {
        const float left = -half_ - 1.3f, right = half_ + 1.3f, z0 = back_ - 1.0f, z1 = back_ + 1.9f;
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

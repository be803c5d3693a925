#include "samples/scenes/hundred/spots.h"

#include <cmath>
#include <string>

#include "samples/scenes/random.h"
#include "samples/scenes/scene_crowd.h"

namespace scenes::hundred
{
namespace
{

// Distances from the eye. Between the bands levels change: half of the nodes remain at the middle level, a quarter at
// the far one; actors with parts across the frustum's edge are near and have all nodes. 10 x 40 + 30 x 20 + 20 x 10
// nodes of 60 actors: half of all, as in S0 6.1.
struct Band {
    double first_m, last_m;
};
constexpr Band near_band = {30, 67}, mid_band = {78, 126}, far_band = {146, 215}, any_band = {25, 170};

struct Kind {
    Row row;
    PathKind way;
    uint32_t count;
    Band band;
};
constexpr Kind kinds[] = {
    {Row::c32, PathKind::to_fro, 2, near_band},
    {Row::c31_within, PathKind::to_fro, 5, near_band},
    {Row::c31_outside, PathKind::to_fro, 3, near_band},
    {Row::b, PathKind::round, 18, mid_band},
    {Row::b, PathKind::round, 12, far_band},
    {Row::c2, PathKind::aside, 12, mid_band},
    {Row::c2, PathKind::aside, 8, far_band},
    {Row::c1, PathKind::aside, 20, {50, 190}},
    {Row::a, PathKind::round, 20, any_band},
};

constexpr double lowest_m = 4.5, apart_m = 15.5, near_apart_m = 12.5, slack_m = 0.05;

Point turned(const clq_transform &place, Point p)
{
    const double y = static_cast<double>(place.orientation_xyzw[1]), w = static_cast<double>(place.orientation_xyzw[3]);
    const double c = w * w - y * y, s = 2 * w * y;
    return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}

clq_transform put(Point at, Point facing) { return stand(at.x, at.y, at.z, facing.x, facing.z, 1); }

class Search
{
public:
    Search(const Spheres &spheres, uint64_t seed) : spheres_(spheres), seed_(seed) {}

    std::vector<Spot> run()
    {
        std::vector<Spot> found;
        for (const Kind &kind : kinds)
            for (uint32_t k = 0; k < kind.count; ++k) found.push_back(find(kind, k));
        return found;
    }

private:
    struct Try {
        Spot spot;
        Point middle;  // of the dragon's range of motion
        bool good;
    };

    Spot find(const Kind &kind, uint32_t number)
    {
        constexpr int most = 200000;
        for (int k = 0; k < most; ++k) {
            const Try tried = draw(kind, number);
            ++tries_;
            if (!tried.good || tried.middle.y < lowest_m || !has_room(kind, tried.middle)) continue;
            taken_.push_back(tried.middle);
            return tried.spot;
        }
        throw Failure("hundred_actors found no position for number " + std::to_string(taken_.size()) + " with seed " +
                      std::to_string(seed_));
    }

    bool has_room(const Kind &kind, Point middle) const
    {
        const double apart = kind.way == PathKind::to_fro ? near_apart_m : apart_m;
        for (const Point &other : taken_) {
            const Point d = middle - other;
            if (d.x * d.x + d.y * d.y + d.z * d.z < apart * apart) return false;
        }
        return true;
    }

    double between(double first, double last, Purpose purpose) const
    {
        return random_between(seed_, tries_, purpose, first, last);
    }

    double refpoint(PathKind way) const { return spheres_.refpoint[static_cast<size_t>(way)]; }
    Lies lies(Point at, double radius) const
    {
        const Lies less = pyramid_.test(at, radius - slack_m), more = pyramid_.test(at, radius + slack_m);
        return less == more ? less : Lies::across;  // within rounding of an edge: neither outside nor within
    }
    bool is_in(const Band &band, Point p) const
    {
        const double reach = pyramid_.reach(p);
        return band.first_m <= reach && reach <= band.last_m;
    }

    Try draw(const Kind &kind, uint32_t number) const
    {
        const double side = number % 2 ? -1 : 1;
        switch (kind.row) {
            case Row::a:
                return anywhere(kind);
            case Row::b:
                return ahead(kind);
            case Row::c1:
            case Row::c2:
                return half_way(kind, side);
            default:
                return on_edge(kind, side);
        }
    }

    Try anywhere(const Kind &kind) const
    {
        const double turn = between(0, 6.283185307179586, Purpose::place_x),
                     far = between(kind.band.first_m, kind.band.last_m, Purpose::radius);
        const Point at = {far * std::sin(turn), between(8, 60, Purpose::row), -far * std::cos(turn)};
        return {{kind.row, kind.way, put(at, {-std::cos(turn), 0, -std::sin(turn)})},
                at,
                lies(at, refpoint(kind.way)) == Lies::outside};
    }

    Try ahead(const Kind &kind) const
    {
        const double far = between(kind.band.first_m, kind.band.last_m, Purpose::radius);
        const Point at =
            pyramid_.at(far, between(-0.55, 0.55, Purpose::place_x) * far, between(-0.3, 0.42, Purpose::row) * far);
        const double turn = between(0, 6.283185307179586, Purpose::heading);
        return {{kind.row, kind.way, put(at, {std::sin(turn), 0, std::cos(turn)})},
                at,
                is_in(kind.band, at) && lies(at, refpoint(kind.way)) == Lies::within};
    }

    // The circle of C1 lies outside, that of C2 inside, and the Reference Point between it and the edge or beyond.
    Try half_way(const Kind &kind, double side) const
    {
        const bool outside = kind.row == Row::c1;
        const double far = between(kind.band.first_m, kind.band.last_m, Purpose::radius), reach = refpoint(kind.way);
        const Point at = pyramid_.beside(side, far, between(-reach, reach, Purpose::place_x),
                                         between(-0.35, 0.42, Purpose::row) * far);
        const Point to = pyramid_.right() * (outside ? side : -side);  // the side of the actor's circle, its left
        Spot spot = {kind.row, kind.way, put(at, {-to.z, 0, to.x})};
        const Point middle = at + turned(spot.place, {aside_m, 0, 0});
        const bool good = is_in(kind.band, middle) && lies(at, reach) == Lies::across &&
                          lies(middle, refpoint(PathKind::round)) == (outside ? Lies::outside : Lies::within);
        return {spot, middle, good};
    }

    // It moves along the plane that it crosses, except in C3.2, which enters head first.
    Try on_edge(const Kind &kind, double side) const
    {
        const Point out = pyramid_.normal(side);
        const double far = between(kind.band.first_m - 3, kind.band.last_m, Purpose::radius);
        double from = between(0.95, 0.985, Purpose::place_x) * spheres_.sklsroot;
        if (kind.row == Row::c31_within) from = -from;
        if (kind.row == Row::c32) from = between(-0.1, 0.1, Purpose::place_x) * spheres_.sklsroot;
        const Point centre = pyramid_.beside(side, far, from, between(-0.35, 0.40, Purpose::row) * far);
        Point facing = unit(cross(out, {0, 1, 0}));
        if (facing.z < 0) facing = facing * -1;  // to the camera
        if (kind.row == Row::c32) facing = out * -1;
        Spot spot = {kind.row, kind.way, put(centre, facing)};
        const Point root = centre - turned(spot.place, spheres_.sklsroot_centre);
        spot.place.position[0] = root.x, spot.place.position[1] = root.y, spot.place.position[2] = root.z;
        const bool alone = pyramid_.out_but(side, centre) < -spheres_.sklsroot - to_fro_m;
        return {spot, centre, alone && is_in(kind.band, centre)};
    }

    const Spheres &spheres_;
    uint64_t seed_, tries_ = 0;
    Frustum pyramid_;
    std::vector<Point> taken_;
};

}  // namespace

std::vector<Spot> find_spots(const Spheres &spheres, uint64_t seed) { return Search(spheres, seed).run(); }

}  // namespace scenes::hundred

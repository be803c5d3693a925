#include "samples/scenes/amphitheatre/cavea.h"

#include "samples/scenes/angles.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr Rgb marble = {0.88f, 0.85f, 0.79f}, travertine = {0.96f, 0.90f, 0.79f}, tufa = {0.88f, 0.78f, 0.64f},
              wood = {0.63f, 0.46f, 0.31f}, stair = {0.80f, 0.73f, 0.63f}, dark = {0.20f, 0.16f, 0.13f},
              red_panel = {0.72f, 0.36f, 0.27f}, green_panel = {0.45f, 0.55f, 0.47f}, cornice = {1.0f, 0.97f, 0.90f};
constexpr double seat_step_m = 3.0, wall_step_m = 2.2, undercut_m = 0.05;
constexpr double parapet_m = 0.75, parapet_wide_m = 0.22, door_m = 2.0;

Rgb seats_of(Tier tier)
{
    switch (tier) {
        case Tier::podium:
            return marble;
        case Tier::primum:
            return marble * 0.97f;
        case Tier::imum:
            return travertine;
        case Tier::summum:
            return travertine * 0.94f;
        default:
            return wood;
    }
}

class Cavea
{
public:
    Cavea(Masonry &masonry, const Plan &plan) : m_(masonry), plan_(plan) {}

    void build()
    {
        for (size_t i = 0; i < plan_.rows().size(); ++i) {
            for (const Stretch &stretch : plan_.stretches_of(i)) row(i, stretch);
            for (const double bay : plan_.stairs_of(i)) steps(i, bay);
        }
        for (size_t i = 0; i < plan_.rows().size(); ++i)
            if (plan_.rows()[i].number == tier(i).opening_row)
                for (const double bay : plan_.openings_of(i)) opening(i, bay);
        for (size_t t = 0; t < tier_count; ++t) walkway(t);
    }

private:
    const TierPlan &tier(size_t row) const { return plan_.tiers()[static_cast<size_t>(plan_.rows()[row].tier)]; }

    void row(size_t i, const Stretch &stretch)
    {
        const Row &r = plan_.rows()[i];
        m_.sweep({{r.out_m + undercut_m, r.step_y_m, 0.5},
                  {r.out_m, r.seat_y_m, 0.9},
                  {r.out_m + r.depth_m + undercut_m, r.seat_y_m, 0.66}},
                 stretch.first, stretch.last, seat_step_m, seats_of(r.tier));
    }

    // Two steps a row.
    void steps(size_t i, double bay)
    {
        const Row &r = plan_.rows()[i];
        const double turn = plan_.turn_of(bay), half = tier(i).stairs_m / 2 / plan_.oval().radius(turn, r.out_m);
        const double middle = (r.step_y_m + r.seat_y_m) / 2, front = r.out_m - r.depth_m / 2;
        const Rgb colour = r.tier == Tier::ligneis ? wood * 0.85f : stair;
        m_.sweep({{front, r.step_y_m, 0.6},
                  {front, middle, 0.9},
                  {r.out_m, middle, 0.8},
                  {r.out_m, r.seat_y_m, 0.9},
                  {r.out_m + r.depth_m, r.seat_y_m, 0.8}},
                 turn - half, turn + half, seat_step_m, colour);
        for (const int side : {-1, 1})
            m_.cheek(turn + side * half, front, r.out_m, r.step_y_m, middle, middle, side, colour * 0.9f);
    }

    // An opening (vomitorium) from below: its floor, its parapets, and the dark door at its end.
    void opening(size_t i, double bay)
    {
        const Row &first = plan_.rows()[i], &last = plan_.rows()[i + opening_rows - 1];
        const double turn = plan_.turn_of(bay), from = first.out_m, to = last.out_m + last.depth_m;
        const double half = opening_m / 2 / plan_.oval().radius(turn, from), top = last.seat_y_m + parapet_m;
        const double inner = half - parapet_wide_m / plan_.oval().radius(turn, from);
        m_.sweep({{from - 0.1, first.step_y_m, 0.6}, {to, first.step_y_m, 0.4}}, turn - half, turn + half, seat_step_m,
                 stair * 0.8f);
        for (const int side : {-1, 1}) {
            m_.cheek(turn + side * half, from, to, first.step_y_m, first.seat_y_m + parapet_m, top, side, travertine);
            m_.cheek(turn + side * inner, from, to, first.step_y_m, first.seat_y_m + parapet_m, top, -side,
                     travertine * 0.8f);
            const double low = side < 0 ? turn - half : turn + inner, high = side < 0 ? turn - inner : turn + half;
            m_.sweep({{from, first.step_y_m, 0.8}, {from, first.seat_y_m + parapet_m, 0.9}, {to, top, 1}}, low, high,
                     seat_step_m, travertine);
        }
        // The seats of the row above go on over the door.
        m_.sweep({{to - 0.45, first.step_y_m, 0.5}, {to - 0.45, top, 0.8}, {to - 0.2, top, 1}}, turn - inner,
                 turn + inner, seat_step_m, travertine * 0.95f);
        m_.sweep({{to - 0.2, top, 1}, {to - 0.2 + 1e-3, last.seat_y_m, 0.8}, {to + undercut_m, last.seat_y_m, 0.7}},
                 turn - inner, turn + inner, seat_step_m, travertine * 0.95f);
        m_.recess(turn, 0.72, to - 0.48, first.step_y_m, first.step_y_m + 1.85, dark);
    }

    // The walkway behind a tier, and the wall behind that.
    void walkway(size_t t)
    {
        const Walkway &way = plan_.walkways()[t];
        const Rgb colour = t + 1 == tier_count ? wood * 0.9f : travertine;
        m_.sweep({{way.from_m, way.level_m, 0.95}, {way.to_m, way.level_m, 0.7}}, 0, two_pi, wall_step_m,
                 colour * 0.92f);
        if (t + 1 == tier_count) return;  // the gallery has walls of its own
        const double high = way.wall_top_m - way.level_m, ledge = plan_.tiers()[t + 1].out_m;
        const Rgb face = t == 0 ? marble : tufa * 1.05f;
        m_.sweep({{way.to_m, way.level_m, 0.6}, {way.to_m, way.wall_top_m - 0.22, 0.9}}, 0, two_pi, wall_step_m, face);
        m_.sweep({{way.to_m, way.wall_top_m - 0.22, 0.7},
                  {way.to_m - 0.08, way.wall_top_m - 0.16, 0.9},
                  {way.to_m - 0.08, way.wall_top_m, 1},
                  {ledge + undercut_m, way.wall_top_m, 0.7}},
                 0, two_pi, wall_step_m, t + 2 == tier_count ? wood : cornice);
        if (high < 2.5) return;
        // The high walls are clad in panels of coloured marble, with doors between.
        for (int k = 0; k < bay_count; ++k) {
            const double turn = plan_.turn_of(k + 0.5);
            if (k % 5 == 1) m_.recess(turn, 0.8, way.to_m - 0.03, way.level_m, way.level_m + door_m, dark);
            else
                m_.panel(turn, 1.5, way.to_m - 0.02, way.level_m + 0.5, way.wall_top_m - 0.6,
                         k % 2 == 0 ? red_panel : green_panel);
        }
    }

    Masonry &m_;
    const Plan &plan_;
};

}  // namespace

void build_cavea(Masonry &masonry, const Plan &plan) { Cavea(masonry, plan).build(); }

}  // namespace scenes::amphitheatre

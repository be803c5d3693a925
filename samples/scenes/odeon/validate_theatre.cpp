#include "samples/scenes/odeon/validate_theatre.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/check.h"
#include "samples/scenes/odeon/toml_table.h"

namespace scenes
{
namespace
{

constexpr double slack_m = 1e-6;

class Sense
{
public:
    Sense(const Theatre &theatre, const std::string &where) : theatre_(theatre), where_(where) {}

    void expect() const
    {
        for (size_t i = 0; i < theatre_.walkways.size(); ++i) walkway(i);
        for (size_t i = 0; i < theatre_.rows.size(); ++i) {
            row_before(i);
            step(i);
            stage(i);
            gangways(i);
        }
        classes();
        seats();
    }

private:
    [[noreturn]] void refuse(const std::string &at, const std::string &sentence) const
    {
        throw Failure((at.empty() ? where_ : at) + ": " + sentence);
    }
    static std::string name(size_t row) { return "row " + std::to_string(row + 1); }
    static double end(const SeatRow &row) { return row.radius_m + row.depth_m; }

    void row_before(size_t i) const
    {
        const SeatRow &row = theatre_.rows[i];
        if (i == 0) {
            if (row.radius_m < theatre_.orchestra_radius_m + seat_edge_to_toes_m - slack_m)
                refuse(row.at, "row 1 begins at " + show(row.radius_m) + " m, and feet before it need " +
                                   show(seat_edge_to_toes_m) + " m of stone; the orchestra already ends at " +
                                   show(theatre_.orchestra_radius_m) + " m");
            return;
        }
        const SeatRow &before = theatre_.rows[i - 1];
        if (end(before) > row.radius_m + slack_m)
            refuse(row.at, name(i - 1) + " and " + name(i) + " overlap: " + name(i - 1) + " reaches to " +
                               show(end(before)) + " m and " + name(i) + " begins at " + show(row.radius_m) + " m");
        if (row.seat_y_m < before.seat_y_m)
            refuse(row.at, name(i) + " sits at " + show(row.seat_y_m) + " m, lower than " + name(i - 1) +
                               " before it at " + show(before.seat_y_m) + " m");
    }

    // Feet stand on the previous row if it adjoins, or on a separate step behind a walkway.
    void step(size_t i) const
    {
        if (i == 0) return;
        const SeatRow &row = theatre_.rows[i], &before = theatre_.rows[i - 1];
        if (row.radius_m - end(before) <= slack_m) {
            if (std::abs(row.step_y_m - before.seat_y_m) > 0.005)
                refuse(row.at, name(i) + " has no step: its feet would be at " + show(row.step_y_m) +
                                   " m, and the seats of " + name(i - 1) + " are at " + show(before.seat_y_m) + " m");
            return;
        }
        for (const Walkway &walkway : theatre_.walkways) {
            if (walkway.inner_m < end(before) - slack_m || walkway.inner_m > row.radius_m) continue;
            if (walkway.outer_m > row.radius_m - seat_edge_to_toes_m + slack_m)
                refuse(row.at, name(i) + " begins at " + show(row.radius_m) + " m, and feet before it need " +
                                   show(seat_edge_to_toes_m) + " m of stone; the walkway reaches to " +
                                   show(walkway.outer_m) + " m");
            if (row.step_y_m < walkway.y_m)
                refuse(row.at, name(i) + " has its step at " + show(row.step_y_m) + " m, below its walkway at " +
                                   show(walkway.y_m) + " m");
            return;
        }
        refuse(row.at, "between " + name(i - 1) + " and " + name(i) + " there is no stone at " + show(end(before)) +
                           " to " + show(row.radius_m) + " m: it needs a walkway");
    }

    void stage(size_t i) const
    {
        const SeatRow &row = theatre_.rows[i];
        for (const double angle : {row.first_deg, row.last_deg})
            for (const double radius : {row.radius_m, end(row)}) {
                const double x = radius * std::sin(angle * radians), z = -radius * std::cos(angle * radians);
                if (z > theatre_.stage.front_z_m && std::abs(x) < theatre_.stage.half_width_m)
                    refuse(row.at, name(i) + " at " + show(angle) + " degrees lies on the stage, which begins at z = " +
                                       show(theatre_.stage.front_z_m) + " m");
            }
    }

    void gangways(size_t i) const
    {
        const SeatRow &row = theatre_.rows[i];
        for (size_t g = 0; g < theatre_.gangways.size(); ++g) {
            const Gangway &gangway = theatre_.gangways[g];
            if (i < gangway.first_row || i > gangway.last_row) continue;
            if (gangway.at_deg < row.first_deg || gangway.at_deg > row.last_deg)
                refuse(gangway.at, "gangway " + std::to_string(g + 1) + " at " + show(gangway.at_deg) +
                                       " degrees lies outside " + name(i) + ", which goes from " + show(row.first_deg) +
                                       " to " + show(row.last_deg) + " degrees");
        }
    }

    void walkway(size_t i) const
    {
        const Walkway &walkway = theatre_.walkways[i];
        const std::string named = "walkway " + std::to_string(i + 1);
        if (!(walkway.inner_m < walkway.outer_m))
            refuse(walkway.at, named + " goes from " + show(walkway.inner_m) + " to " + show(walkway.outer_m) + " m");
        for (size_t r = 0; r < theatre_.rows.size(); ++r) {
            const SeatRow &row = theatre_.rows[r];
            if (walkway.inner_m < end(row) - slack_m && walkway.outer_m > row.radius_m + slack_m)
                refuse(walkway.at, named + " from " + show(walkway.inner_m) + " to " + show(walkway.outer_m) +
                                       " m overlaps " + name(r) + " from " + show(row.radius_m) + " to " +
                                       show(end(row)) + " m");
        }
    }

    void seats() const
    {
        std::vector<uint32_t> of_row(theatre_.rows.size(), 0);
        for (const Seat &seat : seats_of(theatre_)) ++of_row[seat.row];
        for (size_t i = 0; i < of_row.size(); ++i)
            if (of_row[i] == 0)
                refuse(theatre_.rows[i].at, "the gangways leave no seats of " + show(theatre_.seat_width_m) + " m in " +
                                                name(i) + " from " + show(theatre_.rows[i].first_deg) + " to " +
                                                show(theatre_.rows[i].last_deg) + " degrees at a radius of " +
                                                show(theatre_.rows[i].radius_m) + " m");
        for (const SocialClass &one : theatre_.classes) {
            uint32_t room = 0;
            std::string rows;
            for (size_t i = 0; i < of_row.size(); ++i) {
                if (theatre_.rows[i].social_class != one.name) continue;
                room += of_row[i];
                rows += (rows.empty() ? "" : ", ") + std::to_string(i + 1);
            }
            if (one.count > room)
                refuse(one.at, std::to_string(one.count) + " " + one.name + " find " + std::to_string(room) + " seats" +
                                   (rows.empty() ? ": no row is theirs" : " in their rows " + rows));
        }
    }

    void classes() const
    {
        for (size_t i = 0; i < theatre_.rows.size(); ++i) {
            const std::string &wanted = theatre_.rows[i].social_class;
            const auto named = [&](const SocialClass &one) { return one.name == wanted; };
            if (!wanted.empty() && std::none_of(theatre_.classes.begin(), theatre_.classes.end(), named))
                refuse(theatre_.rows[i].at,
                       name(i) + " is for '" + wanted + "', which is no class of its [[characters]]");
        }
    }

    const Theatre &theatre_;
    const std::string &where_;
};

}  // namespace

void validate(const Theatre &theatre, const std::string &where) { Sense(theatre, where).expect(); }

}  // namespace scenes

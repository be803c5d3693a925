#include "lib/asset/trajectories/assemble.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;
using base::text_of;

namespace
{

bool in_order(const Row &a, const Row &b)
{
    if (a.person != b.person) return a.person < b.person;
    if (a.time != b.time) return a.time < b.time;
    return a.line < b.line;
}

// Rows that come after a later row of the same person.
Tally out_of_order(const std::vector<Row> &rows, uint32_t people, Budget &budget)
{
    budget.charge(uint64_t(people) * sizeof(double), "the order of rows");
    std::vector<double> latest(people, -HUGE_VAL);
    Tally found;
    for (const Row &row : rows) {
        if (row.time < latest[row.person]) found.add(row.line);
        else latest[row.person] = row.time;
    }
    return found;
}

bool same_place(const Row &a, const Row &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

struct Repeats {
    Tally equal, at_odds;
    uint32_t equal_person = 0, odd_person = 0;
};

// Keeps the first of several rows of a person at one time.
Repeats drop_repeats(std::vector<Row> &rows)
{
    Repeats found;
    size_t kept = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const Row &row = rows[i];
        if (kept == 0 || rows[kept - 1].person != row.person || rows[kept - 1].time != row.time) {
            rows[kept++] = row;
            continue;
        }
        const bool equal = same_place(rows[kept - 1], row);
        Tally &tally = equal ? found.equal : found.at_odds;
        if (tally.count == 0) (equal ? found.equal_person : found.odd_person) = row.person;
        tally.add(row.line);
    }
    rows.resize(kept);
    return found;
}

// The smallest difference of frame numbers that follow each other for a person; 0 without any.
double smallest_difference(const std::vector<Row> &rows)
{
    double smallest = 0;
    for (size_t i = 1; i < rows.size(); ++i) {
        const double step = rows[i].time - rows[i - 1].time;
        if (rows[i].person == rows[i - 1].person && step > 0 && (smallest == 0 || step < smallest)) smallest = step;
    }
    return smallest;
}

// Frame numbers in a second; 1 for times in seconds; 0: not known.
double rate_of(const Reading &reading, const TrajectoryOptions &options)
{
    if (!reading.frames) return 1;
    if (options.rate_hz > 0) return options.rate_hz;
    if (reading.rate_hz > 0) return reading.rate_hz;
    return reading.smallest_step_s > 0 ? smallest_difference(reading.rows.all) / reading.smallest_step_s : 0;
}

void demand(const Reading &reading, const TrajectoryOptions &options, double rate, double unit)
{
    std::string lacks, wants;
    const auto add = [&](const char *what, const char *option) {
        lacks += std::string(lacks.empty() ? "" : " and ") + what;
        wants += std::string(wants.empty() ? "" : " and ") + option;
    };
    if (rate == 0) add("the rate of its frames", "--rate (rate_hz)");
    if (unit == 0) add("the unit of its coordinates", "--unit (metres_per_unit)");
    if (reading.asks_up && options.up == CLQ_UP_OF_FILE) add("which axis is up", "--up (up)");
    if (!lacks.empty()) fail(CLQ_ARGUMENT, "the file does not say %s: give %s", lacks.c_str(), wants.c_str());
}

}  // namespace

std::string counted(uint64_t count, const char *one, const char *many)
{
    return text_of("%llu %s", base::big(count), count == 1 ? one : many);
}

std::string first_of(const Reading &reading, uint32_t line)
{
    return text_of("; the first is %s %u", reading.place, line);
}

void report_left_out(Reading &reading)
{
    const Rows &rows = reading.rows;
    if (rows.missing.count)
        reading.warnings.push_back("left out " + counted(rows.missing.count, "row", "rows") + " that lack a value" +
                                   first_of(reading, rows.missing.line));
    if (rows.impossible.count)
        reading.warnings.push_back("left out " + counted(rows.impossible.count, "row", "rows") +
                                   " with a number that is not finite or beyond 1e9" +
                                   first_of(reading, rows.impossible.line));
}

void put_in_order(Reading &reading)
{
    Rows &rows = reading.rows;
    const Tally late = out_of_order(rows.all, rows.ids.count(), reading.budget);
    if (late.count && !reading.joined)
        reading.warnings.push_back("put in order " + counted(late.count, "row", "rows") +
                                   " that came after a later row of the same person" + first_of(reading, late.line));
    if (!std::is_sorted(rows.all.begin(), rows.all.end(), in_order))
        std::sort(rows.all.begin(), rows.all.end(), in_order);
}

void convert(Reading &reading, const TrajectoryOptions &options)
{
    const double rate = rate_of(reading, options);
    const double unit = options.metres_per_unit > 0 ? options.metres_per_unit : reading.unit_m;
    demand(reading, options, rate, unit);
    const bool y_up = options.up == CLQ_UP_Y;
    for (Row &row : reading.rows.all) {
        row.time /= rate;
        row.x *= unit, row.y *= unit, row.z *= unit;
        if (!y_up) continue;
        const double up = row.y;
        row.y = -row.z, row.z = up;
    }
}

void keep_first_of_repeats(Reading &reading)
{
    Rows &rows = reading.rows;
    const Repeats repeats = drop_repeats(rows.all);
    if (repeats.equal.count && !reading.joined)
        reading.warnings.push_back("left out " + counted(repeats.equal.count, "row", "rows") +
                                   " with time and place of another row of the same person" +
                                   first_of(reading, repeats.equal.line) + ", person " +
                                   rows.ids.shown(repeats.equal_person));
    if (repeats.at_odds.count)
        reading.warnings.push_back("left out " + counted(repeats.at_odds.count, "row", "rows") +
                                   " that put a person at a second place at one time" +
                                   first_of(reading, repeats.at_odds.line) + ", person " +
                                   rows.ids.shown(repeats.odd_person));
}

Trajectories assemble(Reading &reading, const TrajectoryOptions &options, clq_trajectory_format format)
{
    Rows &rows = reading.rows;
    rows.ids.close();
    report_left_out(reading);
    if (rows.all.empty())
        fail(CLQ_FORMAT, "the file has no positions of people, in %s", counted(rows.read, "row", "rows").c_str());
    put_in_order(reading);
    convert(reading, options);
    keep_first_of_repeats(reading);
    const uint32_t ids = rows.ids.count();
    Trajectories out(std::move(rows.ids));
    split_into_people(reading, options, out);
    out.warnings = std::move(reading.warnings);
    out.facts.format = format;
    out.facts.id_count = ids;
    out.facts.row_count = rows.read;
    describe(out);
    return out;
}

}  // namespace claque::asset

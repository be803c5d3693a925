// JuPedSim's SQLite files, versions 1 to 3. Columns are found by name: their order differs between writers.
#include <cmath>

#include "lib/asset/trajectories/database.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/base/error.h"
#include "lib/math/trig.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr double latest_version = 3;

// A value of the table of keys and values.
double metadata(Database &database, const char *key)
{
    Query query(database, "SELECT value FROM metadata WHERE key = ?1");
    query.bind(1, key);
    if (!query.next()) fail(CLQ_FORMAT, "the database has no %s in metadata", key);
    double value = 0;
    if (!read_number(trimmed(query.text(0)), value) || !std::isfinite(value))
        fail(CLQ_FORMAT, "metadata has the %s %s instead of a number", key, in_quotes(query.text(0)).c_str());
    return value;
}

double checked_rate(Database &database)
{
    for (const char *table : {"metadata", "trajectory_data"})
        if (!database.has_table(table)) fail(CLQ_FORMAT, "the database has no table %s: it is not of JuPedSim", table);
    const double version = metadata(database, "version");
    if (version < 1 || version > latest_version)
        fail(CLQ_UNSUPPORTED, "the database has version %g of JuPedSim's format: 1 to %g are read", version,
             latest_version);
    const double fps = metadata(database, "fps");
    if (!(fps > 0 && fps <= 1e6))
        fail(CLQ_FORMAT, "metadata has the fps %g: more than 0 and at most 1e6 is wanted", fps);
    return fps;
}

void add_row(Query &query, bool oriented, uint32_t line, Reading &reading)
{
    Rows &rows = reading.rows;
    ++rows.read;
    for (int column = 0; column < 4; ++column)
        if (!query.is_number(column)) return rows.missing.add(line);
    Row row;
    row.line = line;
    row.time = query.number(0);
    char digits[24];
    std::snprintf(digits, sizeof digits, "%lld", static_cast<long long>(query.whole(1)));
    row.person = rows.ids.number_of(digits);
    row.x = query.number(2), row.y = query.number(3);
    row.heading_rad = NAN;
    if (oriented) {
        // (0, 0) before the first step.
        const double x = query.number(4), y = query.number(5);
        if ((x != 0 || y != 0) && std::isfinite(x + y)) row.heading_rad = static_cast<float>(math::atan2(y, x));
    }
    rows.add(row);
}

}  // namespace

void read_jupedsim(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    Database database(input.bytes, input.size);
    reading.rate_hz = checked_rate(database);
    reading.frames = true;
    reading.place = "row";
    const bool oriented =
        database.has_column("trajectory_data", "ori_x") && database.has_column("trajectory_data", "ori_y");
    Query query(database, oriented ? "SELECT frame, id, pos_x, pos_y, ori_x, ori_y FROM trajectory_data"
                                   : "SELECT frame, id, pos_x, pos_y FROM trajectory_data");
    for (uint32_t line = 1; query.next(); ++line) add_row(query, oriented, line, reading);
}

}  // namespace claque::asset

#include "samples/cli/position_files.h"

#include <algorithm>
#include <cmath>
#include <memory>
#ifdef CLAQUE_HAS_SQLITE3
#include <sqlite3.h>
#endif

#include "samples/io/ending.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

using scenes::Failure;
using scenes::walkers::RecordPosition;
using scenes::walkers::RecordPositions;

void add_row(std::string &out, const RecordPosition &row, char between)
{
    char text[96];
    std::snprintf(text, sizeof text, "%u%c%d%c%.4f%c%.4f\n", row.person, between, row.frame, between, row.x, between,
                  row.y);
    out += text;
}

std::string csv_of(const RecordPositions &positions)
{
    std::string out = "id,frame,x,y\n";
    for (const RecordPosition &row : positions.rows) add_row(out, row, ',');
    return out;
}

std::string text_of(const RecordPositions &positions)
{
    char rate[64];
    std::snprintf(rate, sizeof rate, "#framerate: %.15g\n", positions.rate_hz);
    std::string out = std::string(rate) + "#ID\tframe\tx/m\ty/m\n";
    for (const RecordPosition &row : positions.rows) add_row(out, row, '\t');
    return out;
}

#ifdef CLAQUE_HAS_SQLITE3

class Writer
{
public:
    Writer()
    {
        sqlite3 *made = nullptr;
        const int code = sqlite3_open(":memory:", &made);
        database_.reset(made);
        check(code);
    }

    void run(const std::string &sql) { check(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr)); }

    void add_positions(const RecordPositions &positions)
    {
        sqlite3_stmt *made = nullptr;
        check(sqlite3_prepare_v2(database_.get(), "INSERT INTO trajectory_data VALUES(?1, ?2, ?3, ?4, 0, 0)", -1, &made,
                                 nullptr));
        const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> insert(made, sqlite3_finalize);
        for (const RecordPosition &row : positions.rows) {
            check(sqlite3_bind_int(made, 1, row.frame));
            check(sqlite3_bind_int64(made, 2, row.person));
            check(sqlite3_bind_double(made, 3, row.x));
            check(sqlite3_bind_double(made, 4, row.y));
            check(sqlite3_step(made) == SQLITE_DONE ? SQLITE_OK : sqlite3_errcode(database_.get()));
            check(sqlite3_reset(made));
        }
    }

    std::string bytes()
    {
        sqlite3_int64 size = 0;
        const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> made(
            sqlite3_serialize(database_.get(), "main", &size, 0), sqlite3_free);
        if (!made) throw std::bad_alloc();
        return std::string(reinterpret_cast<const char *>(made.get()), static_cast<size_t>(size));
    }

private:
    void check(int code)
    {
        if (code != SQLITE_OK) throw Failure(std::string("SQLite could not write: ") + sqlite3_errstr(code));
    }
    std::unique_ptr<sqlite3, decltype(&sqlite3_close)> database_{nullptr, sqlite3_close};
};

struct Box {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
};

Box box_of(const RecordPositions &positions)
{
    Box box;
    for (const RecordPosition &row : positions.rows) {
        box.low[0] = std::min(box.low[0], row.x), box.high[0] = std::max(box.high[0], row.x);
        box.low[1] = std::min(box.low[1], row.y), box.high[1] = std::max(box.high[1], row.y);
    }
    if (positions.rows.empty()) box = {{0, 0}, {0, 0}};
    return box;
}

std::string formatted(const char *format, ...) __attribute__((format(printf, 1, 2)));
std::string formatted(const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

// The tables of JuPedSim's files, version 2. Records have no area: it is the box of the positions, as PedPy writes it
// for trajectories without one. An orientation of 0, 0 is none.
std::string database_of(const RecordPositions &positions)
{
    const Box box = box_of(positions);
    const double a = box.low[0], b = box.low[1], c = box.high[0], d = box.high[1];
    Writer writer;
    writer.run(
        "BEGIN;"
        "CREATE TABLE trajectory_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL,"
        " pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL);"
        "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);"
        "CREATE TABLE geometry(hash INTEGER NOT NULL, wkt TEXT NOT NULL);"
        "CREATE UNIQUE INDEX geometry_hash ON geometry(hash);"
        "CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);");
    writer.run(
        formatted("INSERT INTO metadata VALUES('version', '2'), ('fps', '%.15g'), ('xmin', '%.6f'),"
                  " ('xmax', '%.6f'), ('ymin', '%.6f'), ('ymax', '%.6f');",
                  positions.rate_hz, a, c, b, d));
    writer.run(
        formatted("INSERT INTO geometry VALUES(1, 'POLYGON ((%.6f %.6f, %.6f %.6f, %.6f %.6f, %.6f %.6f,"
                  " %.6f %.6f))');",
                  a, b, c, b, c, d, a, d, a, b));
    writer.add_positions(positions);
    writer.run(
        "INSERT INTO frame_data SELECT DISTINCT frame, 1 FROM trajectory_data ORDER BY frame;"
        "CREATE INDEX frame_id_idx ON trajectory_data(frame, id);"
        "COMMIT;");
    return writer.bytes();
}

#else

std::string database_of(const RecordPositions &)
{
    throw Failure("files of JuPedSim (.sqlite) need libsqlite3, which this build has not: .csv and .txt do without");
}

#endif

}  // namespace

std::string check_position_file(const std::string &name)
{
    const std::string ending = io::ending_of(name);
    if (ending == ".csv" || ending == ".txt" || ending == ".sqlite") return "";
    return name + " ends in none of .csv, .txt and .sqlite";
}

std::string position_file(const std::string &name, const RecordPositions &positions)
{
    const std::string ending = io::ending_of(name);
    if (ending == ".csv") return csv_of(positions);
    return ending == ".txt" ? text_of(positions) : database_of(positions);
}

scenes::walkers::OwnTrajectories trajectories_of(scenes::Library &library, const RecordPositions &positions,
                                                 const std::string &name, double max_speed_m_s)
{
    if (positions.rows.empty()) throw Failure(name + ": nobody is in this record");
    const std::string text = text_of(positions);
    clq_trajectories_def def = clq_trajectories_def_init();
    def.max_speed_m_s = max_speed_m_s;
    clq_trajectories *made = nullptr;
    scenes::check(clq_trajectories_load_memory(library.context(), text.data(), text.size(), name.c_str(), &def, &made));
    return scenes::walkers::OwnTrajectories(made);
}

}  // namespace cli

// Tables whose header names the columns: Pathfinder, crowd:it, Viswalk.
#include "lib/asset/trajectories/columns.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

struct Names {
    const char *id, *time, *x, *y;
    const char *z = nullptr, *heading = nullptr;  // may be missing in the file
};

Columns columns_of(const Fields &header, const Names &names, uint32_t line, char separator)
{
    Columns columns;
    columns.separator = separator;
    const auto find = [&](const char *name) {
        const int column = header.find(name);
        if (column < 0) fail(CLQ_FORMAT, "line %u names no column %s", line, name);
        return column;
    };
    columns.id = find(names.id), columns.time = find(names.time), columns.x = find(names.x), columns.y = find(names.y);
    if (names.z) columns.z = header.find(names.z);
    if (names.heading) columns.heading = header.find(names.heading);
    return columns;
}

void read_with_header(const TrajectoryInput &input, const Names &names, Reading &reading)
{
    Lines lines(input.text());
    std::string_view line;
    do {
        if (!lines.next(line)) fail(CLQ_FORMAT, "the file is empty");
    } while (trimmed(line).empty() || trimmed(line)[0] == '#');
    Fields header;
    header.split(line, separator_of(line));
    read_columns(lines, columns_of(header, names, lines.number(), separator_of(line)), reading);
}

}  // namespace

void read_pathfinder_csv(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    read_with_header(input, {"id", "t", "x", "y", "z"}, reading);
}

void read_crowdit(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    read_with_header(input, {"pedID", "time", "posX", "posY"}, reading);
}

void read_viswalk(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    constexpr std::string_view section = "$PEDESTRIAN:";
    Lines lines(input.text());
    for (std::string_view line; lines.next(line);) {
        if (!starts_with(line, section)) continue;
        Fields header;
        header.split(line.substr(section.size()), ';');
        const Names names{"NO", "SIMSEC", "COORDCENTX", "COORDCENTY", nullptr, "ORIENTATIONANGLE"};
        return read_columns(lines, columns_of(header, names, lines.number(), ';'), reading);
    }
    fail(CLQ_FORMAT, "no line begins with $PEDESTRIAN:");
}

}  // namespace claque::asset

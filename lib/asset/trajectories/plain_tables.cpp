// Tables of numbers without names: PeTrack and the archive, JPSreport, obsmat, and any by the caller's columns.
#include <algorithm>
#include <cmath>

#include "lib/asset/trajectories/columns.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

// A step of ETH's and UCY's files, whatever number of frames of the film it has.
constexpr double obsmat_step_s = 0.4;

// What a comment line says stands in its first bytes.
constexpr size_t longest_comment = 4096;

// Looks for rate and unit in the comment lines at the file's beginning.
void read_header(Lines &lines, Reading &reading)
{
    for (std::string_view line; lines.next(line);) {
        line = trimmed(line);
        if (!line.empty() && line[0] != '#') return lines.back();
        const std::string text = lower_case(line.substr(0, longest_comment));
        if (contains(text, "x/cm") || contains(text, "in cm")) reading.unit_m = 0.01;
        else if (contains(text, "x/m") || contains(text, "in m")) reading.unit_m = 1;
        const size_t word = text.find("framerate");
        if (word == std::string::npos || reading.rate_hz > 0) continue;
        const size_t begin = text.find_first_of("0123456789.", word);
        if (begin == std::string::npos) continue;
        const size_t end = text.find_first_not_of("0123456789.e+-", begin);
        double rate = 0;
        if (!read_number(std::string_view(text).substr(begin, end - begin), rate) || !(rate > 0 && rate <= 1e6))
            fail(CLQ_FORMAT, "line %u has no rate between 0 and 1e6: %s", lines.number(), in_quotes(text).c_str());
        reading.rate_hz = rate;
    }
}

Columns archive_columns(Lines &lines)
{
    Columns columns;
    columns.id = 0, columns.frame = 1, columns.x = 2, columns.y = 3;
    std::string_view line;
    if (!lines.next(line)) return columns;
    lines.back();
    columns.separator = separator_of(line);
    Fields fields;
    fields.split(trimmed(line), columns.separator);
    if (fields.count() > 4) columns.z = 4;
    return columns;
}

void read_archive(const TrajectoryInput &input, double unit_m, Reading &reading)
{
    Lines lines(input.text());
    reading.unit_m = unit_m;
    read_header(lines, reading);
    const Columns columns = archive_columns(lines);
    reading.heights = columns.z >= 0;
    read_columns(lines, columns, reading);
}

Columns named_by_caller(const std::string &text)
{
    Columns columns;
    Fields names;
    names.split(text, ',');
    const std::pair<const char *, int *> known[] = {
        {"id", &columns.id}, {"frame", &columns.frame}, {"time", &columns.time},      {"x", &columns.x},
        {"y", &columns.y},   {"z", &columns.z},         {"heading", &columns.heading}};
    for (int i = 0; i < static_cast<int>(names.count()); ++i) {
        bool is_known = names[i] == "-";
        for (const auto &[name, place] : known) {
            if (names[i] != name) continue;
            if (*place >= 0) fail(CLQ_ARGUMENT, "--columns (columns) names %s twice: '%.200s'", name, text.c_str());
            *place = i;
            is_known = true;
        }
        if (!is_known)
            fail(
                CLQ_ARGUMENT,
                "--columns (columns) has an unknown name %s: id, frame, time, x, y, z and heading are known, - skips a "
                "column",
                in_quotes(names[i]).c_str());
    }
    if (!columns.complete() || (columns.frame >= 0 && columns.time >= 0))
        fail(CLQ_ARGUMENT, "--columns (columns) has to name id, x, y, and frame or time: '%.200s'", text.c_str());
    return columns;
}

}  // namespace

void read_petrack(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    read_archive(input, 0, reading);
}

void read_jpsreport(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    read_archive(input, 1, reading);
}

void read_obsmat(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    Columns columns;
    columns.frame = 0, columns.id = 1, columns.x = 2, columns.y = 4;
    Lines lines(input.text());
    reading.smallest_step_s = obsmat_step_s;
    read_columns(lines, columns, reading);
}

void read_table(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading)
{
    if (options.columns.empty())
        fail(CLQ_ARGUMENT, "a table is read by its columns: give --columns id,frame,x,y (columns)");
    Columns columns = named_by_caller(options.columns);
    Lines lines(input.text());
    reading.unit_m = 0;
    reading.asks_up = columns.z >= 0;
    read_header(lines, reading);
    // The first row of numbers, as a header may be separated otherwise.
    for (std::string_view line; lines.next(line);) {
        if (line.find_first_of("0123456789") == std::string_view::npos) continue;
        columns.separator = separator_of(line);
        if (line.find_first_of("0123456789") == line.find_first_not_of(" \t\"-+.")) break;
    }
    Lines again(input.text());
    read_columns(again, columns, reading);
}

}  // namespace claque::asset

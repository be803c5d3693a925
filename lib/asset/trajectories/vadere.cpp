// Vadere .traj: a row is a foot step, from one place and time to another.
#include <cmath>

#include "lib/asset/trajectories/columns.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr const char *vadere_names[] = {"pedestrianId", "simTime", "endTime", "startX", "startY", "endX", "endY"};
enum VadereColumn { vadere_id, step_begin, step_end, start_x, start_y, end_x, end_y, vadere_columns };

// Columns carry the number of the processor that wrote them: startX-PID1.
int column_before_dash(const Fields &header, std::string_view name)
{
    for (int i = 0; i < static_cast<int>(header.count()); ++i)
        if (header[i].substr(0, header[i].find('-')) == name) return i;
    fail(CLQ_FORMAT, "the file has no column %s: it is older than Vadere 2, or was written without foot steps",
         std::string(name).c_str());
}

class StepReader
{
public:
    StepReader(Lines &lines, Reading &reading) : lines_(lines), reading_(reading) {}

    void read()
    {
        bool named = false;
        for (std::string_view line; lines_.next(line);) {
            const std::string_view text = trimmed(line);
            if (text.empty() || text[0] == '#') continue;
            fields_.split(text, blanks);
            if (named) read_row();
            else {
                for (int i = 0; i < vadere_columns; ++i) columns_[i] = column_before_dash(fields_, vadere_names[i]);
                named = true;
            }
        }
    }

private:
    void read_row()
    {
        Rows &rows = reading_.rows;
        ++rows.read;
        double numbers[vadere_columns] = {};
        for (int i = step_begin; i < vadere_columns; ++i) {
            const std::string_view text = fields_[columns_[i]];
            if (read_number(text, numbers[i])) continue;
            if (lines_.unfinished()) return rows.missing.add(lines_.number());
            fail(CLQ_FORMAT, "line %u, %s: %s instead of a number", lines_.number(), vadere_names[i],
                 in_quotes(text).c_str());
        }
        if (numbers[step_end] < numbers[step_begin])
            fail(CLQ_FORMAT, "line %u: the step ends at %g s, before it begins at %g s", lines_.number(),
                 numbers[step_end], numbers[step_begin]);
        Row row;
        row.line = lines_.number();
        row.heading_rad = NAN;
        row.person = rows.ids.number_of(fields_[columns_[vadere_id]]);
        row.time = numbers[step_begin], row.x = numbers[start_x], row.y = numbers[start_y];
        rows.add(row);
        row.time = numbers[step_end], row.x = numbers[end_x], row.y = numbers[end_y];
        rows.add(row);
    }

    Lines &lines_;
    Reading &reading_;
    Fields fields_;
    int columns_[vadere_columns] = {};
};

}  // namespace

void read_vadere(const TrajectoryInput &input, const TrajectoryOptions &, Reading &reading)
{
    Lines lines(input.text());
    reading.joined = true;
    StepReader(lines, reading).read();
}

}  // namespace claque::asset

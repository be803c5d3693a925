#include "lib/asset/trajectories/columns.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

class ColumnReader
{
public:
    ColumnReader(Lines &lines, const Columns &columns, Reading &reading)
        : lines_(lines), columns_(columns), reading_(reading), wanted_(static_cast<size_t>(columns.last()) + 1)
    {
        reading.frames = columns.time < 0;
    }

    void read()
    {
        for (std::string_view line; lines_.next(line);) {
            const std::string_view text = trimmed(line);
            if (!text.empty() && text[0] != '#') read_row(text);
        }
    }

private:
    void read_row(std::string_view line)
    {
        Rows &rows = reading_.rows;
        fields_.split(line, columns_.separator);
        if (fields_.count() < wanted_ && !lines_.unfinished())
            fail(CLQ_FORMAT, "line %u has %zu columns: %zu are wanted", lines_.number(), fields_.count(), wanted_);
        if (is_units()) return;
        ++rows.read;
        Row row;
        row.line = lines_.number();
        const bool frames = columns_.time < 0;
        double heading = NAN;
        if (fields_[columns_.id].empty() || !number(frames ? columns_.frame : columns_.time, row.time) ||
            !number(columns_.x, row.x) || !number(columns_.y, row.y) || (columns_.z >= 0 && !number(columns_.z, row.z)))
            return rows.missing.add(row.line);
        if (columns_.heading >= 0) (void)number(columns_.heading, heading);
        row.heading_rad = heading_of_degrees(heading);
        row.person = rows.ids.number_of(plain_id(fields_[columns_.id], buffer_));
        rows.add(row);
    }

    // False: the field is empty, or of a line that was cut off.
    bool number(int column, double &out) const
    {
        const std::string_view text = fields_[column];
        if (text.empty()) return false;
        if (read_number(text, out)) return true;
        if (lines_.unfinished()) return false;
        fail(CLQ_FORMAT, "line %u, column %d: %s instead of a number", lines_.number(), column + 1,
             in_quotes(text).c_str());
    }

    // A second line of units, as Pathfinder writes, or a header that no column needs: no column is a number.
    bool is_units()
    {
        if (seen_) return false;
        seen_ = true;
        double number = 0;
        for (const int column : {columns_.time, columns_.frame, columns_.x, columns_.y})
            if (column >= 0 && read_number(fields_[column], number)) return false;
        return true;
    }

    Lines &lines_;
    const Columns &columns_;
    Reading &reading_;
    size_t wanted_;
    Fields fields_;
    char buffer_[32];
    bool seen_ = false;
};

}  // namespace

int Columns::last() const { return std::max({id, frame, time, x, y, z, heading}); }

void read_columns(Lines &lines, const Columns &columns, Reading &reading)
{
    ColumnReader(lines, columns, reading).read();
}

}  // namespace claque::asset

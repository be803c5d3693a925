// Reads rows of columns whose places are known. Most text formats are this and a header.
#pragma once

#include "lib/asset/trajectories/text.h"
#include "lib/asset/trajectories/trajectories.h"

namespace claque::asset
{

// Places of columns from 0; -1: there is none.
struct Columns {
    int id = -1, frame = -1, time = -1, x = -1, y = -1, z = -1, heading = -1;
    char separator = blanks;
    int last() const;
    bool complete() const { return id >= 0 && x >= 0 && y >= 0 && (frame >= 0 || time >= 0); }
};

// Adds all further lines to the rows; passes over empty lines and lines that begin with #. A last line without line end
// that is too short was cut off, and counts as lacking a value, as a row with an empty field does. Throws base::Error
// (CLQ_FORMAT): a line that has too few columns, or a text where a number is wanted.
void read_columns(Lines &lines, const Columns &columns, Reading &reading);

}  // namespace claque::asset

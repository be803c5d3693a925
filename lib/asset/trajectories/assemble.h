// The steps from rows to people.
#pragma once

#include "lib/asset/trajectories/trajectories.h"

namespace claque::asset
{

// "1 row", "17 rows".
std::string counted(uint64_t count, const char *one, const char *many);
// "; the first is line 312"
std::string first_of(const Reading &reading, uint32_t line);

// Warns of rows that the reader left out.
void report_left_out(Reading &reading);
// Sorts rows by person, time and line.
void put_in_order(Reading &reading);
// From units of the file to seconds and metres, z up. Throws base::Error (CLQ_ARGUMENT) if rate, unit or axis are not
// known.
void convert(Reading &reading, const TrajectoryOptions &options);
// Leaves out all but the first of several rows of a person at one time.
void keep_first_of_repeats(Reading &reading);
// The middle of the times between neighbouring samples of a person; 0 if no person has two.
double usual_step_s(const std::vector<Row> &rows);
// Makes people and samples from rows in order.
void split_into_people(Reading &reading, const TrajectoryOptions &options, Trajectories &out);
// Fills in facts that follow from people and samples.
void describe(Trajectories &out);

}  // namespace claque::asset

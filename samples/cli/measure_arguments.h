// The options of `claque tracks` that measure.
#pragma once

#include <CLI/CLI.hpp>

#include "samples/cli/measures.h"
#include "samples/scenes/library.h"

namespace cli
{

struct MeasureArguments {
    std::vector<std::string> files;  // .csv or -: a row for each step; .svg or .png: N-t
    std::string line, area;
};

void add_measure_options(CLI::App &command, MeasureArguments &arguments);
// Early, as the rest takes time. `others`: files that the command writes besides. Throws CLI::ValidationError and
// scenes::Failure.
void check_measures(const MeasureArguments &arguments, std::initializer_list<std::string> others);
bool measures_any(const MeasureArguments &arguments);
bool is_printed(const MeasureArguments &arguments);  // on standard output
// Writes the files. `name` is that of the trajectories.
Measures write_measures(scenes::Library &library, const MeasureArguments &arguments,
                        const clq_trajectories *trajectories, const std::string &name);

}  // namespace cli

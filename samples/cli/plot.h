// The command's charts: their sources and their output files.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "samples/charts/bars.h"

namespace cli
{

// The chart of a `claque bench SCENE --json` report along a camera path; `name` names the report in error messages.
// Throws scenes::Failure.
charts::BarChart path_chart_of(const std::string &json, const std::string &name);

// Accepts names that tell the format: .png, .svg, or none, as for -, which is SVG.
extern const CLI::Validator chart_file;
// Writes PNG or SVG by that rule; the file is complete or absent. Throws scenes::Failure.
void write_chart(const std::string &path, const charts::Drawing &drawing);

}  // namespace cli

// Charts of the command: what may be drawn, and files that come out of it.
#pragma once

#include "samples/charts/bars.h"

#include <CLI/CLI.hpp>

#include <string>

namespace cli
{

// A report of `claque bench SCENE --json` along a camera path; `name` is what refusals call it. Throws scenes::Failure.
charts::BarChart path_chart_of(const std::string &json, const std::string &name);

// Passes names that say which format is meant: .png, .svg, or none, as for -, which is SVG.
extern const CLI::Validator chart_file;
// As PNG or SVG by that rule; there in whole or not at all. Throws scenes::Failure.
void write_chart(const std::string &path, const charts::Drawing &drawing);

}  // namespace cli

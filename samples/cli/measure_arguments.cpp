#include "samples/cli/measure_arguments.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>

#include "samples/cli/files.h"
#include "samples/cli/plot.h"
#include "samples/io/ending.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

using scenes::check;

bool is_table(const std::string &file) { return file == "-" || io::ending_of(file) == ".csv"; }

std::string check_file(const std::string &file)
{
    const std::string ending = io::ending_of(file);
    return is_table(file) || ending == ".svg" || ending == ".png" ? "" : file + " ends in none of .csv, .svg and .png";
}

// Four numbers with commas, or none.
std::optional<std::array<double, 4>> four_numbers(const std::string &text)
{
    std::array<double, 4> out = {};
    std::istringstream in(text);
    for (size_t i = 0; i < out.size(); ++i) {
        char comma = 0;
        if (i > 0 && !(in >> comma && comma == ',')) return {};
        if (!(in >> out[i]) || !std::isfinite(out[i])) return {};
    }
    char more = 0;
    return in >> more ? std::nullopt : std::make_optional(out);
}

MeasurementLine line_of(const std::string &text)
{
    const auto n = four_numbers(text);
    if (!n)
        throw CLI::ValidationError("--line", "'" + text + "' is no line: x0,y0,x1,y1 in metres of the file are wanted");
    if ((*n)[0] == (*n)[2] && (*n)[1] == (*n)[3]) throw CLI::ValidationError("--line", "'" + text + "' has no length");
    return {{(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}};
}

// The rectangle between two corners.
std::optional<MeasurementArea> rectangle_of(const std::string &text)
{
    const auto n = four_numbers(text);
    if (!n && text.find_first_not_of("0123456789+-.,eE ") == std::string::npos)
        throw CLI::ValidationError("--area", "'" + text + "' is no rectangle: x0,y0,x1,y1 in metres are wanted");
    if (!n) return {};
    const double a = std::min((*n)[0], (*n)[2]), b = std::min((*n)[1], (*n)[3]), c = std::max((*n)[0], (*n)[2]),
                 d = std::max((*n)[1], (*n)[3]);
    if (!(a < c && b < d)) throw CLI::ValidationError("--area", "'" + text + "' has no size");
    return MeasurementArea{(c - a) * (d - b), {{{{a, b}, {c, b}, {c, d}}}, {{{a, b}, {c, d}, {a, d}}}}};
}

MeasurementArea area_of(scenes::Library &library, const std::string &text)
{
    if (auto rectangle = rectangle_of(text)) return *rectangle;
    clq_area *made = nullptr;
    check(clq_area_load(library.context(), text.c_str(), &made), text);
    const std::unique_ptr<clq_area, decltype(&clq_area_destroy)> area(made, clq_area_destroy);
    clq_area_info info = clq_area_info_init();
    check(clq_area_get_info(made, &info));
    MeasurementArea out;
    out.area_m2 = info.area_m2;
    if (!(out.area_m2 > 0)) throw scenes::Failure(text + " has no area in which people could be counted");
    for (uint32_t t = 0; t < info.triangle_count; ++t) {
        std::array<Point2, 3> corners;
        for (size_t k = 0; k < 3; ++k) {
            const double *point = info.points_m + 3 * info.triangles[3 * t + k];
            corners[k] = {point[0], point[1]};
        }
        out.triangles.push_back(corners);
    }
    return out;
}

}  // namespace

void add_measure_options(CLI::App &command, MeasureArguments &a)
{
    CLI::Option *files =
        command
            .add_option("--measure", a.files,
                        "Write how many people there are, their density, speed, least distance and crossings, a row "
                        "for each step (CSV; - is standard output), or crossings over time (SVG, PNG); may repeat")
            ->check(CLI::Validator(check_file, ""))
            ->type_name("FILE.csv|FILE.svg|FILE.png")
            ->allow_extra_args(false);
    command.add_option("--line", a.line, "Line whose crossings --measure counts, metres of the file")
        ->type_name("X0,Y0,X1,Y1")
        ->needs(files);
    command
        .add_option("--area", a.area,
                    "Where --measure counts people: a rectangle in metres of the file, or a walkable area")
        ->type_name("X0,Y0,X1,Y1|FILE")
        ->needs(files);
}

bool measures_any(const MeasureArguments &a) { return !a.files.empty(); }

bool is_printed(const MeasureArguments &a) { return std::count(a.files.begin(), a.files.end(), "-") > 0; }

void check_measures(const MeasureArguments &a, std::initializer_list<std::string> others)
{
    if (std::count(a.files.begin(), a.files.end(), "-") + std::count(others.begin(), others.end(), "-") > 1)
        throw CLI::ValidationError("--measure", "standard output takes one of the files named -");
    if (!a.line.empty()) (void)line_of(a.line);
    if (!a.area.empty() && !rectangle_of(a.area)) expect_readable(a.area);
    for (const std::string &file : a.files) {
        expect_writable(file);
        if (!is_table(file) && a.line.empty())
            throw CLI::ValidationError("--measure", file + " shows crossings of a line: --line says which");
    }
}

Measures write_measures(scenes::Library &library, const MeasureArguments &a, const clq_trajectories *trajectories,
                        const std::string &name)
{
    std::optional<MeasurementLine> line;
    std::optional<MeasurementArea> area;
    if (!a.line.empty()) line = line_of(a.line);
    if (!a.area.empty()) area = area_of(library, a.area);
    const Measures measures = measure(trajectories, line, std::move(area));
    for (const std::string &file : a.files) {
        if (is_table(file)) write_whole(file, csv_of(measures));
        else write_chart(file, drawing_of(crossings_over_time(measures, std::filesystem::path(name).filename())));
    }
    return measures;
}

}  // namespace cli

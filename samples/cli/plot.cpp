// claque plot: a chart of measurements, as PNG or SVG.
#include "samples/cli/plot.h"

#include <memory>

#include <nlohmann/json.hpp>

#include "samples/charts/lines.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/io/json.h"
#include "samples/io/png.h"

namespace cli
{
namespace
{

// PNG is drawn at twice the size of SVG, so that small letters stay sharp.
constexpr double pixels_per_px = 2;

struct PlotArguments {
    std::string file, out;
};

std::string extension_of(const std::string &path)
{
    const size_t slash = path.find_last_of('/'), dot = path.find_last_of('.');
    return dot == std::string::npos || (slash != std::string::npos && dot < slash) ? "" : path.substr(dot);
}

bool is_lines(const std::string &chart)
{
    std::string problem;
    const auto json = io::parse_json<nlohmann::json>(chart, problem);
    return json.is_object() && json.contains("kind");
}

void plot(const PlotArguments &a)
{
    expect_writable(a.out);
    const std::string chart = text_of(a.file);
    write_chart(a.out, is_lines(chart) ? drawing_of(charts::line_chart_of(chart, a.file))
                                       : drawing_of(path_chart_of(chart, a.file)));
}

}  // namespace

const CLI::Validator chart_file(
    [](const std::string &path) -> std::string {
        const std::string extension = extension_of(path);
        if (extension.empty() || extension == ".svg" || extension == ".png") return {};
        return path + " ends in " + extension + "; a chart is written as .png or .svg";
    },
    "FILE.png|FILE.svg");

void write_chart(const std::string &path, const charts::Drawing &drawing)
{
    if (extension_of(path) != ".png") return write_whole(path, svg_of(drawing));
    const charts::Pixels pixels = pixels_of(drawing, pixels_per_px);
    const std::vector<unsigned char> file =
        io::png(pixels.rgb.data(), pixels.width, pixels.height, {{"Title", drawing.title}});
    write_whole(path, file.data(), file.size());
}

void add_plot(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<PlotArguments>();
    CLI::App *c = app.add_subcommand("plot", "Draw measurements as a chart");
    c->add_option(
         "FILE", a->file,
         "A report of 'bench SCENE --json' along a camera path, or a line chart, as 'bench doors', 'bench walking' "
         "and 'bench growth' write with --save (JSON)")
        ->required();
    c->add_option("--out,-o", a->out, "The chart, PNG or SVG by its name; - is SVG on standard output")
        ->required()
        ->check(chart_file);
    c->callback([a, &chosen] { chosen = [a] { plot(*a); }; });
}

}  // namespace cli

// claque cost: S0's cost model (its section 6 and appendix), with the counts of a run of the library beside it.
#include <iostream>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/plot.h"
#include "samples/cost/curves.h"
#include "samples/cost/measured.h"
#include "samples/cost/report.h"

namespace cli
{
namespace
{

struct CostArguments {
    std::string measured, json, plot;
    bool markdown = false;
};

void show(const CostArguments &a)
{
    for (const std::string &path : {a.json, a.plot})
        if (!path.empty()) expect_writable(path);
    std::optional<cost::Measured> counts;
    if (!a.measured.empty()) counts = cost::measured_of(text_of(a.measured), a.measured);
    const cost::Measured *measured = counts ? &*counts : nullptr;
    const cost::Scene scene;
    const cost::Report report = report_of(scene, measured);
    if (!a.plot.empty()) write_chart(a.plot, drawing_of(curves_of(scene, measured)));
    if (!a.json.empty()) write_whole(a.json, json_of(report, readings_of(scene, measured)).dump(2) + "\n");
    if (a.json != "-" && a.plot != "-") std::cout << (a.markdown ? markdown_of(report) : text_of(report));
}

}  // namespace

void add_cost(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<CostArguments>();
    CLI::App *c = app.add_subcommand(
        "cost", "Print what an actor pipeline saves by the cost model of S0: Tables 1 to 6, equation 3");
    c->add_option("--measured", a->measured, "Counts of a run of the library (JSON), shown beside the model");
    c->add_option("--json", a->json,
                  "Write all tables and numbers as JSON; - is standard output, where it replaces the text");
    c->add_option("--plot", a->plot,
                  "Draw equation (3) over AverageCost, as PNG or SVG by the file name; - is SVG on standard output")
        ->check(chart_file);
    c->add_flag("--markdown", a->markdown, "Print Markdown tables");
    c->callback([a, &chosen] {
        if (a->json == "-" && a->plot == "-")
            throw CLI::ValidationError("--json and --plot", "only one of them can write to standard output");
        if (a->markdown && (a->json == "-" || a->plot == "-"))
            throw CLI::ValidationError("--markdown", "standard output is used by --json - or --plot -");
        chosen = [a] { show(*a); };
    });
}

}  // namespace cli

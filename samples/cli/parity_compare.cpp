// claque parity compare: compares two results. Exit codes: 0 within the tolerance; 1 outside it; 2 they cannot be
// compared.
#include <cmath>
#include <iostream>
#include <memory>

#include "samples/cli/files.h"
#include "samples/cli/parity.h"
#include "samples/io/png.h"
#include "samples/parity/flip.h"
#include "samples/parity/pictures.h"
#include "samples/parity/report.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

struct CompareArguments {
    std::string reference, result, tolerance = "gpu", json, html;
    double pixels_per_degree = parity::pixels_per_degree();
};

parity::Figure figure(const char *title, const std::string &caption, const parity::Picture &p)
{
    return {title, caption, io::png(p.rgb.data(), p.width, p.height, {{"Title", title}})};
}

std::vector<parity::Figure> figures(const parity::Report &r)
{
    std::vector<parity::Figure> out;
    const auto &a = r.reference, &b = r.result;
    if (a.colour) out.push_back(figure("Reference", a.renderer, *a.colour));
    if (b.colour) out.push_back(figure("Result", b.renderer, *b.colour));
    if (a.colour && b.colour) {
        out.push_back(figure("Difference of colours", "16 times as bright.", difference_picture(*a.colour, *b.colour)));
        out.push_back(figure("LDR-FLIP", "Black: equal, pale yellow: the largest possible difference.",
                             heat_picture(r.comparison.flip)));
    }
    const parity::Picture *under = a.colour ? &*a.colour : nullptr;
    const char *marks = "Amber: within a pixel of a border, red: elsewhere.";
    if (!r.comparison.actor_marks.values.empty())
        out.push_back(
            figure("Pixels with different individuals", marks, marks_picture(r.comparison.actor_marks, under)));
    if (!r.comparison.zone_marks.values.empty())
        out.push_back(figure("Pixels with different zones", marks, marks_picture(r.comparison.zone_marks, under)));
    if (a.depth && b.depth)
        out.push_back(figure("Difference of depth", "Black: 1e-7 and less, pale yellow: 1; logarithmic.",
                             heat_picture(depth_difference(*a.depth, *b.depth))));
    return out;
}

void compare(const CompareArguments &a)
{
    for (const std::string &out : {a.json, a.html})
        if (!out.empty()) expect_writable(out);
    const parity::Tolerance tolerance = parity::tolerance_of(a.tolerance);
    const parity::Capture reference = parity::read_capture(a.reference), result = parity::read_capture(a.result);
    const parity::Comparison comparison = parity::compare(reference, result, a.pixels_per_degree);
    const parity::Verdict verdict = parity::verdict_of(comparison, tolerance);
    const parity::Report report = {reference, result, comparison, verdict};
    if (!a.json.empty()) write_whole(a.json, report_json(report));
    if (!a.html.empty()) write_whole(a.html, report_html(report, figures(report)));
    const bool quiet = a.json == "-" || a.html == "-";
    if (!quiet) std::cout << report_text(report) << std::flush;
    if (!verdict.pass) throw scenes::Failure(a.result + " fails " + verdict.tolerance + ": " + reasons(verdict, 3));
    if (!quiet)
        std::cout << a.result << " passes " << verdict.tolerance << ": " << verdict.checks.size() << " limits kept\n";
}

}  // namespace

void add_parity_compare(CLI::App &parity_command, Work &chosen)
{
    auto a = std::make_shared<CompareArguments>();
    CLI::App *c = parity_command.add_subcommand(
        "compare",
        "Compare two results (docs/parity.md): vertices, normals, visible individuals and zones, depth, colour. Exit "
        "codes: 0 within the tolerance, 1 not, 2 they cannot be compared");
    c->add_option("REFERENCE", a->reference, "The folder of the reference result")->required();
    c->add_option("RESULT", a->result, "The folder of the result to check")->required();
    c->add_option("--tolerance", a->tolerance, "exact, gpu, coarse, loose or a TOML file")->capture_default_str();
    c->add_option("--json", a->json, "Write all measures as JSON; - is standard output");
    c->add_option("--html", a->html, "Write an HTML page with pictures of the differences; - is standard output");
    c->add_option("--pixels-per-degree", a->pixels_per_degree, "Pixels a degree of the viewer's screen, for FLIP")
        ->capture_default_str()
        ->check(CLI::Range(5.0, 500.0));
    c->callback([a, &chosen] {
        chosen = [a] {
            try {
                compare(*a);
            } catch (const parity::Unreadable &error) {
                std::cerr << "claque: " << error.what() << ".\n";
                throw CLI::RuntimeError(2);
            }
        };
    });
}

}  // namespace cli

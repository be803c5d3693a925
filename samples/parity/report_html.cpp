// A comparison as one HTML page that contains its pictures.
#include "samples/parity/base64.h"
#include "samples/parity/report.h"

namespace parity
{
namespace
{

// Colours follow the reader's theme; every meaning of a colour is also given by a word.
const char head[] = R"html(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>claque parity</title>
<style>
:root { color-scheme: light dark; --ink: #1d1d1f; --soft: #5f6368; --paper: #fff; --rule: #d8d8dc;
  --good: #17692f; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8ea; --soft: #a5a8ad; --paper: #17181a; --rule: #3a3c40; --good: #6fd08c; --bad: #ff8a80; }
}
body { font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  margin: 2rem auto; max-width: 72rem; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin-bottom: .2rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
.pass { color: var(--good); } .fail { color: var(--bad); font-weight: 600; } .soft { color: var(--soft); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .25rem .8rem .25rem 0; border-bottom: 1px solid var(--rule); vertical-align: top; }
td.number { white-space: nowrap; } td.path { overflow-wrap: anywhere; }
@media (max-width: 45rem) {  /* a row is a few lines: the name and the number, then what they mean */
  table, tbody { display: block; } tr.names { display: none; }
  tr { display: flex; flex-wrap: wrap; gap: 0 .8rem; padding: .35rem 0; border-bottom: 1px solid var(--rule); }
  th, td { padding: 0; border: 0; overflow-wrap: anywhere; } td:empty { display: none; } td.line { flex-basis: 100%; }
}
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); gap: 1rem; }
figure { margin: 0; } img { width: 100%; height: auto; border: 1px solid var(--rule); background: #000; }
figcaption { color: var(--soft); font-size: .9rem; } figcaption b { color: var(--ink); }
</style></head><body>
)html";

std::string escaped(const std::string &text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else out += c;
    }
    return out;
}

std::string side(const char *name, const Capture &c)
{
    return std::string("<tr><th>") + name + "</th><td class=\"path\">" + escaped(c.folder) +
           "</td><td class=\"line\">" + escaped(c.renderer) + "</td><td class=\"line soft\">" + escaped(c.scene) +
           "</td></tr>\n";
}

std::string row(const Measure &m, const Check *check)
{
    const std::string unit = m.unit.empty() ? "" : " " + m.unit;
    std::string limit;
    if (check)
        limit = std::string(check->at_least ? "at least " : "at most ") + number_text(check->bound) +
                (check->kept ? " <span class=\"pass\">kept</span>" : " <span class=\"fail\">broken</span>");
    return "<tr><td>" + m.name + "</td><td class=\"number\">" + number_text(m.value) + escaped(unit) +
           "</td><td class=\"number\">" + limit + "</td><td class=\"line soft\">" +
           escaped(find_kind(m.name)->meaning) + (m.where.empty() ? "" : "; " + escaped(m.where)) + "</td></tr>\n";
}

std::string figure(const Figure &f)
{
    return "<figure><img alt=\"" + escaped(f.title) + "\" src=\"data:image/png;base64," + base64(f.png) +
           "\"><figcaption><b>" + escaped(f.title) + "</b> " + escaped(f.caption) + "</figcaption></figure>\n";
}

}  // namespace

std::string report_html(const Report &report, const std::vector<Figure> &figures)
{
    const Verdict &v = report.verdict;
    std::string out = head;
    out += "<h1>Parity: <span class=\"" + std::string(v.pass ? "pass\">pass" : "fail\">fail") + "</span></h1>\n";
    out += "<p>Tolerance " + escaped(v.tolerance) + ", " + std::to_string(v.checks.size()) + " limits" +
           (v.pass ? "." : ": " + escaped(reasons(v, 99)) + ".") + "</p>\n<div class=\"scroll\"><table>\n" +
           side("Reference", report.reference) + side("Result", report.result) + "</table></div>\n<h2>Measures</h2>\n";
    out +=
        "<div class=\"scroll\"><table><tr class=\"names\"><th>Measure</th><th>Value</th><th>Limit</th><th>What it "
        "is</th></tr>\n";
    for (const Measure &m : report.comparison.measures) out += row(m, v.find(m.name));
    out += "</table></div>\n";
    for (const NotCompared &n : report.comparison.not_compared)
        out += "<p class=\"soft\">" + escaped(n.group) + ": not compared, " + escaped(n.why) + ".</p>\n";
    if (!figures.empty()) out += "<h2>Pictures</h2>\n<div class=\"figures\">\n";
    for (const Figure &f : figures) out += figure(f);
    return out + (figures.empty() ? "" : "</div>\n") + "</body></html>\n";
}

}  // namespace parity

// The report of a bench along a path as tables: one for a terminal, one in Markdown.
#include <algorithm>
#include <cstdio>

#include "samples/cli/bench.h"

namespace cli
{
namespace
{

std::string with_digits(double value, int digits)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

// Three significant digits.
std::string figure(double ms) { return with_digits(ms, ms < 9.995 ? 2 : ms < 99.95 ? 1 : 0); }

std::string spread(const Json &times)
{
    return figure(times["minimum"].get<double>()) + " / " + figure(times["median"].get<double>());
}

std::string people(const Json &section)
{
    const Json &p = section["people"];
    return with_digits(p["mean"].get<double>(), 0) + " (" + std::to_string(p["minimum"].get<unsigned>()) + " to " +
           std::to_string(p["maximum"].get<unsigned>()) + ")";
}

std::string words(const Json &report, const char *name) { return report[name].get<std::string>(); }

std::string conditions(const Json &report)
{
    return std::to_string(report["size_px"][0].get<int>()) + " x " + std::to_string(report["size_px"][1].get<int>()) +
           ", " + std::to_string(report["threads"].get<int>()) + " threads, " + words(report, "context") + ", " +
           words(report["machine"], "processor") + " with " +
           std::to_string(report["machine"]["cores"].get<unsigned>()) + " cores";
}

const Json *run_of(const Json &report, const std::string &section, const std::string &cache,
                   const std::string &strategy)
{
    for (const Json &run : report["runs"])
        if (words(run, "section") == section && words(run, "cache") == cache && words(run, "strategy") == strategy)
            return &run;
    return nullptr;
}

// The values of `name` in all runs, in the order of their first appearance.
std::vector<std::string> different(const Json &report, const char *name)
{
    std::vector<std::string> found;
    for (const Json &run : report["runs"])
        if (std::find(found.begin(), found.end(), words(run, name)) == found.end()) found.push_back(words(run, name));
    return found;
}

bool has_key_poses(const Json &report)
{
    for (const Json &run : report["runs"])
        if (shares_key_poses(words(run, "cache"))) return true;
    return false;
}

bool has_levels(const Json &report)
{
    for (const Json &run : report["runs"])
        if (words(run, "cache").find(", levels") != std::string::npos) return true;
    return false;
}

// How "the same picture" is restricted in this report.
std::string same_picture(const Json &report)
{
    unsigned most = 0;
    for (const Json &section : report["sections"]) most = std::max(most, section["depth_ties"].get<unsigned>());
    const std::string but =
        std::string(has_levels(report) ? " with levels of detail, and one without" : "") +
        (has_key_poses(report) ? ", except that each key-pose mode has a picture of its own whatever its size" : "");
    if (most == 0) return "the same picture" + but + ", by hash";
    return "the same picture" + but + " (strategies differ in " + std::to_string(most) +
           " pixels at most, where intersecting surfaces have one depth)";
}

// A run's counts a frame: individuals that are animated and skinned on their own, and, where the table has key-poses,
// the share served by them and the number of key-poses skinned.
std::string counts(const Json &run, bool key_poses)
{
    const auto whole = [&](const char *name) { return with_digits(run[name].get<double>(), 0); };
    if (!key_poses) return whole("animated") + " |";
    std::string text = whole("animated") + " | " + whole("skinned") + " | ";
    if (!shares_key_poses(words(run, "cache"))) return text + "| |";
    const double asked = run["key_poses_requested"].get<double>();
    text += asked > 0 ? with_digits(100 * run["key_poses_served"].get<double>() / asked, 0) + " %" : "none requested";
    return text + " | " + with_digits(run["key_poses_updated"].get<double>(), 1) + " |";
}

}  // namespace

void print_sections(const Json &report)
{
    std::printf("%s, %u people, %s, %d frames a section\n", words(report, "scene").c_str(),
                report["count"].get<unsigned>(), conditions(report).c_str(), report["frames"].get<int>());
    size_t longest = 10;
    for (const std::string &cache : different(report, "cache")) longest = std::max(longest, cache.size());
    const int wide = static_cast<int>(longest);
    const bool key_poses = has_key_poses(report);
    for (const Json &section : report["sections"]) {
        const std::string name = words(section, "name");
        std::printf("\n%s: %s people in view, %.0f triangles, pictures %s, %u depth ties\n", name.c_str(),
                    people(section).c_str(), section["triangles"].get<double>(),
                    words(section, "pictures_hash").c_str(), section["depth_ties"].get<unsigned>());
        std::printf("%-*s %-9s %17s %17s %17s %17s %9s %9s %9s", wide, "cache", "strategy", "update ms",
                    "environment ms", "draw ms", "frame ms", "animated", "draws", "sent");
        if (key_poses) std::printf(" %9s %9s %9s", "skinned", "served", "updated");
        std::printf("\n");
        for (const Json &r : report["runs"]) {
            if (words(r, "section") != name) continue;
            std::printf("%-*s %-9s %17s %17s %17s %17s %9.0f %9.0f %9.0f", wide, words(r, "cache").c_str(),
                        words(r, "strategy").c_str(), spread(r["update_ms"]).c_str(),
                        spread(r["environment_ms"]).c_str(), spread(r["draw_ms"]).c_str(),
                        spread(r["frame_ms"]).c_str(), r["animated"].get<double>(), r["draws"].get<double>(),
                        r["triangles_sent"].get<double>());
            if (key_poses)
                std::printf(" %9.0f %9.0f %9.1f", r["skinned"].get<double>(), r["key_poses_served"].get<double>(),
                            r["key_poses_updated"].get<double>());
            std::printf("\n");
        }
    }
    std::printf("\nTimes are minimum / median.\n");
}

std::string markdown_of(const Json &report)
{
    const std::vector<std::string> caches = different(report, "cache"), strategies = different(report, "strategy");
    std::string text =
        "Measured with `claque bench " + words(report, "scene") + " --frames " +
        std::to_string(report["frames"].get<int>()) + "`: " + conditions(report) + ". " +
        std::to_string(report["count"].get<unsigned>()) + " people; every frame is drawn in all variants, which give " +
        same_picture(report) +
        ". Milliseconds a frame, minimum / median; *update* is the library, *draw* the renderer with GL, *environment* "
        "everything but people.\n\n| section | people in view | caches | update | animated |";
    const bool key_poses = has_key_poses(report);
    if (key_poses) text += " skinned | served by key-poses | key-poses skinned |";
    for (const std::string &strategy : strategies) text += " draw " + strategy + " |";
    text += " environment | frames a second, " + strategies.back() + " |\n|---|---|---|---|---|";
    if (key_poses) text += "---|---|---|";
    for (size_t i = 0; i < strategies.size(); ++i) text += "---|";
    text += "---|---|\n";
    for (const Json &section : report["sections"])
        for (const std::string &cache : caches) {
            const std::string name = words(section, "name");
            const Json &last = *run_of(report, name, cache, strategies.back());
            text += "| " + name + " | " + people(section) + " | " + cache + " | " + spread(last["update_ms"]) + " | " +
                    counts(last, key_poses);
            for (const std::string &strategy : strategies)
                text += " " + spread((*run_of(report, name, cache, strategy))["draw_ms"]) + " |";
            text += " " + spread(last["environment_ms"]) + " | " +
                    with_digits(1000 / last["frame_ms"]["median"].get<double>(), 1) + " |\n";
        }
    return text;
}

}  // namespace cli

// claque bench million: what a city of up to a million people costs while a hundredth of the largest is in view: the
// time of an update on one thread, memory of an individual out of view, and the times of creating, saving, restoring.
#include <algorithm>
#include <cstdio>

#include "samples/cli/bench.h"
#include "samples/cli/city_crowd.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"

namespace cli
{

bool is_of_cities(const BenchArguments &a) { return a.subject == "million" || a.subject == "million-memory"; }

namespace
{

constexpr uint32_t most_all_in_view = 100000;  // of a city that is in view as a whole

struct Kind {
    const char *name;
    bool grouped, indexed, all_in_view;
};
constexpr Kind kinds[] = {{"some in view", false, false, false},
                          {"some in view, blocks in groups", true, false, false},
                          {"some in view, with a scene index", false, true, false},
                          {"all in view", false, false, true}};

// most_in_view: of the people, at most.
Json measured(const Kind &kind, uint32_t count, uint32_t most_in_view, int frames)
{
    CityOptions options;
    options.count = count;
    options.in_view = kind.all_in_view ? count : std::min(most_in_view, count / 2);
    options.grouped = kind.grouped, options.indexed = kind.indexed;
    CityCrowd city(options);
    Times update;
    for (int frame = -3; frame < frames; ++frame) {
        const Stopwatch updating;
        city.update(20 + frame / 25.0);
        if (frame >= 0) update.ms.push_back(updating.ms());
    }
    const clq_crowd_stats stats = city.stats();
    const uint64_t held = city.held_bytes();
    std::vector<uint8_t> saved;
    const Stopwatch saving;
    city.save(saved);
    const double save_s = saving.ms() / 1000;
    const Stopwatch restoring;
    city.restore(saved);
    return {{"kind", kind.name},
            {"count", count},
            {"visible", stats.visible},
            {"tested", stats.tested},
            {"update_ms", {{"minimum", update.minimum()}, {"median", update.median()}}},
            {"created_s", city.created_s()},
            {"held_bytes", held},
            {"cache_bytes", stats.cache_pool_bytes},
            {"actor_bytes", stats.actor_bytes},
            {"frame_bytes", stats.frame_bytes},
            {"track_bytes", city.track_bytes()},
            {"saved_bytes", saved.size()},
            {"save_s", save_s},
            {"restore_s", restoring.ms() / 1000}};
}

}  // namespace

Json bench_cities(const BenchArguments &a)
{
    Progress progress("claque bench");
    const bool memory = a.subject == "million-memory";
    Json report = {{"claque", version()},
                   {"kind", "lines"},
                   {"title", memory ? "Memory of a city" : "Updates of a city"},
                   {"x", {{"title", "people"}, {"scale", "log"}}},
                   {"y", {{"title", memory ? "bytes a person" : "milliseconds an update, median"}, {"scale", "log"}}},
                   {"series", Json::array()},
                   {"runs", Json::array()},
                   {"frames", a.frames}};
    // Ten thousand of a million, at every size that has as many.
    const uint32_t largest = *std::max_element(a.counts.begin(), a.counts.end());
    const uint32_t most_in_view = std::max(1u, largest / 100);
    size_t done = 0;
    for (const Kind &kind : kinds) {
        Json points = Json::array(), before;
        for (const uint32_t count : a.counts) {
            if (kind.all_in_view && count > most_all_in_view) continue;
            Json run = measured(kind, count, most_in_view, a.frames);
            // What one more person out of view takes, since the size before, where equally many are in view.
            if (!before.is_null() && before["visible"] == run["visible"] && !kind.all_in_view)
                run["bytes_each_more"] = (run["held_bytes"].get<double>() - before["held_bytes"].get<double>()) /
                                         (count - before["count"].get<double>());
            points.push_back(
                {count, memory ? run["held_bytes"].get<double>() / count : run["update_ms"]["median"].get<double>()});
            report["runs"].push_back(run);
            before = std::move(run);
            progress.step(++done, 4 * a.counts.size());
        }
        report["series"].push_back({{"name", kind.name}, {"points", std::move(points)}});
    }
    report["note"] = "citizens, a tenth of those out of view walking on tracks, one thread, " +
                     std::to_string(a.frames) + " updates";
    return report;
}

void print_cities(const Json &report)
{
    std::printf("%-36s %8s %8s  %17s  %8s %8s %9s  %9s  %s\n", "kind", "people", "in view", "update ms min/med",
                "create s", "save s", "restore s", "MB held", "bytes for each more out of view");
    for (const Json &r : report["runs"])
        std::printf("%-36s %8u %8u  %8.2f %8.2f  %8.2f %8.2f %9.2f  %9.1f  %s\n", r["kind"].get<std::string>().c_str(),
                    r["count"].get<unsigned>(), r["visible"].get<unsigned>(), r["update_ms"]["minimum"].get<double>(),
                    r["update_ms"]["median"].get<double>(), r["created_s"].get<double>(), r["save_s"].get<double>(),
                    r["restore_s"].get<double>(), r["held_bytes"].get<double>() / 1e6,
                    r.contains("bytes_each_more")
                        ? std::to_string(static_cast<int>(r["bytes_each_more"].get<double>())).c_str()
                        : "");
}

}  // namespace cli

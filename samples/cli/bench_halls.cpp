// claque bench doors and walking: the walkers of claque-stage in written halls, against people (docs/navigation.md).
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/halls/door.h"
#include "samples/halls/ring.h"

namespace cli
{

namespace
{

// The values of a row over all seeds.
class Spread
{
public:
    void add(double value) { least_ = std::min(least_, value), most_ = std::max(most_, value); }
    double least() const { return least_; }
    double most() const { return most_; }
    Json json() const { return {{"least", least_}, {"most", most_}}; }

private:
    double least_ = HUGE_VAL, most_ = -HUGE_VAL;
};

Json series(const std::string &name, Json points, size_t colour, const char *dash)
{
    return {{"name", name}, {"points", std::move(points)}, {"colour", colour}, {"dash", dash}};
}

Json report_of(const BenchArguments &a, const char *title, const char *x, const char *y)
{
    return {{"claque", version()},
            {"kind", "lines"},
            {"title", title},
            {"x", {{"title", x}, {"from", 0}}},
            {"y", {{"title", y}, {"from", 0}}},
            {"series", Json::array()},
            {"runs", Json::array()},
            {"seeds", a.seeds},
            {"note", std::to_string(a.seeds) + (a.seeds == 1 ? " seed" : " seeds, the least and the most of each")}};
}

// Rows beside those of the chart: two crowds meet at an opening.
Json meetings(const BenchArguments &a, Progress &progress, size_t done, size_t all)
{
    Json rows = Json::array();
    for (const halls::Opening &opening : halls::openings) {
        Spread last, nearest;
        size_t left = 0;
        for (unsigned seed = 1; seed <= a.seeds; ++seed) {
            const halls::Meeting meeting = halls::meet_at_a_door(opening.width_m, opening.count, {seed});
            last.add(meeting.last_s), nearest.add(meeting.nearest_m), left += meeting.left;
            progress.step(++done, all);
        }
        rows.push_back({{"width_m", opening.width_m},
                        {"people", 2 * opening.count},
                        {"last_s", last.json()},
                        {"nearest_m", nearest.least()},
                        {"left", left}});
    }
    return rows;
}

Json doors(const BenchArguments &a, Progress &progress)
{
    Json report = report_of(a, "People who leave a hall through one door", "width of the door, metres",
                            "people a second, while more than 2 a square metre wait");
    Json least = Json::array(), most = Json::array(), demanded_least = Json::array(), demanded_most = Json::array();
    const size_t all = (std::size(halls::doors) + std::size(halls::openings)) * a.seeds;
    size_t done = 0;
    for (const halls::Door &door : halls::doors) {
        Spread flow, pause, nearest;
        size_t left = 0;
        for (unsigned seed = 1; seed <= a.seeds; ++seed) {
            const halls::Passage passage = halls::through_a_door(door.width_m, door.people, {seed});
            flow.add(passage.flow), pause.add(passage.longest_pause_s), nearest.add(passage.nearest_m);
            left += passage.left;
            progress.step(++done, all);
        }
        report["runs"].push_back({{"width_m", door.width_m},
                                  {"people", door.people},
                                  {"flow_demanded", {{"least", door.least}, {"most", door.most}}},
                                  {"flow", flow.json()},
                                  {"longest_pause_s", pause.most()},
                                  {"nearest_m", nearest.least()},
                                  {"left", left}});
        least.push_back({door.width_m, flow.least() * door.width_m});
        most.push_back({door.width_m, flow.most() * door.width_m});
        demanded_least.push_back({door.width_m, door.least * door.width_m});
        demanded_most.push_back({door.width_m, door.most * door.width_m});
    }
    report["series"] = {series("walkers, least", least, 0, "solid"), series("walkers, most", most, 0, "dashed"),
                        series("demanded, least", demanded_least, 1, "dashed"),
                        series("demanded, most", demanded_most, 1, "dotted")};
    report["meetings"] = meetings(a, progress, done, all);
    return report;
}

constexpr double densities[] = {1, 1.5, 2, 2.5, 3};

Json walking(const BenchArguments &a, Progress &progress)
{
    Json report = report_of(a, "People who walk round and round", "people a square metre", "median speed, m/s");
    Json weidmann = Json::array();
    for (int i = 10; i <= 60; ++i) weidmann.push_back({i / 20.0, halls::weidmann_m_s(i / 20.0)});
    report["series"].push_back(series("people (Weidmann 1993)", weidmann, 1, "dashed"));
    report["series"].back()["dots"] = "never";
    size_t done = 0;
    for (const int ways : {1, 2}) {
        Json least = Json::array(), most = Json::array();
        for (const double density : densities) {
            if (ways == 2 && density > 2) break;
            Spread speed, order, stop, nearest;
            for (unsigned seed = 1; seed <= a.seeds; ++seed) {
                const halls::Round round = halls::walked_round(ways == 1 ? 4 : 5, density, ways, {seed});
                speed.add(round.median_m_s), order.add(round.order), stop.add(round.longest_stop_s);
                nearest.add(round.nearest_m);
                progress.step(++done, 8 * a.seeds);
            }
            least.push_back({density, speed.least()}), most.push_back({density, speed.most()});
            report["runs"].push_back({{"ways", ways},
                                      {"people_per_m2", density},
                                      {"weidmann_m_s", halls::weidmann_m_s(density)},
                                      {"median_m_s", speed.json()},
                                      {"order", order.least()},
                                      {"longest_stop_s", stop.most()},
                                      {"nearest_m", nearest.least()}});
        }
        const std::string name = ways == 1 ? "all one way, 4 m wide" : "counterflow, 5 m wide";
        const size_t colour = ways == 1 ? 0 : 2;
        report["series"].push_back(series(name + ", least", least, colour, "solid"));
        report["series"].push_back(series(name + ", most", most, colour, "dashed"));
    }
    return report;
}

}  // namespace

Json bench_halls(const BenchArguments &a)
{
    Progress progress("claque bench");
    return a.subject == "doors" ? doors(a, progress) : walking(a, progress);
}

void print_halls(const Json &report)
{
    const auto number = [](const Json &of, const char *name) { return of[name].get<double>(); };
    const bool of_doors = report["runs"][0].contains("width_m");
    std::printf("%s: %s\n", report["title"].get<std::string>().c_str(), report["note"].get<std::string>().c_str());
    if (of_doors)
        std::printf("%7s %7s  %s  %s  %s  %s\n", "door m", "people", "demanded /s/m", "walkers /s/m", "longest pause s",
                    "nearest centres m");
    else
        std::printf("%5s %9s  %s  %s  %s  %s  %s\n", "ways", "people/m2", "Weidmann m/s", "walkers m/s",
                    "order of lanes", "longest stop s", "nearest centres m");
    for (const Json &run : report["runs"])
        if (of_doors)
            std::printf("%7.1f %7u  %5.1f to %-5.1f  %4.2f to %-4.2f  %15.1f  %17.4f%s\n", number(run, "width_m"),
                        run["people"].get<unsigned>(), number(run["flow_demanded"], "least"),
                        number(run["flow_demanded"], "most"), number(run["flow"], "least"), number(run["flow"], "most"),
                        number(run, "longest_pause_s"), number(run, "nearest_m"),
                        run["left"].get<size_t>() > 0 ? "  some never left" : "");
        else
            std::printf("%5d %9.1f  %12.2f  %4.2f to %-4.2f  %14.2f  %14.1f  %17.4f\n", run["ways"].get<int>(),
                        number(run, "people_per_m2"), number(run, "weidmann_m_s"), number(run["median_m_s"], "least"),
                        number(run["median_m_s"], "most"), number(run, "order"), number(run, "longest_stop_s"),
                        number(run, "nearest_m"));
    if (!of_doors) return;
    std::printf("\nTwo crowds of equal size meet at the opening\n%9s %7s  %s  %s\n", "opening m", "people",
                "last one through s", "nearest centres m");
    for (const Json &run : report["meetings"])
        std::printf("%9.1f %7u  %7.0f to %-7.0f  %17.4f%s\n", number(run, "width_m"), run["people"].get<unsigned>(),
                    number(run["last_s"], "least"), number(run["last_s"], "most"), number(run, "nearest_m"),
                    run["left"].get<size_t>() > 0 ? "  some never passed" : "");
}

}  // namespace cli

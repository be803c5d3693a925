// claque bench growth: how the cost of an update grows with the crowd (S0 7.2), once with a fifth of it in view and
// once with 1000 actors in view at every size; and what one more actor out of view costs, alone and in a group. No
// picture is drawn.
#include <cmath>
#include <cstdio>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"
#include "samples/scenes/random.h"

namespace cli
{
namespace
{

using scenes::Purpose;

constexpr double field_m = 400, growth_fov_deg = 60, growth_aspect = 4.0 / 3.0;
constexpr uint32_t kept_in_view = 1000;

enum class View { share, number };
enum class Rest { alone, grouped };

// Citizens on a disc round the eye: all over it, or `kept_in_view` of them ahead and all others behind.
struct GrowthField {
    GrowthField(scenes::Library &library, uint32_t count, View view, Rest rest) : cast(library, scenes::CrowdOptions())
    {
        clq_template *citizen = library.builtin("citizen");
        clq_group behind = {};
        if (rest == Rest::grouped) scenes::check(clq_group_create(cast.crowd(), nullptr, &behind));
        for (uint32_t person = 0; person < count; ++person) {
            const bool ahead = view == View::number && person < kept_in_view;
            const double turn = random_unit(7, person, Purpose::heading),
                         away = 8 + field_m * std::sqrt(random_unit(7, person, Purpose::radius));
            constexpr double tau = 2 * 3.14159265358979323846;
            const double angle = ahead ? 0.5 * (turn - 0.5) : tau * turn;
            // Those behind stand on a disc of their own, so that their group's bounding sphere is behind as well.
            const double back = view == View::number && !ahead ? 1.1 * (field_m + 8) : 0;
            clq_play play = {};
            play.clip = clq_template_find_clip(citizen, "stand");
            play.speed = 1;
            play.phase_s = static_cast<float>(random_unit(7, person, Purpose::phase));
            cast.enter(
                {citizen, scenes::stand(-away * std::sin(angle), 0, back - away * std::cos(angle), 0, 1, 1), play});
            if (rest == Rest::grouped && !ahead)
                scenes::check(clq_actor_join(cast.crowd(), cast.actors().back(), behind, nullptr));
        }
        clq_view *made = nullptr;
        scenes::check(clq_view_create(cast.crowd(), &made));
        eye.reset(made);
        const double at[3] = {0, 1.7, 0}, ahead[3] = {0, 1.6, -10};
        const clq_camera camera = scenes::look(at, ahead, growth_fov_deg, growth_aspect, 0.5, 1000);
        scenes::check(clq_view_set_camera(made, &camera));
    }
    void update(double time_s)
    {
        clq_view *views[] = {eye.get()};
        scenes::check(clq_crowd_update(cast.crowd(), time_s, views, 1));
    }
    scenes::SceneCrowd cast;
    scenes::Own<clq_view> eye;
};

struct Measured {
    Times update;
    clq_crowd_stats stats = clq_crowd_stats_init();
};

Measured measure(scenes::Library &library, uint32_t count, View view, Rest rest, int frames)
{
    GrowthField field(library, count, view, rest);
    Measured out;
    for (int frame = -2; frame < frames; ++frame) {
        const Stopwatch updating;
        field.update(2 + frame / 25.0);
        if (frame >= 0) out.update.ms.push_back(updating.ms());
    }
    scenes::check(clq_crowd_get_stats(field.cast.crowd(), &out.stats));
    return out;
}

}  // namespace

Json bench_growth(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Json report = {{"claque", version()},
                   {"kind", "lines"},
                   {"title", "How an update grows with the crowd"},
                   {"x", {{"title", "actors"}, {"scale", "log"}}},
                   {"y", {{"title", "milliseconds an update, median"}, {"scale", "log"}}},
                   {"series", Json::array()},
                   {"runs", Json::array()},
                   {"threads", thread_count(a.setup)},
                   {"frames", a.frames}};
    const struct {
        const char *name;
        View view;
        Rest rest;
    } kinds[] = {{"a fifth in view", View::share, Rest::alone},
                 {"1000 in view", View::number, Rest::alone},
                 {"1000 in view, the others in a group", View::number, Rest::grouped}};
    size_t done = 0;
    for (const auto &kind : kinds) {
        Json points = Json::array();
        double before_ms = 0;
        uint32_t before = 0;
        for (const uint32_t count : a.counts) {
            const Measured m = measure(library, count, kind.view, kind.rest, a.frames);
            const double median = m.update.median();
            Json run = {{"kind", kind.name},
                        {"count", count},
                        {"visible", m.stats.visible},
                        {"tested", m.stats.tested},
                        {"update_ms", {{"minimum", m.update.minimum()}, {"median", median}}}};
            // Cost of one more actor out of view since the previous size.
            if (kind.view == View::number && before >= kept_in_view)
                run["ns_each_more"] = (median - before_ms) * 1e6 / (count - before);
            before = count, before_ms = median;
            points.push_back({count, median});
            report["runs"].push_back(std::move(run));
            progress.step(++done, 3 * a.counts.size());
        }
        report["series"].push_back({{"name", kind.name}, {"points", std::move(points)}});
    }
    report["note"] = "citizens, animation and geometry caches, " + std::to_string(thread_count(a.setup)) +
                     " threads, medians of " + std::to_string(a.frames) + " updates";
    return report;
}

void print_growth(const Json &report)
{
    std::printf("%-36s %8s %8s %8s  %10s %10s  %s\n", "kind", "actors", "tested", "in view", "update ms", "median",
                "ns for each more out of view");
    for (const Json &r : report["runs"])
        std::printf("%-36s %8u %8u %8u  %10.3f %10.3f  %s\n", r["kind"].get<std::string>().c_str(),
                    r["count"].get<unsigned>(), r["tested"].get<unsigned>(), r["visible"].get<unsigned>(),
                    r["update_ms"]["minimum"].get<double>(), r["update_ms"]["median"].get<double>(),
                    r.contains("ns_each_more") ? std::to_string(r["ns_each_more"].get<double>()).c_str() : "");
}

}  // namespace cli

// Individual speed: distance between the samples a quarter of a second before and after, over the time between them;
// one-sided at the ends. Classical density: people in an area over its size. N-t: people beyond a line, each from the
// first step behind it. Flow: crossings less one, over the time from the first to the last (Seyfried et al. 2005).
#include "samples/cli/measures.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "samples/scenes/check.h"

namespace cli
{
namespace
{

using scenes::check;

constexpr double none = NAN, half_window_s = 0.25, instant_s = 1e-6;
constexpr size_t most_steps = 2000000;  // 22 hours of 25 frames a second

// Twice the area of a triangle; positive: counter-clockwise.
double turn(Point2 a, Point2 b, Point2 c) { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); }

Point2 place(const clq_trajectory_sample &sample) { return {sample.x, sample.y}; }

// The line itself belongs to its right side, so a step onto it and the next one away count once.
bool crosses(const MeasurementLine &line, Point2 from, Point2 to)
{
    const double before = turn(line.from, line.to, from), after = turn(line.from, line.to, to);
    if ((before > 0) == (after > 0)) return false;
    const double begin = turn(from, to, line.from), end = turn(from, to, line.to);
    return (begin >= 0) != (end >= 0) || begin == 0 || end == 0;
}

class Speeds
{
public:
    Speeds(const clq_trajectory_sample *own, uint64_t count) : own_(own), count_(count) {}

    // Indices ascend from call to call.
    double at(uint64_t i)
    {
        while (own_[first_].time_s < own_[i].time_s - half_window_s - instant_s) ++first_;
        while (last_ + 1 < count_ && own_[last_ + 1].time_s <= own_[i].time_s + half_window_s + instant_s) ++last_;
        const uint64_t a = first_ < i || i == 0 ? first_ : i - 1, b = last_ > i ? last_ : std::min(count_ - 1, i + 1);
        const double x = own_[b].x - own_[a].x, y = own_[b].y - own_[a].y;
        return b > a ? std::sqrt(x * x + y * y) / (own_[b].time_s - own_[a].time_s) : none;
    }

private:
    const clq_trajectory_sample *own_;
    uint64_t count_, first_ = 0, last_ = 0;
};

// Sweeps over the places in the order of x, and keeps those within the least distance in the order of y: each place has
// few neighbours there (Shamos and Hoey 1975).
double nearest_of(std::vector<Point2> &places)
{
    if (places.size() < 2) return none;
    std::sort(places.begin(), places.end());
    std::set<Point2> swept;  // y, x
    double least = HUGE_VAL;
    size_t first = 0;
    for (const Point2 &place : places) {
        while (place[0] - places[first][0] > least) swept.erase({places[first][1], places[first][0]}), ++first;
        for (auto near = swept.lower_bound({place[1] - least, -HUGE_VAL});
             near != swept.end() && (*near)[0] - place[1] <= least; ++near)
            least = std::min(least, std::hypot((*near)[1] - place[0], (*near)[0] - place[1]));
        if (!swept.insert({place[1], place[0]}).second) return 0;
    }
    return least;
}

struct Step {
    std::vector<Point2> places;
    double speeds = 0;  // of those inside
    uint32_t inside = 0, with_speed = 0, crossings = 0;
};

void add(const clq_trajectory_sample *own, uint64_t count, double start_s, double step_s, const Measures &of,
         std::vector<Step> &steps)
{
    Speeds speeds(own, count);
    bool has_crossed = false;
    for (uint64_t i = 0; i < count; ++i) {
        Step &step = steps[std::min(steps.size() - 1, size_t(std::lround((own[i].time_s - start_s) / step_s)))];
        step.places.push_back(place(own[i]));
        const double speed = speeds.at(i);
        if (!of.area || of.area->holds(place(own[i]))) {
            ++step.inside;
            if (std::isfinite(speed)) step.speeds += speed, ++step.with_speed;
        }
        if (i > 0 && of.line && !has_crossed && crosses(*of.line, place(own[i - 1]), place(own[i])))
            has_crossed = true, ++step.crossings;
    }
}

void add_number(std::string &out, double value, const char *format = ",%.4f")
{
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    out += std::isfinite(value) ? text : ",";
}

}  // namespace

bool MeasurementArea::holds(Point2 p) const
{
    for (const std::array<Point2, 3> &t : triangles) {
        const double a = turn(t[0], t[1], p), b = turn(t[1], t[2], p), c = turn(t[2], t[0], p);
        if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return true;
    }
    return false;
}

Measures measure(const clq_trajectories *trajectories, std::optional<MeasurementLine> line,
                 std::optional<MeasurementArea> area)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_get_info(trajectories, &info));
    if (!(info.step_s > 0)) throw scenes::Failure("no person has two samples, so nothing can be measured over time");
    const double count = (info.max_s - info.min_s) / info.step_s;
    if (!(count < double(most_steps)))
        throw scenes::Failure("the file has more than 2000000 steps, which are too many to measure");
    Measures out;
    out.line = line, out.area = std::move(area);
    std::vector<Step> steps(size_t(std::lround(count)) + 1);
    const clq_trajectory_sample *all = clq_trajectories_get_samples(trajectories);
    for (uint32_t p = 0; p < info.person_count; ++p) {
        clq_trajectory_person person = clq_trajectory_person_init();
        check(clq_trajectories_get_person(trajectories, p, &person));
        add(all + person.first_sample, person.sample_count, info.min_s, info.step_s, out, steps);
    }
    out.first_s = out.last_s = out.flow_per_s = out.nearest_m = out.nearest_s = none;
    uint32_t crossed = 0;
    for (size_t k = 0; k < steps.size(); ++k) {
        Step &step = steps[k];
        Moment moment;
        moment.time_s = info.min_s + double(k) * info.step_s;
        moment.people = static_cast<uint32_t>(step.places.size()), moment.inside = step.inside;
        moment.speed_m_s = step.with_speed > 0 ? step.speeds / step.with_speed : none;
        moment.nearest_m = nearest_of(step.places);
        if (step.crossings > 0 && crossed == 0) out.first_s = moment.time_s;
        if (step.crossings > 0) out.last_s = moment.time_s;
        moment.crossed = crossed += step.crossings;
        if (moment.nearest_m < out.nearest_m || !std::isfinite(out.nearest_m))
            out.nearest_m = moment.nearest_m, out.nearest_s = moment.time_s;
        if (out.area) out.most_per_m2 = std::max(out.most_per_m2, moment.inside / out.area->area_m2);
        out.moments.push_back(moment);
    }
    if (crossed > 1 && out.last_s > out.first_s) out.flow_per_s = (crossed - 1) / (out.last_s - out.first_s);
    return out;
}

std::string csv_of(const Measures &measures)
{
    std::string out = "time_s,people,inside,density_per_m2,speed_m_s,nearest_m,crossed\n";
    for (const Moment &moment : measures.moments) {
        char text[96];
        std::snprintf(text, sizeof text, "%.4f,%u,%u", moment.time_s, moment.people, moment.inside);
        out += text;
        add_number(out, measures.area ? moment.inside / measures.area->area_m2 : none);
        add_number(out, moment.speed_m_s);
        add_number(out, moment.nearest_m);
        add_number(out, measures.line ? moment.crossed : none, ",%.0f");
        out += '\n';
    }
    return out;
}

charts::LineChart crossings_over_time(const Measures &measures, const std::string &file)
{
    charts::LineChart chart;
    const MeasurementLine &line = *measures.line;
    char about[200];
    std::snprintf(about, sizeof about, ", the line from (%g, %g) to (%g, %g)", line.from[0], line.from[1], line.to[0],
                  line.to[1]);
    chart.title = "Crossings of the line";
    chart.subtitle = file + about;
    chart.x.title = "time in s", chart.y.title = "people";
    chart.x.from = measures.moments.front().time_s, chart.x.to = measures.moments.back().time_s;
    chart.y.from = 0;
    charts::Series series;
    series.name = "N";
    series.dots = charts::Series::Dots::never;
    uint32_t before = 0;
    for (const Moment &moment : measures.moments) {
        if (moment.crossed == before && &moment != &measures.moments.front() && &moment != &measures.moments.back())
            continue;
        if (moment.crossed > before) series.points.push_back({moment.time_s, double(before)});
        series.points.push_back({moment.time_s, double(moment.crossed)});
        before = moment.crossed;
    }
    chart.series.push_back(std::move(series));
    if (std::isfinite(measures.flow_per_s)) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "%.3f people a second from the first crossing at %.2f s to the last at %.2f s.",
                      measures.flow_per_s, measures.first_s, measures.last_s);
        chart.note = text;
    }
    return chart;
}

nlohmann::ordered_json json_of(const Measures &m)
{
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    const auto point = [](Point2 p) { return Json{p[0], p[1]}; };
    Json out = {{"nearest_m", number(m.nearest_m)}, {"nearest_s", number(m.nearest_s)}};
    out["area_m2"] = m.area ? Json(m.area->area_m2) : Json();
    out["most_per_m2"] = m.area ? Json(m.most_per_m2) : Json();
    out["line"] = m.line ? Json{point(m.line->from), point(m.line->to)} : Json();
    out["crossed"] = m.line ? Json(m.moments.back().crossed) : Json();
    out["first_s"] = number(m.first_s), out["last_s"] = number(m.last_s), out["flow_per_s"] = number(m.flow_per_s);
    return out;
}

std::string told(const Measures &measures)
{
    std::string out;
    const auto line = [&](const char *format, auto... values) {
        char text[240];
        std::snprintf(text, sizeof text, format, values...);
        out += text;
    };
    if (std::isfinite(measures.nearest_m))
        line("nearest          %.3f m between two people, at %.2f s\n", measures.nearest_m, measures.nearest_s);
    if (measures.area)
        line("density          at most %.3f people/m2 in %.2f m2\n", measures.most_per_m2, measures.area->area_m2);
    if (measures.line && std::isfinite(measures.flow_per_s))
        line("flow             %u crossed the line, %.3f a second from %.2f to %.2f s\n",
             measures.moments.back().crossed, measures.flow_per_s, measures.first_s, measures.last_s);
    else if (measures.line) line("flow             %u crossed the line\n", measures.moments.back().crossed);
    return out;
}

}  // namespace cli

#include "samples/scenes/walkers/passings.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/check.h"

namespace scenes::walkers
{

namespace
{

constexpr float quarter_turn = 1.57079632679489662f;

// A passing is found from places up to 0.6 s around it, and these from the points around them.
constexpr double stretch_s = 64, beside_s = 1;

int64_t stretch_at(double time_s) { return static_cast<int64_t>(std::floor(time_s / stretch_s)); }

// Counting takes as long as finding: most people pass a few others.
std::vector<clq_found_passing> passings_among(clq_context *context,
                                              const std::vector<std::vector<clq_track_point>> &points)
{
    std::vector<clq_track_def> defs(points.size(), clq_track_def_init());
    std::vector<const clq_track_def *> all;
    for (size_t i = 0; i < points.size(); ++i) {
        defs[i].points = points[i].data(), defs[i].point_count = static_cast<uint32_t>(points[i].size());
        all.push_back(&defs[i]);
    }
    const uint32_t people = static_cast<uint32_t>(all.size());
    std::vector<clq_found_passing> found(8 * points.size() + 64);
    size_t count = 0;
    if (clq_find_passings(context, all.data(), people, found.data(), found.size(), &count) != CLQ_OK) {
        check(clq_find_passings(context, all.data(), people, nullptr, 0, &count));
        found.resize(count);
        check(clq_find_passings(context, all.data(), people, found.data(), found.size(), &count));
    }
    found.resize(count);
    return found;
}

}  // namespace

clq_trajectory_person person_of(const clq_trajectories *trajectories, uint32_t number)
{
    clq_trajectory_person person = clq_trajectory_person_init();
    check(clq_trajectories_get_person(trajectories, number, &person));
    return person;
}

std::vector<clq_track_point> points_of(const clq_trajectory_person &person, const clq_trajectory_sample *samples,
                                       const Plan &plan, uint64_t first, uint64_t end)
{
    std::vector<clq_track_point> points;
    points.reserve(end - first);
    for (uint64_t i = person.first_sample + first; i < person.first_sample + end; ++i) {
        const clq_trajectory_sample &sample = samples[i];
        clq_track_point point = {};
        point.time_s = sample.time_s - plan.start_s;
        plan.to_scene(sample.x, sample.y, sample.z, point.position);
        point.heading_rad = sample.heading_rad + quarter_turn;  // NaN stays NaN
        points.push_back(point);
    }
    return points;
}

Passings::Passings(Library &library, const clq_trajectories *trajectories, const Plan &plan)
    : library_(library), trajectories_(trajectories), samples_(clq_trajectories_get_samples(trajectories)), plan_(plan)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_get_info(trajectories, &info));
    for (uint32_t i = 0; i < info.person_count; ++i) people_.push_back(person_of(trajectories_, i));
}

std::vector<clq_track_passing> Passings::of(uint32_t number)
{
    const clq_trajectory_person &person = people_[number];
    const double start_s = samples_[person.first_sample].time_s - plan_.start_s;
    const double end_s = samples_[person.first_sample + person.sample_count - 1].time_s - plan_.start_s;
    std::vector<clq_track_passing> own;
    const auto before = [](const Found &found, uint32_t of) { return found.person < of; };
    for (int64_t stretch = stretch_at(start_s); stretch <= stretch_at(end_s); ++stretch) {
        const std::vector<Found> &found = found_in(stretch);
        for (auto at = std::lower_bound(found.begin(), found.end(), number, before);
             at != found.end() && at->person == number; ++at)
            own.push_back(at->passing);
    }
    return own;
}

// Among the points of the stretch and around it, whose passings outside of it are those of its neighbours.
const std::vector<Passings::Found> &Passings::found_in(int64_t stretch)
{
    const auto [place, is_new] = known_.try_emplace(stretch);
    if (!is_new) return place->second;
    const double from_s = double(stretch) * stretch_s - beside_s, to_s = double(stretch + 1) * stretch_s + beside_s;
    std::vector<uint32_t> numbers;
    std::vector<std::vector<clq_track_point>> points;
    for (uint32_t i = 0; i < people_.size(); ++i) {
        const clq_trajectory_sample *first = samples_ + people_[i].first_sample, *end = first + people_[i].sample_count;
        const auto time_of = [this](const clq_trajectory_sample &sample) { return sample.time_s - plan_.start_s; };
        const auto *later = std::partition_point(first, end, [&](const auto &s) { return time_of(s) <= from_s; });
        const auto *after = std::partition_point(later, end, [&](const auto &s) { return time_of(s) < to_s; });
        const uint64_t begin = static_cast<uint64_t>(std::max<std::ptrdiff_t>(later - first - 1, 0));
        const uint64_t behind = static_cast<uint64_t>(std::min(after - first + 1, end - first));
        if (time_of(*first) >= to_s || time_of(end[-1]) <= from_s) continue;
        numbers.push_back(i);
        points.push_back(points_of(people_[i], samples_, plan_, begin, behind));
    }
    const std::vector<clq_found_passing> found = passings_among(library_.context(), points);
    for (const clq_found_passing &one : found)
        if (stretch_at(one.passing.time_s) == stretch) place->second.push_back({numbers[one.track], one.passing});
    return place->second;
}

}  // namespace scenes::walkers

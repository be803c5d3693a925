#include "samples/scenes/walkers/people.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"

namespace scenes::walkers
{

namespace
{

constexpr float quarter_turn = 1.57079632679489662f;

std::vector<clq_track_point> points_of(const clq_trajectory_person &person, const clq_trajectory_sample *samples,
                                       const Plan &plan)
{
    std::vector<clq_track_point> points;
    points.reserve(person.sample_count);
    for (uint64_t i = person.first_sample; i < person.first_sample + person.sample_count; ++i) {
        const clq_trajectory_sample &sample = samples[i];
        clq_track_point point = {};
        point.time_s = sample.time_s - plan.start_s;
        plan.to_scene(sample.x, sample.y, sample.z, point.position);
        point.heading_rad = sample.heading_rad + quarter_turn;  // NaN stays NaN
        points.push_back(point);
    }
    return points;
}

// A member of the cast by its share.
size_t member_of(const std::vector<Member> &cast, double share)
{
    double all = 0, passed = 0;
    for (const Member &member : cast) all += member.described.share;
    for (size_t i = 0; i + 1 < cast.size(); ++i)
        if (share * all < (passed += cast[i].described.share)) return i;
    return cast.size() - 1;
}

std::vector<clq_track_def> defs_of(const std::vector<std::vector<clq_track_point>> &points)
{
    std::vector<clq_track_def> defs(points.size(), clq_track_def_init());
    for (size_t i = 0; i < points.size(); ++i)
        defs[i].points = points[i].data(), defs[i].point_count = static_cast<uint32_t>(points[i].size());
    return defs;
}

// Pairs that pass closely: shoulders turn then.
std::vector<clq_found_passing> passings_of(Library &library, const std::vector<clq_track_def> &defs)
{
    std::vector<const clq_track_def *> all;
    for (const clq_track_def &def : defs) all.push_back(&def);
    const uint32_t count = static_cast<uint32_t>(all.size());
    size_t found = 0;
    check(clq_find_passings(library.context(), all.data(), count, nullptr, 0, &found));
    std::vector<clq_found_passing> passings(found);
    check(clq_find_passings(library.context(), all.data(), count, passings.data(), passings.size(), &found));
    return passings;
}

}  // namespace

OwnTrajectories load(Library &library, const Options &options)
{
    clq_trajectories_def def = options.reading;
    def.columns = options.columns.empty() ? nullptr : options.columns.c_str();
    clq_trajectories *made = nullptr;
    check(clq_trajectories_load(library.context(), options.file.c_str(), &def, &made));
    OwnTrajectories out(made);
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_get_info(made, &info));
    if (info.person_count == 0) throw Failure(options.file + ": it has no people");
    return out;
}

Plan plan_of(const clq_trajectories *trajectories, const Options &options)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_get_info(trajectories, &info));
    Plan plan;
    // Whole metres, so that the scene's coordinates are the file's but for an offset that people can read.
    const double x = (info.box_min_m[0] + info.box_max_m[0]) / 2, y = (info.box_min_m[1] + info.box_max_m[1]) / 2;
    plan.x = std::floor(x), plan.y = std::floor(y);
    if (options.origin) {
        plan.x = (*options.origin)[0], plan.y = (*options.origin)[1];
        plan.middle_x = x - plan.x, plan.middle_z = plan.y - y;
    }
    plan.z = info.box_min_m[2];
    plan.start_s = info.min_s, plan.end_s = info.max_s;
    plan.half_x = std::max(1.0, (info.box_max_m[0] - info.box_min_m[0]) / 2);
    plan.half_z = std::max(1.0, (info.box_max_m[1] - info.box_min_m[1]) / 2);
    return plan;
}

std::vector<Person> tracks_of(Library &library, const clq_trajectories *trajectories, const Plan &plan,
                              const std::vector<Member> &cast, uint64_t seed,
                              const std::function<void(size_t, size_t)> &progress)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_get_info(trajectories, &info));
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(trajectories);
    std::vector<clq_trajectory_person> all(info.person_count, clq_trajectory_person_init());
    std::vector<std::vector<clq_track_point>> points;
    for (uint32_t i = 0; i < info.person_count; ++i) {
        check(clq_trajectories_get_person(trajectories, i, &all[i]));
        points.push_back(points_of(all[i], samples, plan));
    }
    std::vector<clq_track_def> defs = defs_of(points);
    const std::vector<clq_found_passing> passings = passings_of(library, defs);
    size_t next = 0;
    std::vector<Person> people;
    for (uint32_t i = 0; i < info.person_count; ++i) {
        Person person;
        person.id = all[i].id;
        person.member = member_of(cast, random_unit(seed, i, Purpose::clip));
        const Member &member = cast[person.member];
        person.scale = member.scale * random_between(seed, i, Purpose::size, 0.95, 1.05);
        clq_track_def &def = defs[i];
        std::vector<clq_track_passing> own;
        while (next < passings.size() && passings[next].track == i) own.push_back(passings[next++].passing);
        def.passings = own.data(), def.passing_count = static_cast<uint32_t>(own.size());
        def.scale = static_cast<float>(person.scale);
        def.seed = random_bits(seed, i, Purpose::act);
        clq_track *made = nullptr;
        check(clq_track_create(member.locomotion.get(), &def, &made), "person " + person.id);
        person.track.reset(made);
        person.start_s = points[i].front().time_s, person.end_s = points[i].back().time_s;
        people.push_back(std::move(person));
        progress(i + 1, info.person_count);
    }
    return people;
}

}  // namespace scenes::walkers

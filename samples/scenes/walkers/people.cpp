#include "samples/scenes/walkers/people.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"

namespace scenes::walkers
{

namespace
{

// A member of the cast by its share.
size_t member_of(const std::vector<Member> &cast, double share)
{
    double all = 0, passed = 0;
    for (const Member &member : cast) all += member.described.share;
    for (size_t i = 0; i + 1 < cast.size(); ++i)
        if (share * all < (passed += cast[i].described.share)) return i;
    return cast.size() - 1;
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

People::People(Library &library, const clq_trajectories *trajectories, const Plan &plan,
               const std::vector<Member> &cast, uint64_t seed)
    : trajectories_(trajectories), plan_(plan), cast_(cast), seed_(seed), passings_(library, trajectories, plan)
{
    clq_trajectories_info info = clq_trajectories_info_init();
    check(clq_trajectories_get_info(trajectories_, &info));
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(trajectories_);
    for (uint32_t i = 0; i < info.person_count; ++i) {
        const clq_trajectory_person read = person_of(trajectories_, i);
        Person person;
        person.id = read.id;
        // A person who boards becomes another one: the flags of a person are all alike.
        const uint32_t flags = samples[read.first_sample].flags;
        person.kind = flags & CLQ_TRAJECTORY_VEHICLE ? Person::Kind::vehicle
                      : flags & CLQ_TRAJECTORY_RIDES ? Person::Kind::rides
                                                     : Person::Kind::walks;
        person.member = member_of(cast_, random_unit(seed_, i, Purpose::clip));
        person.scale = cast_[person.member].scale * random_between(seed_, i, Purpose::size, 0.95, 1.05);
        person.start_s = samples[read.first_sample].time_s - plan_.start_s;
        person.end_s = samples[read.first_sample + read.sample_count - 1].time_s - plan_.start_s;
        people_.push_back(std::move(person));
    }
}

clq_track *People::track(size_t i)
{
    Person &person = people_[i];
    if (person.track) return person.track.get();
    const uint32_t number = static_cast<uint32_t>(i);
    const clq_trajectory_person read = person_of(trajectories_, number);
    const std::vector<clq_track_point> points =
        points_of(read, clq_trajectories_get_samples(trajectories_), plan_, 0, read.sample_count);
    const std::vector<clq_track_passing> own = passings_.of(number);
    clq_track_def def = clq_track_def_init();
    def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
    def.passings = own.data(), def.passing_count = static_cast<uint32_t>(own.size());
    def.scale = static_cast<float>(person.scale);
    def.seed = random_bits(seed_, i, Purpose::act);
    clq_track *made = nullptr;
    check(clq_track_create(cast_[person.member].locomotion.get(), &def, &made), "person " + person.id);
    person.track.reset(made);
    ++made_;
    return made;
}

std::vector<Person> People::take(const std::function<void(size_t, size_t)> &progress)
{
    for (size_t i = 0; i < people_.size(); ++i) {
        if (people_[i].kind == Person::Kind::walks) track(i);
        progress(i + 1, people_.size());
    }
    return std::move(people_);
}

}  // namespace scenes::walkers

// Where people of a file pass each other closely, found for a stretch of time when it is asked for.
#pragma once

#include <claque/track.h>
#include <claque/trajectories.h>

#include <map>
#include <vector>

#include "samples/scenes/library.h"
#include "samples/scenes/walkers/plan.h"

namespace scenes::walkers
{

// The points of a person in the scene, [first, end) of its own.
std::vector<clq_track_point> points_of(const clq_trajectory_person &person, const clq_trajectory_sample *samples,
                                       const Plan &plan, uint64_t first, uint64_t end);
clq_trajectory_person person_of(const clq_trajectories *trajectories, uint32_t number);

class Passings
{
public:
    // `trajectories` must live as long as this.
    Passings(Library &library, const clq_trajectories *trajectories, const Plan &plan);

    // Those of a person, in order of time: as clq_find_passings finds them among all people. Throws Failure.
    std::vector<clq_track_passing> of(uint32_t person);

private:
    struct Found {
        uint32_t person;
        clq_track_passing passing;
    };
    const std::vector<Found> &found_in(int64_t stretch);

    Library &library_;
    const clq_trajectories *trajectories_;
    const clq_trajectory_sample *samples_;
    Plan plan_;
    std::vector<clq_trajectory_person> people_;
    std::map<int64_t, std::vector<Found>> known_;  // by stretch; sorted by person, then time
};

}  // namespace scenes::walkers

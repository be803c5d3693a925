// The people of a file of trajectories as tracks, in the coordinates of the scene.
#pragma once

#include "samples/scenes/walkers/cast.h"
#include "samples/scenes/walkers/walkers.h"

namespace scenes::walkers
{

struct DestroyTrajectories {
    void operator()(clq_trajectories *p) const { clq_trajectories_destroy(p); }
};
using OwnTrajectories = std::unique_ptr<clq_trajectories, DestroyTrajectories>;

OwnTrajectories load(Library &library, const Options &options);

// A plan of the world: x to the east, y to the north, z up, metres; the scene has x, z to the south, y up, and its
// origin at the middle of the people or where the options say.
struct Plan {
    double x = 0, y = 0, z = 0;         // the scene's origin in the world
    double start_s = 0, end_s = 0;      // of the file
    double half_x = 1, half_z = 1;      // of the people, metres
    double middle_x = 0, middle_z = 0;  // of the people, in the scene
    double ground = 0;                  // its height in the scene
    void to_scene(double px, double py, double pz, double out[3]) const
    {
        out[0] = px - x, out[1] = pz - z, out[2] = -(py - y);
    }
};
Plan plan_of(const clq_trajectories *trajectories, const Options &options);

struct Person {
    std::string id;
    size_t member = 0;  // of the cast
    OwnTrack track;
    double start_s = 0, end_s = 0;
    double scale = 1;
};

// One track for each person, with a member of the cast and a size by hash; shoulders turn where people pass closely.
// Throws Failure.
std::vector<Person> tracks_of(Library &library, const clq_trajectories *trajectories, const Plan &plan,
                              const std::vector<Member> &cast, uint64_t seed,
                              const std::function<void(size_t, size_t)> &progress);

}  // namespace scenes::walkers

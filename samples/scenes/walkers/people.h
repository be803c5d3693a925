// The people of a file of trajectories as tracks, in the coordinates of the scene.
#pragma once

#include "samples/scenes/walkers/cast.h"
#include "samples/scenes/walkers/passings.h"
#include "samples/scenes/walkers/walkers.h"

namespace scenes::walkers
{

struct DestroyTrajectories {
    void operator()(clq_trajectories *p) const { clq_trajectories_destroy(p); }
};
using OwnTrajectories = std::unique_ptr<clq_trajectories, DestroyTrajectories>;

OwnTrajectories load(Library &library, const Options &options);

Plan plan_of(const clq_trajectories *trajectories, const Options &options);

struct Person {
    enum class Kind : uint8_t { walks, rides, vehicle } kind = Kind::walks;  // the latter two have no track
    std::string id;
    size_t member = 0;  // of the cast
    OwnTrack track;     // null until it is made
    double start_s = 0, end_s = 0;
    double scale = 1;
};

// The people of a file, each with a member of the cast and a size by hash. Tracks are made when they are asked for, and
// the passings round them found: that takes many times what reading their rows does. What a person is does not depend
// on which people were asked for before.
class People
{
public:
    // `trajectories` and `cast` must live as long as this. Throws Failure.
    People(Library &library, const clq_trajectories *trajectories, const Plan &plan, const std::vector<Member> &cast,
           uint64_t seed);

    const std::vector<Person> &all() const { return people_; }
    // Makes the track of a person who walks if it has none; its shoulders turn where people pass closely. Throws
    // Failure.
    clq_track *track(size_t person);
    size_t made() const { return made_; }  // tracks
    // All of them, with their tracks.
    std::vector<Person> take(const std::function<void(size_t, size_t)> &progress);

private:
    const clq_trajectories *trajectories_;
    Plan plan_;
    const std::vector<Member> &cast_;
    uint64_t seed_;
    std::vector<Person> people_;
    Passings passings_;
    size_t made_ = 0;
};

}  // namespace scenes::walkers

// People on a navigation mesh: DetourCrowd moves them, in ticks. The ways are found here and given to the crowd, so that
// the crowd's own queue of searches stays empty and a tick depends on what is in this struct alone.
#pragma once

#include <DetourCrowd.h>

#include "lib/stage/walk/mesh.h"

namespace claque::walk
{

struct FreeCrowd {
    void operator()(dtCrowd *crowd) const { dtFreeCrowd(crowd); }
};
struct FreeTrack {
    void operator()(clq_track *track) const { clq_track_destroy(track); }
};
using HeldTrack = std::unique_ptr<clq_track, FreeTrack>;

// Filters of the crowd's agents.
constexpr unsigned char open_filter = 0, everything_filter = 1;

// One walker; its index is that of its agent in the crowd.
struct Body {
    uint32_t generation = 0;  // odd while it is used
    clq_walker_state state = CLQ_WALKER_STANDS;
    Float3 goal{}, end{};  // end: of the way that was found
    dtPolyRef goal_ref = 0;
    float near_m = 0.3f, own_speed = 1;
    bool complete = true;  // the way leads to the goal
    bool cut = false;      // it has as many polygons as a way can have, and goes on
    // Of its track.
    const clq_locomotion *locomotion = nullptr;
    float heading_rad = 0;  // at which it rests; NaN: any
    float scale = 1;
    uint64_t seed = 0;
    std::vector<clq_track_point> points;  // from a little before the next piece on
    HeldTrack piece;
    double piece_end_s = 0;

    bool used() const { return generation & 1; }
};

class Walkers
{
public:
    Walkers(clq_navigation &mesh, const clq_walkers_def &def);
    ~Walkers();
    Walkers(const Walkers &) = delete;
    Walkers &operator=(const Walkers &) = delete;

    clq_walker add(const clq_walker_def &def);
    void remove(clq_walker id);
    void go(clq_walker id, const double goal[3], float near_m, float speed_m_s);
    void stop(clq_walker id);
    void step();

    double time_s() const { return def_.start_s + double(ticks_) * def_.tick_s; }
    const std::vector<clq_walker_piece> &pieces() const { return pieces_; }
    void get(clq_walker id, clq_walker_info &out) const;
    void get(clq_walkers_info &out) const;
    const clq_walkers_def &def() const { return def_; }

private:
    uint32_t index_of(clq_walker id) const;
    dtCrowdAgent &agent(uint32_t i) const { return *crowd_->getEditableAgent(static_cast<int>(i)); }
    clq_walker id_of(uint32_t i) const { return {i + 1, bodies_[i].generation}; }

    // Before the crowd's update.
    void see_doors();
    void plan_ways();
    void plan(uint32_t i);
    // After it.
    void look_round(uint32_t i);
    void record(uint32_t i);
    void publish();
    void publish(uint32_t i);
    void guess(uint32_t i, std::vector<clq_track_point> &points) const;

    clq_navigation &mesh_;
    clq_walkers_def def_;
    std::unique_ptr<dtCrowd, FreeCrowd> crowd_;
    std::vector<Body> bodies_;
    std::vector<clq_walker_piece> pieces_;
    Way way_;  // scratch
    uint64_t ticks_ = 0, plans_ = 0, published_ = 0, mesh_version_ = 0;
    uint32_t next_plan_ = 0;  // the body that is looked at first
    uint32_t count_ = 0;
    bool all_published_ = true;  // false: memory ran out while the pieces of this tick were made
};

}  // namespace claque::walk

struct clq_walkers : claque::walk::Walkers {
    using Walkers::Walkers;
};

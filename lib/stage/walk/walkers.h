// People on a navigation mesh, in ticks: each looks along its way, sees bodies and walls, chooses a velocity, gives
// way, and moves by its share of the gaps at most. DetourCrowd holds the agents with their ways; its own update is not
// called, so a tick depends on this struct alone.
#pragma once

#include <DetourCrowd.h>

#include "lib/stage/save/archive.h"
#include "lib/stage/walk/cells.h"
#include "lib/stage/walk/mesh.h"
#include "lib/stage/walk/steer.h"

namespace claque::walk
{

struct FreeCrowd {
    void operator()(dtCrowd *crowd) const { dtFreeCrowd(crowd); }
};
struct FreeTrack {
    void operator()(clq_track *track) const { clq_track_destroy(track); }
};
using HeldTrack = std::unique_ptr<clq_track, FreeTrack>;

constexpr float still_m_s = 0.05f;  // a walker that is slower stands
// Waits after which one of two blocked walkers goes first: in a narrow place, and anywhere.
constexpr float waits_s = 1, waits_long_s = 4;
constexpr float turned_shoulders = 0.85f;  // share of its radius that a walker takes with its shoulders turned
constexpr double min_piece_s = 0.0999;     // a little less than claque/track.h wants

// Filters of the crowd's agents.
constexpr unsigned char open_filter = 0, everything_filter = 1, any_byway_filter = 2, byway_filter = 3;
constexpr float widest_m = 10;  // the most that a walker goes wide of a corner
constexpr unsigned char last_filter = byway_filter + CLQ_BYWAY_GROUPS - 1;
static_assert(last_filter < DT_CROWD_MAX_QUERY_FILTER_TYPE, "DetourCrowd has so many filters");

// One walker; its index is that of its agent in the crowd.
struct Body {
    uint32_t generation = 0;  // odd while it is used
    clq_walker_state state = CLQ_WALKER_STANDS;
    Float3 goal{}, end{};  // end: of the way that was found; of a walker that rests, its place
    float aim[2] = {};     // x and z: where its way goes now; 0: nowhere
    dtPolyRef goal_ref = 0;
    float near_m = 0.3f, own_speed = 1, speed = 1;  // speed: of the present goal
    bool complete = true;                           // the way leads to the goal
    bool cut = false;                               // it has as many polygons as a way can have, and goes on
    float slope = 0;                                // of the ground that it went over last; positive: up
    float wide_m = 0;                               // farther than usual round the corner before which it is held up
    float shoulders = 1;                            // share of its radius that it takes
    float held_up_s = 0;                            // since when oncoming walkers hold it up
    // Of its track.
    const clq_locomotion *locomotion = nullptr;
    float heading_rad = 0;  // at which it rests; NaN: any
    float scale = 1;
    uint64_t seed = 0;
    std::vector<clq_track_point> points;  // from a little before the next piece on
    HeldTrack piece;
    double piece_end_s = 0;
    // It is shown beside the ground: on its way to `beside`, or from there.
    enum class Pull : uint8_t { none, to, from } pull = Pull::none;
    double beside[3] = {}, pull_s = 0;  // since when
    uint32_t border = 0;                // its pieces end at the ticks that leave this remainder

    bool used() const { return generation & 1; }
};

// A walker that wants to pass: the direction in which it goes, and where a place lies from it.
struct Passing {
    float x, z, ahead, aside;
};

// Whether it looks where it was told to.
inline bool rests(const Body &body) { return body.state == CLQ_WALKER_STANDS || body.state == CLQ_WALKER_ARRIVED; }

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

    // The whole state, without locomotions: a body's is a number in a table of the caller. Pieces are saved with it.
    void save(stage::SaveWriter &out, const std::vector<const clq_locomotion *> &locomotions) const;
    // Throws stage::Error (FORMAT) or std::bad_alloc. It must be thrown away then. Doors move with set_doors.
    using Doors = std::vector<uint8_t>;
    Doors restore(stage::SaveReader &in, const std::vector<const clq_locomotion *> &locomotions);
    void set_doors(const Doors &open) noexcept;
    bool knows(clq_walker id) const noexcept;

    uint32_t index_of(clq_walker id) const;
    void rest_at(clq_walker id, float heading_rad);  // of a walker that arrives
    // Moves a walker that has arrived to a place within half a metre that need not be on the ground.
    void settle(clq_walker id, const double place[3]);
    bool has_settled(clq_walker id) const;
    // A walker that was added now, from where it stands.
    void rise_from(clq_walker id, const double place[3]);
    // A walker that was added now and stood since an earlier time: its first piece, up to now.
    void stand_since(clq_walker id, double time_s);
    double time_s() const { return def_.start_s + double(ticks_) * def_.tick_s; }
    const std::vector<clq_walker_piece> &pieces() const { return pieces_; }
    void get(clq_walker id, clq_walker_info &out) const;
    void get(clq_walkers_info &out) const;
    const clq_walkers_def &def() const { return def_; }

private:
    dtCrowdAgent &agent(uint32_t i) const { return *crowd_->getEditableAgent(static_cast<int>(i)); }
    const dtQueryFilter *filter(const dtCrowdAgent &a) const { return crowd_->getFilter(a.params.queryFilterType); }
    clq_walker id_of(uint32_t i) const { return {i + 1, bodies_[i].generation}; }

    void see_doors();
    void keep_to_byways(uint32_t i);
    void plan_ways();
    void plan(uint32_t i);
    void make_room(uint32_t i);
    bool wants_to_pass(uint32_t k, const Float3 &place, float radius, float slower_than, Passing &out) const;
    bool one_can_go_round(uint32_t i, const Passing &passing, float bodies) const;
    float room_towards(uint32_t i, float x, float z, float reach) const;
    void step_aside(uint32_t i, const Passing &passing, float bodies);
    void go_back(uint32_t i, bool went_back);
    void look_along(uint32_t i);
    float room_at(uint32_t i, dtPolyRef polygon, const float *corner, Flat outwards);
    float sight() const;
    void fill_cells();
    bool stays(uint32_t i) const;
    bool gives_way(uint32_t k, uint32_t i) const;
    float breadth(uint32_t i) const;
    void turn_shoulders(uint32_t i);
    Near near_of(uint32_t i, uint32_t k) const;
    void see_bodies(uint32_t i);
    void see_walls(uint32_t i);
    void steer(uint32_t i);
    void give_way();
    Flat held_up_towards(uint32_t i) const;
    bool is_nearer(uint32_t a, uint32_t b) const;
    void press_on_by_rank();
    void pass_rank_on(uint32_t i);
    bool is_narrow(uint32_t i, Flat towards, float reach) const;
    void press_on(uint32_t i);
    void push_back(uint32_t k, Flat away, bool firmly);
    void push_those_before(uint32_t i);
    void push_on();
    void push_those_behind(uint32_t i);
    void move(uint32_t i);
    void look_round(uint32_t i);
    void aim(uint32_t i);
    void rest(uint32_t i, clq_walker_state state);
    bool others_are_there(uint32_t i) const;
    void record(uint32_t i);
    void return_to_ground(Body &body) const;
    void show(uint32_t i, const float *place, double time_s, double out[3]) const;
    void publish();
    void publish(uint32_t i);
    uint32_t first_border(uint32_t i) const;
    template <class Archive>
    void walk_totals(Archive &archive);
    template <class Archive>
    void walk_body(Archive &archive, uint32_t i, const std::vector<const clq_locomotion *> &locomotions);
    void put_back(uint32_t i, const std::vector<dtPolyRef> &path, const float *target);
    void check_saved(uint32_t i) const;
    void guess(uint32_t i, std::vector<clq_track_point> &points) const;

    clq_navigation &mesh_;
    clq_walkers_def def_;
    std::unique_ptr<dtCrowd, FreeCrowd> crowd_;
    std::vector<Body> bodies_;
    std::vector<clq_walker_piece> pieces_;
    Way way_;  // scratch
    struct Push {
        Flat away;
        bool listed = false, firmly = false, presses = false;
    };
    // Each tick writes it anew, by body.
    struct Scratch {
        std::vector<Wish> wishes;
        std::vector<Surroundings> around;
        std::vector<Push> pushes;
        std::vector<uint32_t> ranks;  // the lowest goes first where people meet
        std::vector<uint32_t> order, by_rank, pushed;
        std::vector<Cells::Place> places;
        Cells cells;
    } scratch_;
    uint64_t ticks_ = 0, plans_ = 0, published_ = 0, mesh_version_ = 0;
    uint32_t next_plan_ = 0;  // the body that is looked at first
    uint32_t count_ = 0;
    bool all_published_ = true;  // false: memory ran out while the pieces of this tick were made
};

// A track as bytes, and back. Throw stage::Error or std::bad_alloc.
std::vector<uint8_t> bytes_of(const clq_track *track);
HeldTrack track_of(const clq_locomotion *locomotion, const std::vector<uint8_t> &bytes);

}  // namespace claque::walk

struct clq_walkers : claque::walk::Walkers {
    using Walkers::Walkers;
};

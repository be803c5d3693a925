// The steps of one update, in their order (S0 4.2); each has a short file of its own. A step reads its first members
// and writes only through its last ones; none allocates. check() reports the first array that does not fit; run()
// requires it, and builds with assertions hold every step of every update to it.
#pragma once

#include <cmath>

#include "lib/base/status.h"
#include "lib/frame/blocks.h"
#include "lib/frame/frame_data.h"
#include "lib/frame/order.h"
#include "lib/frame/seen_rows.h"
#include "lib/frame/stats.h"
#include "lib/frame/view.h"

namespace claque::frame
{

// S0 4.3: tests Group Bspheres against each view's frustum and lists the remaining rows.
struct CullGroups {
    const Given &given;
    const Blocks &blocks;

    base::Span<uint8_t> block_seen;  // [view][block]
    base::Span<uint32_t> tested;     // [row_capacity]

    base::Status check() const;
    uint32_t run() const;  // returns how many of `tested` were written

private:
    bool is_visible(const CameraState &eye, const Block &block) const;
};

// Keeps what CullGroups found.
struct NoteGroups {
    const Given &given;
    const Blocks &blocks;
    base::Span<const uint8_t> block_seen;  // [view][block]

    base::Span<GroupRow> groups;  // [group_count]: writes those that a view met
    Stats &stats;

    base::Status check() const;
    void run() const;
};

// Tests the coarse bound of each row and drops the rows whose bound meets no view. Phase 1 would reject them too.
// Traditional mode drops none.
struct CullBounds {
    const Given &given;

    base::Span<uint8_t> near;     // scratch [tested]
    base::Span<uint32_t> tested;  // the rows that are left come first, in their order

    base::Status check() const;
    uint32_t run() const;  // returns how many are left
};

// Evaluates the tracks of the tested rows.
struct FollowTracks {
    const Given &given;
    base::Span<const uint32_t> tested;

    base::Span<track::Motion> motions;  // by slot of Follows

    base::Status check() const;
    void run() const;
};

// Phase 1: tests Refpoint Bspheres. Before phase 3, traditional mode rejects only actors that their track does not have
// at this time.
struct CullRefpoints {
    const Given &given;
    base::Span<const uint32_t> tested;
    base::Span<const track::Motion> motions;  // by slot of Follows

    base::Span<uint8_t> passed;  // [tested]: whether any view meets it

    base::Status check() const;
    uint32_t run() const;  // returns how many passed

private:
    bool passes(uint32_t row) const;
    bool meets(const CameraState &eye, uint32_t row, uint32_t follow_slot) const;
    glm::dvec3 position_of(uint32_t row, uint32_t follow_slot) const;
};

// Lists what phase 1 let through.
struct ListCandidates {
    const Given &given;
    base::Span<const uint32_t> tested;
    base::Span<const uint8_t> passed;  // [tested], as CullRefpoints leaves them
    uint32_t considered;               // individuals before the first test, for the statistics

    SeenRows &seen;                    // reserved for all rows that are tested
    base::Span<Candidate> candidates;  // as many as passed
    Stats &stats;

    base::Status check() const;
    void run() const;
};

base::Status check_motions(const Given &given, base::Span<const track::Motion> motions);
// Whether `rows` has every candidate's slot.
bool has_slots(base::Span<const Candidate> candidates, base::Span<const Row> rows);

// Places the Skeleton Roots of the candidates: Reference Point, root path, ground.
struct PlaceRoots {
    const Given &given;
    base::Span<const track::Motion> motions;  // by slot of Follows

    base::Span<Candidate> candidates;
    Stats &stats;

    base::Status check() const;
    void run() const;
};

// Phase 2: tests Sklsroot Bspheres and computes eyeDistances.
struct CullRoots {
    const Given &given;
    base::Span<const Candidate> candidates;

    Visibilities visibilities;
    Stats &stats;

    base::Status check() const;
    void run() const;
};

// S1 4, S0 5: selects level, rate and tick of the candidates.
struct ChooseLevels {
    const Given &given;
    Visibilities visibilities;
    base::Span<const track::Motion> motions;  // by slot of Follows
    uint64_t live_since;                      // ticks shown up to this update may be followed by earlier ones

    base::Span<Candidate> candidates;
    base::Span<Row> rows;  // by Candidate::slot

    base::Status check() const;
    void run() const;

private:
    // Of a candidate, the smallest over the views that see it, world units; below 0: none does.
    struct Distances {
        float nearest = -1, effective = -1;
        // From here the reference picture would show it as large as it is shown, or from `nearest` if that is nearer.
        double shown_from = HUGE_VAL;
    };
    Distances distances_of(uint32_t i) const;
    void evaluate_candidate(uint32_t i) const;
    uint32_t level_of(const Row &row, uint32_t crowd_row, float effective_distance_m) const;
    double speed_of(const Candidate &candidate) const;
};

// Chooses what each visible candidate shows: one clip, layers, or key-poses.
struct MakeRequests {
    const Given &given;
    base::Span<const Candidate> candidates;
    base::Span<const Row> rows;
    const animcache::Caches &caches;

    base::Span<uint8_t> blends;                      // scratch [candidates]: whether layers must be chosen
    std::pmr::vector<pose::Layer> &layers;           // within its capacity
    std::pmr::vector<animcache::Request> &requests;  // within its capacity: one per candidate
    Stats &stats;

    base::Status check() const;
    void run() const;

private:
    bool make(const Candidate &candidate, animcache::Request &request) const;
    bool keep_pose(animcache::Request &request) const;
    void choose_clip(animcache::Request &request) const;
    void choose_layers(animcache::Request &request, uint64_t levels) const;
    void share_key_poses(animcache::Request &request) const;
};

// Live clock: how many poses this update may renew, and what deferred actors show.
struct KeepToBudget {
    const Given &given;
    double elapsed_s;    // since the update before
    double pose_cost_s;  // of posing and skinning one individual; 0: unknown

    animcache::Caches &caches;
    base::Span<Candidate> candidates;
    base::Span<Row> rows;

    base::Status check() const;
    void run() const;

private:
    uint32_t budget() const;
};

// Control mechanisms of actors that are due write degrees of freedom.
struct Behave {
    const Given &given;
    base::Span<const Candidate> candidates;
    base::Span<const Row> rows;
    const SeenRows &seen;
    uint32_t dofs_each;  // the maximum over all templates

    base::Span<uint32_t> behaving;  // scratch [candidates]: candidates whose mechanisms run
    base::Span<float> dofs;         // [dofs_each] per candidate, and one more for actors that are not candidates
    animcache::Caches &caches;      // its requests point at their dofs
    Stats &stats;

    base::Status check() const;
    void run() const;

private:
    void run_memories() const;
    void run_one(uint32_t i, behave::Counts &counts) const;
    float *dofs_of(uint32_t i) const { return dofs.data + size_t(i) * dofs_each; }
    uint32_t asking(uint32_t row) const;
};

// Phase 3: tests Internal Bspheres and lists the individuals to draw.
struct CullParts {
    const Given &given;
    base::Span<const Candidate> candidates;

    animcache::Caches &caches;  // sets `drawn` of its requests
    Visibilities visibilities;
    base::Span<Row> rows;
    base::Span<uint32_t> visible;  // [candidates]
    Stats &stats;

    base::Status check() const;
    uint32_t run() const;  // returns how many of `visible` were written

private:
    struct Tested;
    void test_parts(uint32_t view, uint32_t i, Tested &tested) const;
    void test(uint32_t i, Tested &tested) const;
    void note(uint32_t i, Tested &tested) const;
};

// Builds the sorted draw list of one view.
struct ListView {
    const Given &given;
    uint32_t view_index;
    base::Span<const Candidate> candidates;
    base::Span<const uint32_t> visible;
    Visibilities visibilities;
    const animcache::Caches &caches;

    std::pmr::vector<SortEntry> &listed, &ordered;  // scratch, within their capacity
    View &view;

    base::Status check() const;
    void run() const;

private:
    draw::Item item_of(const SortEntry &listed) const;
    void write_items() const;
};

// Adds an update to the statistics of distance bands.
struct CountBands {
    const Given &given;
    const animcache::Caches &caches;
    base::Span<const Row> rows;
    double elapsed_s;  // since the update before; 0: unknown

    base::Span<Band> bands;

    base::Status check() const;
    void run() const;
};

// Whether the Skeleton Root follows the ground.
bool follows_ground(const crowd::Crowd &crowd, uint32_t row);

}  // namespace claque::frame

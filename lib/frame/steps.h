// The steps of one update, in their order; each is a short file of its own. Only reserve() may fail.
#pragma once

#include "lib/frame/frame.h"

namespace claque::frame
{

// What one task of phase 3 found.
struct PartsTested {
    uint32_t slice = 0;
    const math::Affine *palette = nullptr;  // of the individual at hand; null until it is needed
    uint64_t spheres_built = 0, sphere_tests = 0, products_tracked = 0;
    uint64_t products_invisible = 0;  // of these, for who turned out to be invisible
    uint32_t crossing = 0;
};

struct Update {
    const crowd::Crowd &crowd;
    Frame &frame;
    base::Span<View *const> views;
    double time_s;
    const base::Jobs &jobs;

    void reserve();  // frame.cpp: memory for all that follows; throws std::bad_alloc

    // S0 4.2. In traditional mode nobody is rejected before phase 3.
    void cull_groups();                // groups.cpp: Group Bspheres against each view's frustum; who is left
    void cull_refpoints();             // cull.cpp: phase 1, Refpoint Bspheres
    void place_roots();                // roots.cpp: Skeleton Roots of who is left
    void cull_roots();                 // cull.cpp: phase 2, Sklsroot Bspheres; eyeDistances
    void choose_levels_and_periods();  // levels.cpp: level, rate and tick of who is left
    void find_due();                   // frame.cpp: whose pose is not that of its tick, and who of them must wait
    void behave();                     // behave.cpp: control mechanisms of who is due write degrees of freedom
    void animate();                    // frame.cpp: degrees of freedom and clips to matrices
    void cull_parts();                 // parts.cpp: phase 3, Internal Bspheres

    void skin();   // frame.cpp: vertices of who is drawn
    void list();   // list.cpp: one sorted list a view
    void count();  // counters.cpp

    double now() const;               // budget.cpp: the host's clock where a budget is in milliseconds, else 0
    void learn_cost(double spent_s);  // of all that were posed in this update

private:
    using Row = Frame::Row;
    using Candidate = Frame::Candidate;
    using ViewVisibility = Frame::ViewVisibility;

    bool traditional() const { return frame.settings_.cull == Cull::traditional; }
    bool is_visible(const CameraState &eye, const Block &block) const;
    ViewVisibility &view_visibility(uint32_t view, uint32_t candidate) const
    {
        return frame.view_visibilities_[size_t(view) * frame.candidates_.size() + candidate];
    }
    glm::dvec3 position_of(uint32_t row) const;
    bool follows_ground(uint32_t row) const;
    void place_root(Candidate &candidate) const;
    void evaluate_candidate(uint32_t candidate);
    uint32_t level_of(const Row &row, uint32_t crowd_row, float effective_distance_m) const;
    void request(uint32_t candidate);
    void reserve_layers();  // layers.cpp: of all memory the last, as lists of the update before still point at it
    void choose_clips(animcache::Request &request, uint64_t levels);
    void share_key_poses(animcache::Request &request) const;
    uint32_t budget() const;
    void keep_to_budget();
    void run_memories();
    const animcache::Request *find_request(uint32_t row) const;
    float *dofs_of(const animcache::Request &request) const;
    void test_parts(uint32_t view, uint32_t index, const animcache::Request &request, PartsTested &tested) const;
    void list_view(uint32_t view);
    draw::Item item_of(const CameraState &eye, uint32_t view, const SortEntry &listed) const;
    uint32_t band_of(float distance) const;

    // A loop over n in slices whose number does not follow the number of threads.
    template <class Body>
    void for_slices(uint32_t n, const Body &body) const
    {
        constexpr uint32_t slice_size = 256;
        jobs.for_each((n + slice_size - 1) / slice_size, [&](uint32_t k) {
            const uint32_t last = n - k * slice_size < slice_size ? n : (k + 1) * slice_size;
            for (uint32_t i = k * slice_size; i < last; ++i) body(i);
        });
    }
};

}  // namespace claque::frame

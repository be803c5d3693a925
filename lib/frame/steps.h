// The steps of one update, in their order; each is a short file of its own. Only reserve() may fail.
#pragma once

#include "lib/frame/frame.h"
#include "lib/math/frustum.h"

namespace claque::frame
{

// An eye, ready for many individuals.
struct EyeOf {
    explicit EyeOf(const Camera &camera);
    glm::dvec3 eye;
    glm::dmat3 world_to_eye;
    math::Frustum frustum;
};

struct Update {
    const crowd::Crowd &crowd;
    Frame &frame;
    base::Span<View *const> views;
    double time_s;
    const base::Jobs &jobs;

    void reserve();                    // reserve.cpp: memory for all that follows; throws std::bad_alloc
    void cull_groups();                // cull.cpp: Group Bspheres against each view's frustum; who is left
    void place_and_cull();             // cull.cpp: Reference Points relative to each eye, spheres against its frustum
    void choose_levels_and_periods();  // levels.cpp: eyeDistance, level, rate and tick of who is visible
    void find_due();                   // update.cpp: whose pose or vertices are not those of their tick
    void animate();
    void skin();
    void list();   // list.cpp: one sorted list a view
    void count();  // counters.cpp

private:
    using Row = Frame::Row;
    using Listed = Frame::Listed;

    bool sees(const EyeOf &eye, const Block &block) const;
    float distance_if_seen(const EyeOf &eye, uint32_t row) const;
    void look_at(uint32_t candidate);
    void list_view(uint32_t view);
    draw::Item item_of(const EyeOf &eye, const Listed &listed) const;
    uint32_t band_of(float distance) const;

    // A loop over n in slices whose number does not follow the number of threads.
    template <class Body>
    void for_slices(uint32_t n, const Body &body) const
    {
        constexpr uint32_t slice = 256;
        jobs.for_each((n + slice - 1) / slice, [&](uint32_t k) {
            const uint32_t last = n - k * slice < slice ? n : (k + 1) * slice;
            for (uint32_t i = k * slice; i < last; ++i) body(i);
        });
    }
};

}  // namespace claque::frame

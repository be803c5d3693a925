// Questions to a scene. Answers are exact for the crowd as it is, whatever of it has been taken over; they are in the
// order that each function names and do not depend on the history or on threads. Nothing is allocated or changed.
#pragma once

#include <claque/scene.h>

#include "lib/math/frustum.h"
#include "lib/scene/scene.h"

namespace claque::scene
{

// The work of a question, for tests and measurements.
struct Effort {
    uint64_t nodes = 0;   // of the tree that were looked at
    uint64_t tested = 0;  // individuals that were tested exactly
};

struct Asked {
    const Scene &scene;
    const crowd::Crowd &crowd;
    const Filter &filter;
    double time_s = 0;
    Effort *effort = nullptr;  // or null
};

// Where answers go. If there are more than `capacity`, those that come first are written.
struct Room {
    clq_scene_hit *hits = nullptr;
    uint32_t capacity = 0;
};

// All return the number of answers. Places are those of place.h.
// By what they show and by category; in the order of rows.
uint32_t find(const Asked &asked, clq_actor *out, uint32_t capacity);
// By the host's key in [low, high]; in the order of keys, then rows.
uint32_t find_keys(const Asked &asked, double low, double high, clq_actor *out, uint32_t capacity);
// The next individual in the order of keys, or the one before. False: there is none.
bool next_in_order(const Asked &asked, uint32_t row, bool back, uint32_t &out);

// Places within a distance; the nearest first, then by row. The second returns `capacity` at most and looks no further.
uint32_t find_within(const Asked &asked, const glm::dvec3 &point, double radius, const Room &room);
uint32_t find_nearest(const Asked &asked, const glm::dvec3 &point, double radius, const Room &room);
// Places within a box, sides included; by row.
uint32_t find_in_box(const Asked &asked, const glm::dvec3 &low, const glm::dvec3 &high, const Room &room);
// Bodies that meet a frustum, whose planes are in world axes relative to the eye; by row. Distances are from the eye.
uint32_t find_in_frustum(const Asked &asked, const glm::dvec3 &eye, const math::Frustum &frustum, const Room &room);

// A ray from a point, in a direction of length 1.
struct Ray {
    glm::dvec3 origin = glm::dvec3(0), direction = glm::dvec3(0, 0, -1);
    double length = 0;  // may be infinite
};
// Bodies that a ray meets, by the distance at which it enters them, then by row.
uint32_t find_on_ray(const Asked &asked, const Ray &ray, const Room &room);

// The distance at which a ray enters a sphere, 0 from within; negative: it misses it.
double entry_of(const Ray &ray, const glm::dvec3 &centre, double radius);
// The same of a box grown by `margin`.
double entry_of(const Ray &ray, const Box &box, double margin);

}  // namespace claque::scene

// S0 4.2: who can be seen, by the sphere that holds every pose (Sklsroot Bsphere), in double relative to the eye.
#include <cmath>

#include "lib/frame/steps.h"
#include "lib/math/place.h"

namespace claque::frame
{

namespace
{

double length(const glm::dvec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

}  // namespace

EyeOf::EyeOf(const Camera &camera)
    : eye(camera.eye), world_to_eye(math::rotation_of(camera.rotation)), frustum(math::frustum_of(camera.projection))
{
}

// The distance of the Reference Point, or -1.
float Update::distance_if_seen(const EyeOf &eye, uint32_t row) const
{
    if (!crowd.alive(row)) return -1;
    const crowd::Place &place = crowd.place_of(row);
    const model::Sphere &sphere = crowd.template_of(row).sklsroot;
    const glm::dvec3 centre(sphere.centre);
    const double scale = std::fabs(double(place.scale));
    const glm::dvec3 away = place.position - eye.eye;
    const glm::dvec3 refpoint = eye.world_to_eye * away;
    // First however the actor is turned, which costs little; then as it is.
    if (test(eye.frustum, refpoint, scale * (length(centre) + sphere.radius)) == math::Inside::no) return -1;
    const glm::dvec3 turned = math::rotation_of(place.orientation) * (centre * double(place.scale));
    if (test(eye.frustum, refpoint + eye.world_to_eye * turned, scale * sphere.radius) == math::Inside::no) return -1;
    return static_cast<float>(length(away));
}

void Update::place_and_cull()
{
    const uint32_t rows = crowd.row_count();
    for (uint32_t v = 0; v < views.count; ++v) {
        const EyeOf eye(views[v]->camera);
        float *distances = frame.view_distances_.data() + size_t(v) * rows;
        for_slices(rows, [&](uint32_t row) { distances[row] = distance_if_seen(eye, row); });
    }
}

}  // namespace claque::frame

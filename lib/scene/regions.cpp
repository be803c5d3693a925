// Questions for a box, a frustum and a ray.
#include "lib/scene/answers.h"
#include "lib/scene/candidates.h"

namespace claque::scene
{

namespace
{

double dot(const glm::dvec3 &a, const glm::dvec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool holds(const glm::dvec3 &low, const glm::dvec3 &high, const glm::dvec3 &p)
{
    for (int k = 0; k < 3; ++k)
        if (!(low[k] <= p[k] && p[k] <= high[k])) return false;
    return true;
}

bool meets(const glm::dvec3 &low, const glm::dvec3 &high, const Box &box, double margin)
{
    for (int k = 0; k < 3; ++k)
        if (!(double(box.low[k]) - margin <= high[k] && low[k] <= double(box.high[k]) + margin)) return false;
    return true;
}

// False is certain: the box is beyond a plane, at its nearest corner.
bool meets(const math::Frustum &frustum, const glm::dvec3 &eye, const Box &box, double margin)
{
    for (int i = 0; i < frustum.count; ++i) {
        const math::Plane &plane = frustum.planes[i];
        double inside = plane.offset + margin;
        for (int k = 0; k < 3; ++k)
            inside += plane.normal[k] * (double(plane.normal[k] < 0 ? box.low[k] : box.high[k]) - eye[k]);
        if (inside < 0) return false;
    }
    return true;
}

}  // namespace

uint32_t find_in_box(const Asked &asked, const glm::dvec3 &low, const glm::dvec3 &high, const Room &room)
{
    const Margins margins(asked, low);
    Answers<clq_scene_hit, ByRow> answers(room.hits, room.capacity, ByRow());
    for_candidates_in(
        asked, [&](const Leaf &node) { return meets(low, high, node.box, margins.of_places(node)); },
        [&](uint32_t row) {
            glm::dvec3 place;
            if (!place_at(asked.crowd, row, asked.time_s, place) || !holds(low, high, place)) return;
            answers.add(hit_of(asked.crowd, row, place, 0));
        });
    return answers.finish();
}

uint32_t find_in_frustum(const Asked &asked, const glm::dvec3 &eye, const math::Frustum &frustum, const Room &room)
{
    const Margins margins(asked, eye);
    Answers<clq_scene_hit, ByRow> answers(room.hits, room.capacity, ByRow());
    for_candidates_in(
        asked, [&](const Leaf &node) { return meets(frustum, eye, node.box, margins.of_bodies(node)); },
        [&](uint32_t row) {
            Body body;
            if (!body_at(asked.crowd, row, asked.time_s, body)) return;
            if (math::test(frustum, body.centre - eye, body.radius) == math::Containment::outside) return;
            const glm::dvec3 away = body.place - eye;
            answers.add(hit_of(asked.crowd, row, body.place, std::sqrt(dot(away, away))));
        });
    return answers.finish();
}

double entry_of(const Ray &ray, const glm::dvec3 &centre, double radius)
{
    const glm::dvec3 to = centre - ray.origin;
    const double outside = dot(to, to) - radius * radius;
    if (outside <= 0) return 0;
    const double along = dot(to, ray.direction);
    const glm::dvec3 across = to - ray.direction * along;
    const double root = radius * radius - dot(across, across);
    if (along < 0 || root < 0) return -1;
    return std::fmax(0, along - std::sqrt(root));
}

double entry_of(const Ray &ray, const Box &box, double margin)
{
    double from = 0, to = ray.length;
    for (int k = 0; k < 3; ++k) {
        const double low = double(box.low[k]) - margin - ray.origin[k],
                     high = double(box.high[k]) + margin - ray.origin[k];
        if (ray.direction[k] == 0) {
            if (low > 0 || high < 0) return -1;
            continue;
        }
        const double a = low / ray.direction[k], b = high / ray.direction[k];
        from = std::fmax(from, std::fmin(a, b));
        to = std::fmin(to, std::fmax(a, b));
    }
    return from <= to ? from : -1;
}

uint32_t find_on_ray(const Asked &asked, const Ray &ray, const Room &room)
{
    const Margins margins(asked, ray.origin);
    Answers<clq_scene_hit, ByDistance> answers(room.hits, room.capacity, ByDistance());
    for_candidates_in(
        asked, [&](const Leaf &node) { return entry_of(ray, node.box, margins.of_bodies(node)) >= 0; },
        [&](uint32_t row) {
            Body body;
            if (!body_at(asked.crowd, row, asked.time_s, body)) return;
            const double entry = entry_of(ray, body.centre, body.radius);
            if (entry >= 0 && entry <= ray.length) answers.add(hit_of(asked.crowd, row, body.place, entry));
        });
    return answers.finish();
}

}  // namespace claque::scene

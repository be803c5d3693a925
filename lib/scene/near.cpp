// Questions round a point.
#include "lib/scene/answers.h"
#include "lib/scene/candidates.h"

namespace claque::scene
{

namespace
{

double length_of(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

double distance_of(const glm::dvec3 &a, const glm::dvec3 &b) { return length_of(a.x - b.x, a.y - b.y, a.z - b.z); }

double beyond(double x, double low, double high) { return x < low ? low - x : x > high ? x - high : 0; }

// From a point to a box grown by `margin`: never more than to a place in it, also when rounded.
double distance_of(const glm::dvec3 &point, const Box &box, double margin)
{
    double away[3];
    for (int k = 0; k < 3; ++k) away[k] = beyond(point[k], double(box.low[k]) - margin, double(box.high[k]) + margin);
    return length_of(away[0], away[1], away[2]);
}

}  // namespace

uint32_t find_within(const Asked &asked, const glm::dvec3 &point, double radius, const Room &room)
{
    const Margins margins(asked, point);
    Answers<clq_scene_hit, ByDistance> answers(room.hits, room.capacity, ByDistance());
    for_candidates_in(
        asked, [&](const Leaf &node) { return distance_of(point, node.box, margins.of_places(node)) <= radius; },
        [&](uint32_t row) {
            glm::dvec3 place;
            if (!place_at(asked.crowd, row, asked.time_s, place)) return;
            const double distance = distance_of(place, point);
            if (distance <= radius) answers.add(hit_of(asked.crowd, row, place, distance));
        });
    return answers.finish();
}

uint32_t find_nearest(const Asked &asked, const glm::dvec3 &point, double radius, const Room &room)
{
    if (room.capacity == 0) return 0;
    const Margins margins(asked, point);
    Answers<clq_scene_hit, ByDistance> answers(room.hits, room.capacity, ByDistance());
    double limit = radius;
    const auto test = [&](uint32_t row) {
        glm::dvec3 place;
        if (!place_at(asked.crowd, row, asked.time_s, place)) return;
        const double distance = distance_of(place, point);
        if (!(distance <= limit)) return;
        answers.add(hit_of(asked.crowd, row, place, distance));
        if (answers.full()) limit = std::min(limit, answers.last().distance);
    };
    const auto nearness = [&](const Leaf &node) {
        if (asked.effort) ++asked.effort->nodes;
        return distance_of(point, node.box, margins.of_places(node));
    };
    for_candidates(
        asked, [&](const auto &leaf) { asked.scene.tree().for_each_by_distance(nearness, limit, leaf); }, test);
    return std::min(answers.finish(), room.capacity);
}

}  // namespace claque::scene

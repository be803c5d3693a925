// The common course of all questions by place: which individuals are tested exactly.
#pragma once

#include <cmath>

#include "lib/scene/chosen.h"
#include "lib/scene/questions.h"

namespace claque::scene
{

// A filter that chooses fewer is followed instead of the tree.
constexpr uint32_t few = 64;

// How far the places below a node may be outside its box, and how far their bodies.
class Margins
{
public:
    Margins(const Asked &asked, const glm::dvec3 &point)
        : gap_s_(std::fabs(asked.time_s - asked.scene.time_s()) * (1 + 1e-9))
    {
        // Sums of coordinates are rounded: a little for their size.
        double size = std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z);
        if (!asked.scene.tree().empty()) {
            const Box &box = asked.scene.tree().node(asked.scene.tree().root()).box;
            for (int k = 0; k < 3; ++k) size += std::fabs(double(box.low[k])) + std::fabs(double(box.high[k]));
        }
        rounding_ = 1e-13 * size;
    }
    double of_places(const Leaf &node) const
    {
        return node.speed > 0 && gap_s_ > 0 ? double(node.speed) * gap_s_ + rounding_ : 0;
    }
    double of_bodies(const Leaf &node) const { return of_places(node) + double(node.reach) + rounding_; }

private:
    double gap_s_, rounding_;
};

inline clq_actor id_of(const crowd::Crowd &crowd, uint32_t row)
{
    const crowd::Id id = crowd.id_of(row);
    return {id.index1, id.generation};
}

inline clq_scene_hit hit_of(const crowd::Crowd &crowd, uint32_t row, const glm::dvec3 &place, double distance)
{
    return {id_of(crowd, row), {place.x, place.y, place.z}, distance};
}

struct ByRow {
    bool operator()(const clq_scene_hit &a, const clq_scene_hit &b) const { return a.actor.index1 < b.actor.index1; }
};

struct ByDistance {
    bool operator()(const clq_scene_hit &a, const clq_scene_hit &b) const
    {
        return a.distance != b.distance ? a.distance < b.distance : a.actor.index1 < b.actor.index1;
    }
};

// Calls test(row) for each individual that the filter matches and that may be an answer: `walk` calls its argument with
// the leaves of the tree that may be.
template <class Walk, class Test>
void for_candidates(const Asked &asked, const Walk &walk, const Test &test)
{
    const Scene &scene = asked.scene;
    const auto matching = [&](uint32_t row) {
        if (asked.effort) ++asked.effort->tested;
        if (scene.matches(asked.crowd, row, asked.filter)) test(row);
    };
    if (scene.changes().everything) {
        for (uint32_t row = 0; row < asked.crowd.row_count(); ++row)
            if (asked.crowd.alive(row)) matching(row);
        return;
    }
    const auto taken_over = [&](uint32_t row) {
        if (!scene.is_marked(row)) matching(row);
    };
    const Chosen chosen(scene, asked.crowd, asked.filter);
    if (chosen.most() <= few) chosen.for_each(taken_over);
    else walk(taken_over);
    scene.for_each_marked(matching);
}

// The same with a walk through the nodes that `enters` lets through.
template <class Enters, class Test>
void for_candidates_in(const Asked &asked, const Enters &enters, const Test &test)
{
    const auto counted = [&](const Leaf &node) {
        if (asked.effort) ++asked.effort->nodes;
        return enters(node);
    };
    for_candidates(
        asked, [&](const auto &leaf) { asked.scene.tree().for_each(counted, leaf); }, test);
}

}  // namespace claque::scene

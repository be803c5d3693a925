#include "lib/lod/surface/stacking.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "lib/base/error.h"

namespace claque::lod
{

namespace
{

// Whether the box, grown by `skin`, holds the point.
bool holds(const AabbTree::Box &box, double skin, const glm::dvec3 &p)
{
    return glm::all(glm::lessThanEqual(box.min - skin, p)) && glm::all(glm::lessThanEqual(p, box.max + skin));
}

}  // namespace

void check_stacking(const std::vector<Corners3> &triangles, const std::string &model)
{
    if (triangles.size() <= max_stacking) return;
    const AabbTree tree(triangles);
    const uint64_t maximum = max_stacking * triangles.size();
    // Rays pass through what is nearer than this (visibility.cpp); what is farther stops them.
    const double skin = 1e-5 * glm::length(tree.boxes[0].max - tree.boxes[0].min);
    uint64_t met = 0;
    std::vector<uint32_t> open;
    for (const Corners3 &t : triangles) {
        const glm::dvec3 centre = (t[0] + t[1] + t[2]) / 3.0;
        open.push_back(0);
        while (!open.empty() && met <= maximum) {
            const AabbTree::Box &box = tree.boxes[open.back()];
            open.pop_back();
            if (!holds(box, skin, centre)) continue;
            if (box.left) open.push_back(box.left), open.push_back(box.left + 1);
            else met += box.end - box.begin;
        }
        if (met > maximum)
            base::fail(
                CLQ_LIMIT,
                "'%s' has %zu triangles that lie on one another: more than %llu are where the centre of one is, on "
                "average, and what is seen of them would take the square of their number",
                model.c_str(), triangles.size(), base::big(max_stacking));
    }
}

}  // namespace claque::lod

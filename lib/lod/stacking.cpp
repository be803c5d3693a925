#include "lib/lod/stacking.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "lib/base/error.h"

namespace claque::lod
{

namespace
{

bool holds(const AabbTree::Box &box, const glm::dvec3 &p)
{
    return glm::all(glm::lessThanEqual(box.min, p)) && glm::all(glm::lessThanEqual(p, box.max));
}

}  // namespace

void check_stacking(const std::vector<Corners3> &triangles, const std::string &model)
{
    if (triangles.size() <= max_stacking) return;
    const AabbTree tree(triangles);
    const uint64_t most = max_stacking * triangles.size();
    uint64_t met = 0;
    std::vector<uint32_t> open;
    for (const Corners3 &t : triangles) {
        const glm::dvec3 centre = (t[0] + t[1] + t[2]) / 3.0;
        open.push_back(0);
        while (!open.empty() && met <= most) {
            const AabbTree::Box &box = tree.boxes[open.back()];
            open.pop_back();
            if (!holds(box, centre)) continue;
            if (box.left) open.push_back(box.left), open.push_back(box.left + 1);
            else met += box.end - box.begin;
        }
        if (met > most)
            base::fail(
                CLQ_LIMIT,
                "'%s' has %zu triangles that lie on one another: more than %llu are where the centre of one is, on "
                "average, and what is seen of them would take the square of their number",
                model.c_str(), triangles.size(), base::big(max_stacking));
    }
}

}  // namespace claque::lod

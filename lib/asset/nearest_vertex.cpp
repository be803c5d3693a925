#include "lib/asset/nearest_vertex.h"

#include <algorithm>
#include <limits>

namespace claque::asset
{

struct NearestVertex::Search {
    const glm::vec3 &place;
    uint32_t found;
    double distance2 = std::numeric_limits<double>::infinity();
    int left = 1000;  // a search in a mesh takes some thirty
};

NearestVertex::NearestVertex(const std::vector<glm::vec3> &positions, std::vector<uint32_t> among)
    : positions_(positions), tree_(std::move(among))
{
    split(0, tree_.size(), 0);
}

void NearestVertex::split(size_t first, size_t last, int axis)
{
    if (last - first < 2) return;
    const size_t middle = (first + last) / 2;
    const auto at = [&](size_t i) { return tree_.begin() + static_cast<std::ptrdiff_t>(i); };
    // Ties go by index, so that the tree does not depend on the C++ library.
    std::nth_element(at(first), at(middle), at(last), [&](uint32_t a, uint32_t b) {
        const float x = positions_[a][axis], y = positions_[b][axis];
        return x < y || (x == y && a < b);
    });
    split(first, middle, (axis + 1) % 3);
    split(middle + 1, last, (axis + 1) % 3);
}

void NearestVertex::search(size_t first, size_t last, int axis, Search &of) const
{
    if (first == last || of.left-- <= 0) return;
    const size_t middle = (first + last) / 2;
    const glm::vec3 &here = positions_[tree_[middle]];
    double distance2 = 0;
    for (int k = 0; k < 3; ++k) {
        const double apart = double(of.place[k]) - double(here[k]);
        distance2 += apart * apart;
    }
    if (distance2 < of.distance2) of.distance2 = distance2, of.found = tree_[middle];
    const double beyond = double(of.place[axis]) - double(here[axis]);
    const int next = (axis + 1) % 3;
    if (beyond < 0) search(first, middle, next, of);
    else search(middle + 1, last, next, of);
    if (!(beyond * beyond < of.distance2)) return;
    if (beyond < 0) search(middle + 1, last, next, of);
    else search(first, middle, next, of);
}

uint32_t NearestVertex::to(const glm::vec3 &place) const
{
    Search of = {place, tree_.front()};
    search(0, tree_.size(), 0, of);
    return of.found;
}

}  // namespace claque::asset
